#pragma once
// Replies that may still come although their questions were given up at their deadlines. While a device owes
// replies its line is dirty: a received reply may be an old one. A device answers in order: after a reply
// that cannot be mistaken for an outstanding one, all outstanding replies have come or will never come.
#include <algorithm>
#include <array>
#include <cstdint>

#include "core/time/clock.h"

namespace hw {

/// The form of a reply: replies of different kinds are never mistaken for each other. The numbers are the
/// driver's own, below `reply_kind_count`; `any` may have the form of every other.
enum class ReplyKind : std::uint8_t { any };
inline constexpr std::size_t reply_kind_count = 8;

class OutstandingReplies {
 public:
  /// No reply comes later than this.
  static constexpr Duration longest_delay = std::chrono::seconds(3);

  void add(ReplyKind reply_kind, Instant now) {
    until_[static_cast<std::size_t>(reply_kind)] = now + longest_delay;
  }
  /// A reply of this kind was accepted. If it was an outstanding one, the right one still comes.
  void take(ReplyKind reply_kind, Instant now) {
    if (now < until_[0] || now < until_[static_cast<std::size_t>(reply_kind)]) add(reply_kind, now);
  }
  /// Only the beginning of a reply was received; the rest cannot be recognised by its form.
  void tear(Instant now) { torn_until_ = now + longest_delay; }
  void add(const OutstandingReplies& more) {
    for (std::size_t i = 0; i < reply_kind_count; ++i) until_[i] = std::max(until_[i], more.until_[i]);
    torn_until_ = std::max(torn_until_, more.torn_until_);
  }
  void clear() {
    until_.fill({});
    torn_until_ = {};
  }
  /// No reply has been outstanding since the line was last clean.
  [[nodiscard]] bool never() const {
    return std::all_of(until_.begin(), until_.end(), [](Instant until) { return until == Instant{}; });
  }
  [[nodiscard]] bool torn(Instant now) const { return now < torn_until_; }
  /// A reply of `reply_kind` is outstanding and comes after the outstanding one of `other`.
  [[nodiscard]] bool comes_behind(ReplyKind reply_kind, ReplyKind other, Instant now) const {
    const Instant until = until_[static_cast<std::size_t>(reply_kind)];
    return now < until && until > until_[static_cast<std::size_t>(other)];
  }
  [[nodiscard]] bool any(Instant now) const {
    return std::any_of(until_.begin(), until_.end(), [now](Instant until) { return now < until; });
  }
  /// An outstanding reply may be of this kind.
  [[nodiscard]] bool may_be_outstanding(ReplyKind reply_kind, Instant now) const {
    if (reply_kind == ReplyKind::any) return any(now);
    return now < until_[0] || now < until_[static_cast<std::size_t>(reply_kind)];
  }
  /// When the next outstanding reply expires; `now`: none is outstanding.
  [[nodiscard]] Instant next_end(Instant now) const {
    Instant next = Instant::max();
    for (const Instant until : until_)
      if (now < until) next = std::min(next, until);
    return next == Instant::max() ? now : next;
  }

 private:
  std::array<Instant, reply_kind_count> until_{};
  Instant torn_until_{};
};

}  // namespace hw
