#pragma once
// Progress and remaining time of a program transfer: fills Snapshot::transfer, and the log (driver=info).
// Lines are what a person counts; a unit of work is one question or command, which takes about the same time
// each.
#include <string>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw {

class TransferProgress {
 public:
  using Phase = TransferState::Phase;
  /// Both outlive it.
  TransferProgress(TransferState& shown, const Catalog& catalog) : shown_(shown), catalog_(catalog) {}

  void begin(int slot, Instant now);
  /// `lines` 0: not known.
  void enter(Phase phase, int lines);
  /// The work from here to the end, in all phases; 0: not known.
  void expect(int work) { work_left_ = work; }
  void expect_more(int work) { work_left_ += work; }
  void worked(Instant now);
  void line_done() { ++shown_.done; }
  /// Whether to publish now: not for each line on a fast wire.
  [[nodiscard]] bool is_news(Instant now);
  /// Ends well or not; the progress stays visible.
  void end();

 private:
  void write_log() const;

  TransferState& shown_;
  const Catalog& catalog_;
  Instant began_{}, reported_at_{}, logged_{};
  int work_done_ = 0, work_left_ = 0;
};

/// "the first 41 of its 302 lines are written", for a broken transfer to the controller; empty: there was
/// none, or it is not known.
std::string report_written(const TransferState& transfer);

}  // namespace hw
