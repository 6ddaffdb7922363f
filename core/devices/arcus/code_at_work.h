#pragma once
// Which stored code may be running, and what it may do: programs that were seen or started, and subroutines
// that the host has called (GS, decision AMB-046). No SR ends the thread of a subroutine and no SASTAT shows
// it: STOP ends only its present move, and its next line may begin another.
#include <optional>
#include <string_view>

#include "core/device/stop.h"
#include "core/devices/arcus/console.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/held_lines.h"
#include "core/devices/arcus/stored_code.h"

namespace hw::arcus {

class CodeAtWork {
 public:
  explicit CodeAtWork(const Console& console) : console_(console) {}

  // ---- the stored code
  void know(StoredCode code) { code_ = code; }
  /// The code was not read, or another compiler made it.
  void forget() { code_.reset(); }
  [[nodiscard]] HeldLines& lines() { return lines_; }
  [[nodiscard]] const std::optional<StoredCode>& known() const { return code_; }
  [[nodiscard]] bool leaves_param(std::size_t index) const { return code_ && !code_->sets.test(index); }
  [[nodiscard]] bool switches_motors() const { return !code_ || code_->switches_motors; }

  // ---- programs
  /// A program may run; within this time the status shows whether it still does.
  void program_runs(Duration at_most) {
    runs_until_ = std::max(runs_until_, console_.scheduler.now() + at_most);
  }
  [[nodiscard]] bool program_may_run() const { return console_.scheduler.now() <= runs_until_; }

  // ---- subroutines
  /// Call before the command is sent: it may take effect even if it is not confirmed.
  void goes_out(std::string_view command);
  void was_refused(std::string_view command);
  /// Also counts a subroutine that moves nothing: no status shows it.
  [[nodiscard]] Duration longest_run(std::string_view call) const;
  [[nodiscard]] bool was_called() const { return called_.has_value(); }
  /// The subroutine called last may still be running.
  [[nodiscard]] bool subroutine_may_run();
  /// An axis was seen to move, or may have.
  void axis_moves() { moved_at_ = console_.scheduler.now(); }
  /// Stops each move that the subroutine begins, until it has ended or its end cannot be known.
  StopProgress outlast(const StopOrder& order, bool turns);

  void restarted();

 private:
  struct Called {
    int number;
    std::optional<Duration> rests;  ///< ended once nothing has moved for this long
    bool reported = false;
  };

  const Console& console_;
  std::optional<StoredCode> code_;
  HeldLines lines_;
  Instant runs_until_{};
  std::optional<Called> called_, called_before_;
  Instant moved_at_{};
};

}  // namespace hw::arcus
