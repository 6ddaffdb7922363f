#pragma once
// The event registers of the host, and their interrupt (decisions M30 to M33).
#include <cstdint>
#include <optional>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

class Flags {
 public:
  // Events on the board. Axes as bits.
  void command_error() { command_error_ = true; }
  /// Interrupts the host each time, even if it has not read the previous flag.
  void set_done(unsigned axes);
  void clear_done(unsigned axes) { done_ &= ~axes, done_letters_ &= ~axes; }
  /// `interrupts`: those of the axes with IS in force (decision M93).
  void set_slip(unsigned axes, unsigned interrupts);
  void hit_limit(unsigned axes);
  /// The limit switches now operated.
  void set_limit_switches(unsigned axes) { limits_live_ = axes; }
  /// User input 0 or 1 went low.
  void input_fell();
  void clear_all();  ///< IC: done, slip and command error
  /// The `D` of RA, RI, QA and QI: a latch of its own, not cleared by reading the done register (decision
  /// M97).
  [[nodiscard]] unsigned done_letters() const { return done_letters_; }
  [[nodiscard]] unsigned slip() const { return slip_; }

  // The control register.
  [[nodiscard]] std::uint8_t control() const { return control_; }
  /// Enabling a source that is already pending interrupts the host.
  void set_control(std::uint8_t value);
  void clear_control(std::uint8_t bits) { control_ = static_cast<std::uint8_t>(control_ & ~bits); }

  // Reads by the host, with their side effects.
  std::uint8_t read_status(bool initialized);
  std::uint8_t read_slip();
  std::uint8_t read_done();
  /// Clears the bits of switches that are free again.
  std::uint8_t read_limit();

  [[nodiscard]] std::optional<std::uint8_t> interrupt() const;
  void acknowledge() { requested_ = false; }
  std::uint8_t vector = 0;

 private:
  /// Requests an interrupt if the sources of `enable` are enabled.
  void request(std::uint8_t enable);
  [[nodiscard]] std::uint8_t limits() const { return static_cast<std::uint8_t>(limits_live_ | limits_hit_); }

  std::uint8_t control_ = 0;
  unsigned done_ = 0, done_letters_ = 0, slip_ = 0, slip_interrupts_ = 0, limits_live_ = 0, limits_hit_ = 0;
  bool command_error_ = false;
  bool interrupted_ = false;  ///< status bit 7, until it is read
  bool requested_ = false;    ///< the line to the host, until the vector is fetched or the status read
};

}  // namespace hw::vme58
