#pragma once
// Watches the snapshot for motions and programs that begin and end, and reports each end once. Io thread.
#include <array>
#include <functional>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "core/device/stop.h"
#include "core/device/way_watch.h"

namespace hw {

class EndingWatch {
 public:
  using Report = std::function<void(const Ending&)>;
  /// The catalog must outlive it. `report` null: ends are not reported. `ways_of` null: no program is known.
  EndingWatch(const Catalog& catalog, Report report, WayWatch::WaysOf ways_of = {})
      : catalog_(catalog), report_(std::move(report)), ways_(catalog, std::move(ways_of)) {}

  /// A stop was requested: from now on, ends by a stop are attributed to it.
  void stop_asked(const StopOrder& order, const Snapshot& now, Instant at);
  /// The first byte of the stop was sent.
  void stop_goes_out(const StopOrder& order, Instant at);
  /// The console is about to start this program.
  void program_starts(int slot, Instant now) { ways_.starts(slot, now); }
  /// Something may move an axis or set a count.
  void disturbed() { ways_.disturbed(); }
  /// To be called after each change of the snapshot.
  void look(const Snapshot& now);

 private:
  /// A motion, or a run of programs or lists.
  struct Run {
    bool under_way = false;
    bool quiet = false;  ///< of a motion: reported with its program or list
    bool over = false;   ///< of a program: reported when its last motion has been judged
    Ending ending;
    StoppedBy stopped_by = StoppedBy::unknown;
    Instant asked_at{}, sent_at{};  ///< of the first stop
    Instant slow_at{};              ///< when it was first seen to slow down after the stop
    Instant rests_since{};          ///< of a motion whose end is not explained yet: at rest since then
    Steps asked_place{};
    Pps asked_speed{};
    Instant seen_at{};  ///< the latest reading
    Steps seen_place{};
    double pace = 0;  ///< steps/s between the last two readings before the stop
  };
  void look_at_axis(const Snapshot& now, int axis);
  void look_at_program(const Snapshot& now);
  void look_at_threads(const Snapshot& now);
  void finish_judged(Run& run);
  static void find_cause(Ending& ending, const Snapshot& now, int line);
  void look_at_list(const Snapshot& now);
  void look_at_pieces(const Snapshot& now);
  static void begin(Run& run, Ending::What what, Instant now);
  void finish(Run& run, Instant at);
  static void see_slowing(Run& run, const AxisState& axis);
  static bool falls_behind(Run& run, const AxisState& axis);
  static void find_axis_at_limit(Ending& ending, const Snapshot& now);
  static void time_the_stop(Run& run, Instant at);
  static bool stops_axis(const StopOrder& order, int axis);

  const Catalog& catalog_;
  const Report report_;
  WayWatch ways_;
  std::array<Run, max_axes> axes_;
  std::array<Run, max_threads> threads_;
  Run program_, list_, pieces_;
};

}  // namespace hw
