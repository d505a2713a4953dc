#pragma once
// Long lists of remarks shortened for a terminal.

#include <string>
#include <vector>

namespace dobra::cli {

/// The remarks, those of one kind together where the first of them stands: of more than five the first three and how
/// many more there are. Remarks are of one kind if they differ in numbers and names alone; the name behind the word
/// "fault" makes a kind of its own.
/// @param where  all of them are to be found
std::vector<std::string> shortened(const std::vector<std::string>& remarks,
                                   const char* where = "--verbose prints them; --json and report.json have all");

}  // namespace dobra::cli
