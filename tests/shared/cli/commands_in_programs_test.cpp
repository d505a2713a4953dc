// A sub-command that a folder of a program declares is one of the program's.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "shared/io/file.h"

namespace {

namespace fs = std::filesystem;

TEST(CommandsInPrograms, HaveEverySubCommandOfTheirFolder) {
  const fs::path root = DOBRA_SOURCE_DIR;
  const std::regex declaration(R"(\bCommand (\w+_command)\(\);)");
  for (const std::string program : {"recon", "quebra"}) {
    const std::string main = dobra::io::read_text((root / program / "main.cpp").string()).value();
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(root / program / "cli")) {
      if (entry.path().extension() != ".h") continue;
      const std::string header = dobra::io::read_text(entry.path().string()).value();
      for (std::sregex_iterator at(header.begin(), header.end(), declaration), end; at != end; ++at) {
        ++count;
        EXPECT_NE(main.find(program + "::cli::" + (*at)[1].str() + "()"), std::string::npos)
            << program << "/main.cpp does not name " << (*at)[1];
      }
    }
    EXPECT_GT(count, 3U) << "the search finds no sub-commands any more";
  }
}

}  // namespace
