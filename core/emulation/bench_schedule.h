#pragma once
// Carries out the events of a bench file on one emulator, in its own time.
#include <deque>
#include <optional>

#include "core/emulation/bench_file.h"
#include "core/emulation/emulator.h"

namespace hw {

class BenchSchedule {
 public:
  /// In order, until one is refused.
  static Result<> act(const std::vector<BenchCommand>& commands, Emulator& emulator) {
    for (const BenchCommand& command : commands)
      if (auto done = emulator.operate(command); !done) return done;
    return {};
  }
  /// Carries out the start of the file, and keeps the later events.
  Result<> begin(const BenchFile& bench, Emulator& emulator) {
    if (auto done = act(bench.at_start, emulator); !done) return done;
    later_.assign(bench.later.begin(), bench.later.end());
    return {};
  }
  /// Later events count from here; else from the beginning of time.
  void count_from(Instant began) { began_ = began.time_since_epoch(); }

  /// Time of the next event; none: no more.
  [[nodiscard]] std::optional<Instant> next() const {
    if (later_.empty()) return std::nullopt;
    return Instant(later_.front().at + began_);
  }
  /// Carries out everything that is due.
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
