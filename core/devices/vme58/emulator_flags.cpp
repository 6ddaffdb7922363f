#include "core/devices/vme58/emulator_flags.h"

#include <utility>

namespace hw::vme58 {

void Flags::request(std::uint8_t enable) {
  if ((control_ & control::interrupts) == 0 || (control_ & enable) == 0) return;
  interrupted_ = requested_ = true;
}

void Flags::set_done(unsigned axes) {
  done_ |= axes, done_letters_ |= axes;
  if (axes != 0) request(control::done_interrupt);
}

void Flags::set_slip(unsigned axes, unsigned interrupts) {
  const unsigned fresh = axes & ~slip_;
  slip_ |= axes;
  slip_interrupts_ |= axes & interrupts;
  if ((fresh & interrupts) != 0) request(control::slip_interrupt | control::done_interrupt);
}

void Flags::hit_limit(unsigned axes) {
  const unsigned fresh = axes & ~limits_hit_;
  limits_hit_ |= axes;
  if (fresh != 0) request(control::limit_interrupt);
}

void Flags::input_fell() { request(control::io_interrupt); }

void Flags::clear_all() {
  done_ = done_letters_ = slip_ = slip_interrupts_ = 0;
  command_error_ = false;
}

void Flags::set_control(std::uint8_t value) {
  const bool opened = (value & control::interrupts) != 0 && (control_ & control::interrupts) == 0;
  const auto fresh = static_cast<std::uint8_t>(opened ? value : value & ~control_);
  control_ = value;
  if (done_ != 0) request(fresh & control::done_interrupt);
  if (limits_hit_ != 0) request(fresh & control::limit_interrupt);
  if (slip_interrupts_ != 0) request(fresh & (control::slip_interrupt | control::done_interrupt));
}

std::uint8_t Flags::read_status(bool initialized) {
  std::uint8_t s = 0;
  if (std::exchange(command_error_, false)) s |= status::command_error;
  if (initialized) s |= status::initialized;
  if (slip_ != 0) s |= status::slip;
  if (limits() != 0) s |= status::overtravel;
  if (done_ != 0) s |= status::done;
  if ((control_ & control::interrupt_board) != 0) s |= status::board_interrupted;
  if (std::exchange(interrupted_, false)) s |= status::interrupt;
  requested_ = false;
  return s;
}

std::uint8_t Flags::read_slip() {
  slip_interrupts_ = 0;
  return static_cast<std::uint8_t>(std::exchange(slip_, 0u));
}

std::uint8_t Flags::read_done() { return static_cast<std::uint8_t>(std::exchange(done_, 0u)); }

std::uint8_t Flags::read_limit() {
  const std::uint8_t value = limits();
  limits_hit_ &= limits_live_;
  return value;
}

std::optional<std::uint8_t> Flags::interrupt() const {
  if (!requested_) return std::nullopt;
  return vector;
}

}  // namespace hw::vme58
