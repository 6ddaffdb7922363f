#pragma once
// The VME58 as its data sheet (3701-2300000 rev C) describes it. Shared by driver and emulator; facts only.
//
//   0x000  input put index  (read)   where the board puts the next reply character
//   0x002  output get index (read)   where the board takes the next command character
//   0x004  input buffer     (read)   256 cells of 16 bits, the character in the low byte
//   0x400  axis X, 0x480 axis Y ... 0x780 axis S (read): twelve values of 32 bits each
//   0x800  output put index (r/w)    where the host puts the next command character
//   0x802  input get index  (r/w)    where the host takes the next reply character
//   0x804  output buffer    (r/w)
//   0xA04  reserved         (r/w)    plain memory that only a reset clears
//   0xF88  mailbox          (r/w)
//   0xFE0  registers at odd addresses
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hw::vme58 {

inline constexpr int most_axes = 8;
inline constexpr std::string_view axis_letters = "XYZTUVRS";

// --- window ------------------------------------------------------------------------------------------------

inline constexpr std::uint16_t window_bytes = 4096;

namespace at {
inline constexpr std::uint16_t input_put_index = 0x000, output_get_index = 0x002, input_buffer = 0x004;
inline constexpr std::uint16_t axis_data = 0x400;
inline constexpr std::uint16_t output_put_index = 0x800, input_get_index = 0x802, output_buffer = 0x804;
inline constexpr std::uint16_t reserved1 = 0xA04, mailbox = 0xF88, registers = 0xFE0;
}  // namespace at

inline constexpr std::uint16_t axis_stride = 0x80;
inline constexpr int ring_cells = 256;  ///< characters; 255 fit, equal indexes mean empty

/// Values of an axis block, in memory order.
enum class AxisValue : std::uint8_t {
  encoder_position,
  command_position,
  command_velocity,
  acceleration,
  maximum_velocity,
  base_velocity,
  proportional_gain,
  differential_gain,
  integral_gain,
  acceleration_feed_forward,
  velocity_feed_forward,
  offset,
};
inline constexpr int axis_values = 12;

constexpr std::uint16_t offset_of(int axis, AxisValue value) {
  return static_cast<std::uint16_t>(at::axis_data + axis * axis_stride + 4 * static_cast<int>(value));
}

// --- registers (8 bits, at odd offsets) --------------------------------------------------------------------

namespace reg {
inline constexpr std::uint16_t control = 0xFE1, status = 0xFE3, io_low = 0xFE5, slip = 0xFE7, done = 0xFE9;
inline constexpr std::uint16_t io_high = 0xFEB, limit = 0xFED, home = 0xFEF, vector = 0xFF1;
}  // namespace reg

namespace control {
inline constexpr std::uint8_t update_data = 1 << 0;  ///< set by the host, cleared by the board after copying
inline constexpr std::uint8_t slip_interrupt = 1 << 2, limit_interrupt = 1 << 3, done_interrupt = 1 << 4;
inline constexpr std::uint8_t interrupt_board = 1 << 5;  ///< announces mail
inline constexpr std::uint8_t io_interrupt = 1 << 6;     ///< user inputs 0 and 1
inline constexpr std::uint8_t interrupts = 1 << 7;       ///< without it the board never interrupts the host
}  // namespace control

namespace status {
inline constexpr std::uint8_t command_error = 1 << 0;  ///< latched until read
inline constexpr std::uint8_t initialized = 1 << 1;
inline constexpr std::uint8_t slip = 1 << 2, overtravel = 1 << 3,
                              done = 1 << 4;               ///< some bit of that register is set
inline constexpr std::uint8_t board_interrupted = 1 << 5;  ///< mail is not yet taken
inline constexpr std::uint8_t interrupt = 1 << 7;  ///< cleared by reading; bit 6 is unused (decision M30)
}  // namespace status

/// Commands that the mailbox accepts (decision M29): a letter in each of its two cells.
inline constexpr std::array<std::string_view, 8> mailbox_commands{"SA", "SD", "ST", "KL",
                                                                  "FL", "IC", "CW", "RS"};

// --- general purpose lines ---------------------------------------------------------------------------------

inline constexpr int io_lines = 14, first_fixed_output = 12, lines_of_a_group = 4;
inline constexpr std::uint16_t factory_outputs = 0x3F00;  ///< bit n: line n is an output

// --- limits of values --------------------------------------------------------------------------------------

inline constexpr std::int64_t position_max = 33'500'000;  ///< to either side of zero
inline constexpr std::int64_t distance_max = 67'000'000;
inline constexpr std::int64_t velocity_max = 1'044'000;      ///< counts/s
inline constexpr std::int64_t acceleration_max = 8'000'000;  ///< counts/s²
inline constexpr std::int64_t wait_max_ms = 4'294'967'295;   ///< decision M64
inline constexpr std::int64_t whole_max = 2'147'483'647;     ///< where the manual names no limit
inline constexpr int queue_entries = 200;                    ///< of each axis queue, of AA's, of AM's
inline constexpr int contour_entries = 200;                  ///< decision M21
inline constexpr int loop_levels = 4;
inline constexpr int parabolic_max = 10;                                                     ///< PN
inline constexpr int integration_exponent_max = 15;                                          ///< KN
inline constexpr std::int64_t default_velocity = 200'000, default_acceleration = 2'000'000;  ///< decision M47
inline constexpr int default_servo_update_us = 1000;                                         ///< decision M96

// --- models ------------------------------------------------------------------------------------------------

enum class AxisKind : std::uint8_t { absent, servo, stepper };

struct AxisFitting {
  AxisKind kind = AxisKind::absent;
  bool encoder = false;
  [[nodiscard]] constexpr bool fitted() const { return kind != AxisKind::absent; }
};

/// Servo axes come first, and each has an encoder.
struct Variant {
  std::string_view name;  ///< suffix of "VME58-"
  int servos = 0, steppers = 0, encoders = 0;

  [[nodiscard]] constexpr int axes() const { return servos + steppers; }
  [[nodiscard]] constexpr AxisFitting fitting(int axis) const {
    if (axis < 0 || axis >= axes()) return {};
    return {axis < servos ? AxisKind::servo : AxisKind::stepper, axis < encoders};
  }
};

/// Ordering information; the first one is the default (decision M89).
inline constexpr std::array<Variant, 9> variants{{
    {"8S", 8, 0, 8},
    {"4S4", 4, 4, 4},
    {"8", 0, 8, 0},
    {"4E", 0, 4, 4},
    {"2S2", 2, 2, 2},
    {"2S6", 2, 6, 2},
    {"6S2", 6, 2, 6},
    {"4S", 4, 0, 4},
    {"4", 0, 4, 0},
}};

/// Matches names in any case; null: no such model.
constexpr const Variant* find_variant(std::string_view name) {
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
  for (const Variant& v : variants) {
    bool same = v.name.size() == name.size();
    for (std::size_t i = 0; same && i < name.size(); ++i) same = v.name[i] == upper(name[i]);
    if (same) return &v;
  }
  return nullptr;
}

}  // namespace hw::vme58
