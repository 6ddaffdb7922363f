#include "transports/byte_line.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hw {
namespace {

// The level of a line on which a byte was sent from t = 0, in units of 1/(sender * receiver) seconds.
struct Waveform {
  unsigned frame;    // start bit, data from bit 0, stop bit
  std::int64_t bit;  // length of a bit of the sender

  [[nodiscard]] bool high_at(std::int64_t t) const {
    const std::int64_t n = t / bit;
    return n >= 10 || ((frame >> n) & 1u) != 0;
  }
  // Start of the first low bit at or after `t` that follows a high level; negative: none.
  [[nodiscard]] std::int64_t next_fall(std::int64_t t) const {
    for (std::int64_t n = (t + bit - 1) / bit; n < 10; ++n)
      if (!high_at(n * bit) && (n == 0 || high_at(n * bit - 1))) return n * bit;
    return -1;
  }
};

// ---- two senders at once

constexpr std::size_t parts_of_bit = 10;
constexpr std::size_t behind = 24;  // delay of the second sender, in parts of a bit

std::size_t length(std::string_view bytes) { return bytes.size() * 10 * parts_of_bit; }

void pull_low(std::vector<bool>& low, std::string_view bytes, std::size_t from) {
  auto at = low.begin() + static_cast<std::ptrdiff_t>(from);
  for (const char c : bytes) {
    const unsigned frame = unsigned{static_cast<unsigned char>(c)} << 1 | 0x200u;
    for (int bit = 0; bit < 10; ++bit, at += parts_of_bit)
      if ((frame >> bit & 1u) == 0) std::fill(at, at + parts_of_bit, true);
  }
}

}  // namespace

std::string misread(unsigned char byte, int sender_baud, int receiver_baud) {
  const Waveform sent{(unsigned{byte} << 1) | 0x200u, 2 * receiver_baud};
  const std::int64_t half = sender_baud, bit = 2 * half;  // of the receiver
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

std::string collided(std::string_view first, std::string_view second) {
  constexpr std::size_t room = 20 * parts_of_bit;  // space for a late last frame
  std::vector<bool> low(std::max(length(first), length(second) + behind) + room);
  pull_low(low, first, 0);
  pull_low(low, second, behind);
  std::string got;
  for (std::size_t at = 0; at + room / 2 < low.size();) {
    const bool falls = low[at] && (at == 0 || !low[at - 1]);
    if (!falls) {
      ++at;
      continue;
    }
    unsigned value = 0;
    for (std::size_t i = 0; i < 8; ++i)
      value |= unsigned{!low[at + (i + 1) * parts_of_bit + parts_of_bit / 2]} << i;
    got += static_cast<char>(value);
    at += 9 * parts_of_bit + parts_of_bit / 2;
  }
  return got;
}

void ByteLine::put(std::string_view bytes, int sender_baud, Instant now, int line_baud) {
  if (queue_.empty() && !bytes.empty()) due_ = now + byte_time(line_baud);
  for (const char value : bytes.substr(0, longest_queue - queue_.size()))
    queue_.push_back({value, sender_baud});
}

}  // namespace hw
