#pragma once
// One direction of a serial line that takes its time: ten bit times a byte (start, eight data bits, stop).
#include <deque>
#include <string>
#include <string_view>

#include "core/time/clock.h"

namespace hw {

/// 0 when there is no rate.
constexpr Duration byte_time(int baud) { return baud > 0 ? Duration(10'000'000'000LL / baud) : Duration{}; }

/// What a receiver at one rate makes of a byte sent at another: its samples of the sender's bits, framing
/// errors and all. Neither rate is 0.
std::string misread(unsigned char byte, int sender_baud, int receiver_baud);

/// What a receiver makes of a line on which two speak at once: the second begins a little later, and whoever
/// pulls the line low wins.
std::string collided(std::string_view first, std::string_view second);

class ByteLine {
 public:
  struct Byte {
    char value;
    int sender_baud;  ///< 0: the sender has no rate, so it fits any
  };

  /// Behind what is already on the line. The line's rate counts when a byte begins, not when it is put.
  void put(std::string_view bytes, int sender_baud, Instant now, int line_baud);
  [[nodiscard]] bool empty() const { return queue_.empty(); }
  /// When the last bit of the first byte arrives; Instant::max() on an idle line.
  [[nodiscard]] Instant due() const { return queue_.empty() ? Instant::max() : due_; }
  [[nodiscard]] Byte first() const { return queue_.front(); }
  /// Takes the first byte off; the next one begins where it ended.
  void pop(int line_baud) {
    queue_.pop_front();
    due_ += byte_time(line_baud);
  }
  void clear() { queue_.clear(); }

 private:
  static constexpr std::size_t longest_queue = 1 << 20;  // a sender that ignores the rate loses the rest
  std::deque<Byte> queue_;
  Instant due_{};
};

}  // namespace hw
