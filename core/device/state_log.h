#pragma once
// Logs the conclusions of a driver about its controller: restarts, counts that became doubtful, programs and
// how they ended, the state of the guard. --log driver.vxm=debug. Io thread.
#include <array>
#include <cstdint>

#include "core/device/decision_log.h"
#include "core/device/snapshot.h"

namespace hw {

class StateLog {
 public:
  explicit StateLog(const Catalog& catalog) : catalog_(catalog), log_(driver_log(catalog)) {}
  /// Compares with the previous snapshot. While the level is off this costs the read of a number.
  void look(const Snapshot& now);

 private:
  struct Seen {
    LinkState link = LinkState::connecting;
    std::uint32_t restarts = 0;
    RunState run = RunState::idle;
    EndedBy run_ended_by = EndedBy::nothing;
    std::int8_t slot = -1;
    std::uint8_t slots_torn = 0;
    bool unsaved = false;
    JogGuard guard;
    Identity identity;
    std::array<PositionTrust, max_axes> trust{};
    std::array<Activity, max_axes> activity{};
    std::array<EndedBy, max_axes> ended_by{};
  };
  static Seen seen_in(const Snapshot& now);
  void log_controller(const Seen& before, const Seen& now) const;
  void log_axis(int axis, const Seen& before, const Seen& now) const;

  const Catalog& catalog_;
  const log::Subject& log_;
  bool looks_ = false;  ///< `last_` is of the snapshot before
  Seen last_;
};

}  // namespace hw
