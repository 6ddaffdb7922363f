#pragma once
// The run under way in the controller: a move of the console, or a stored program; how it ends, and how that
// is shown.
#include <optional>
#include <utility>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/job.h"
#include "core/devices/vxm/motor_readings.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/slots.h"

namespace hw::vxm {

class UnderWay {
 public:
  UnderWay(const Console& console, Presence& presence, const Slots& slots, MotorReadings& readings,
           Hold& hold, Ramp& ramp)
      : console_(console),
        presence_(presence),
        slots_(slots),
        readings_(readings),
        hold_(hold),
        ramp_(ramp),
        news_(console.scheduler) {}

  [[nodiscard]] bool busy() const { return job_.active() || program_runs_; }
  /// Notified when something was received or concluded.
  Event& news() { return news_; }

  // ---- moves of the console
  Job& job() { return job_; }
  [[nodiscard]] const Job& job() const { return job_; }
  void begin(Job job);
  void drop_job() { job_ = Job(); }

  // ---- stored programs
  [[nodiscard]] bool program_runs() const { return program_runs_; }
  /// `slot` -1: the selected program, as far as is known.
  void program_begins(int slot);
  /// Slot of a run whose end was seen, with the limits not read since.
  std::optional<int> take_ended_run() { return std::exchange(ended_run_, std::nullopt); }

  // ---- end of a run
  /// The run has ended, by itself or by force.
  void run_ended(EndedBy ended_by);
  /// K has been confirmed: nothing runs, no hold, no error.
  void killed(EndedBy ended_by = EndedBy::abort);
  /// The next V shows what K has ended. Nothing shows whether it ended the hold.
  void kill_not_confirmed(EndedBy ended_by);
  void kill_was_sent() { killed_at_ = console_.scheduler.now(); }
  [[nodiscard]] Instant killed_at() const { return killed_at_; }
  /// The controller has restarted.
  void forget();

  // ---- lost wire: motions go on without the console
  void wire_lost();
  [[nodiscard]] bool was_lost_while_busy() const { return lost_while_busy_; }
  bool take_lost_while_busy() { return std::exchange(lost_while_busy_, false); }

 private:
  void forget_how_it_ended();

  const Console& console_;
  Presence& presence_;
  const Slots& slots_;
  MotorReadings& readings_;
  Hold& hold_;
  Ramp& ramp_;
  Event news_;
  Job job_;
  bool program_runs_ = false;
  std::optional<int> ended_run_;
  bool lost_while_busy_ = false;
  Instant killed_at_{};
};

}  // namespace hw::vxm
