#pragma once
// The place of a running program when the controller does not report it: worked out from its run time and a
// rehearsal of the text that the controller holds, begun from the controller's state at the start. A report
// about a held program corrects the estimate. GUI thread.
#include <memory>
#include <optional>
#include <string>

#include "core/device/controller_state.h"
#include "gui/model/program_texts.h"
#include "gui/model/worker.h"

namespace hw::gui {

class RunFollower {
 public:
  struct Place {
    int slot = -1, command = -1;  ///< -1: not known
    int pass = 0, passes = 0;     ///< number of this pass, of how many; 0: not known
    double next_in_s = 0;         ///< until the next command; 0: not known
  };

  /// `catalog` must outlive this object.
  explicit RunFollower(const Catalog& catalog) : catalog_(catalog) {}
  /// Once a frame.
  void follow(const Snapshot& now, const BenchView& bench, Instant clock, const ProgramTexts& texts,
              const Language* language, Worker& worker);
  /// As reported by the controller, else as worked out.
  [[nodiscard]] Place place() const;
  /// Run time, without the times in which it was held or waited.
  [[nodiscard]] double run_s() const { return run_s_; }
  /// Time left in the run; nothing: not known, or endless.
  [[nodiscard]] std::optional<double> left_s() const;

 private:
  void begin(const Snapshot& now, const BenchView& bench, const ProgramTexts& texts, const Language& language,
             Worker& worker);
  void put_right(const ProgramState& reported);
  void see_turns(const Rehearsal& r, double since, Place& place) const;
  void count_passes(const Rehearsal& r, Place& place) const;
  [[nodiscard]] const Rehearsal* rehearsal() const { return of_run_ ? &*of_run_ : nullptr; }

  const Catalog& catalog_;
  bool following_ = false;
  Instant started_at_{}, seen_at_{};
  RunState seen_run_ = RunState::idle;
  ProgramState program_;
  double run_s_ = 0;
  int run_number_ = 0;  ///< distinguishes the rehearsal of an earlier run from this run's
  std::optional<Rehearsal> of_run_;
  std::optional<Snapshot> at_rest_;  ///< the latest before the run
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
