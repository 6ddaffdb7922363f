#include "core/devices/arcus/code_at_work.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/devices/arcus/codec.h"

namespace hw::arcus {
namespace {

constexpr Duration between_stops = Millis(100);
constexpr Duration longest_watch = std::chrono::seconds(10);
constexpr Duration usual_rest = std::chrono::seconds(2);    // if its end cannot be known
constexpr Duration longest_rest = std::chrono::seconds(5);  // longest rest waited for

}  // namespace

void CodeAtWork::goes_out(std::string_view command) {
  lines_.goes_out(command);
  if (!command.starts_with("GS")) return;
  called_before_ = called_;
  const auto number = decode_number(command.substr(2));
  if (!number || *number < 0 || *number >= subroutines) return;
  const auto n = static_cast<std::size_t>(*number);
  const bool known = code_ && code_->subs[n];
  if (known && !code_->subs[n]->moves) return;
  called_ = Called{static_cast<int>(n), known ? code_->subs[n]->rests : std::nullopt};
  moved_at_ = console_.scheduler.now();
}

Duration CodeAtWork::longest_run(std::string_view call) const {
  constexpr Duration unknown_duration = std::chrono::seconds(10);
  const auto number = decode_number(call.substr(2));
  if (!code_ || !number || *number < 0 || *number >= subroutines) return unknown_duration;
  const auto& sub = code_->subs[static_cast<std::size_t>(*number)];
  return sub ? sub->rests.value_or(unknown_duration) : Duration::zero();
}

bool CodeAtWork::subroutine_may_run() {
  if (called_ && called_->rests && console_.scheduler.now() - moved_at_ > *called_->rests) called_.reset();
  return called_.has_value();
}

StopProgress CodeAtWork::outlast(const StopOrder& order, bool turns) {
  const Instant now = console_.scheduler.now();
  const bool watches = now - order.first_sent_at < longest_watch;
  if (turns && watches)  // the axis ramps down, or the subroutine has begun its next move
    return now - order.sent_at < between_stops ? StopProgress::wait() : StopProgress::again();
  const bool is_reported = called_->rests && *called_->rests <= longest_rest;
  const Instant stands_since = std::max(moved_at_, order.first_sent_at);
  if (watches && (is_reported || now - stands_since <= usual_rest)) return StopProgress::wait();
  Fault fault(FaultKind::controller,
              fmt::format("Subroutine {}, started by GS, may still run, and {}.", called_->number,
                          turns ? "an axis still moves" : "its next line may start a move again"),
              "STOP ends only its present move; no command ends a subroutine.",
              "Switch the power off to end it.");
  if (turns || !std::exchange(called_->reported, true)) return StopProgress::failed(std::move(fault));
  console_.report(Notice::Kind::warning,
                  fault.sentence());  // all axes stood through two stops: later stops need not fail
  return StopProgress::stands();
}

void CodeAtWork::was_refused(std::string_view command) {
  if (command.starts_with("GS")) called_ = called_before_;
}

void CodeAtWork::restarted() {
  code_.reset();
  lines_.forget();
  called_.reset();
}

}  // namespace hw::arcus
