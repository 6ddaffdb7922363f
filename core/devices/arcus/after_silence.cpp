#include "core/devices/arcus/after_silence.h"

namespace hw::arcus {

Task<Result<>> AfterSilence::look() {
  if (!watch_.was_silent() && !watch_.in_doubt()) co_return Result<>();
  const std::uint32_t restarts = console_.snapshot.restarts;
  const RestartWatch::Look look = watch_.begin_look();
  auto seen = co_await status_.read(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await lines_.read(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await watch_.look_at_motors(look);
  if (seen && console_.snapshot.restarts == restarts) co_return seen;
  if (!seen && worth_another_try(seen.error())) {
    seen.error().kind = FaultKind::refused;
    seen.error().done = "Nothing was sent.";
  }
  if (!seen) co_return seen;
  co_return fail(FaultKind::refused, "The controller was switched off and on, so its state has changed.",
                 "Nothing was sent.", "Check its positions before you try again.");
}

// A stop that was unanswered when the wire was lost does not explain a counter at zero. An unanswered
// switching of motor power may have taken effect.
Task<Result<>> AfterSilence::look_back_over_the_loss() {
  if (watch_.program_ran()) threads_.program_runs();  // perhaps until just now
  watch_.settle();
  const RestartWatch::Look look = watch_.begin_look();
  watch_.look_at_counters(look, true);
  co_return co_await watch_.look_at_motors(look);
}

}  // namespace hw::arcus
