#pragma once
// General purpose lines and auxiliary outputs. A line is low while the bench (inputs) or the board (outputs)
// pulls it down; an auxiliary output is high while its transistor is off.
#include <cstdint>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

class UserIo {
 public:
  /// `outputs`: bit n is set if line n is an output (jumpers).
  explicit UserIo(std::uint16_t outputs) : outputs_(outputs) {}

  void reset() { low_ = 0, aux_high_ = 0xFF; }

  [[nodiscard]] std::uint16_t outputs() const { return outputs_; }
  [[nodiscard]] bool is_output(int line) const { return (outputs_ >> line & 1u) != 0; }
  /// BL, BH.
  void drive(int line, bool low) { set(low_, line, low); }
  void pull(int line, bool low) { set(pulled_, line, low); }
  [[nodiscard]] std::uint16_t pulled() const { return pulled_; }

  /// Bit n: line n is high.
  [[nodiscard]] std::uint16_t levels() const {
    constexpr unsigned all = (1u << io_lines) - 1;
    const unsigned low = (outputs_ & low_) | (~unsigned{outputs_} & pulled_);
    return static_cast<std::uint16_t>(all & ~low);
  }
  /// True in the sense of WS and SW (decision M36).
  [[nodiscard]] bool is_true(int line) const { return (levels() >> line & 1u) == 0; }

  void set_aux(unsigned axes, bool high) { aux_high_ = high ? aux_high_ | axes : aux_high_ & ~axes; }
  [[nodiscard]] unsigned aux_high() const { return aux_high_; }
  /// Bit n: output line n is on (low).
  [[nodiscard]] unsigned lines_on() const { return unsigned{outputs_} & low_; }

 private:
  static void set(std::uint16_t& bits, int line, bool on) {
    const auto bit = static_cast<std::uint16_t>(1u << line);
    bits = static_cast<std::uint16_t>(on ? bits | bit : bits & ~bit);
  }
  std::uint16_t outputs_;
  std::uint16_t low_ = 0, pulled_ = 0;
  unsigned aux_high_ = 0xFF;
};

}  // namespace hw::vme58
