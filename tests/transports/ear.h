#pragma once
// Hears a stream in a test.
#include <vector>

#include "core/link/stream.h"
#include "core/time/real_scheduler.h"
#include "core/time/virtual_scheduler.h"

namespace hw::test {

struct Ear final : Stream::Listener {
  std::string received;
  std::vector<Instant> times;  ///< one per byte
  std::optional<Fault> closed;
  std::function<void()> on_bytes, on_close;
  Scheduler* scheduler = nullptr;

  Ear() = default;
  explicit Ear(Stream& stream, Scheduler* clock = nullptr) : scheduler(clock) { stream.listen(this); }

  void bytes_arrived(std::string_view bytes) override {
    received += bytes;
    if (scheduler) times.insert(times.end(), bytes.size(), scheduler->now());
    if (on_bytes) on_bytes();
  }
  void stream_closed(const Fault& why) override {
    closed = why;
    if (on_close) on_close();
  }
};

/// Runs real I/O until `done`, at most two seconds.
template <class Done>
bool poll_until(IoContext& io, Done done, Millis patience = Millis(2000)) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) return false;
    io.restart();
    io.run_one_for(Millis(20));
  }
  return true;
}

/// Runs a task to its end on real I/O. Aborts the test program when it does not end.
template <class T>
T run_task(IoContext& io, Task<T> task, Millis patience = Millis(10000)) {
  std::optional<T> result;
  std::exception_ptr thrown;
  auto finished = [&](std::exception_ptr error, T value) {
    thrown = error;
    result.emplace(std::move(value));
  };
  asio::co_spawn(io.get_executor(), std::move(task), finished);
  const bool ended = poll_until(
      io, [&] { return result.has_value(); }, patience);
  if (thrown) std::rethrow_exception(thrown);
  if (!ended) std::abort();
  return std::move(*result);
}

}  // namespace hw::test
