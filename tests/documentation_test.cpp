// Pages of docs/: every one is listed in docs/README.md, and what they link to is there.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text_of_page(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Targets of links to other files, without what comes after #.
std::vector<std::string> links_in(const std::string& page) {
  static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  std::vector<std::string> targets;
  for (auto at = std::sregex_iterator(page.begin(), page.end(), link); at != std::sregex_iterator(); ++at) {
    const std::string target = (*at)[1];
    if (target.find("://") == std::string::npos) targets.push_back(target);
  }
  return targets;
}

std::vector<fs::path> pages_of(const fs::path& folder) {
  std::vector<fs::path> pages;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  return pages;
}

const fs::path docs = fs::path(DOBRA_SOURCE_DIR) / "docs";

TEST(Documentation, TheIndexListsEveryPage) {
  const std::string index = text_of_page(docs / "README.md");
  for (const fs::path& page : pages_of(docs)) {
    const std::string name = page.lexically_relative(docs).generic_string();
    if (name == "README.md" || name.starts_with("decisions/")) continue;
    EXPECT_NE(index.find("(" + name + ")"), std::string::npos) << name << " is not in docs/README.md";
  }
}

TEST(Documentation, WhatPagesLinkToIsThere) {
  std::vector<fs::path> pages = pages_of(docs);
  pages.push_back(fs::path(DOBRA_SOURCE_DIR) / "README.md");
  ASSERT_GT(pages.size(), 50U);
  for (const fs::path& page : pages) {
    for (const std::string& target : links_in(text_of_page(page))) {
      EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page << " links to " << target;
    }
  }
}

TEST(Documentation, LinksAreFoundInAText) {
  EXPECT_EQ(links_in("see [a](b.md), [c](../d.md#e) ![f](g.svg) [h](https://example.org) [i](#j)"),
            (std::vector<std::string>{"b.md", "../d.md", "g.svg"}));
}

}  // namespace
