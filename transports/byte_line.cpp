#include "transports/byte_line.h"

#include <cstdint>

namespace hw {
namespace {

// The level of a line on which one byte was sent from t = 0, in units of 1/(sender * receiver) seconds.
struct Waveform {
  unsigned frame;    // start bit, data from bit 0, stop bit
  std::int64_t bit;  // length of a sender's bit

  [[nodiscard]] bool high_at(std::int64_t t) const {
    const std::int64_t n = t / bit;
    return n >= 10 || ((frame >> n) & 1u) != 0;
  }
  // Start of the first low bit that begins at or after `t` behind a high one; negative: none.
  [[nodiscard]] std::int64_t next_fall(std::int64_t t) const {
    for (std::int64_t n = (t + bit - 1) / bit; n < 10; ++n)
      if (!high_at(n * bit) && (n == 0 || high_at(n * bit - 1))) return n * bit;
    return -1;
  }
};

}  // namespace

std::string misread(unsigned char byte, int sender_baud, int receiver_baud) {
  const Waveform sent{(unsigned{byte} << 1) | 0x200u, 2 * receiver_baud};
  const std::int64_t half = sender_baud, bit = 2 * half;  // the receiver's
  std::string got;
  for (std::int64_t fall = sent.next_fall(0); fall >= 0;) {
    unsigned value = 0;
    for (int i = 0; i < 8; ++i)
      value |= static_cast<unsigned>(sent.high_at(fall + bit + half + i * bit)) << i;
    got += static_cast<char>(value);
    fall = sent.next_fall(fall + 9 * bit + half);
  }
  return got;
}

void ByteLine::put(std::string_view bytes, int sender_baud, Instant now, int line_baud) {
  if (queue_.empty() && !bytes.empty()) due_ = now + byte_time(line_baud);
  for (const char value : bytes.substr(0, longest_queue - queue_.size()))
    queue_.push_back({value, sender_baud});
}

}  // namespace hw
