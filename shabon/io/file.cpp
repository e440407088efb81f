#include "shabon/io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

namespace shabon::io {

namespace {

namespace fs = std::filesystem;

Diagnostics file_error(const fs::path& path, const std::string& what, int error = 0) {
  Diagnostics errors = fail(Failure::file, error ? what + ": " + std::generic_category().message(error) : what);
  errors[0].source = path.string();
  return errors;
}

// A name with a NUL inside would silently mean another file.
bool nameable(const fs::path& path) { return !path.empty() && path.native().find('\0') == fs::path::string_type::npos; }

// Owns an open file; closing says whether the bytes arrived.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  bool close() {  // false with errno set
    if (number_ < 0) return true;
    return ::close(std::exchange(number_, -1)) == 0 || errno == EINTR;
  }

 private:
  int number_;
};

int open_file(const fs::path& path, int flags, mode_t mode = 0) {
  for (;;) {
    const int number = ::open(path.c_str(), flags | O_CLOEXEC, mode);
    if (number >= 0 || errno != EINTR) return number;
  }
}

bool write_all(int number, std::string_view bytes) {  // false with errno set
  constexpr std::size_t most = std::size_t{1} << 30;  // one call takes less than 2 GiB
  while (!bytes.empty()) {
    const ssize_t written = ::write(number, bytes.data(), std::min(bytes.size(), most));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string kind_of_file(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

// Reads until the end or one byte past the limit: a file can grow, and files in /proc have size 0.
Result<std::string> read_open(const fs::path& path, int number, std::size_t size_hint, std::size_t max_bytes) {
  constexpr std::size_t step = 64 << 10;
  std::string bytes(std::min(size_hint, max_bytes) + 1, '\0');
  std::size_t used = 0;
  for (;;) {
    if (used == bytes.size()) bytes.resize(std::min(used + std::max(step, used), max_bytes + 1));
    const ssize_t count = ::read(number, bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return file_error(path, "cannot read", errno);
    used += static_cast<std::size_t>(count);
    if (used > max_bytes) {
      Diagnostics errors = fail(Failure::content, "file is larger than " + std::to_string(max_bytes) + " bytes");
      errors[0].source = path.string();
      return errors;
    }
    if (count == 0) break;
  }
  bytes.resize(used);
  return bytes;
}

// Where and how bytes for `path` go.
struct Target {
  fs::path file;        // links followed
  bool direct = false;  // not a regular file: written as it is
  mode_t mode = 0;      // permissions to keep, when the file exists
  bool exists = false;
};

// The shell's names for open files are no places in a folder: replacing what they point to would leave the shell's own
// file behind.
bool names_open_file(const fs::path& path) {
  const std::string name = path.lexically_normal().string();
  return name == "/dev/stdout" || name == "/dev/stderr" || name.starts_with("/dev/fd/") || name.starts_with("/proc/");
}

Result<Target> find_target(const fs::path& path) {
  if (!nameable(path)) return file_error(path, "not a file name");
  if (!path.has_filename()) return file_error(path, "cannot write: it is a folder");
  if (names_open_file(path)) return Target{path, true};
  Target target{path};
  struct stat status;
  // A link that points to nothing yet is followed by hand, as far as the system itself would.
  for (int links = 0; ::lstat(target.file.c_str(), &status) == 0 && S_ISLNK(status.st_mode); ++links) {
    std::error_code error;
    const fs::path next = fs::read_symlink(target.file, error);
    if (error) return file_error(path, "cannot write", error.value());
    if (links == 40) return file_error(path, "cannot write", ELOOP);
    target.file = target.file.parent_path() / next;
    if (names_open_file(target.file)) return Target{path, true};
  }
  if (::stat(target.file.c_str(), &status) != 0) {
    if (errno != ENOENT) return file_error(path, "cannot write", errno);
    return target;
  }
  if (S_ISDIR(status.st_mode)) return file_error(path, "cannot write: it is a folder");
  if (!S_ISREG(status.st_mode)) target.direct = true;
  if (::faccessat(AT_FDCWD, target.file.c_str(), W_OK, AT_EACCESS) != 0) return file_error(path, "cannot write", errno);
  target.exists = true;
  target.mode = status.st_mode & 07777;
  return target;
}

Status write_directly(const fs::path& path, const Target& target, std::string_view bytes) {
  // Appending keeps what `>>` and earlier output put there. Without a reader a FIFO fails here instead of waiting.
  Descriptor file(open_file(target.file, O_WRONLY | O_APPEND | O_NONBLOCK | O_NOCTTY));
  if (!file.open()) return file_error(path, "cannot write", errno);
  const int flags = ::fcntl(file.number(), F_GETFL);
  if (flags >= 0) ::fcntl(file.number(), F_SETFL, flags & ~O_NONBLOCK);
  if (!write_all(file.number(), bytes) || !file.close()) return file_error(path, "cannot write", errno);
  return Done{};
}

// A file beside the target that vanishes unless it is renamed. Its name does not build on the target's, which may
// already have the greatest length allowed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : file_(create(target)) {}
  ~TemporaryFile() {
    if (present_) ::unlink(path_.c_str());
  }
  bool open() const { return file_.open(); }
  Descriptor& file() { return file_; }
  bool rename_to(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) return false;
    present_ = false;
    return true;
  }

 private:
  int create(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    for (int attempt = 0; attempt < 100; ++attempt) {
      const std::string name = ".shabon-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
      path_ = target.parent_path() / name;
      const int number = open_file(path_, O_WRONLY | O_CREAT | O_EXCL, 0666);
      present_ = number >= 0;
      if (present_ || errno != EEXIST) return number;
    }
    return -1;
  }

  fs::path path_;
  bool present_ = false;
  Descriptor file_;  // made last, closed first
};

Status write_beside(const fs::path& path, const Target& target, std::string_view bytes) {
  TemporaryFile temporary(target.file);
  if (!temporary.open()) return file_error(path, "cannot write", errno);
  if (target.exists) (void)!::fchmod(temporary.file().number(), target.mode);  // on some file systems there is no mode
  if (!write_all(temporary.file().number(), bytes) || !temporary.file().close() || !temporary.rename_to(target.file))
    return file_error(path, "cannot write", errno);
  return Done{};
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) try {
  if (!nameable(path)) return file_error(path, "not a file name");
  Descriptor file(open_file(path, O_RDONLY | O_NONBLOCK | O_NOCTTY));
  if (!file.open()) return file_error(path, "cannot read", errno);
  struct stat status;
  if (::fstat(file.number(), &status) != 0) return file_error(path, "cannot read", errno);
  if (!S_ISREG(status.st_mode)) return file_error(path, "cannot read: it is " + kind_of_file(status.st_mode));
  const auto size = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  return read_open(path, file.number(), size, max_bytes);
} catch (const std::bad_alloc&) {
  return file_error(path, "cannot read", ENOMEM);
}

Result<std::string> read_text_file(const fs::path& path, std::size_t max_bytes) {
  Result<std::string> text = read_file(path, max_bytes);
  if (text && text->starts_with("\xEF\xBB\xBF")) text->erase(0, 3);
  return text;
}

Status write_file_atomically(const fs::path& path, std::string_view bytes) {
  const Result<Target> target = find_target(path);
  if (!target) return target.errors();
  return target->direct ? write_directly(path, *target, bytes) : write_beside(path, *target, bytes);
}

Status check_writable(const fs::path& path) {
  const Result<Target> target = find_target(path);
  if (!target) return target.errors();
  if (target->direct) return Done{};
  TemporaryFile temporary(target->file);
  if (!temporary.open()) return file_error(path, "cannot write", errno);
  return Done{};
}

}  // namespace shabon::io
