#include "transports/serial.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/core.h>
#include <grp.h>
#include <linux/serial.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include "transports/fd_stream.h"
#include "transports/gone.h"
#include "transports/port_holder.h"
#include "transports/tty.h"

namespace hw {
namespace {

struct Refused {
  PortRefusal refusal;
  Fault fault;
};

Refused refused(PortRefusal refusal, std::string what, std::string advice) {
  return {refusal, Fault(FaultKind::port, std::move(what), "Nothing was sent.", std::move(advice))};
}

Refused missing(const std::string& path) {
  return refused(PortRefusal::missing, fmt::format("There is no port {}.", path),
                 "Plug the adapter in; `handwheel scan` lists the existing ports.");
}

Refused busy(const std::string& path) {
  const std::string holder = port_holder(path);
  return refused(PortRefusal::busy,
                 holder.empty() ? fmt::format("{} is in use by another program.", path)
                                : fmt::format("{} is in use: {} holds it.", path, holder),
                 "Close the port there, then open it again.");
}

std::string group_of(const std::string& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return "dialout";
  const group* owner = ::getgrgid(there.st_gid);
  return owner ? owner->gr_name : std::to_string(there.st_gid);
}

/// Whether joining the file's group helps. Users do not join root's group, and a group without rights does
/// not help.
bool group_helps(const std::string& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return true;
  constexpr mode_t both = S_IRGRP | S_IWGRP;
  return there.st_gid != 0 && (there.st_mode & both) == both;
}

Refused not_permitted(const std::string& path) {
  if (!group_helps(path))
    return refused(
        PortRefusal::not_permitted, fmt::format("{} cannot be opened: only its owner may use it.", path),
        fmt::format("Run `sudo chgrp dialout {0} && sudo chmod g+rw {0}` as a member of dialout. A "
                    "udev rule makes that last.",
                    path));
  const passwd* self = ::getpwuid(::geteuid());
  const std::string user = self ? self->pw_name : "$USER", group = group_of(path);
  return refused(PortRefusal::not_permitted,
                 fmt::format("{} cannot be opened: it belongs to the group {}, and {} is not a member.", path,
                             group, user),
                 fmt::format("Run `sudo usermod -aG {} {}`, then log out and in again.", group, user));
}

Refused not_serial(const std::string& path) {
  return refused(PortRefusal::not_serial, fmt::format("{} is not a serial port.", path),
                 "Serial ports are called /dev/ttyUSB0, /dev/ttyACM0 or /dev/ttyS0, for example.");
}

Refused other(const std::string& path, int error) {
  const bool no_hardware = error == EIO || error == ENXIO || error == ENODEV;
  return refused(PortRefusal::other,
                 no_hardware ? fmt::format("{} has a name but no hardware behind it.", path)
                             : fmt::format("{} cannot be opened: {}.", path, std::strerror(error)),
                 "Choose another port; `handwheel scan` lists the existing ones.");
}

Refused why_port_not_opened(const std::string& path, int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR: return missing(path);
    case EBUSY: return busy(path);
    case EACCES:
    case EPERM: return not_permitted(path);
    case EISDIR: return not_serial(path);
    default: return other(path, error);
  }
}

// Whether a program holds the port by TIOCEXCL without a lock, which would not stop root. (Not checked on a
// pseudo-terminal, which may keep that mode after its client has gone.)
bool taken_exclusively(int fd, const std::string& path) {
  int exclusive = 0;
  char real[512];
  const bool pty = ::ttyname_r(fd, real, sizeof real) == 0 && std::string_view(real).starts_with("/dev/pts/");
  return !pty && ::ioctl(fd, TIOCGEXCL, &exclusive) == 0 && exclusive != 0 && !port_holder(path).empty();
}

// USB adapters delay bytes by up to 16 ms unless asked not to. Not all drivers support it, so a failure is
// ignored.
void ask_for_low_latency(int fd) {
  serial_struct settings{};
  if (::ioctl(fd, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  ::ioctl(fd, TIOCSSERIAL, &settings);
}

Result<> apply_rate(int fd, const std::string& path, int baud, int when) {
  const auto speed = speed_constant(baud);
  if (!speed)
    return fail(FaultKind::port, fmt::format("{} baud is not a rate of serial ports.", baud),
                "The rate was not changed.", "Use 9600, 19200, 38400, 57600 or 115200.");
  termios settings{}, got{};
  const auto no = [&] {
    return fail(FaultKind::port, fmt::format("{} cannot be set to {} baud.", path, baud),
                "The rate was not changed.", "Try another rate or another adapter.");
  };
  if (::tcgetattr(fd, &settings) != 0) return no();
  make_raw_8n1(settings);
  ::cfsetspeed(&settings, *speed);
  if (::tcsetattr(fd, when, &settings) != 0 || ::tcgetattr(fd, &got) != 0) return no();
  if (::cfgetospeed(&got) != *speed) return no();
  return {};
}

class SerialStream final : public FdStream {
 public:
  SerialStream(Scheduler& scheduler, int fd, std::string path, int baud)
      : FdStream(scheduler, fd, Kind::tty), path_(std::move(path)), baud_(baud) {}
  ~SerialStream() override {
    if (fd() < 0) return;
    ::ioctl(fd(), TIOCNXCL);
    ::tcflush(fd(), TCIFLUSH);
  }

  // Bytes still in the kernel are sent at the old rate first. They are few, because only one transaction is
  // in flight.
  Result<> set_rate(int baud) override {
    if (fd() < 0) return fail(why_ended(EIO));
    int waiting = 0;
    const bool idle = ::ioctl(fd(), TIOCOUTQ, &waiting) == 0 && waiting == 0;
    auto set = apply_rate(fd(), path_, baud, idle ? TCSANOW : TCSADRAIN);
    if (set) baud_ = baud;
    return set;
  }
  [[nodiscard]] int rate() const override { return baud_; }
  [[nodiscard]] std::string describe() const override { return fmt::format("{}, {} baud", path_, baud_); }

 private:
  [[nodiscard]] Fault why_ended(int error) const override {
    const bool pulled = error == 0 || error == EIO || error == ENXIO || error == ENODEV;
    return gone(pulled ? fmt::format("{} is gone: the cable was pulled or the adapter switched off.", path_)
                       : fmt::format("{} failed: {}.", path_, std::strerror(error)),
                "Plug it in again. The console then opens it again.");
  }

  std::string path_;
  int baud_;
};

tl::expected<int, Refused> open_exclusively(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) return tl::unexpected(why_port_not_opened(path, errno));
  const auto refuse = [fd](Refused why) {
    ::close(fd);
    return tl::unexpected(std::move(why));
  };
  if (!::isatty(fd)) return refuse(errno == EIO ? other(path, EIO) : not_serial(path));
  if (taken_exclusively(fd, path))
    return refuse(busy(path));  // before we lock it, because our lock would look like a holder
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) return refuse(busy(path));
  ::ioctl(fd, TIOCEXCL);
  return fd;
}

}  // namespace

Result<std::unique_ptr<Stream>> open_serial(Scheduler& scheduler, const std::string& path, int baud,
                                            PortRefusal* refusal) {
  PortRefusal ignored;
  PortRefusal& result = refusal ? *refusal : ignored;
  result = PortRefusal::none;
  const auto fd = open_exclusively(path);
  if (!fd) {
    result = fd.error().refusal;
    return fail(fd.error().fault);
  }
  auto stream = std::make_unique<SerialStream>(scheduler, *fd, path, baud);
  if (auto set = apply_rate(*fd, path, baud, TCSANOW); !set) {
    result = PortRefusal::other;
    return fail(set.error());
  }
  ask_for_low_latency(*fd);
  ::tcflush(*fd, TCIOFLUSH);  // earlier bytes are not replies to us
  return stream;
}

}  // namespace hw
