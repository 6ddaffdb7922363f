#pragma once
// Sees motions and programs begin and end in what the driver knows, and tells each end once. Io thread.
#include <array>
#include <functional>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "core/device/stop.h"

namespace hw {

class EndingWatch {
 public:
  using Tell = std::function<void(const Ending&)>;
  /// The catalog outlives it. `tell` null: nobody wants to know.
  EndingWatch(const Catalog& catalog, Tell tell) : catalog_(catalog), tell_(std::move(tell)) {}

  /// A stop is asked for: what ends by one from now on, ends by this.
  void stop_asked(const StopOrder& order, const Snapshot& now, Instant at);
  /// Its first byte goes out.
  void stop_goes_out(const StopOrder& order, Instant at);
  /// After each change of what is known.
  void look(const Snapshot& now);

 private:
  /// A motion, or a run of programs or lists.
  struct Run {
    bool under_way = false;
    bool quiet = false;  ///< of a motion: a program or a list tells of it
    Ending told;
    StoppedBy who = StoppedBy::nobody;
    Instant asked_at{}, sent_at{};  ///< of the first stop
    Steps asked_place{};
  };
  void look_at_axis(const Snapshot& now, int axis);
  void look_at_program(const Snapshot& now);
  void look_at_threads(const Snapshot& now);
  static void find_cause(Ending& told, const Snapshot& now, int line);
  void look_at_list(const Snapshot& now);
  void look_at_pieces(const Snapshot& now);
  static void begin(Run& run, Ending::What what, Instant now);
  void finish(Run& run, Instant at);
  static void time_the_stop(Run& run, Instant at);
  static bool stops_axis(const StopOrder& order, int axis);

  const Catalog& catalog_;
  const Tell tell_;
  std::array<Run, max_axes> axes_;
  std::array<Run, max_threads> threads_;
  Run program_, list_, pieces_;
};

}  // namespace hw
