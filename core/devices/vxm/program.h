#pragma once
// Stored commands: the contents of a program of 256 bytes, the cost of each, and its form in `lst`.
#include <cstdint>
#include <string>
#include <vector>

#include "core/devices/vxm/facts.h"

namespace hw::vxm {

enum class Op : std::uint8_t {
  index,                  ///< ImMx, ImM-x: value signed
  home,                   ///< ImM0, ImM-0: value +1 or -1
  index_to,               ///< IAmMx: value signed
  set_zero,               ///< IAmM-0
  speed,                  ///< SmMx
  speed_full,             ///< SAmMx
  analog_speed,           ///< SmM-x: value is the range
  analog_speed_full,      ///< SAmM-x
  accel,                  ///< AmMx
  loop,                   ///< Lx
  loop_alternate,         ///< L-x
  loop_always,            ///< LAx
  loop_always_alternate,  ///< LA-x
  loop_endless,           ///< L0
  marker,                 ///< LM0
  marker_nf90,            ///< L-0
  marker_reset,           ///< LM-0
  mirror_2,               ///< LM-2
  mirror_12,              ///< LM-3
  jump,                   ///< Jx
  call,                   ///< JMx
  call_pick,              ///< JM-x
  pause,                  ///< Px: tenths of a second
  pause_fine,             ///< P-x: tenths of a millisecond
  pause_out,              ///< PAx
  pause_out_fine,         ///< PA-x
  user,                   ///< Ux
  group,                  ///< ( ): indexes in `parts`
};

struct Command {
  Op op = Op::user;
  std::uint8_t motor = 0;  ///< 1 to 4; 0: none
  std::int32_t value = 0;
  std::vector<Command> parts;

  Command() = default;
  Command(Op o, int m, std::int32_t v) : op(o), motor(static_cast<std::uint8_t>(m)), value(v) {}
  bool operator==(const Command&) const = default;
};

/// Bytes of program memory.
[[nodiscard]] int bytes_of(const Command& command);
/// As entered, in canonical form, the motor always shown: "I1M-400".
[[nodiscard]] std::string listing_of(const Command& command);
/// Any L, LA or LM command.
[[nodiscard]] bool is_loop(Op op);
/// ImMx, IAmMx, ImM0, IAmM-0: allowed between ( and ).
[[nodiscard]] bool is_index(Op op);
/// Turns a motor when executed.
[[nodiscard]] bool moves(const Command& command);
/// The analog range of SmM-x, or null.
[[nodiscard]] const AnalogRange* find_analog_range(int number);
/// Speed that the analog input asks for in a range, steps/s.
[[nodiscard]] int analog_speed(const AnalogRange& range, int reading);

class Program {
 public:
  [[nodiscard]] int free() const { return program_bytes - used_; }
  [[nodiscard]] int used() const { return used_; }
  [[nodiscard]] int size() const { return static_cast<int>(commands_.size()); }
  [[nodiscard]] bool empty() const { return commands_.empty(); }
  [[nodiscard]] const Command& operator[](int i) const { return commands_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const std::vector<Command>& commands() const { return commands_; }

  /// False: the command does not fit, and is not stored.
  bool add(const Command& command);
  void remove_last();
  void clear();
  /// U91 at `i` becomes U92 and `index`.
  void rewrite_u91(int i, const Command& index);
  /// The target of a loop command at `i`: after the nearest LM0 above it, else the beginning.
  [[nodiscard]] int loop_target(int i) const;

 private:
  std::vector<Command> commands_;
  int used_ = 0;
};

}  // namespace hw::vxm
