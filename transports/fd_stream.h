#pragma once
// The base of all transports on a file descriptor. It always reads, into a fixed buffer. It writes at once,
// and queues only bytes that the kernel does not take. Neither allocates while the queue is empty.
#include <memory>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

class FdStream : public Stream {
 public:
  enum class Kind { tty, socket };
  /// What happens when the other side leaves a megabyte unread: the stream closes, or loses new bytes as a
  /// serial line does.
  enum class WhenFull { close, lose };

  ~FdStream() override;
  void listen(Listener* listener) final;
  void send(std::string_view bytes) override;
  void discard_unsent() final;
  [[nodiscard]] WireShare share() const override {
    const int open = fd();
    return open < 0 ? WireShare() : WireShare{WireShare::How::bytes, open, {}, 0};
  }

 protected:
  /// Takes ownership of `fd`. Reading begins with the first listener.
  FdStream(Scheduler& scheduler, int fd, Kind kind, WhenFull when_full = WhenFull::close);

  [[nodiscard]] Scheduler& scheduler() const { return scheduler_; }
  [[nodiscard]] int fd() const;  ///< -1 once closed
  /// Ends the stream as if the other side had closed it. The listener gets `why` from the io thread's loop.
  void end_soon(Fault why);
  /// Called with bytes from the descriptor. Pass the listener's bytes to deliver(), after which *this may no
  /// longer exist.
  virtual void received(std::string_view bytes) { deliver(bytes); }
  void deliver(std::string_view bytes) {
    if (listener_) listener_->bytes_arrived(bytes);
  }
  /// Whether the stream continues after this error. If so, unsent bytes are lost, and reading stops until
  /// read_on().
  [[nodiscard]] virtual bool survives(int error) const { return (void)error, false; }
  virtual void reading_stopped() {}
  void read_on();
  /// Continues with another descriptor.
  void replace(int fd);
  /// Why the stream ended. `error` is an errno; 0: the other side closed.
  [[nodiscard]] virtual Fault why_ended(int error) const = 0;

 private:
  struct Io;
  void end(const Fault& why);
  void read_failed(int error);

  Scheduler& scheduler_;
  Listener* listener_ = nullptr;
  Kind kind_;
  WhenFull when_full_;
  std::shared_ptr<Io> io_;  // outlives *this while an operation is under way
};

}  // namespace hw
