#pragma once
// The origin of an axis' number, in words shown beside it.
#include "core/device/snapshot.h"
#include "gui/model/traffic_log.h"
#include "gui/model/units_format.h"

namespace hw::gui {

enum class Origin : std::uint8_t {
  unknown,    ///< never read, or no longer true
  stale,      ///< out of date
  untrusted,  ///< counted, but the axis may be elsewhere
  counted,    ///< from an unknown start
  homed,
  set  ///< by hand
};

Origin origin_of(const Snapshot& now, AxisId axis, Instant clock);
/// "homed 12:04", "set by hand yesterday", "counted", "1.2 s old", "untrusted: power was cut". `brief`:
/// without the time; "restored" alone.
NumberText provenance(const Snapshot& now, AxisId axis, Instant clock, const DayClock& day, bool brief);
/// "12:04" of today, "yesterday", "9 days ago".
NumberText format_day_or_time(Instant when, Instant now, const DayClock& day);

}  // namespace hw::gui
