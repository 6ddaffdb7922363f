#pragma once
// The newest value from one writer thread to one reader thread. No lock, no allocation; the reader never
// waits and keeps its view until it asks again. (A triple buffer: one slot each for writer, reader,
// exchange.)
#include <array>
#include <atomic>
#include <cstdint>

namespace hw {

template <class T>
class Latest {
 public:
  /// Writer thread.
  void publish(const T& value) {
    slots_[back_] = value;
    back_ = middle_.exchange(back_ | fresh, std::memory_order_acq_rel) & index_mask;
  }
  /// Reader thread: the newest value published so far. Valid until the next call.
  const T& view() {
    if (middle_.load(std::memory_order_acquire) & fresh)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & index_mask;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t fresh = 0x80, index_mask = 0x03;
  std::array<T, 3> slots_{};
  std::uint8_t back_ = 0;
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t front_ = 2;
};

}  // namespace hw
