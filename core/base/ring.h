#pragma once
// A bounded queue from one writer thread to one reader thread for items that must not be lost silently:
// traffic, events. When it is full the newest item is dropped and counted, so that the reader knows how many
// are missing; nothing blocks.
#include <atomic>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace hw {

template <class T>
class Ring {
 public:
  explicit Ring(std::size_t capacity) : slots_(std::bit_ceil(capacity)) {}

  /// Writer thread. False: the reader is behind, the item was dropped and counted.
  bool push(T item) {
    const auto tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) == slots_.size()) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    slots_[tail & (slots_.size() - 1)] = std::move(item);
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }
  /// The same without a copy: `fill` writes into the slot and reuses its memory. `left_for_others`: how many
  /// places this item must leave free.
  template <class Fill>
  bool push_in_place(Fill&& fill, std::size_t left_for_others = 0) {
    const auto tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) >= slots_.size() - left_for_others) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    fill(slots_[tail & (slots_.size() - 1)]);
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }
  /// Reader thread: hands each waiting item, oldest first, to `take`.
  template <class Take>
  std::size_t drain(Take&& take) {
    const auto tail = tail_.load(std::memory_order_acquire);
    auto head = head_.load(std::memory_order_relaxed);
    const std::size_t n = tail - head;
    for (; head != tail; ++head) {
      take(slots_[head & (slots_.size() - 1)]);
      head_.store(head + 1, std::memory_order_release);
    }
    return n;
  }
  [[nodiscard]] std::size_t capacity() const { return slots_.size(); }
  [[nodiscard]] bool empty() const {
    return head_.load(std::memory_order_acquire) == tail_.load(std::memory_order_acquire);
  }
  [[nodiscard]] std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  std::vector<T> slots_;
  alignas(64) std::atomic<std::uint64_t> head_{0};
  alignas(64) std::atomic<std::uint64_t> tail_{0};
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace hw
