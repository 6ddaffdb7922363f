#include "transports/pty_endpoint.h"

#include <boost/asio/posix/basic_stream_descriptor.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "transports/fd_stream.h"
#include "transports/tty.h"

namespace hw {
namespace {

tl::unexpected<Fault> cannot(const std::string& link, const std::string& why, std::string advice = {}) {
  return fail(FaultKind::port, fmt::format("Cannot serve on {}: {}.", link, why), "Nothing is served there.",
              std::move(advice));
}

Result<> make_link(const std::string& terminal, const std::string& link) {
  struct stat there {};
  if (::lstat(link.c_str(), &there) == 0 && !S_ISLNK(there.st_mode))
    return cannot(link, "there is a file of that name", "Choose another path, or move the file away.");
  const std::string beside = fmt::format("{}.{}", link, ::getpid());
  ::unlink(beside.c_str());
  if (::symlink(terminal.c_str(), beside.c_str()) == 0) {
    if (::rename(beside.c_str(), link.c_str()) == 0) return {};
    ::unlink(beside.c_str());
  }
  return cannot(link, std::strerror(errno), "Choose a path in a folder that you may write to.");
}

struct Terminal {
  int master = -1;
  std::string name;
};

// Resets the terminal: no unread bytes, raw mode, `baud`, no exclusive mode of the last client.
bool make_as_new(const std::string& name, int baud) {
  const int slave = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (slave < 0) return false;
  termios settings{};
  bool done = ::tcgetattr(slave, &settings) == 0;
  make_raw_8n1(settings);
  if (const auto speed = speed_constant(baud)) ::cfsetspeed(&settings, *speed);
  done = done && ::tcsetattr(slave, TCSANOW, &settings) == 0;
  ::tcflush(slave, TCIFLUSH);
  ::ioctl(slave, TIOCNXCL);
  ::close(slave);
  return done;
}

Result<Terminal> make_terminal(const std::string& link, int baud) {
  Terminal made;
  made.master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  char name[128];
  const bool works = made.master >= 0 && ::grantpt(made.master) == 0 && ::unlockpt(made.master) == 0 &&
                     ::ptsname_r(made.master, name, sizeof name) == 0 && make_as_new(name, baud);
  if (!works) {
    const int error = errno;
    if (made.master >= 0) ::close(made.master);
    return cannot(link, fmt::format("the system gives no pseudo-terminal ({})", std::strerror(error)));
  }
  made.name = name;
  if (auto linked = make_link(made.name, link); !linked) {
    ::close(made.master);
    return fail(linked.error());
  }
  return made;
}

/// Notifies when a program opens the file.
class OpenNotice : public std::enable_shared_from_this<OpenNotice> {
 public:
  OpenNotice(Scheduler& scheduler, std::function<void()> opened)
      : notices_(scheduler.executor()), opened_(std::move(opened)) {
    if (const int fd = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC); fd >= 0) notices_.assign(fd);
  }
  /// Returns false when the system has no watch left.
  bool watch(const std::string& file) {
    if (!notices_.is_open()) return false;
    watch_ = ::inotify_add_watch(notices_.native_handle(), file.c_str(), IN_OPEN);
    if (watch_ >= 0 && !std::exchange(waiting_, true)) wait();
    return watch_ >= 0;
  }
  void unwatch() {
    if (watch_ >= 0) ::inotify_rm_watch(notices_.native_handle(), std::exchange(watch_, -1));
  }
  void stop() {
    opened_ = nullptr;
    boost::system::error_code ignored;
    notices_.close(ignored);
  }

 private:
  void wait() {
    notices_.async_wait(asio::posix::descriptor_base::wait_read, [self = shared_from_this()](auto error) {
      if (error || !self->opened_) return;
      self->take();
      if (self->opened_) self->wait();
    });
  }
  void take() {
    alignas(inotify_event) char notes[4096];
    bool opened = false;
    for (ssize_t size; (size = ::read(notices_.native_handle(), notes, sizeof notes)) > 0;)
      for (ssize_t at = 0; at < size;) {
        const auto& note = *reinterpret_cast<const inotify_event*>(notes + at);
        opened = opened || (note.mask & IN_OPEN) != 0;  // otherwise a watch has ended
        at += static_cast<ssize_t>(sizeof note + note.len);
      }
    if (opened) opened_();
  }

  asio::posix::basic_stream_descriptor<Executor> notices_;
  std::function<void()> opened_;
  int watch_ = -1;
  bool waiting_ = false;
};

// The kernel shows whether there is a client: without a client, the master reads EIO and is hung up. Bytes
// sent without a client are lost, as on a serial line, and reading stops until the next client opens the
// terminal.
class PtyEndpoint final : public FdStream {
 public:
  PtyEndpoint(Scheduler& scheduler, const Terminal& terminal, std::string link, int baud)
      : FdStream(scheduler, terminal.master, Kind::tty, WhenFull::lose),
        terminal_(terminal.name),
        link_(std::move(link)),
        baud_(baud),
        notice_(std::make_shared<OpenNotice>(scheduler, [this] { read_on(); })),
        look_again_(scheduler, [this] { read_on(); }) {}
  ~PtyEndpoint() override {
    notice_->stop();
    char target[256];
    const ssize_t n = ::readlink(link_.c_str(), target, sizeof target);
    if (n > 0 && terminal_ == std::string_view(target, static_cast<std::size_t>(n))) ::unlink(link_.c_str());
  }

  // Without this check Linux keeps bytes written without a client for the next client.
  void send(std::string_view bytes) override {
    if (!hung_up()) FdStream::send(bytes);
  }

  Result<> set_rate(int) override { return {}; }  // the client sets the rate
  [[nodiscard]] int rate() const override {
    termios settings{};  // on the master, Linux returns the client's settings
    return ::tcgetattr(fd(), &settings) == 0 ? baud_of(::cfgetospeed(&settings)) : 0;
  }
  [[nodiscard]] std::string describe() const override { return "pty:" + link_; }

 private:
  [[nodiscard]] bool survives(int error) const override { return error == EIO; }
  [[nodiscard]] Fault why_ended(int error) const override {
    return Fault(FaultKind::lost,
                 fmt::format("The pseudo-terminal {} failed ({}).", link_, std::strerror(error)));
  }
  void reading_stopped() override {
    if (!hung_up()) return read_on();  // the next client has opened it already: keep its settings
    notice_->unwatch();                // otherwise it would notice our own open
    if (!make_as_new(terminal_, baud_) && errno == EBUSY) renew();
    if (!notice_->watch(terminal_)) look_again_.arm(scheduler().now() + Millis(50));
    if (!hung_up()) read_on();
  }
  [[nodiscard]] bool hung_up() const {
    pollfd master{fd(), POLLIN, 0};
    ::poll(&master, 1, 0);
    return (master.revents & POLLHUP) != 0;
  }
  // Replaces a terminal that a client left in exclusive mode when it died. Otherwise only root could open it
  // again.
  void renew() {
    const auto fresh = make_terminal(link_, baud_);
    if (!fresh) return;
    terminal_ = fresh->name;
    replace(fresh->master);
  }

  std::string terminal_, link_;
  int baud_;
  std::shared_ptr<OpenNotice> notice_;
  Timer look_again_;  // polls when there is no notice
};

}  // namespace

Result<std::unique_ptr<Stream>> open_pty_endpoint(Scheduler& scheduler, const std::string& link, int baud) {
  const auto terminal = make_terminal(link, baud);
  if (!terminal) return fail(terminal.error());
  return std::make_unique<PtyEndpoint>(scheduler, *terminal, link, baud);
}

}  // namespace hw
