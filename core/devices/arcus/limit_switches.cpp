#include "core/devices/arcus/limit_switches.h"

#include "core/base/index.h"

namespace hw::arcus {

std::size_t fields_of_status(const Console& console) {
  std::size_t fields = ix(console.axes());
  for (const std::string_view id : console.forms.behind_status) fields += id.empty() ? 0 : 1;
  return fields;
}

bool LimitSwitches::glance_is_due() const {
  constexpr Duration glance_every = Millis(10);
  const Instant now = console_.scheduler.now();
  return now < watched_until_ && now - glanced_at_ >= glance_every;
}

// A fault here is ignored: it also shows on the question that follows.
Task<> LimitSwitches::glance() {
  glanced_at_ = console_.scheduler.now();
  auto words = co_await conversation_.ask_numbers(std::string(console_.forms.status),
                                                  fields_of_status(console_), Priority::poll);
  if (words) take(*words, conversation_.asked_at());
}

void LimitSwitches::take(const std::vector<std::int64_t>& words, Instant asked_at) {
  if (asked_at < shown_of_) return;
  const StatusBits& bits = console_.model().status;
  std::uint64_t limits = 0;
  for (int i = 0; i < console_.axes(); ++i)
    limits = limits << 2 | std::uint64_t{has_bit(words[ix(i)], bits.minus_limit)} << 1 |
             std::uint64_t{has_bit(words[ix(i)], bits.plus_limit)};
  const bool agree = look_.agrees(limits, conversation_.times_cleaned());
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    axis.limit_minus = has_bit(words[ix(i)], bits.minus_limit);
    axis.limit_plus = has_bit(words[ix(i)], bits.plus_limit);
    axis.limits_known = agree;
  }
  shown_of_ = glanced_at_ = asked_at;
  if (console_.scheduler.now() < watched_until_) console_.changed();
}

}  // namespace hw::arcus
