#pragma once
// Logs what a driver has concluded about its controller: that it was restarted, that a count cannot be
// trusted any more, what runs, whether the guard is installed. --log driver.vxm=debug. Io thread.
#include <array>
#include <cstdint>

#include "core/device/decision_log.h"
#include "core/device/snapshot.h"

namespace hw {

class StateLog {
 public:
  explicit StateLog(const Catalog& catalog) : catalog_(catalog), log_(driver_log(catalog)) {}
  /// Compares with the snapshot before it. While nobody wants the lines it costs the read of a number.
  void look(const Snapshot& now);

 private:
  struct Seen {
    LinkState link = LinkState::connecting;
    std::uint32_t restarts = 0;
    RunState run = RunState::idle;
    std::int8_t slot = -1;
    std::uint8_t slots_torn = 0;
    bool unsaved = false;
    JogGuard guard;
    Identity identity;
    std::array<PositionTrust, max_axes> trust{};
    std::array<Activity, max_axes> activity{};
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
