#pragma once
// The tool of the programs that the console has put into a controller: it may be on while a program runs, and
// at no other time. Every stop takes it along; what ends in another way is seen by the rounds of status. Io
// thread only.
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

  /// Before a driver is asked for it. Refused: a text whose tool is not understood, and a hold where the tool
  /// would stay on in it.
  [[nodiscard]] Result<> begin(const IntentBody& intent, const Snapshot& now);
  /// By a text of the user's.
  void program_may_run(const Snapshot& now);
  /// It has been done.
  void done(const IntentBody& intent);
  /// It was refused, and the programs in the controller are what they were.
  void refused(const IntentBody& intent);

  /// Of all programs that may be in the controller.
  [[nodiscard]] const ToolOff& outputs() const { return all_; }
  [[nodiscard]] bool is_off(const Snapshot& now) const;
  /// A program may have switched it on.
  [[nodiscard]] bool may_be_on(const Snapshot& now) const {
    return !all_.empty() && (at_work_ || !is_off(now));
  }
  [[nodiscard]] bool at_work() const { return at_work_; }
  /// It keeps the wire for seconds, in which nobody would see that a program has ended with its tool on.
  [[nodiscard]] bool is_seen_before(const IntentBody& intent) const;

  enum class Wish : std::uint8_t {
    nothing,
    look,        ///< a whole round of status has to show what it is: see looks_by()
    switch_off,  ///< nothing runs that could do so
    stop         ///< a limit has ended a motion while it is on, and the program goes on
  };
  /// By a round of status that has just ended; `rounds` of them have.
  [[nodiscard]] Wish watch(const Snapshot& now, std::uint64_t rounds);
  void looks_by(std::uint64_t round, Instant asked_at) { look_ = round, asked_at_ = asked_at; }
  /// Somebody waits for that round.
  [[nodiscard]] bool looks() const { return look_ != 0; }

  /// Of the order that switches it off, by a whole round behind everything else that was to stop.
  [[nodiscard]] StopProgress progress(const StopOrder& order, const Snapshot& now) const;
  /// It could not be switched off, and that was said: nothing more is tried until a program is at work again.
  void give_up();

  /// Acts one by one that switch it (Snapshot::pieces).
  void pieces_begin(const ToolOff& tool, const Snapshot& now);

  // ---- a hold: what was cut goes on where it was held
  /// It is being switched off in one; what is on now comes on again with the program.
  void note_hold(const Snapshot& now);
  void forget_hold() { held_.clear(); }
  /// To be switched before the program goes on.
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
  std::uint32_t limits_ = 0;  ///< that showed in the latest round, or when it went to work
  std::uint64_t look_ = 0;    ///< the round that shows what `cause_` has to be judged by; 0: none
  Instant asked_at_{};
  Cause cause_ = Cause::none;
};

}  // namespace hw
