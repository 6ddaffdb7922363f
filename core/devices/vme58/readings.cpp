#include "core/devices/vme58/readings.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {
namespace {

constexpr Duration copy_look = std::chrono::microseconds(300);
constexpr Duration update_patience = Millis(50);
constexpr int live_values = 3;  // encoder, position, velocity come first

}  // namespace

tl::unexpected<Fault> rejected_by_board(std::string_view text) {
  return fail(FaultKind::controller,
              fmt::format("The board rejected \"{}\": its status register reports a command error.",
                          without_end(text)),
              "The other commands of this text were carried out.",
              "Check the axis' equipment (servo, step, encoder), the range of the number, and the mode.");
}

// ---- registers

tl::unexpected<Fault> Readings::unanswered() {
  wire_.count_miss();
  return fail(FaultKind::garbled, "The board no longer answers: every byte of the window reads FF.",
              "Nothing was repeated.", "Check the crate's power and the board.");
}

Task<Result<Registers>> Readings::read_registers(Priority priority, bool ask_for_data) {
  std::vector<BusCycle>& cycles = wire_.burst();
  if (ask_for_data)
    cycles.push_back(BusCycle::store(1, reg::control, wire_.enabled() | control::update_data));
  const std::size_t first = cycles.size();
  for (const std::uint16_t offset :
       {reg::control, reg::status, reg::limit, reg::home, reg::io_low, reg::io_high, reg::vector})
    cycles.push_back(BusCycle::read(1, offset));
  for (const std::uint16_t offset : {at::reserved1, at::input_put_index, at::input_put_index,
                                     at::output_get_index, at::output_get_index, at::output_put_index})
    cycles.push_back(BusCycle::read(2, offset));
  auto done = co_await wire_.run(cycles, priority);
  if (!done) co_return fail(done.error());
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(cycles[first + i].value); };
  const auto word = [&](std::size_t i) { return cycles[first + 7 + i].value; };
  const bool ones =
      std::all_of(cycles.begin() + static_cast<std::ptrdiff_t>(first), cycles.end(),
                  [](const BusCycle& c) { return c.value == (c.width == 1 ? 0xFFu : 0xFFFFu); });
  if (ones) co_return unanswered();
  if (word(1) != word(2) || !is_index(word(1)) || word(3) != word(4) || !is_index(word(3)) ||
      !is_index(word(5)))
    co_return fail(FaultKind::garbled, "The indexes of the rings are not valid.", "They are read again.");
  Registers r;
  r.control = byte(0), r.status = byte(1), r.limit = byte(2), r.home = byte(3);
  r.io = static_cast<std::uint16_t>(byte(4) | (byte(5) & 0x3F) << 8);
  r.mark = static_cast<std::uint16_t>(word(0));
  r.input_put = static_cast<int>(word(1)), r.output_get = static_cast<int>(word(3));
  r.output_put = static_cast<int>(word(5));
  for (std::size_t i = first; i < cycles.size(); ++i)
    snapshot_.window.put(cycles[i].offset, cycles[i].width, cycles[i].value);
  snapshot_.window.known = true;
  co_return r;
}

void Readings::take(const Registers& registers) {
  if ((registers.status & status::command_error) != 0) command_error_ = true;
  status_ = registers.status;
  if ((status_ & status::done) == 0) snapshot_.window.put(reg::done, 1, 0);
  listener_.registers_read(registers);
}

Task<Result<>> Readings::look_at_registers(Priority priority, bool ask_for_data) {
  const auto registers = co_await read_registers(priority, ask_for_data);
  if (!registers) co_return fail(registers.error());
  take(*registers);
  co_return Result<>();
}

Task<Result<bool>> Readings::was_rejected(Priority priority) {
  auto looked = co_await look_at_registers(priority);
  if (!looked) co_return fail(looked.error());
  co_return take_command_error();
}

bool Readings::take_command_error() { return std::exchange(command_error_, false); }

// ---- data area

Task<Result<>> Readings::read_axes(Priority priority, Copy copy) {
  std::vector<BusCycle>& cycles = wire_.burst();
  if (copy == Copy::ask) {
    cycles.push_back(BusCycle::store(1, reg::control, wire_.enabled() | control::update_data));
    cycles.push_back(BusCycle::read(1, reg::control));
    auto asked = co_await wire_.run(cycles, priority);
    if (!asked) co_return asked;
    if (cycles.back().value == 0xFF)
      co_return unanswered();  // the bus is silent, so the board has not received the request
  }
  const Instant give_up = wire_.now() + update_patience;
  const int whole = whole_.next(axes());
  Duration look = first_look_;
  Instant looked_at;
  for (;;) {
    auto paused = co_await wire_.pause(std::exchange(look, copy_look));
    if (!paused) co_return paused;
    cycles.clear();
    cycles.push_back(BusCycle::read(1, reg::control));
    for (int i = 0; i < axes(); ++i) append_axis_reads(cycles, i, i == whole ? axis_values : live_values);
    looked_at = wire_.now();
    auto done = co_await wire_.run(cycles, priority);
    if (!done) co_return done;
    if ((cycles.front().value & control::update_data) == 0) break;
    if (wire_.now() > give_up) {
      wire_.count_miss();
      co_return fail(FaultKind::no_answer,
                     "The board did not copy its axis data in time (control register, bit 0).",
                     "Positions are shown as last read.");
    }
  }
  take_values(cycles);
  listener_.axes_read(whole, looked_at);  // the copy is not newer than this
  seen_ = true;
  co_return Result<>();
}

Task<Result<>> Readings::read_all(Priority priority) {
  for (int i = 0; i < axes(); ++i) {
    auto read = co_await read_axes(priority);
    if (!read) co_return read;
  }
  co_return Result<>();
}

void Readings::take_values(const std::vector<BusCycle>& cycles) {
  for (const BusCycle& cycle : cycles) {
    snapshot_.window.put(cycle.offset, cycle.width, cycle.value);
    if (cycle.width != 4) continue;
    const int axis = (cycle.offset - at::axis_data) / axis_stride;
    const int place = (cycle.offset - at::axis_data) % axis_stride / 4;
    data_[ix(axis)].values[ix(place)] = static_cast<std::int32_t>(cycle.value);
  }
}

std::int64_t Readings::value(int axis, AxisValue v) const { return data_[ix(axis)][v]; }

void Readings::know(int axis, AxisValue v, std::int64_t value) {
  data_[ix(axis)].values[ix(static_cast<int>(v))] = static_cast<std::int32_t>(value);
}

bool Readings::moving(int axis) const { return seen_ && value(axis, AxisValue::command_velocity) != 0; }

void Readings::forget() {
  seen_ = false;
  status_ = 0;
}

Task<Result<>> Readings::read_rings(Priority priority) {
  std::vector<BusCycle>& cycles = wire_.burst();
  for (const std::uint16_t index :
       {at::input_put_index, at::output_get_index, at::output_put_index, at::input_get_index})
    cycles.push_back(BusCycle::read(2, index));
  cycles.push_back(BusCycle::read(2, at::mailbox));
  cycles.push_back(BusCycle::read(2, at::mailbox + 2));
  for (const std::uint16_t buffer : {at::input_buffer, at::output_buffer})
    for (int i = 0; i < ring_cells; ++i)
      cycles.push_back(BusCycle::read(2, static_cast<std::uint16_t>(buffer + 2 * i)));
  auto done = co_await wire_.run(cycles, priority);
  if (!done) co_return done;
  for (const BusCycle& cycle : cycles) snapshot_.window.put(cycle.offset, cycle.width, cycle.value);
  co_return Result<>();
}

}  // namespace hw::vme58
