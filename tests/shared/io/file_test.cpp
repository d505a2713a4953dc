#include "shared/io/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace dobra::io {
namespace {

using base::ErrorCode;

class File : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("dobra_file_test_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path put(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  }
  [[nodiscard]] std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
  }
  std::filesystem::path folder;
};

TEST_F(File, AMissingFileADirectoryAndAnEmptyFileAreNamed) {
  const auto missing = read_text(folder / "missing.csv");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::FileNotFound);
  EXPECT_EQ(base::to_string(missing.error()), (folder / "missing.csv").string() + ": there is no such file");
  EXPECT_EQ(read_text(folder).error().code, ErrorCode::NotAFile);
  EXPECT_EQ(read_text(put("empty.csv", "")).error().code, ErrorCode::EmptyFile);
  EXPECT_EQ(read_text(put("blank.csv", " \r\n\t\n")).error().code, ErrorCode::EmptyFile);
}

TEST_F(File, BinaryContentAndOtherEncodingsAreRefusedWithTheLine) {
  const auto nul = read_text(put("nul.csv", std::string("1,2\n3,\0", 7)));
  ASSERT_FALSE(nul.ok());
  EXPECT_EQ(nul.error().code, ErrorCode::BadFormat);
  EXPECT_EQ(nul.error().place->line, 2U);
  const auto latin = read_text(put("latin.csv", "ok\nok\nse\xE7\xE3o\n"));
  ASSERT_FALSE(latin.ok());
  EXPECT_EQ(latin.error().code, ErrorCode::BadFormat);
  EXPECT_EQ(latin.error().place->line, 3U);
  EXPECT_NE(latin.error().message.find("0xE7"), std::string::npos);
}

TEST_F(File, TextComesBackWithoutItsByteOrderMark) {
  const auto text = read_text(put("bom.csv", "\xEF\xBB\xBFse\xC3\xA7\xC3\xA3o\r\n"));
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(*text, "se\xC3\xA7\xC3\xA3o\r\n");
}

TEST_F(File, OnlyWellFormedUtf8IsText) {
  EXPECT_FALSE(first_byte_outside_utf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"));
  EXPECT_EQ(first_byte_outside_utf8("a\xC0\xAF"), 1U);         // overlong '/'
  EXPECT_EQ(first_byte_outside_utf8("\xE0\x80\x80"), 0U);      // overlong
  EXPECT_EQ(first_byte_outside_utf8("ab\xED\xA0\x80"), 2U);    // surrogate
  EXPECT_EQ(first_byte_outside_utf8("\xF4\x90\x80\x80"), 0U);  // beyond U+10FFFF
  EXPECT_EQ(first_byte_outside_utf8("abc\xE2\x82"), 3U);       // cut short
}

TEST_F(File, AFileIsReplacedAndKeepsItsPermissions) {
  const auto file = put("a.txt", "old");
  ::chmod(file.c_str(), 0640);
  ASSERT_TRUE(write_file(file, "new bytes").ok());
  EXPECT_EQ(*read_bytes(file), "new bytes");
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(File, ASymbolicLinkStaysALink) {
  const auto file = put("a.txt", "old");
  std::filesystem::create_symlink(file, folder / "link.txt");
  ASSERT_TRUE(write_file(folder / "link.txt", "new").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(*read_bytes(file), "new");
}

TEST_F(File, TheFullDeviceAMissingFolderAndADirectoryCannotBeWritten) {
  const auto full = write_file("/dev/full", "x");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().code, ErrorCode::CannotWrite);
  EXPECT_EQ(base::to_string(full.error()), "/dev/full: cannot be written: No space left on device");
  EXPECT_EQ(base::exit_code(full.error().code), 4);
  EXPECT_EQ(write_file(folder / "no" / "such.txt", "x").error().code, ErrorCode::CannotWrite);
  EXPECT_EQ(write_file(folder, "x").error().code, ErrorCode::CannotWrite);
}

TEST_F(File, AWriteThatFailsHalfWayLeavesTheOldFileAndNothingBeside) {
  const auto file = put("a.txt", "old");
  // A limit on the size of files stands for a disk that fills up in the middle of a write.
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit small = before;
  small.rlim_cur = 4096;
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto written = write_file(file, std::string(100000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, ErrorCode::CannotWrite);
  EXPECT_EQ(*read_bytes(file), "old");
  EXPECT_EQ(files_in_folder(), 1U);
}

}  // namespace
}  // namespace dobra::io
