#include "core/devices/vme58/all_stop.h"

#include <utility>

namespace hw::vme58 {
namespace {

constexpr Duration longest_rest = Millis(400);

}  // namespace

Task<Result<>> AllStop::send(std::string_view word) {
  if (word == "KL") doubt_positions();
  behind_ = Behind::not_known;
  rests_since_ = wire_.now();
  auto mailed = co_await mailbox_.mail_past_ring(word);
  const bool may_be_deaf = mailbox_ignores_mail_ || by_mail_alone_ || !any_moves();
  const bool ring_may_do = mailed ? may_be_deaf : mailed.error().kind == FaultKind::no_answer;
  by_mail_alone_ = ring_may_do && !conversation_.is_known();
  if (!ring_may_do || by_mail_alone_) co_return mailed;
  std::string text = std::string(word) + "\n";
  auto written = co_await conversation_.write(std::move(text), Priority::stop);
  co_return written ? written : mailed;
}

bool AllStop::any_moves() const {
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i)
    if (motions_.moving(i)) return true;
  return false;
}

Task<Result<>> AllStop::look_at_queues() {
  if (behind_ == Behind::nothing || selection_.recording()) co_return Result<>();
  if (any_moves()) {
    rests_since_ = wire_.now();
    co_return Result<>();
  }
  const auto taken = co_await conversation_.is_taken(Priority::stop);
  if (!taken) co_return fail(taken.error());
  if (!*taken) co_return Result<>();
  auto asked = co_await queues_.read(Priority::stop);
  if (!asked) co_return asked;
  if (queues_.empty())
    behind_ = Behind::nothing;
  else
    behind_ = queues_.known() ? Behind::waits : Behind::not_known;
  co_return Result<>();
}

bool AllStop::owes_ring() const { return by_mail_alone_ && conversation_.is_known(); }

AllStop::Behind AllStop::behind() const {
  const bool rests = wire_.now() - rests_since_ >= longest_rest;
  return behind_ == Behind::not_known && rests ? Behind::nothing : behind_;
}

void AllStop::another_was_sent() {
  if (behind_ != Behind::nothing) by_mail_alone_ = true;
}

void AllStop::without_effect() {
  if (std::exchange(mailbox_ignores_mail_, true)) return;
  wire_.report(Notice::Kind::warning,
               "The board acknowledged a stop in its mailbox but did not act on it. From now on, stops also "
               "go through its command ring.");
}

void AllStop::doubt_positions() {
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) {
    if (effect_.is_watched(i) && snapshot_.axes[i].trust.cause == Doubt::killed)
      continue;  // KL is sent again
    motions_.doubt_killed_position(i, snapshot_.axes[i].speed.value);
  }
}

}  // namespace hw::vme58
