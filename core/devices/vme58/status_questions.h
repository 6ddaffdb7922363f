#pragma once
// Questions that a status round asks by command, while the board takes commands: flags, slips, loops and
// queues.
#include <optional>
#include <string_view>

#include "core/devices/vme58/speeds.h"

namespace hw::vme58 {

class StatusQuestions {
 public:
  StatusQuestions(Wire& wire, Readings& readings, Conversation& conversation, const Selection& selection,
                  Queues& queues, LimitEnds& limits, ServoLoops& loops, Motions& motions, Speeds& speeds,
                  NextRound& next, const Catalog& catalog, Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        conversation_(conversation),
        selection_(selection),
        queues_(queues),
        limits_(limits),
        loops_(loops),
        motions_(motions),
        speeds_(speeds),
        next_(next),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// Readout groups that the user watches (intent::Watch).
  void watch(std::uint32_t groups) { watched_ = groups; }
  [[nodiscard]] bool watches(int group) const { return bit(watched_, group); }
  void begins() { ++number_; }
  Task<Result<>> ask_in_turn();
  /// Reads the done register if a motion of ours may have ended. Also for rounds in which no question gets
  /// through.
  Task<Result<>> look_at_done();
  /// Whether every queue is empty and no axis turns. Switches and axes are read after the queues: motions of
  /// AM leave their queue at once, and a switch may just have emptied one.
  Task<Result<bool>> is_worked_off();
  /// `any`: the status register reports that some axis has slipped.
  void take_slip_flag(bool any);
  void forget() { slips_ = 0; }

 private:
  static constexpr int queue_rounds = 5;
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  [[nodiscard]] bool in_turn() const { return number_ % queue_rounds == 0; }
  [[nodiscard]] bool wants_done() const;
  [[nodiscard]] bool wants_queues();
  Task<Result<>> read_flags();
  Task<Result<>> read_slips();
  Task<Result<>> read_loops();
  void take_done(unsigned axes);
  void slipped(int axis);
  void show(std::string_view letters, int axis, std::optional<std::int64_t> value);

  Wire& wire_;
  Readings& readings_;
  Conversation& conversation_;
  const Selection& selection_;
  Queues& queues_;
  LimitEnds& limits_;
  ServoLoops& loops_;
  Motions& motions_;
  Speeds& speeds_;
  NextRound& next_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
  std::uint32_t watched_ = 0;
  std::uint8_t slips_ = 0;
  int number_ = 0;
};

}  // namespace hw::vme58
