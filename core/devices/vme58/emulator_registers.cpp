// The window as the bus sees it: memory, registers with their effects, the mailbox.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {
namespace {

constexpr Duration update_time = std::chrono::microseconds(900);  // hosts poll for its end
constexpr Duration mail_time = std::chrono::microseconds(50);     // until the cells are free again

constexpr std::uint8_t undriven_bus = 0xFF;

template <class N>
std::int32_t dpram_value(N v) {
  using Limits = std::numeric_limits<std::int32_t>;
  if constexpr (std::is_floating_point_v<N>)
    return static_cast<std::int32_t>(std::clamp(std::trunc(v), N{Limits::min()}, N{Limits::max()}));
  else
    return static_cast<std::int32_t>(std::clamp(v, N{Limits::min()}, N{Limits::max()}));
}

}  // namespace

std::uint8_t Board::read(std::uint16_t offset) {
  if (!powered_) return undriven_bus;
  if (offset < at::registers) return window_.read(offset);
  look_at_switches();
  switch (offset) {
    case reg::control: return flags_.control();
    case reg::status: return flags_.read_status(!boots_until_);
    case reg::io_low: return static_cast<std::uint8_t>(io_.levels());
    case reg::slip: return flags_.read_slip();
    case reg::done: return flags_.read_done();
    case reg::io_high: return static_cast<std::uint8_t>(io_.levels() >> 8);
    case reg::limit: return flags_.read_limit();
    case reg::home: {
      unsigned homes = 0;
      each_axis(fitted_, [&](int a) { homes |= unsigned{motion_.home_active(a)} << a; });
      return static_cast<std::uint8_t>(homes);
    }
    case reg::vector: return flags_.vector;
    default: return 0;
  }
}

void Board::write(std::uint16_t offset, std::uint8_t value) {
  if (!powered_) return;
  if (offset < at::registers) return window_.write(offset, value);
  if (boots_until_) return;
  if (offset == reg::control) set_control(value);
  if (offset == reg::vector) flags_.vector = value;
}

void Board::written(std::uint16_t offset) {
  constexpr std::uint16_t put_index_low = at::output_put_index + 1, get_index_low = at::input_get_index + 1;
  if (offset != put_index_low && offset != get_index_low) return;
  if (!powered_ || boots_until_) return;
  // An invalid index is not followed.
  if (!window_.indexes_make_sense()) return command_error();
  pump();
}

void Board::look_at_switches() {
  unsigned limits = 0;
  each_axis(fitted_, [&](int a) { limits |= unsigned{motion_.limit_active(a)} << a; });
  flags_.set_limit_switches(limits);
}

void Board::set_control(std::uint8_t value) {
  if (update_due_) value |= control::update_data;
  if (mail_due_) value |= control::interrupt_board;
  flags_.set_control(value);
  if ((value & control::update_data) != 0 && !update_due_) update_due_ = now() + update_time;
  if ((value & control::interrupt_board) != 0 && !mail_due_) {
    mail_due_ = now() + mail_time;
    take_mail();
  }
}

void Board::copy_axis_data() {
  each_axis(fitted_, [this](int a) {
    const AxisSettings& s = motion_.settings(a);
    const auto set = [this, a](AxisValue what, std::int32_t to) { window_.set_axis_value(a, what, to); };
    set(AxisValue::encoder_position, dpram_value(motion_.encoder(a)));
    set(AxisValue::command_position, dpram_value(motion_.sampled_position(a)));
    set(AxisValue::command_velocity, dpram_value(std::round(motion_.sampled_velocity(a))));
    set(AxisValue::acceleration, dpram_value(s.acceleration));
    set(AxisValue::maximum_velocity, dpram_value(s.velocity));
    set(AxisValue::base_velocity, dpram_value(s.base_velocity));
    set(AxisValue::proportional_gain, dpram_value(s.gains.proportional));
    set(AxisValue::differential_gain, dpram_value(s.gains.differential));
    set(AxisValue::integral_gain, dpram_value(s.gains.integral));
    set(AxisValue::acceleration_feed_forward, dpram_value(s.gains.acceleration_feed_forward));
    set(AxisValue::velocity_feed_forward, dpram_value(s.gains.velocity_feed_forward));
    set(AxisValue::offset, dpram_value(s.gains.offset));
  });
  flags_.clear_control(control::update_data);
}

/// Decision M29. The command takes effect at once; the host sees later that the mailbox is free again.
void Board::take_mail() {
  const std::array letters{static_cast<char>(window_.cell(at::mailbox)),
                           static_cast<char>(window_.cell(at::mailbox + 2))};
  const std::string_view text(letters.data(), letters.size());
  if (std::find(mailbox_commands.begin(), mailbox_commands.end(), text) == mailbox_commands.end())
    return command_error();
  if (make_.ignores_mail) return;  // mail is acknowledged without effect
  Command urgent;
  urgent.fact = find_command(letters[0], letters[1], where::any);
  do_at_once(urgent);
  settle();
}

void Board::acknowledge_mail() {
  window_.set_cell(at::mailbox, 0);
  window_.set_cell(at::mailbox + 2, 0);
  flags_.clear_control(control::interrupt_board);
}

}  // namespace hw::vme58
