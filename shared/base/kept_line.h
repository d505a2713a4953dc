#pragma once
// Lines of a progress that stay: what a long loop tells step by step (a cycle with its error), beside the wording of
// the moment. They go the way of every report; a listener that shows but one line may show them as any other.

#include <string>
#include <string_view>

namespace dobra::base {

/// `text` as what a Progress reports, marked as a line to keep.
inline std::string kept_line(std::string text) { return std::move(text) + '\n'; }
/// Whether a report is one; its text is then without the mark.
inline bool is_kept_line(std::string_view what) { return what.ends_with('\n'); }

}  // namespace dobra::base
