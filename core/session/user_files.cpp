#include "core/session/user_files.h"

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/shown_text.h"

namespace hw {
namespace fs = std::filesystem;
namespace {

/// An owned file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool good() const { return fd_ >= 0; }
  /// 0, or errno: network file systems report a full disk only here.
  int close() { return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

 private:
  int fd_;
};

tl::unexpected<Fault> not_written(const fs::path& path, int error) {
  return fail(FaultKind::port,
              fmt::format("{} was not written: {}.", shown_path(path.string()), reason_of(error)), {},
              error == ENOSPC || error == EDQUOT || error == EFBIG
                  ? "Free some space, or choose another place."
                  : "Choose another place.");
}

// A device or pipe has no contents to protect and must not be replaced by a file.
Result<> write_in_place(const fs::path& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.good()) return not_written(path, errno);
  if (const int error = write_all(file.get(), bytes)) return not_written(path, error);
  if (const int error = file.close()) return not_written(path, error);
  return {};
}

fs::path environment_folder(const char* name, const char* below_home) {
  if (const char* value = std::getenv(name); value && *value == '/') return value;
  const char* home = std::getenv("HOME");
  return home && *home == '/' ? fs::path(home) / below_home : fs::path();
}

}  // namespace

UserFolders UserFolders::standard() {
  const fs::path config = environment_folder("XDG_CONFIG_HOME", ".config");
  const fs::path state = environment_folder("XDG_STATE_HOME", ".local/state");
  if (config.empty() || state.empty()) return none();
  return {config / "handwheel", state / "handwheel", true};
}

UserFolders UserFolders::below(const fs::path& folder) { return {folder / "config", folder / "state", true}; }

int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

std::string reason_of(int error_number) {
  switch (error_number) {
    case ENOSPC: return "the disk is full";
    case EDQUOT: return "your disk quota is used up";
    case EFBIG: return "the file would be larger than is allowed there";
    case EACCES:
    case EPERM: return "you have no permission";
    case EROFS: return "the disk is read-only";
    case ENOENT: return "there is no such folder";
    case EISDIR: return "it is a folder";
    case ENOTDIR: return "part of the path is not a folder";
    case ENAMETOOLONG: return "the name is too long";
    case EIO: return "the disk reports an error";
    default: return std::strerror(error_number);
  }
}

Result<std::string> read_file(const fs::path& path, std::uintmax_t largest) {
  const std::string name = shown_path(path.filename().string());
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.good()) {
    if (errno == ENOENT)
      return fail(FaultKind::port, fmt::format("There is no file {}.", shown_path(path.string())), {},
                  "Check the name and the folder.");
    return fail(FaultKind::port, fmt::format("{} cannot be read: {}.", name, reason_of(errno)));
  }
  struct stat about {};
  if (::fstat(file.get(), &about) != 0)
    return fail(FaultKind::port, fmt::format("{} cannot be read: {}.", name, reason_of(errno)));
  if (S_ISDIR(about.st_mode)) return fail(FaultKind::port, fmt::format("{} is a folder.", name));
  const auto too_large = [&] {
    return fail(
        FaultKind::text,
        fmt::format("{} is larger than {} kB, which is too large for such a file.", name, largest / 1000),
        "It was not opened.");
  };
  if (S_ISREG(about.st_mode) && static_cast<std::uintmax_t>(about.st_size) > largest) return too_large();
  std::string bytes;
  char block[16384];
  for (;;) {
    const ssize_t n = ::read(file.get(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return fail(FaultKind::port, fmt::format("{} cannot be read: {}.", name, reason_of(errno)));
    if (n == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(n));
    if (bytes.size() > largest) return too_large();
  }
}

namespace {

/// Default permissions for a new file, unchanged ones for an existing file.
mode_t usual_mode(const fs::path& target) {
  struct stat old {};
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return ::stat(target.c_str(), &old) == 0 ? old.st_mode & 07777 : 0666 & ~mask;
}

enum class Readable : std::uint8_t { as_usual, by_owner };

Result<> write_whole(const fs::path& path, std::string_view bytes, Readable readable) {
  std::error_code ignored;
  fs::path target = fs::canonical(path, ignored);  // resolves links
  if (target.empty()) target = path;
  if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored)) {
    if (fs::is_directory(target, ignored)) return not_written(path, EISDIR);
    return write_in_place(path, bytes);
  }
  std::string beside =
      (target.parent_path() / fmt::format(".{}.XXXXXX", target.filename().string())).string();
  Descriptor file(::mkostemp(beside.data(), O_CLOEXEC));
  if (!file.good()) return not_written(path, errno);
  // mkostemp() has created it for the owner only.
  if (readable == Readable::as_usual) ::fchmod(file.get(), usual_mode(target));
  int error = write_all(file.get(), bytes);
  if (!error && ::fsync(file.get()) != 0) error = errno;
  if (const int at_close = file.close(); !error) error = at_close;
  if (!error && ::rename(beside.c_str(), target.c_str()) != 0) error = errno;
  if (!error) return {};
  ::unlink(beside.c_str());
  return not_written(path, error);
}

void make_missing_folders(const fs::path& folder) {
  std::error_code ignored;
  if (folder.empty() || fs::exists(folder, ignored)) return;
  make_missing_folders(folder.parent_path());
  ::mkdir(folder.c_str(), 0700);
}

}  // namespace

Result<> write_file(const fs::path& path, std::string_view bytes) {
  return write_whole(path, bytes, Readable::as_usual);
}

Result<> write_private_file(const fs::path& path, std::string_view bytes) {
  return write_whole(path, bytes, Readable::by_owner);
}

void make_private_folder(const fs::path& folder) {
  make_missing_folders(folder);
  ::chmod(folder.c_str(), 0700);
}

fs::path set_aside(const fs::path& path, std::string_view ending) {
  std::error_code error;
  for (int n = 0; n < 100; ++n) {
    fs::path aside = path;
    aside += n == 0 ? std::string(ending) : fmt::format("{}-{}", ending, n);
    if (fs::exists(aside, error)) continue;
    fs::rename(path, aside, error);
    if (error) return {};
    ::chmod(aside.c_str(), 0600);  // it may have come from elsewhere, open to others
    return aside;
  }
  return {};
}

std::string file_name_for(std::string_view key) {
  std::string name;
  std::uint32_t hash = 2166136261u;  // FNV-1a: different keys with the same readable part differ here
  for (const char c : key) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_';
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  if (name.size() > 60) name.resize(60);
  return fmt::format("{}{}{:08x}", name, name.empty() || name.back() == '-' ? "" : "-", hash);
}

}  // namespace hw
