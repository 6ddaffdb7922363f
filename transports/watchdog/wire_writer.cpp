#include "transports/watchdog/wire_writer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <endian.h>
#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

namespace hw::watchdog {
namespace {

constexpr int patience_ms = 200;

bool becomes_writable(int fd) {
  pollfd wait{fd, POLLOUT, 0};
  return ::poll(&wait, 1, patience_ms) == 1 && (wait.revents & POLLOUT) != 0;
}

void write_bytes(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t n = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n < 0 && errno == ENOTSOCK) n = ::write(fd, bytes.data(), bytes.size());
    if (n > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
      continue;
    }
    if (n < 0 && errno == EINTR) continue;
    if (n == 0 || (errno != EAGAIN && errno != EWOULDBLOCK) || !becomes_writable(fd)) return;
  }
}

void transfer(int fd, std::string_view bytes) {
  std::array<char, usb_transfer> data{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), data.size() - 1), data.begin());
  usbdevfs_bulktransfer bulk{usb_endpoint_out, data.size(), patience_ms, data.data()};
  ::ioctl(fd, USBDEVFS_BULK, &bulk);
}

void dial(const std::string& place, std::string_view bytes) {
  sockaddr_storage peer{};
  if (place.size() > sizeof peer) return;
  std::memcpy(&peer, place.data(), place.size());
  const int fd = ::socket(peer.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (fd < 0) return;
  const int connected =
      ::connect(fd, reinterpret_cast<const sockaddr*>(&peer), static_cast<socklen_t>(place.size()));
  if (connected == 0 || (errno == EINPROGRESS && becomes_writable(fd))) write_bytes(fd, bytes);
  ::close(fd);
}

void store(volatile std::uint8_t* at, std::string_view value) {
  if (value.size() == 1) {
    *at = static_cast<std::uint8_t>(value.front());
    return;
  }
  for (std::size_t i = 0; i + 1 < value.size(); i += 2) {
    std::uint16_t word = 0;
    std::memcpy(&word, value.data() + i, sizeof word);  // big-endian here and there
    *reinterpret_cast<volatile std::uint16_t*>(at + i) = word;
  }
}

// Bus port messages: op, offset, value. A will has no reads.
void run_cycles(int fd, std::uint32_t base, std::string_view messages) {
  void* memory = ::mmap(nullptr, window_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd, base);
  if (memory == MAP_FAILED) return;
  auto* window = static_cast<volatile std::uint8_t*>(memory);
  while (messages.size() > 3) {
    const std::size_t width = static_cast<unsigned char>(messages[0]) & 0x7Fu;
    const std::size_t offset = static_cast<std::size_t>(static_cast<unsigned char>(messages[1])) << 8 |
                               static_cast<unsigned char>(messages[2]);
    const bool whole = messages.size() >= 3 + width;
    const bool fits = width >= 1 && width <= 4 && offset + width <= window_bytes;
    if (!whole || !fits || (width > 1 && offset % 2 != 0)) break;
    store(window + offset, messages.substr(3, width));
    messages.remove_prefix(3 + width);
  }
  ::munmap(memory, window_bytes);
}

}  // namespace

void write_to_wire(const Message& will, int fd, std::string_view bytes) {
  using How = WireShare::How;
  switch (will.how) {
    case How::none: return;
    case How::bytes: return write_bytes(fd, bytes);
    case How::messages: return transfer(fd, bytes);
    case How::dial: return dial(will.place, bytes);
    case How::memory: return run_cycles(fd, will.base, bytes);
  }
}

}  // namespace hw::watchdog
