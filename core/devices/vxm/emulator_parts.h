#pragma once
// Value types of an emulated controller.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/devices/vxm/program.h"
#include "core/motion/plant.h"
#include "core/motion/profile.h"
#include "core/time/clock.h"

namespace hw::vxm {

inline constexpr Instant never_changed = Instant(std::chrono::hours(-24));
inline constexpr Duration power_lamps = std::chrono::seconds(1), power_flash = Millis(500);
inline constexpr int power_flashes = 6;
inline constexpr Duration fast_flash = Millis(200);
inline constexpr Duration jog_delay = Millis(300), debounce = Millis(20);
inline constexpr int jog_crawl = 39;  ///< steps/s while Stop is held (p.7)

/// set/get values of one controller, B and O. Motors by index 0 and 1.
struct Setup {
  std::array<int, 2> motor_type{}, jog_1{default_speed, default_speed}, jog_2{default_speed, default_speed};
  std::array<int, 2> joy_1{}, joy_2{}, limit_mode{}, pulse_every{};
  std::array<bool, 2> full_jog_power{};
  int baud = 9, mode = mode_always, dead_zone = 40, pulse_width = 1;
  int inputs = inputs_run | inputs_stop | inputs_branch_3;
  int backlash = 0, limit_report = 0;
  int pma = pma_off;
  bool pma_except = false;  ///< PMA-x
};

/// The memory that rsm stores.
struct Memory {
  Setup setup;
  std::array<Program, program_count> programs;
};

/// An input line. Low is operated.
struct Line {
  bool low = false;
  Instant since = never_changed;
  bool used = false;  ///< this press has taken effect
  /// When the line will have been at the wanted level for `hold` if it stays so; none: it is not at that
  /// level.
  [[nodiscard]] std::optional<Instant> stable(bool want_low, Duration hold) const {
    if (low != want_low) return std::nullopt;
    return since + hold;
  }
};
enum LineName : int {
  line_jog = 0,
  line_run = 4,
  line_in_1 = 5,
  line_in_2,
  line_in_3,
  line_in_4,
  line_count
};

struct Axis {
  motion::Plant plant;
  bool fitted = true;
  std::int32_t counter = 0;
  std::int64_t comb = 0;  ///< steps since the pulse comb was laid (setP, N)
  int speed = default_speed, accel = default_accel;
  std::array<bool, 2> seen_closed{};                    ///< limit inputs minus, plus since power-up (V69)
  std::int64_t lowest = 0, highest = 0, travelled = 0;  ///< for rehearsals; of the unwrapped counter
  std::int64_t unwrapped = 0;
};

enum class MotionKind : std::uint8_t { index, home, nonstop, jog, joystick };
enum class MotionEnd : std::uint8_t { done, limit, stopped };

/// The motion of the one motor that turns.
struct Motion {
  bool active = false, stopping = false, slowing_noted = false;
  bool ended = false;  ///< not yet handled
  MotionKind kind = MotionKind::index;
  MotionEnd end = MotionEnd::done;
  int axis = 0;
  Sign sign = Sign::plus;
  std::int32_t from = 0;                 ///< counter at distance 0
  std::int64_t applied = 0;              ///< steps applied to the counter and the plant
  std::optional<std::int64_t> limit_at;  ///< the step at which a switch ends it
  std::int64_t come_back = 0;            ///< backlash: steps to plus that follow
  motion::Profile profile;
};

struct OpenLoop {
  int at = 0;      ///< place of the loop command
  int passes = 0;  ///< completed so far
};

struct Frame {
  int program = 0, next = 0;
  bool called = false, pick = false;
  std::vector<OpenLoop> loops;
};

/// A move that the current command still has to make.
struct PlannedMove {
  int motor = 1;
  std::int64_t distance = 0;
  int home = 0;            ///< -1, +1: to that limit
  bool with_next = false;  ///< starts together with the next move
};

enum class Doing : std::uint8_t { next, moving, pausing, yielding, waiting, for_host, held };

/// A wait for inputs (U0 ...).
struct Wait {
  int u = 0;
  bool on_slave = false, raised = false, low_seen = false, out_before = false;
  Instant begun{};
};

struct Nonstop {
  bool on = false, moving = false;
  int signal = 77;  ///< 7, 8 or 77
  int motor = 0;    ///< 0: no index yet
  Sign sign = Sign::plus;
  int accel = default_accel;
  double speed = 0;  ///< reached at the end of the last index
};

struct Run {
  bool on = false;
  Doing doing = Doing::next;
  std::vector<Frame> stack;
  int then_program = -1;  ///< runs after the stack is empty (program 4 first)
  Instant until{};
  bool out_before = false;  ///< level of output 1 before a pause raised it
  bool out_raised = false;
  Wait wait;
  bool step_allowed = false;  ///< G has released one held command
  std::vector<PlannedMove> moves;
  std::size_t next_move = 0;
  bool hit_limit = false;
  std::array<std::int64_t, 2> way_back{};
  std::optional<std::int32_t> pick_from;  ///< counter before an absolute index inside JM-x
  int pick_axis = 0;
  bool stop_asked = false;  ///< Stop input: the run ends when the motor stands
  Nonstop nonstop;
  Instant instant{};
  int commands_this_instant = 0;
};

struct Jog {
  enum class Phase : std::uint8_t { none, stepped, turning, ending, blocked } phase = Phase::none;
  int axis = 0;
  Sign sign = Sign::plus;
  Instant since{};
  bool joystick = false;
  int speed = 0;
};

/// An event reported to a rehearsal.
struct Trace {
  Instant at{};
  int program = -1, command = -1;  ///< -1: no command, an event
  std::string what;
  int motor = 0, limit = 0;  ///< motor stopped by its limit switch on the way to -1 or +1; 0: none
};

/// A pulse, without the other controller's positions.
struct Pulse {
  Instant at{};
  int output = 0, axis = 0;
  Duration width{};
  std::int32_t position = 0;
};

/// The earlier of two events, either of which may never come.
inline std::optional<Instant> earlier(std::optional<Instant> a, std::optional<Instant> b) {
  if (!a) return b;
  if (!b) return a;
  return std::min(*a, *b);
}

}  // namespace hw::vxm
