#include "transports/fd_stream.h"

#include <array>
#include <boost/asio/posix/basic_stream_descriptor.hpp>
#include <cerrno>

#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

namespace hw {
namespace {
constexpr std::size_t longest_backlog = 1 << 20;
}

struct FdStream::Io : std::enable_shared_from_this<Io> {
  FdStream* owner;  // null when the stream was destroyed
  asio::posix::basic_stream_descriptor<Executor> descriptor;
  Kind kind;
  bool reading = false, waiting_to_write = false, ending = false;
  std::string backlog;
  std::size_t backlog_sent = 0;
  std::array<char, 16384> buffer;

  Io(FdStream* o, Executor executor, int fd, Kind k) : owner(o), descriptor(executor, fd), kind(k) {
    boost::system::error_code ignored;
    descriptor.non_blocking(true, ignored);
  }

  void read() {
    reading = true;
    descriptor.async_read_some(asio::buffer(buffer), [self = shared_from_this()](auto error, std::size_t n) {
      self->reading = false;
      if (!self->owner) return;
      if (error) return self->owner->read_failed(error == asio::error::eof ? 0 : error.value());
      self->owner->received(std::string_view(self->buffer.data(), n));
      if (self->owner) self->read_soon();
    });
  }

  // Reading is posted behind the work that these bytes have started, so that the next text is sent before the
  // kernel is asked for more bytes.
  void read_soon() {
    if (std::exchange(reading, true)) return;
    asio::post(descriptor.get_executor(), [self = shared_from_this()] {
      self->reading = false;
      if (self->owner && self->descriptor.is_open()) self->read();
    });
  }

  // Returns the number of bytes that the kernel took; negative: an errno.
  ssize_t write_now(std::string_view bytes) {
    for (;;) {
      const int fd = descriptor.native_handle();
      const ssize_t n = kind == Kind::socket
                            ? ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT)
                            : ::write(fd, bytes.data(), bytes.size());
      if (n >= 0) return n;
      if (errno == EAGAIN || errno == EWOULDBLOCK) return 0;
      if (errno != EINTR) return -errno;
    }
  }

  void wait_to_write() {
    waiting_to_write = true;
    descriptor.async_wait(asio::posix::descriptor_base::wait_write, [self = shared_from_this()](auto error) {
      self->waiting_to_write = false;
      if (self->owner && !error) self->write_backlog();
    });
  }
  void write_backlog() {
    const ssize_t n = write_now(std::string_view(backlog).substr(backlog_sent));
    if (n < 0 && !owner->survives(static_cast<int>(-n)))
      return owner->end(owner->why_ended(static_cast<int>(-n)));
    if (n >= 0) {
      backlog_sent += static_cast<std::size_t>(n);
      if (backlog_sent < backlog.size()) return wait_to_write();
    }
    backlog.clear();
    backlog_sent = 0;
  }
};

FdStream::FdStream(Scheduler& scheduler, int fd, Kind kind, WhenFull when_full)
    : scheduler_(scheduler),
      kind_(kind),
      when_full_(when_full),
      io_(std::make_shared<Io>(this, scheduler.executor(), fd, kind)) {}

FdStream::~FdStream() {
  io_->owner = nullptr;
  boost::system::error_code ignored;
  io_->descriptor.close(ignored);
}

int FdStream::fd() const { return io_->descriptor.is_open() ? io_->descriptor.native_handle() : -1; }

void FdStream::listen(Listener* listener) {
  listener_ = listener;
  if (listener) read_on();
}

void FdStream::read_on() {
  if (listener_ && io_->descriptor.is_open() && !io_->reading) io_->read();
}

void FdStream::read_failed(int error) {
  if (!survives(error)) return end(why_ended(error));
  reading_stopped();
}

void FdStream::replace(int fd) {
  io_->owner = nullptr;
  boost::system::error_code ignored;
  io_->descriptor.close(ignored);
  io_ = std::make_shared<Io>(this, scheduler_.executor(), fd, kind_);
}

void FdStream::send(std::string_view bytes) {
  if (bytes.empty() || io_->ending || !io_->descriptor.is_open()) return;
  if (io_->backlog.empty()) {
    const ssize_t n = io_->write_now(bytes);
    if (n < 0) {
      if (!survives(static_cast<int>(-n))) end_soon(why_ended(static_cast<int>(-n)));
      return;
    }
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  if (bytes.empty()) return;
  if (io_->backlog.size() - io_->backlog_sent + bytes.size() > longest_backlog) {
    if (when_full_ == WhenFull::close)
      end_soon(Fault(FaultKind::lost, describe() + ": the other side has stopped reading.",
                     "The connection was closed."));
    return;
  }
  io_->backlog += bytes;
  if (!io_->waiting_to_write) io_->wait_to_write();
}

void FdStream::discard_unsent() {
  io_->backlog.clear();
  io_->backlog_sent = 0;
  if (!io_->descriptor.is_open()) return;
  if (kind_ == Kind::tty) {
    ::tcflush(fd(), TCOFLUSH);
    return;
  }
  const linger at_once{1, 0};  // otherwise the kernel retries for minutes
  ::setsockopt(fd(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

void FdStream::end_soon(Fault why) {
  if (std::exchange(io_->ending, true)) return;
  asio::post(scheduler_.executor(), [io = io_, why = std::move(why)] {
    if (io->owner) io->owner->end(why);
  });
}

void FdStream::end(const Fault& why) {
  if (!io_->descriptor.is_open()) return;
  boost::system::error_code ignored;
  io_->descriptor.close(ignored);
  if (listener_) listener_->stream_closed(why);
}

}  // namespace hw
