#include "gui/model/provenance.h"

#include <fmt/format.h>

#include "core/device/refusals.h"
#include "gui/model/axis_look.h"

namespace hw::gui {

Origin origin_of(const Snapshot& now, AxisId axis, Instant clock) {
  const AxisState& a = now.axes[axis.index];
  const bool old = now.link.state == LinkState::lost || (a.position_known && is_old(now, axis.index, clock));
  if (old && a.seen_at != Instant{}) return Origin::stale;
  if (!a.position_known) return Origin::unknown;
  switch (a.trust.kind) {
    case Trust::counted: return Origin::counted;
    case Trust::homed: return Origin::homed;
    case Trust::set: return Origin::set;
    case Trust::untrusted: break;
  }
  return Origin::untrusted;
}

static NumberText joined(std::string_view words, std::string_view more) {
  NumberText text;
  text.append(words);
  text.append(more.empty() ? "" : " ");
  text.append(more);
  return text;
}

NumberText provenance(const Snapshot& now, AxisId axis, Instant clock, const DayClock& day, bool brief) {
  const AxisState& a = now.axes[axis.index];
  const Origin origin = origin_of(now, axis, clock);
  if (brief && a.trust.restored && (origin == Origin::homed || origin == Origin::set))
    return joined("restored", "");
  NumberText when;
  if (!brief) {
    when = format_day_or_time(a.trust.since, clock, day);
    when.append(a.trust.restored ? ", restored" : "");
  }
  switch (origin) {
    case Origin::stale: return joined(format_duration(seconds(clock - a.seen_at)), "old");
    case Origin::unknown: return joined("not known: home it, or set it", "");
    case Origin::untrusted: return joined("untrusted:", brief_words_of(a.trust.cause));
    case Origin::homed: return joined("homed", when);
    case Origin::set: return joined("set by hand", when);
    case Origin::counted: break;
  }
  return joined("counted", "");
}

NumberText format_day_or_time(Instant when, Instant now, const DayClock& day) {
  constexpr Duration whole_day = std::chrono::hours(24);
  const Duration since_midnight = day.of(now);
  const Duration ago = now - when;
  NumberText text;
  if (ago <= since_midnight) {
    char time[16];
    text.append(format_time_of_day(day.of(when), false, time).substr(0, 5));
    return text;
  }
  const auto days = 1 + (ago - since_midnight) / whole_day;
  if (days == 1) return joined("yesterday", "");
  char number[24];
  const auto end = fmt::format_to_n(number, sizeof number, "{}", days);
  return joined(std::string_view(number, end.size), "days ago");
}

}  // namespace hw::gui
