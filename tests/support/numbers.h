#pragma once
// That written results hold no word that stands for no number.

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <string>

#include "shared/io/file.h"

namespace dobra::test {

inline void expect_numbers(std::string text, const std::string& what) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto is_letter = [&](std::size_t i) { return std::isalnum(static_cast<unsigned char>(text[i])) != 0; };
  for (const std::string word : {"null", "nan", "inf", "infinity"}) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      const auto end = at + word.size();
      EXPECT_FALSE((at == 0 || !is_letter(at - 1)) && (end == text.size() || !is_letter(end)))
          << what << ": " << text.substr(at < 80 ? 0 : at - 80, 160);
    }
  }
}

inline void expect_numbers_in(const std::filesystem::path& folder) {
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".vtu")  // bytes; its writer refuses such numbers itself
      expect_numbers(io::read_bytes(file.path()).value(), file.path().filename().string());
  }
}

}  // namespace dobra::test
