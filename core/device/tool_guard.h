#pragma once
// Switches a tool (pen, laser) off whenever no program that the console has loaded runs. Every stop switches
// it off too; other ends are seen in the status rounds. Io thread only.
#include <cstdint>
#include <map>
#include <optional>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/device/stop.h"
#include "core/device/tool_off.h"

namespace hw {

class ToolGuard {
 public:
  explicit ToolGuard(const Catalog& catalog) : catalog_(catalog) {}

  /// Before the driver performs `intent`. Refuses a text whose tool is not understood, and a hold during
  /// which the tool would stay on.
  [[nodiscard]] Result<> begin(const IntentBody& intent, const Snapshot& now);
  /// A text that the user typed may have started a program.
  void program_may_run(const Snapshot& now);
  /// `intent` was performed.
  void done(const IntentBody& intent);
  /// `intent` was refused; the programs in the controller are unchanged.
  void refused(const IntentBody& intent);

  /// The tool outputs of all programs that may be in the controller.
  [[nodiscard]] const ToolOff& outputs() const { return all_; }
  [[nodiscard]] bool is_off(const Snapshot& now) const;
  /// A program may have switched the tool on.
  [[nodiscard]] bool may_be_on(const Snapshot& now) const {
    return !all_.empty() && (at_work_ || !is_off(now));
  }
  [[nodiscard]] bool at_work() const { return at_work_; }
  /// `intent` uses the wire for seconds, so a status round must show first that no tool is on.
  [[nodiscard]] bool is_seen_before(const IntentBody& intent) const;

  enum class Request : std::uint8_t {
    nothing,
    look,        ///< a whole status round must show the state of the tool: see looks_by()
    switch_off,  ///< no program runs that could switch it off
    stop         ///< a limit ended a motion with the tool on, and the program continues
  };
  /// What to do after a status round; `rounds`: status rounds ended so far.
  [[nodiscard]] Request watch(const Snapshot& now, std::uint64_t rounds);
  void looks_by(std::uint64_t round, Instant asked_at) { look_ = round, asked_at_ = asked_at; }
  /// The guard waits for that round.
  [[nodiscard]] bool looks() const { return look_ != 0; }

  /// Progress of the stop that switches the tool off, judged by a whole round after all other stops.
  [[nodiscard]] StopProgress progress(const StopOrder& order, const Snapshot& now) const;
  /// The tool could not be switched off, and the user was notified: no further attempt until a program runs
  /// again.
  void give_up();

  /// Pieces that switch the tool act by act begin (Snapshot::pieces).
  void pieces_begin(const ToolOff& tool, const Snapshot& now);

  // ---- a hold: the cut continues where it was held
  /// A hold switches the tool off; outputs that are on now are switched on again when the program continues.
  void note_hold(const Snapshot& now);
  void forget_hold() { held_.clear(); }
  /// To be switched on before the program continues.
  [[nodiscard]] const ToolOff& of_hold() const { return held_; }

 private:
  enum class Cause : std::uint8_t { none, rests, limit };
  void goes_to_work(const Snapshot& now);
  [[nodiscard]] Cause cause(const Snapshot& now);
  [[nodiscard]] std::optional<bool> is_on(int number, const Snapshot& now) const;
  [[nodiscard]] int place_of(int slot) const { return catalog_.program.threads > 0 ? 0 : slot; }
  void gather();

  const Catalog& catalog_;
  std::map<int, ToolOff> by_place_;
  std::optional<ToolOff> loading_;
  ToolOff all_, held_;
  bool at_work_ = false;
  std::uint32_t limits_ = 0;  ///< limits that showed in the latest round, or at the start
  std::uint64_t look_ = 0;    ///< the round that decides about `cause_`; 0: none
  Instant asked_at_{};
  Cause cause_ = Cause::none;
};

}  // namespace hw
