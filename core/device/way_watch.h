#pragma once
// Watches the motions of a known program that runs alone. Controllers do not report how such a motion ended;
// the place where the axis rests can show that it was cut short (ProgramWays).
//
// Judges only programs that this console started, and only rests that follow another rest that was seen: a
// motion that was not seen makes the way longer, never shorter. Anything else that may move an axis or set a
// count ends the judgement until the next program. Io thread.
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/device/program_ways.h"
#include "core/device/snapshot.h"

namespace hw {

class WayWatch {
 public:
  using WaysOf = std::function<std::optional<ProgramWays>(int slot)>;
  /// The catalog must outlive it. `ways_of` null: no program is known.
  WayWatch(const Catalog& catalog, WaysOf ways_of) : catalog_(catalog), ways_of_(std::move(ways_of)) {}

  /// The console is about to start this program.
  void starts(int slot, Instant now);
  /// The console stops this axis: it is not judged until the next program.
  void stopped(int axis);
  /// Something may move an axis or set a count: nothing is judged until the next program.
  void disturbed();
  /// To be called after each change of the snapshot. Returns the motions that were cut short.
  std::vector<Ending> look(const Snapshot& now);
  /// The program is over, and the places where its axes rest are read.
  [[nodiscard]] bool is_judging() const { return over_since_ != Instant{}; }
  /// The motion of the latest program that came to rest last, if it was cut short.
  [[nodiscard]] const std::optional<Ending>& last_cut() const { return last_cut_; }

 private:
  struct Axis {
    std::optional<Steps> rest;  ///< where it was seen at rest before its present motion
    Steps place{};
    Instant read_at{};      ///< of `place`
    Instant still_since{};  ///< all readings since then show it at rest at `place`
    Instant began{}, came_to_rest{};
    bool moved = false;  ///< seen to move since `rest`
    bool is_ignored = false;
    bool judged_elsewhere = false;
    bool at_limit = false;
    std::int8_t direction = 0;
  };
  struct Start {
    int slot = 0;
    Instant at{};
  };
  enum class Program : std::uint8_t { unknown, runs, over };
  [[nodiscard]] Program program(const Snapshot& now, int& slot) const;
  void follow_program(const Snapshot& now);
  void look_at_axis(const Snapshot& now, int axis, std::vector<Ending>& cut);
  void see_motion(const AxisState& state, Axis& axis) const;
  [[nodiscard]] bool sees_rest(const AxisState& state, Axis& axis, Instant now) const;
  void judge(const Snapshot& now, int axis, std::vector<Ending>& cut);
  [[nodiscard]] bool is_settled(const Snapshot& now) const;

  const Catalog& catalog_;
  const WaysOf ways_of_;
  std::optional<Start> start_;       ///< sent, and not seen yet
  std::optional<ProgramWays> ways_;  ///< of the program that runs, or has ended a moment ago
  bool runs_ = false;
  Instant over_since_{}, last_rest_{};
  std::optional<Ending> last_cut_;
  std::uint32_t restarts_ = 0;
  std::array<Axis, max_axes> axes_{};
};

}  // namespace hw
