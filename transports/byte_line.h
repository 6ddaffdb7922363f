#pragma once
// One direction of a serial line with its timing: ten bit times a byte (start, eight data bits, stop).
#include <deque>
#include <string>
#include <string_view>

#include "core/time/clock.h"

namespace hw {

/// The time of a byte; 0 without a rate.
constexpr Duration byte_time(int baud) { return baud > 0 ? Duration(10'000'000'000LL / baud) : Duration{}; }

/// The bytes that a receiver reads from a byte sent at another rate, framing errors included. Neither rate is
/// 0.
std::string misread(unsigned char byte, int sender_baud, int receiver_baud);

/// The bytes received when two devices send at once. The second device begins a little later, and a low level
/// wins.
std::string collided(std::string_view first, std::string_view second);

class ByteLine {
 public:
  struct Byte {
    char value;
    int sender_baud;  ///< 0: the sender has no rate, so it fits any
  };

  /// Appends bytes to the line. The rate of the line at the beginning of each byte applies, not the present
  /// rate.
  void put(std::string_view bytes, int sender_baud, Instant now, int line_baud);
  [[nodiscard]] bool empty() const { return queue_.empty(); }
  /// The arrival of the last bit of the first byte; Instant::max() on an idle line.
  [[nodiscard]] Instant due() const { return queue_.empty() ? Instant::max() : due_; }
  [[nodiscard]] Byte first() const { return queue_.front(); }
  /// Removes the first byte. The next byte begins at its end.
  void pop(int line_baud) {
    queue_.pop_front();
    due_ += byte_time(line_baud);
  }
  void clear() { queue_.clear(); }

 private:
  static constexpr std::size_t longest_queue =
      1 << 20;  // bytes beyond it are lost, if a sender ignores the rate
  std::deque<Byte> queue_;
  Instant due_{};
};

}  // namespace hw
