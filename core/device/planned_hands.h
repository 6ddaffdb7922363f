#pragma once
// The hands of a bench file at work on one emulator, by its own time.
#include <deque>
#include <optional>

#include "core/device/bench_file.h"
#include "core/device/emulator.h"

namespace hw {

class PlannedHands {
 public:
  /// In order, as far as none is refused.
  static Result<> act(const std::vector<BenchCommand>& commands, Emulator& emulator) {
    for (const BenchCommand& command : commands)
      if (auto done = emulator.operate(command); !done) return done;
    return {};
  }
  /// Does what stands at the start, and remembers what comes later.
  Result<> begin(const BenchFile& bench, Emulator& emulator) {
    if (auto done = act(bench.at_start, emulator); !done) return done;
    later_.assign(bench.later.begin(), bench.later.end());
    return {};
  }
  /// What comes later counts from here; else from the beginning of time.
  void count_from(Instant began) { began_ = began.time_since_epoch(); }

  /// When a hand comes next; none: no more.
  [[nodiscard]] std::optional<Instant> next() const {
    if (later_.empty()) return std::nullopt;
    return Instant(later_.front().at + began_);
  }
  /// Everything that is due.
  void act_until(Instant now, Emulator& emulator) {
    while (next() && *next() <= now) {
      (void)emulator.operate(later_.front().command);
      later_.pop_front();
    }
  }

 private:
  std::deque<TimedBenchCommand> later_;
  Duration began_{};
};

}  // namespace hw
