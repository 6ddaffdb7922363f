#pragma once
// Where the number of an axis comes from, in words for beside it.
#include "core/device/snapshot.h"
#include "gui/model/traffic_log.h"
#include "gui/model/units_format.h"

namespace hw::gui {

enum class Origin : std::uint8_t {
  unknown,    ///< never read, or not true any more
  stale,      ///< it was so some time ago
  untrusted,  ///< it counts, and may stand elsewhere
  counted,    ///< nobody has said from where
  homed,
  set  ///< by hand
};

Origin origin_of(const Snapshot& now, AxisId axis, Instant clock);
/// "homed 12:04", "set by hand yesterday", "counted", "1.2 s old", "untrusted: power was cut". `brief`:
/// without when.
NumberText provenance(const Snapshot& now, AxisId axis, Instant clock, const DayClock& day, bool brief);
/// "12:04" of today, "yesterday", "9 days ago".
NumberText format_day_or_time(Instant when, Instant now, const DayClock& day);

}  // namespace hw::gui
