// Subroutines that the host has called (GS, decision AMB-046). No SR ends the thread that they run in and no
// SASTAT shows it: STOP ends only the move that one has begun, and its next line may begin another.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr Duration between_stops = Millis(100);
constexpr Duration longest_watch = std::chrono::seconds(10);
constexpr Duration usual_rest = std::chrono::seconds(2);    // where nobody can tell when it is over
constexpr Duration longest_rest = std::chrono::seconds(5);  // that is waited for

}  // namespace

/// Before it is sent: whether or not it is confirmed.
void ArcusDriver::note_call(std::string_view text) {
  if (!text.starts_with("GS")) return;
  called_before_ = called_;
  const auto number = decode_number(text.substr(2));
  if (!number || *number < 0 || *number >= subroutines) return;
  const auto n = static_cast<std::size_t>(*number);
  const bool known = stored_code_ && stored_code_->subs[n];
  if (known && !stored_code_->subs[n]->moves) return;
  called_ = Called{static_cast<int>(n), known ? stored_code_->subs[n]->rests : std::nullopt};
  moved_at_ = scheduler_.now();
}

/// Of what moves nothing, too: no status shows it.
Duration ArcusDriver::longest_run(std::string_view call) const {
  constexpr Duration where_nobody_can_tell = std::chrono::seconds(10);
  const auto number = decode_number(call.substr(2));
  if (!stored_code_ || !number || *number < 0 || *number >= subroutines) return where_nobody_can_tell;
  const auto& sub = stored_code_->subs[static_cast<std::size_t>(*number)];
  return sub ? sub->rests.value_or(where_nobody_can_tell) : Duration::zero();
}

/// The one that was called may still be under way.
bool ArcusDriver::subroutine_may_run() {
  if (called_ && called_->rests && scheduler_.now() - moved_at_ > *called_->rests) called_.reset();
  return called_.has_value();
}

// Each move that it begins is stopped, until it is over or nobody can tell.
StopProgress ArcusDriver::outlast_subroutine(const StopOrder& order, bool turns) {
  const Instant now = scheduler_.now();
  if (std::exchange(outlasted_stop_, order.epoch) != order.epoch) stood_at_ = now;
  if (turns) stood_at_ = now;
  const bool watches = now - order.first_sent_at < longest_watch;
  if (turns && watches)  // a ramp, or its next move
    return now - order.sent_at < between_stops ? StopProgress::wait() : StopProgress::again();
  const bool is_told = called_->rests && *called_->rests <= longest_rest;
  if (watches && (is_told || now - stood_at_ <= usual_rest)) return StopProgress::wait();
  stands(-1);
  Fault fault(FaultKind::controller,
              fmt::format("Subroutine {}, which GS has started, may go on, and {}.", called_->number,
                          turns ? "an axis still moves" : "its next line may move again what stands now"),
              "STOP ends only the move that it has begun; no command ends a subroutine.",
              "Switch the power off to end it.");
  if (turns || !std::exchange(called_->told, true)) return StopProgress::failed(std::move(fault));
  tell(Notice::Kind::warning, fault.sentence());  // it stood through two stops: they are not failed for ever
  return StopProgress::stands();
}

}  // namespace hw::arcus
