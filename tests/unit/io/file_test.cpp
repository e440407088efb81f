#include "shabon/io/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "scratch.h"

namespace shabon::io {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t plenty = 1 << 20;

TEST(ReadFile, GivesAllBytes) {
  const Scratch scratch;
  for (std::size_t size : {0u, 1u, 65535u, 65536u, 300000u}) {
    const std::string bytes(size, 'x');
    const auto read = read_file(scratch.put("a", bytes), plenty);
    ASSERT_TRUE(read) << errors_of(read);
    EXPECT_EQ(*read, bytes);
  }
}

TEST(ReadFile, HoldsToTheBound) {
  const Scratch scratch;
  const fs::path path = scratch.put("a", std::string(100, 'x'));
  EXPECT_TRUE(read_file(path, 100));
  EXPECT_TRUE(fails(read_file(path, 99), Failure::content, "larger than 99 bytes"));
}

TEST(ReadFile, NamesWhatCannotBeRead) {
  const Scratch scratch;
  ASSERT_EQ(::mkfifo((scratch / "fifo").c_str(), 0600), 0);
  EXPECT_TRUE(fails(read_file(scratch / "none", plenty), Failure::file, "No such file"));
  EXPECT_TRUE(fails(read_file(scratch.folder(), plenty), Failure::file, "folder"));
  EXPECT_TRUE(fails(read_file(scratch / "fifo", plenty), Failure::file, "FIFO"));
  EXPECT_TRUE(fails(read_file("/dev/zero", plenty), Failure::file, "device"));
  EXPECT_TRUE(fails(read_file("", plenty), Failure::file, "not a file name"));
  EXPECT_TRUE(fails(read_file(std::string("a\0b", 3), plenty), Failure::file, "not a file name"));
  EXPECT_EQ(read_file(scratch / "none", plenty).errors()[0].source, (scratch / "none").string());
}

TEST(ReadTextFile, DropsTheByteOrderMark) {
  const Scratch scratch;
  EXPECT_EQ(*read_text_file(scratch.put("a", "\xEF\xBB\xBFtext"), plenty), "text");
  EXPECT_EQ(*read_text_file(scratch.put("b", "text"), plenty), "text");
}

TEST(WriteFile, CreatesAndReplaces) {
  const Scratch scratch;
  ASSERT_TRUE(write_file_atomically(scratch / "a", "one"));
  EXPECT_EQ(scratch.get("a"), "one");
  ASSERT_TRUE(write_file_atomically(scratch / "a", "second"));
  EXPECT_EQ(scratch.get("a"), "second");
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(WriteFile, KeepsPermissionsAndFollowsTheUmask) {
  const Scratch scratch;
  const mode_t before = ::umask(027);
  ASSERT_TRUE(write_file_atomically(scratch / "new", "x"));
  ::umask(before);
  EXPECT_EQ(fs::status(scratch / "new").permissions(), fs::perms(0640));
  fs::permissions(scratch / "new", fs::perms(0604));
  ASSERT_TRUE(write_file_atomically(scratch / "new", "y"));
  EXPECT_EQ(fs::status(scratch / "new").permissions(), fs::perms(0604));
}

TEST(WriteFile, ReplacesWhatALinkPointsTo) {
  const Scratch scratch;
  scratch.put("real", "old");
  fs::create_symlink("real", scratch / "link");
  fs::create_symlink("later", scratch / "dangling");
  fs::create_symlink("loop", scratch / "loop");
  ASSERT_TRUE(write_file_atomically(scratch / "link", "new"));
  ASSERT_TRUE(write_file_atomically(scratch / "dangling", "made"));
  EXPECT_TRUE(fs::is_symlink(scratch / "link") && fs::is_symlink(scratch / "dangling"));
  EXPECT_EQ(scratch.get("real"), "new");
  EXPECT_EQ(scratch.get("later"), "made");
  EXPECT_TRUE(fails(write_file_atomically(scratch / "loop", "x"), Failure::file, "symbolic links"));
}

TEST(WriteFile, NamesWhatCannotBeWritten) {
  const Scratch scratch;
  ASSERT_EQ(::mkfifo((scratch / "fifo").c_str(), 0600), 0);
  for (const auto& write : {+[](const fs::path& path) { return write_file_atomically(path, "x"); },
                            +[](const fs::path& path) { return check_writable(path); }}) {
    EXPECT_TRUE(fails(write(scratch.folder()), Failure::file, "folder"));
    EXPECT_TRUE(fails(write(scratch / "new/"), Failure::file, "folder"));
    EXPECT_TRUE(fails(write(scratch / "none/file"), Failure::file, "No such file"));
    EXPECT_TRUE(fails(write(scratch / std::string(300, 'n')), Failure::file, "name too long"));
    EXPECT_TRUE(fails(write(""), Failure::file, "not a file name"));
  }
  EXPECT_TRUE(fails(write_file_atomically("/dev/full", "x"), Failure::file, "No space left"));
  EXPECT_TRUE(fails(write_file_atomically(scratch / "fifo", "x"), Failure::file, "No such device"));  // nobody reads
  EXPECT_EQ(scratch.entries(), 1u);
}

// Root may write everywhere, so the test gives that up for a while.
class AsNobody {
 public:
  explicit AsNobody(const fs::path& folder) : was_root_(::geteuid() == 0) {
    constexpr uid_t nobody = 65534;
    if (was_root_) ready_ = ::chown(folder.c_str(), nobody, static_cast<gid_t>(-1)) == 0 && ::seteuid(nobody) == 0;
  }
  ~AsNobody() {
    if (was_root_ && ::seteuid(0) != 0) std::abort();
  }
  bool ready() const { return ready_; }

 private:
  bool was_root_, ready_ = true;
};

TEST(WriteFile, RespectsWhatIsReadOnly) {
  const Scratch scratch;
  const AsNobody nobody(scratch.folder());
  ASSERT_TRUE(nobody.ready());
  fs::permissions(scratch.put("a", "old"), fs::perms(0400));
  EXPECT_TRUE(fails(write_file_atomically(scratch / "a", "new"), Failure::file, "Permission denied"));
  EXPECT_TRUE(fails(check_writable(scratch / "a"), Failure::file, "Permission denied"));
  EXPECT_EQ(scratch.get("a"), "old");
  fs::create_directory(scratch / "closed");
  fs::permissions(scratch / "closed", fs::perms(0500));
  EXPECT_TRUE(fails(write_file_atomically(scratch / "closed/a", "new"), Failure::file, "Permission denied"));
  EXPECT_TRUE(fails(check_writable(scratch / "closed/a"), Failure::file, "Permission denied"));
  fs::permissions(scratch.put("secret", "x"), fs::perms(0));
  EXPECT_TRUE(fails(read_file(scratch / "secret", plenty), Failure::file, "Permission denied"));
}

TEST(WriteFile, WritesIntoDevicesAndFifos) {
  const Scratch scratch;
  EXPECT_TRUE(write_file_atomically("/dev/null", "x"));
  ASSERT_EQ(::mkfifo((scratch / "fifo").c_str(), 0600), 0);
  const int reader = ::open((scratch / "fifo").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  ASSERT_TRUE(write_file_atomically(scratch / "fifo", "through"));
  char text[16] = {};
  EXPECT_EQ(::read(reader, text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  ::close(reader);
}

// A file that may not grow past a limit fails like a full disk: in the middle of the bytes.
TEST(WriteFile, LeavesTheOldFileWhenTheDiskIsFull) {
  const Scratch scratch;
  scratch.put("a", "old");
  rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Status replaced = write_file_atomically(scratch / "a", std::string(100000, 'x'));
  const Status created = write_file_atomically(scratch / "b", std::string(100000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(fails(replaced, Failure::file, "File too large"));
  EXPECT_TRUE(fails(created, Failure::file, "File too large"));
  EXPECT_EQ(scratch.get("a"), "old");
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(CheckWritable, LeavesNothing) {
  const Scratch scratch;
  EXPECT_TRUE(check_writable(scratch / "new"));
  EXPECT_TRUE(check_writable("/dev/null"));
  EXPECT_EQ(scratch.entries(), 0u);
  scratch.put("a", "old");
  EXPECT_TRUE(check_writable(scratch / "a"));
  EXPECT_EQ(scratch.get("a"), "old");
  EXPECT_EQ(scratch.entries(), 1u);
}

}  // namespace
}  // namespace shabon::io
