#pragma once
// A move of the console: its legs, the first of which is under way, and how that leg ends.
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/device/snapshot.h"
#include "core/device/stop.h"
#include "core/devices/vxm/speeds.h"

namespace hw::vxm {

/// One run of the console's own: at most one index (or a pair on two controllers), so that D always ends it.
struct Leg {
  std::string text;  ///< stored commands, each with its ender
  int axis = -1, second_axis = -1;
  Activity activity = Activity::idle;  ///< idle: switches or sets something, moves nothing
  Sign sign = Sign::plus;
  std::optional<Steps> target;
  std::optional<Steps> up_to;  ///< of a jog: the end of its travel
  LegPace pace;
  bool to_switch = false;       ///< it ends on a limit switch
  std::optional<Trust> zeroes;  ///< the leg zeroes its axis: why the zero is trusted

  [[nodiscard]] bool is_of(int an_axis) const { return axis == an_axis || second_axis == an_axis; }
};

class Job {
 public:
  Job() = default;
  /// A job that starts again at the end of its bounded index.
  static Job jog(Leg leg);
  void add(Leg leg) { legs_.push_back(std::move(leg)); }
  /// Null: no leg.
  Leg* last() { return legs_.empty() ? nullptr : &legs_.back(); }

  [[nodiscard]] bool active() const { return !legs_.empty(); }
  /// The leg under way.
  [[nodiscard]] const Leg& leg() const { return legs_.front(); }
  [[nodiscard]] bool moves(int axis) const { return active() && leg().is_of(axis); }
  /// The stop covers the leg under way.
  [[nodiscard]] bool concerns(const StopOrder& order) const;
  [[nodiscard]] bool is_jog() const { return jog_; }
  [[nodiscard]] bool has_more() const { return jog_ || legs_.size() > 1; }

  // ---- the leg under way
  void leg_begins() { leg_over_ = limit_reported_ = false; }
  /// The prompt was received or missed; the positions still have to be read.
  void leg_is_over() { leg_over_ = true; }
  [[nodiscard]] bool is_leg_over() const { return leg_over_; }
  void report_limit() { limit_reported_ = true; }
  [[nodiscard]] bool limit_was_reported() const { return limit_reported_; }
  /// The caller stopped the move by a text and waits for its prompt.
  void ask_for_end(bool asked) { end_is_asked_ = active() && asked; }
  [[nodiscard]] bool end_is_asked() const { return end_is_asked_; }

  // ---- why it is cut short
  void ends_by(EndedBy why) { ended_by_ = why; }
  [[nodiscard]] EndedBy ended_by() const { return ended_by_; }
  /// The leg under way ends, and no later leg follows.
  void note_stop();
  /// The stop has cut off this leg only.
  [[nodiscard]] bool was_cut_whole() const { return cut_whole_; }

  // ---- later legs
  /// Drops all later legs.
  void drop_rest();
  /// Drops the later legs of this axis; -1: of any axis. Returns them.
  std::vector<Leg> drop_later_legs(int axis);
  /// Continues with the next leg if this leg has reached its target. `again` is appended as the last leg.
  void go_on(EndedBy ended_by, std::optional<Leg> again);

 private:
  std::deque<Leg> legs_;
  bool jog_ = false;
  EndedBy ended_by_ = EndedBy::nothing;
  bool leg_over_ = false, limit_reported_ = false, cut_whole_ = false, end_is_asked_ = false;
};

}  // namespace hw::vxm
