#include "shared/cli/staging.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "shared/io/file.h"

namespace dobra::cli {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

class StagingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("dobra_staging_test_" + std::to_string(::getpid()));
    fs::remove_all(root);
    fs::create_directories(root);
  }
  void TearDown() override { fs::remove_all(root); }
  [[nodiscard]] static std::size_t count(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
  }
  static void put(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }
  fs::path root;
};

TEST_F(StagingTest, EverythingIsMovedInAtOnceAndNothingIsLeftBeside) {
  {
    auto staging = Staging::open(root / "a" / "b", TargetFolder::Create);
    ASSERT_TRUE(staging.ok());
    put(staging->path("x.txt"), "x");
    put(staging->path("y.txt"), "y");
    EXPECT_FALSE(fs::exists(root / "a" / "b" / "x.txt"));
    const auto names = staging->commit();
    ASSERT_TRUE(names.ok());
    EXPECT_EQ(*names, (std::vector<std::string>{"x.txt", "y.txt"}));
  }
  EXPECT_EQ(*io::read_bytes(root / "a" / "b" / "y.txt"), "y");
  EXPECT_EQ(count(root / "a" / "b"), 2U);
}

TEST_F(StagingTest, FoldersOfProcessesThatAreGoneAreSweptAndNoOthers) {
  // A child makes one and is killed; another stays while it runs.
  const auto child_with_staging = [&] {
    std::array<int, 2> told{};
    EXPECT_EQ(::pipe(told.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      auto staging = Staging::open(root, TargetFolder::MustExist);
      if (staging.ok()) put(staging->path("half.txt"), "half");
      static_cast<void>(!::write(told[1], "x", 1));
      ::pause();
      ::_exit(1);
    }
    char byte = 0;
    EXPECT_EQ(::read(told[0], &byte, 1), 1);
    for (const int end : told) ::close(end);
    return child;
  };
  const auto end = [](pid_t child) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  };
  const pid_t dead = child_with_staging();
  const pid_t alive = child_with_staging();
  end(dead);
  // What others call alike is theirs.
  fs::create_directories(root / ".staging-notes");
  fs::create_directories(root / ".staging-0-0");
  fs::create_directories(root / ".staging");
  const auto left_by = [&](pid_t process) {
    return std::any_of(fs::directory_iterator(root), fs::directory_iterator(), [&](const auto& entry) {
      return entry.path().filename().string().starts_with(".staging-" + std::to_string(process) + '-');
    });
  };
  EXPECT_TRUE(left_by(dead) && left_by(alive));
  { const auto next = Staging::open(root, TargetFolder::MustExist); }
  EXPECT_FALSE(left_by(dead));
  EXPECT_TRUE(left_by(alive));
  EXPECT_EQ(count(root), 4U);
  end(alive);
}

TEST_F(StagingTest, WhatIsGivenUpLeavesNoFolderBehind) {
  {
    auto staging = Staging::open(root / "a" / "b", TargetFolder::Create);
    ASSERT_TRUE(staging.ok());
    put(staging->path("x.txt"), "x");
  }
  EXPECT_EQ(count(root), 0U);
}

TEST_F(StagingTest, AFolderThatWasThereStaysAsItWas) {
  put(root / "x.txt", "old");
  {
    auto staging = Staging::open(root, TargetFolder::MustExist);
    ASSERT_TRUE(staging.ok());
    put(staging->path("x.txt"), "new");
  }
  EXPECT_EQ(*io::read_bytes(root / "x.txt"), "old");
  EXPECT_EQ(count(root), 1U);
}

TEST_F(StagingTest, ADirectoryOrAFullDeviceInAFilesPlaceStopsEverything) {
  put(root / "a.txt", "old");
  fs::create_symlink("/dev/full", root / "z.txt");
  {
    auto staging = Staging::open(root, TargetFolder::MustExist);
    put(staging->path("a.txt"), "new");
    put(staging->path("z.txt"), "new");
    const auto names = staging->commit();
    ASSERT_FALSE(names.ok());
    EXPECT_EQ(base::to_string(names.error()),
              (root / "z.txt").string() + ": cannot be written: No space left on device");
  }
  fs::remove(root / "z.txt");
  fs::create_directory(root / "z.txt");
  {
    auto staging = Staging::open(root, TargetFolder::MustExist);
    put(staging->path("a.txt"), "new");
    put(staging->path("z.txt"), "new");
    EXPECT_EQ(base::to_string(staging->commit().error()),
              (root / "z.txt").string() + ": cannot be written: Is a directory");
  }
  EXPECT_EQ(*io::read_bytes(root / "a.txt"), "old");
  EXPECT_EQ(count(root), 2U);
}

TEST_F(StagingTest, ATargetThatIsNoFolderIsNamed) {
  EXPECT_EQ(Staging::open("/dev/full", TargetFolder::Create).error().code, ErrorCode::CannotWrite);
  EXPECT_EQ(base::to_string(Staging::open("/dev/full", TargetFolder::Create).error()),
            "/dev/full: cannot be written: Not a directory");
  EXPECT_EQ(Staging::open(root / "missing", TargetFolder::MustExist).error().code, ErrorCode::CannotWrite);
  put(root / "file", "");
  EXPECT_EQ(Staging::open(root / "file" / "x", TargetFolder::Create).error().code, ErrorCode::CannotWrite);
}

TEST_F(StagingTest, WhetherAFileCanBeWrittenIsKnownWithoutATrace) {
  put(root / "file", "old");
  fs::create_directory(root / "folder");
  for (const fs::path& good : {root / "new.svg", root / "file", fs::path("/dev/null")})
    EXPECT_TRUE(check_writable(good)) << good;
  for (const fs::path& bad : {root / "folder", root / "missing" / "x", root / "file" / "x", fs::path("/dev/none/x")})
    EXPECT_EQ(check_writable(bad).error().code, ErrorCode::CannotWrite) << bad;
  EXPECT_EQ(count(root), 2U);
  EXPECT_EQ(*io::read_bytes(root / "file"), "old");
}

TEST_F(StagingTest, ErrorsNameTheFileWhereTheUserExpectsIt) {
  auto staging = Staging::open(root, TargetFolder::MustExist);
  ASSERT_TRUE(staging.ok());
  const base::Error shown = staging->for_user(io::cannot_write(staging->path("x.svg"), ENOSPC));
  EXPECT_EQ(base::to_string(shown), (root / "x.svg").string() + ": cannot be written: No space left on device");
}

}  // namespace
}  // namespace dobra::cli
