#include "core/devices/vxm/driver_parts.h"

namespace hw::vxm {

Known::Known(const Console& c, Conversation& conversation, const std::function<Result<>()>& may_change)
    : identification(c, conversation),
      signals(c, conversation, identification),
      parameters(c, conversation, identification, may_change),
      slots(c, conversation, parameters, may_change),
      scratch(conversation, slots),
      readings(c.scheduler),
      knowledge(identification, parameters, slots) {}

Course::Course(const Console& c, Conversation& conversation, Known& k)
    : presence(c.scheduler, conversation),
      ramp(c, k.identification, k.readings, k.hold),
      under_way(c, presence, k.slots, k.readings, k.hold, ramp),
      positions(c, conversation, k.identification, k.signals, k.readings, k.hold, ramp, under_way),
      headline(c, presence, k.identification),
      kills(c, conversation, presence, k.identification, k.readings, under_way, headline),
      hold_switch(conversation, k.hold, kills),
      admission(c, presence, k.identification, k.parameters, under_way),
      restarts(c, conversation, presence, k.knowledge, k.scratch, k.speeds, k.hold, under_way, positions),
      status(c, conversation, presence, k.hold, under_way, restarts) {}

Work::Work(const Console& c, Conversation& conversation, Known& k, Course& now)
    : legs(c, conversation, k.signals, k.slots, k.scratch, k.speeds, k.hold, now.hold_switch, k.knowledge,
           now.presence, now.under_way, now.ramp, now.positions, now.status),
      moves(c, conversation, k.identification, k.signals, k.parameters, k.speeds, now.admission,
            now.positions, legs),
      runs(c, conversation, k.slots, k.speeds, k.readings, k.hold, now.hold_switch, now.ramp, now.under_way,
           now.admission, legs),
      stops(c, conversation, now.presence, now.under_way, now.ramp, now.kills, now.hold_switch),
      texts(c, conversation, k.parameters, k.slots, k.speeds, k.hold, now.presence, now.under_way, now.ramp,
            now.kills, now.positions) {}

Watch::Watch(const Console& c, Conversation& conversation, Known& k, Course& now, Work& w)
    : echo(c, conversation),
      opening(c, conversation, now.presence, k.hold, now.under_way, now.positions, now.restarts, echo,
              w.legs),
      rounds(c, conversation, k.identification, k.signals, k.knowledge, now.presence, now.under_way,
             now.positions, now.headline, now.status, echo, w.legs, w.runs),
      unsolicited(c, now.presence, k.identification, k.slots, k.hold, now.under_way, now.headline) {}

}  // namespace hw::vxm
