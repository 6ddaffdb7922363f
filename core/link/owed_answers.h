#pragma once
// Answers that nobody waits for any more and that may still come: the questions were given up at their
// deadlines. While a device owes some its line is dirty, and what comes may be one of them. A device answers
// in the order in which it was asked: once it has given an answer that cannot be mistaken for one of those,
// they have all come, or never will.
#include <algorithm>
#include <array>
#include <cstdint>

#include "core/time/clock.h"

namespace hw {

/// What an answer looks like: those of different looks are never taken for each other. The numbers are the
/// driver's own, below `look_count`; `any` may look like each.
enum class Look : std::uint8_t { any };
inline constexpr std::size_t look_count = 8;

class OwedAnswers {
 public:
  /// Later than this no answer comes.
  static constexpr Duration longest_delay = std::chrono::seconds(3);

  void add(Look look, Instant now) { until_[static_cast<std::size_t>(look)] = now + longest_delay; }
  /// One of this look was taken for the answer that was waited for. It may be one of those that are owed, and
  /// its own still come.
  void take(Look look, Instant now) {
    if (now < until_[0] || now < until_[static_cast<std::size_t>(look)]) add(look, now);
  }
  /// The beginning of one has come: its end does not look like it.
  void tear(Instant now) { torn_until_ = now + longest_delay; }
  void add(const OwedAnswers& more) {
    for (std::size_t i = 0; i < look_count; ++i) until_[i] = std::max(until_[i], more.until_[i]);
    torn_until_ = std::max(torn_until_, more.torn_until_);
  }
  void clear() {
    until_.fill({});
    torn_until_ = {};
  }
  /// Since the last time that everything had been answered or outwaited, none was ever owed.
  [[nodiscard]] bool never() const {
    return std::all_of(until_.begin(), until_.end(), [](Instant until) { return until == Instant{}; });
  }
  [[nodiscard]] bool torn(Instant now) const { return now < torn_until_; }
  /// That one is owed, and was given up after the other: it comes behind it.
  [[nodiscard]] bool comes_behind(Look look, Look other, Instant now) const {
    const Instant until = until_[static_cast<std::size_t>(look)];
    return now < until && until > until_[static_cast<std::size_t>(other)];
  }
  [[nodiscard]] bool any(Instant now) const {
    return std::any_of(until_.begin(), until_.end(), [now](Instant until) { return now < until; });
  }
  /// One of them may look like this.
  [[nodiscard]] bool may_look(Look look, Instant now) const {
    if (look == Look::any) return any(now);
    return now < until_[0] || now < until_[static_cast<std::size_t>(look)];
  }
  /// When the next of them can be owed no more; `now`: none is owed.
  [[nodiscard]] Instant next_end(Instant now) const {
    Instant next = Instant::max();
    for (const Instant until : until_)
      if (now < until) next = std::min(next, until);
    return next == Instant::max() ? now : next;
  }

 private:
  std::array<Instant, look_count> until_{};
  Instant torn_until_{};
};

}  // namespace hw
