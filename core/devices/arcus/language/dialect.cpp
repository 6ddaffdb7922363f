#include "core/devices/arcus/language/dialect.h"

#include <algorithm>

#include "core/devices/arcus/facts.h"

namespace hw::arcus::language {
namespace {

constexpr auto largest = static_cast<std::int32_t>(max_number);

constexpr auto min_position = static_cast<std::int32_t>(position_min),
               max_position = static_cast<std::int32_t>(position_max),
               max_speed = static_cast<std::int32_t>(arcus::max_speed);

constexpr NameRow read_only(std::string_view spelling, Quantity q, Indexing indexing = Indexing::none,
                            int first = 0, int last = 0) {
  NameRow row{spelling, q, indexing, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(last)};
  return row;
}
constexpr NameRow read_write(std::string_view spelling, Quantity q, Indexing indexing, std::int32_t minimum,
                             std::int32_t maximum) {
  NameRow row{spelling, q, indexing};
  row.writable = Writable::number_or_variable;
  row.minimum = minimum;
  row.maximum = maximum;
  return row;
}
constexpr NameRow write_only(std::string_view spelling, Quantity q, Indexing indexing, std::int32_t minimum,
                             std::int32_t maximum) {
  NameRow row = read_write(spelling, q, indexing, minimum, maximum);
  row.readable = false;
  return row;
}
/// The name's syntax line in the manual has a value only, no variable.
constexpr NameRow number_only(NameRow row) {
  row.writable = Writable::number;
  return row;
}
constexpr NameRow numbered(NameRow row, int first, int last) {
  row.indexing = Indexing::number;
  row.first = static_cast<std::uint8_t>(first);
  row.last = static_cast<std::uint8_t>(last);
  return row;
}
constexpr NameRow switch_output(std::string_view spelling, Quantity q, int last) {
  NameRow row = numbered(read_write(spelling, q, Indexing::number, 0, 1), 1, last);
  row.any_is_on = true;
  return row;
}
constexpr NameRow or_zero(NameRow row) {
  row.also_zero = true;
  return row;
}
constexpr NameRow alias(NameRow row, std::string_view usual) {
  row.usual = usual;
  return row;
}

constexpr auto none = Indexing::none;
constexpr auto axis = Indexing::axis;
constexpr auto number = Indexing::number;
using Q = Quantity;

// PMX manual, ch. 10; AMB-094, 107, 108.
constexpr NameRow pmx_names[] = {
    read_write("ACC", Q::acceleration, none, 0, largest),
    read_write("ACC", Q::axis_acceleration, axis, 0, largest),
    read_write("DEC", Q::deceleration, none, 0, largest),
    read_write("DEC", Q::axis_deceleration, axis, 0, largest),
    read_write("HSPD", Q::high_speed, none, 1, max_speed),
    read_write("HSPD", Q::axis_high_speed, axis, 0, max_speed),
    read_write("LSPD", Q::low_speed, none, 1, max_speed),
    read_write("LSPD", Q::axis_low_speed, axis, 0, max_speed),
    read_only("AI", Q::analog, number, 1, 8),
    read_only("DI", Q::inputs),
    read_only("DI", Q::input, number, 1, 8),
    read_write("DO", Q::outputs, none, 0, 255),
    switch_output("DO", Q::output, 8),
    alias(read_write("DIO", Q::outputs, none, 0, 255), "DO"),
    read_write("E", Q::encoder_position, axis, min_position, max_position),
    read_write("EO", Q::enables, none, 0, 15),
    switch_output("EO", Q::enable, 4),
    number_only(write_only("JOYENA", Q::joystick_axes, none, 0, 15)),
    write_only("JOYHS", Q::joystick_speed, axis, 0, largest),
    write_only("JOYDEL", Q::joystick_delta, axis, 0, largest),
    write_only("JOYNO", Q::joystick_minus_outer, axis, min_position, max_position),
    write_only("JOYNI", Q::joystick_minus_inner, axis, min_position, max_position),
    write_only("JOYPI", Q::joystick_plus_inner, axis, min_position, max_position),
    write_only("JOYPO", Q::joystick_plus_outer, axis, min_position, max_position),
    read_only("MST", Q::motor_status, axis),
    read_write("P", Q::pulse_position, axis, min_position, max_position),
    read_only("PS", Q::speed, axis),
    read_write("SCV", Q::s_curve, axis, 0, 1),
    number_only(write_only("SL", Q::loop_enable, axis, 0, 1)),
    read_only("SLS", Q::loop_state, axis),
    write_only("SSPD", Q::new_speed, axis, 1, max_speed),
    write_only("SSPDM", Q::speed_window, axis, 0, 7),
    write_only("SYNCFG", Q::sync_condition, axis, 1, 3),
    write_only("SYNPOS", Q::sync_position, axis, min_position, max_position),
    alias(write_only("SYNPOSE", Q::sync_position, axis, min_position, max_position), "SYNPOS"),
    read_only("SYNSTAT", Q::sync_state, axis),
    alias(read_only("SYNXS", Q::sync_state, none, 0), "SYNSTATX"),
    alias(read_only("SYNYS", Q::sync_state, none, 1), "SYNSTATY"),
    alias(read_only("SYNZS", Q::sync_state, none, 2), "SYNSTATZ"),
    alias(read_only("SYNUS", Q::sync_state, none, 3), "SYNSTATU"),
    number_only(write_only("SYNTIME", Q::sync_time, axis, 0, 10)),
    number_only(write_only("TOC", Q::comm_timeout, none, 0, largest)),
    number_only(read_write("TR", Q::timer, none, 0, largest)),
};

// DMX manual, ch. 10; AMB-108. A name without axis letter means the only axis, 0.
constexpr NameRow dmx_names[] = {
    read_write("ACC", Q::acceleration, none, 0, largest),
    read_write("DEC", Q::deceleration, none, 0, largest),
    read_write("HSPD", Q::high_speed, none, 1, max_speed),
    read_write("LSPD", Q::low_speed, none, 1, max_speed),
    read_only("DI", Q::inputs),
    read_only("DI", Q::input, number, 1, 6),
    read_write("DO", Q::outputs, none, 0, 7),
    switch_output("DO", Q::output, 3),
    number_only(or_zero(write_only("DRVIC", Q::idle_current, none, min_current, max_current))),
    number_only(write_only("DRVIT", Q::idle_delay, none, 1, 100)),
    number_only(write_only("DRVRC", Q::run_current, none, min_current, max_current)),
    read_write("EO", Q::enables, none, 0, 1),
    read_write("E", Q::encoder_position, axis, min_position, max_position),
    read_write("P", Q::pulse_position, axis, min_position, max_position),
    read_only("PS", Q::speed),
    write_only("LT", Q::latch_enable, axis, 0, 1),
    read_only("LTE", Q::latch_encoder, axis),
    read_only("LTP", Q::latch_pulse, axis),
    read_only("LTS", Q::latch_state, axis),
    read_only("MST", Q::motor_status, axis),
    write_only("SCV", Q::s_curve, axis, 0, 1),
    number_only(write_only("SL", Q::loop_enable, none, 0, 1)),
    number_only(write_only("SL", Q::loop_enable, axis, 0, 1)),
    read_only("SLS", Q::loop_state, axis),
    write_only("SSPD", Q::new_speed, axis, 1, max_speed),
    write_only("SSPDM", Q::speed_window, axis, 0, 9),
    write_only("SYNCFG", Q::sync_condition, axis, 1, 3),
    write_only("SYNPOS", Q::sync_position, axis, min_position, max_position),
    read_only("SYNSTAT", Q::sync_state, axis),
    alias(read_only("SYNS", Q::sync_state), "SYNSTATX"),
    alias(read_only("SYNXS", Q::sync_state), "SYNSTATX"),
    number_only(write_only("TOC", Q::comm_timeout, none, 0, largest)),
};

constexpr WordRow all_words[] = {
    {"HOME", Opcode::home_switch},
    {"LHOME", Opcode::home_limit},
    {"ZHOME", Opcode::home_switch_index},
    {"ZOME", Opcode::home_index},
    {"HLHOME", Opcode::home_switch_slow},
    {"JOG", Opcode::jog},
    {"STOP", Opcode::stop, true},
    {"ABORT", Opcode::abort, true},
    {"WAIT", Opcode::wait},
    {"ECLEAR", Opcode::clear_error},
    {"SYNON", Opcode::sync_on},
    {"SYNOFF", Opcode::sync_off},
};

/// The axis whose letter stands behind `spelling` in `letters`, or -1.
int axis_behind(const Dialect& dialect, std::string_view spelling, std::string_view letters) {
  if (letters.size() != spelling.size() + 1 || !letters.starts_with(spelling)) return -1;
  return dialect.axis_of(letters.back());
}

}  // namespace

const Dialect& pmx_4ex_sa() {
  static constexpr Dialect dialect{"pmx-4ex-sa", "PMX-4EX-SA", "XYZU",       4,           true,
                                   pmx_names,    all_words,    min_position, max_position};
  return dialect;
}

const Dialect& dmx_k_sa() {
  static constexpr Dialect dialect{"dmx-k-sa", "DMX-K-SA", "X",          2,           false,
                                   dmx_names,  all_words,  min_position, max_position};
  return dialect;
}

std::span<const Dialect* const> all_dialects() {
  static const Dialect* const all[] = {&pmx_4ex_sa(), &dmx_k_sa()};
  return all;
}

std::optional<NameFound> find_name(const Dialect& dialect, std::string_view letters, int n) {
  for (const NameRow& row : dialect.names) {
    switch (row.indexing) {
      case Indexing::none:
        if (n < 0 && letters == row.spelling) return NameFound{&row, row.first};
        break;
      case Indexing::number:
        if (n >= 0 && letters == row.spelling) return NameFound{&row, n};
        break;
      case Indexing::axis:
        if (const int a = n < 0 ? axis_behind(dialect, row.spelling, letters) : -1; a >= 0)
          return NameFound{&row, a};
        break;
    }
  }
  return std::nullopt;
}

std::optional<WordFound> find_word(const Dialect& dialect, std::string_view letters) {
  for (const WordRow& row : dialect.words) {
    if (row.alone && dialect.axes.size() > 1 && letters == row.spelling)
      return WordFound{row.op, dialect.all_axes()};
    if (const int a = axis_behind(dialect, row.spelling, letters); a >= 0)
      return WordFound{row.op, one_axis(a)};
  }
  return std::nullopt;
}

const NameRow* writable_row(const Dialect& dialect, Quantity quantity) {
  const auto row = std::find_if(dialect.names.begin(), dialect.names.end(), [&](const NameRow& r) {
    return r.quantity == quantity && r.writable != Writable::no;
  });
  return row == dialect.names.end() ? nullptr : &*row;
}

bool can_hold(const Dialect& dialect, Quantity quantity, std::int64_t value) {
  const NameRow* row = writable_row(dialect, quantity);
  return row && (row->any_is_on || row->accepts(value));
}

std::string spell(const Dialect& dialect, Quantity quantity, int index) {
  for (const NameRow& row : dialect.names) {
    if (row.quantity != quantity || !row.usual.empty()) continue;
    std::string text(row.spelling);
    if (row.indexing == Indexing::axis) text += dialect.axes[static_cast<std::size_t>(index)];
    if (row.indexing == Indexing::number) text += std::to_string(index);
    return text;
  }
  return {};
}

std::string spell(const Dialect& dialect, const Operand& operand) {
  switch (operand.kind) {
    case Operand::Kind::number: return std::to_string(operand.number);
    case Operand::Kind::variable: return "V" + std::to_string(operand.number);
    case Operand::Kind::quantity: return spell(dialect, operand.quantity, operand.index);
  }
  return {};
}

}  // namespace hw::arcus::language
