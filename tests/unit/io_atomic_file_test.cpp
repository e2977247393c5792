#include <filesystem>
#include <string>

#include "support/error_of.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "ramify/io/atomic_file.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

using test::error_of;

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const test::Scratch scratch_;
  const fs::path folder_ = scratch_.path();
};

/// Files of this process end at a limit while this lives, as on a full disk.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(AtomicFile, WritesAndReplaces) {
  const fs::path path = folder_ / "table.csv";
  write_file_atomically(path, "old");
  EXPECT_EQ(read_text_file(path), "old");
  const std::string large(3'000'000, 'x');
  write_file_atomically(path, large);
  EXPECT_EQ(read_text_file(path), large);
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, FullDiskKeepsTheOldFileAndLeavesNoTemporary) {
  const fs::path path = folder_ / "table.csv";
  write_file_atomically(path, "old");
  std::string message;
  {
    const SmallFiles full(4096);
    message = error_of([&] { write_file_atomically(path, std::string(100'000, 'x')); });
  }
  EXPECT_EQ(message,
            "cannot write '" + path.string() + "' (File too large): free space or choose another place");
  EXPECT_EQ(read_text_file(path), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, ErrorOnlySeenAtTheClose) {
  EXPECT_EQ(error_of([] { write_file_atomically("/dev/full", "short"); }),
            "cannot write '/dev/full' (No space left on device): free space or choose another place");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFile, MissingFolderAndFolderAsTarget) {
  const fs::path absent = folder_ / "absent" / "table.csv";
  EXPECT_EQ(error_of([&] { write_file_atomically(absent, "x"); }),
            "cannot write '" + absent.string() +
                "' (No such file or directory): create its folder or choose another place");
  fs::create_directory(folder_ / "sub");
  EXPECT_NE(error_of([&] { write_file_atomically(folder_ / "sub", "x"); }).find("(Is a directory)"),
            std::string::npos);
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, SymbolicLinkIsWrittenThrough) {
  write_file_atomically(folder_ / "target", "old");
  fs::create_symlink("target", folder_ / "link");
  write_file_atomically(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_text_file(folder_ / "target"), "new");
}

TEST_F(AtomicFile, WritableFolderIsCreatedAndLeftEmpty) {
  require_writable_folder(folder_ / "a" / "b/");
  EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b"));
  require_writable_folder(folder_ / "a" / "b");
  EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b"));
}

TEST_F(AtomicFile, RelativeFolderIsCreatedHere) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  require_writable_folder("out");
  write_file_atomically("plain.txt", "x");
  fs::current_path(before);
  EXPECT_TRUE(fs::is_directory(folder_ / "out"));
  EXPECT_EQ(read_text_file(folder_ / "plain.txt"), "x");
}

TEST_F(AtomicFile, UnusableFolderIsRefused) {
  write_file_atomically(folder_ / "file", "x");
  EXPECT_EQ(
      error_of([&] { require_writable_folder(folder_ / "file"); }),
      "cannot use the folder '" + (folder_ / "file").string() + "' (Not a directory): choose another place");
  EXPECT_NE(error_of([&] { require_writable_folder(folder_ / "file" / "sub"); }).find("(Not a directory)"),
            std::string::npos);
  EXPECT_NE(error_of([] { require_writable_folder("/proc/ramify"); }).find("cannot use the folder"),
            std::string::npos);
}

TEST_F(AtomicFile, FolderCreatedForNothingIsRemovedAgain) {
  std::string message;
  {
    const SmallFiles full(4096);
    message = error_of([&] { require_writable_folder(folder_ / "a" / "b"); });
  }
  EXPECT_NE(message.find("(File too large): free space"), std::string::npos) << message;
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace ramify
