#pragma once
// The time without a connection: from the loss of the wire, through all attempts, to the next connection and
// its report. Io thread.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "core/device/loss_report.h"

namespace hw {

class Outage {
 public:
  struct Loss {
    bool at_work = false;     ///< something moved or ran
    bool on_the_way = false;  ///< a command or question was on its way
    bool may_run = false;     ///< something that was stopped or held may still run
  };
  /// False: the wire was lost already; attempts in between do not count.
  bool begin(const Snapshot& last_known, const Loss& loss, Instant now) {
    if (std::exchange(on_, true)) return false;
    may_run_ = loss.may_run;
    restarts_ = last_known.restarts;
    report_.lost(last_known, loss.at_work, loss.on_the_way, now);
    return true;
  }
  /// Connected again. Returns whether the controller was switched off and on meanwhile.
  bool end(const Snapshot& known) {
    on_ = may_run_ = at_once_ = false;
    may_take_ = first_attempt;
    attempts_ = 0;
    return std::exchange(restarts_, known.restarts) != known.restarts;
  }
  [[nodiscard]] bool may_run() const { return may_run_; }
  /// See LossReport::back().
  std::string report_when_back(const Catalog& catalog, const Snapshot& known, bool at_work, Instant now) {
    return report_.back(catalog, known, at_work, now);
  }

  // ---- attempts to connect
  /// Begins another attempt; returns its number.
  int try_again(Instant now) {
    at_once_ = false;
    tried_at(now);
    return ++attempts_;
  }
  /// Begins an attempt on the same wire.
  void tried_at(Instant now) { attempt_at_ = now; }
  [[nodiscard]] Instant attempt_at() const { return attempt_at_; }
  /// An unconfirmed stop is sent again when an attempt takes this long. Each may take twice as long as the
  /// one before, so that a slow controller can connect.
  [[nodiscard]] Instant latest() const { return attempt_at_ + may_take_; }
  bool takes_too_long(Instant now) {
    if (now < latest()) return false;
    may_take_ *= 2;
    return true;
  }
  /// The next attempt begins at once.
  void retry_at_once() { at_once_ = on_; }
  /// The same for a stop requested now: since the loss it is unknown whether anything runs.
  void retry_at_once_for_stop() {
    retry_at_once();
    may_run_ = may_run_ || on_;
  }
  [[nodiscard]] bool hurries() const { return at_once_; }
  [[nodiscard]] Duration back_off() const {
    constexpr Millis steps[] = {Millis(250), Millis(500), Millis(1000), Millis(2000), Millis(5000)};
    return steps[std::min<std::size_t>(static_cast<std::size_t>(attempts_), std::size(steps) - 1)];
  }

 private:
  static constexpr Duration first_attempt = std::chrono::seconds(1);
  bool on_ = false, may_run_ = false, at_once_ = false;
  std::uint32_t restarts_ = 0;
  int attempts_ = 0;
  Instant attempt_at_{};
  Duration may_take_ = first_attempt;
  LossReport report_;
};

}  // namespace hw
