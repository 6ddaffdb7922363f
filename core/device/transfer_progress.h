#pragma once
// How far a program has come on its way to or from the controller, and how long the rest takes by the rate so
// far: fills Snapshot::transfer, and without a window the log tells it (driver=info). Lines are what a person
// counts; work is what takes about the same time each, a question or a command.
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
  /// `lines` 0: nobody knows how many.
  void enter(Phase phase, int lines);
  /// So much is to be done from here to the end, in all phases; 0: nobody knows.
  void expect(int work) { work_left_ = work; }
  void expect_more(int work) { work_left_ += work; }
  void worked(Instant now);
  void line_done() { ++shown_.done; }
  /// Not for each line of a quick wire.
  [[nodiscard]] bool is_news(Instant now);
  /// Well or not: how far it has come stays to be told.
  void end();

 private:
  void tell_log() const;

  TransferState& shown_;
  const Catalog& catalog_;
  Instant began_{}, told_{}, logged_{};
  int work_done_ = 0, work_left_ = 0;
};

/// "the first 41 of its 302 lines are written": of a program that was on its way to the controller; empty:
/// none was, or it is not known.
std::string say_written(const TransferState& transfer);

}  // namespace hw
