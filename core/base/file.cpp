#include "core/base/file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hw {
namespace {

tl::unexpected<Fault> cannot(const char* verb, const std::string& path, int error) {
  return fail(FaultKind::port, path + " cannot be " + verb + ": " + std::strerror(error) + ".");
}

Result<> write_all(int file, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const ssize_t n = ::write(file, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return cannot("written", path, errno);
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  if (::fsync(file) != 0 && errno != EINVAL) return cannot("written", path, errno);
  return {};
}

std::string behind_links(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (!real) return path;
  std::string target = real;
  std::free(real);
  return target;
}

void sync_folder(const std::string& path) {
  const auto slash = path.rfind('/');
  const std::string folder = slash == path.npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

}  // namespace

Result<std::string> read_text_file(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return cannot("opened", path, errno);
  std::string text;
  char part[16384];
  for (;;) {
    const ssize_t n = ::read(file, part, sizeof part);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      ::close(file);
      return cannot("read", path, error);
    }
    if (n == 0) break;
    text.append(part, static_cast<std::size_t>(n));
  }
  ::close(file);
  return text;
}

Result<> write_file_atomically(const std::string& path, std::string_view text) {
  const std::string target = behind_links(path);
  std::string beside = target + ".XXXXXX";
  const int file = ::mkostemp(beside.data(), O_CLOEXEC);
  if (file < 0) return cannot("written", path, errno);
  struct stat old {};
  const mode_t mode = ::stat(target.c_str(), &old) == 0 ? old.st_mode & 07777 : 0644;
  Result<> written = write_all(file, text, path);
  if (written) ::fchmod(file, mode);
  if (::close(file) != 0 && written) written = cannot("written", path, errno);
  if (written && ::rename(beside.c_str(), target.c_str()) != 0) written = cannot("written", path, errno);
  if (!written) {
    ::unlink(beside.c_str());
    return written;
  }
  sync_folder(target);
  return {};
}

}  // namespace hw
