#include "core/devices/vxm/driver_parts.h"

namespace hw::vxm {

Known::Known(const Console& c, Conversation& talk, const std::function<Result<>()>& may_change)
    : nameplate(c, talk),
      signals(c, talk, nameplate),
      parameters(c, talk, nameplate, may_change),
      slots(c, talk, parameters, may_change),
      scratch(talk, slots),
      sight(c.scheduler),
      knowledge(nameplate, parameters, slots) {}

Course::Course(const Console& c, Conversation& talk, Known& k)
    : presence(c.scheduler, talk),
      ramp(c, k.nameplate, k.sight, k.hold),
      under_way(c, presence, k.slots, k.sight, k.hold, ramp),
      positions(c, talk, k.nameplate, k.signals, k.sight, k.hold, ramp, under_way),
      headline(c, presence, k.nameplate),
      kills(c, talk, presence, k.nameplate, k.sight, under_way, headline),
      hold_switch(talk, k.hold, kills),
      admission(c, presence, k.nameplate, k.parameters, under_way),
      restarts(c, talk, presence, k.knowledge, k.scratch, k.speeds, k.hold, under_way, positions),
      status(c, talk, presence, k.hold, under_way, restarts) {}

Work::Work(const Console& c, Conversation& talk, Known& k, Course& now)
    : legs(c, talk, k.signals, k.slots, k.scratch, k.speeds, k.hold, now.hold_switch, k.knowledge,
           now.presence, now.under_way, now.ramp, now.positions, now.status),
      moves(c, talk, k.nameplate, k.signals, k.parameters, k.speeds, now.admission, now.positions, legs),
      runs(c, talk, k.slots, k.speeds, k.sight, k.hold, now.hold_switch, now.ramp, now.under_way,
           now.admission, legs),
      stops(c, talk, now.presence, now.under_way, now.ramp, now.kills, now.hold_switch),
      texts(c, talk, k.parameters, k.slots, k.speeds, k.hold, now.presence, now.under_way, now.ramp,
            now.kills, now.positions) {}

Watch::Watch(const Console& c, Conversation& talk, Known& k, Course& now, Work& w)
    : echo(c, talk),
      opening(c, talk, now.presence, k.hold, now.under_way, now.positions, now.restarts, echo, w.legs),
      rounds(c, talk, k.nameplate, k.signals, k.knowledge, now.presence, now.under_way, now.positions,
             now.headline, now.status, echo, w.legs, w.runs),
      unasked(c, now.presence, k.nameplate, k.slots, k.hold, now.under_way, now.headline) {}

}  // namespace hw::vxm
