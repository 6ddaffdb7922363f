#pragma once
// Parts of one emulated controller that have a state of their own and know nothing of the rest.
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_parts.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/program_syntax.h"

namespace hw::vxm {

/// In what its firmware differs from the newest.
struct Quirks {
  char error_first = error_mark;
  bool mode_while_running = false;  ///< E and F are taken during a run (decision V103)
  int firmware = newest_firmware;   ///< in hundredths; features of later versions are unknown
};

/// The supply, and what keeps the controller from working although it is on.
struct Supply {
  bool on = true;
  bool deaf = false;          ///< receive overrun: until power-off
  bool buttons_held = false;  ///< since power-up
  Instant since{};
  [[nodiscard]] bool works() const { return on && !deaf && !buttons_held; }
};

/// How it talks to its host.
struct HostMode {
  bool online = false, echo = false;
  bool group_cr = false;  ///< G: a carriage return behind prompts
  void enter(char letter) { online = true, echo = letter == 'E', group_cr = letter == 'G'; }
  void leave() { online = echo = group_cr = false; }
};

/// Finds `res` among letters of which nothing else is read.
class ResetWord {
 public:
  bool is_complete_with(char c) {
    constexpr std::string_view word = "res";
    letters_ = c == word[ix(letters_)] ? letters_ + 1 : c == 'r' ? 1 : 0;
    return letters_ == 3;
  }
  void forget() { letters_ = 0; }

 private:
  int letters_ = 0;  ///< received so far
};

/// The host's unfinished input: a word, a group, and their purpose.
struct HostEntry {
  Reader reader;
  std::optional<Command> group;  ///< open: ( without its )
  bool to_slave = false;         ///< between [ and ]
  int program = 0, motor = 1;    ///< the chosen ones
  void drop_unfinished() { to_slave = false, group.reset(); }
};

/// All that it has received and not yet obeyed, and how it answers.
struct HostSide {
  HostMode mode;
  ResetWord reset_word;
  HostEntry entry;
  Reader bus_reader;  ///< of a Slave: letters of its Master
};

/// Outputs of the user, and pulses on the second.
class Outputs {
 public:
  void set(int number, bool on) {
    const int bit = 1 << (number - 1);
    bits_ = on ? bits_ | bit : bits_ & ~bit;
  }
  void set_all(int bits) { bits_ = bits; }
  void pulse_until(Instant end) { pulse_until_ = end; }
  void clear() { bits_ = 0, pulse_until_ = never_changed; }
  [[nodiscard]] bool first_is_on() const { return (bits_ & 1) != 0; }
  [[nodiscard]] int at(Instant now) const { return bits_ | (pulse_until_ > now ? 2 : 0); }

 private:
  int bits_ = 0;
  Instant pulse_until_ = never_changed;
};

class AnalogInput {
 public:
  void set(int value) { value_ = std::clamp(value, analog_min, analog_max); }
  [[nodiscard]] int value() const { return value_; }
  /// The joystick's present place is its middle (App. J).
  void take_as_centre() { centre_ = value_; }
  [[nodiscard]] int deflection() const { return value_ - centre_; }

 private:
  int value_ = analog_default, centre_ = analog_default;
};

/// Positions captured on the way: the first four of a run are kept until the next (V27).
class Captures {
 public:
  void take(std::int32_t first_motor, std::int32_t second_motor) {
    if (count_ == 4) return;
    positions_[0][count_] = first_motor, positions_[1][count_] = second_motor;
    ++count_;
  }
  void clear() { *this = Captures(); }
  [[nodiscard]] const std::array<std::int32_t, 4>& of(int axis) const { return positions_[ix(axis)]; }

 private:
  std::array<std::array<std::int32_t, 4>, 2> positions_{};
  std::size_t count_ = 0;
};

/// The place where a motor last began to slow down: the reply to `*`.
struct Slowing {
  Instant when = never_changed;
  std::int32_t counter = 0;
};

/// Volatile: as new after power-up.
struct State {
  char error = 0;
  bool first_run = true;       ///< no program has run yet
  bool hold = false;           ///< H: no command begins
  bool jog_in_waits = false;   ///< the buttons jog while a program waits
  bool nf90_pause_out = true;  ///< as NF90: output 1 is on during pauses
  Captures captures;
  Slowing slowing;
};

/// For this controller's motors; a Slave's partly come from its Master.
struct Rules {
  bool nf90 = false;
  int backlash = 0;
  std::array<bool, 2> inverted{};
  bool jogs = true;  ///< of a Slave: its Master allows its buttons to jog
};

/// The loads and inputs wired to it.
struct Terminals {
  std::array<Line, line_count> lines;
  AnalogInput analog;
  Outputs outputs;
};

/// Facts about the present run, for a rehearsal.
struct RunTally {
  bool limit_was_hit = false;
  int moves_begun = 0;
};

}  // namespace hw::vxm
