#include "core/devices/vxm/headline.h"

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

void Headline::show() const {
  Snapshot& draft = console_.draft;
  if (presence_.is_halted()) {
    const ErrorWords words = explain_error(presence_.error());
    draft.notice = words.what + " " + words.advice;
    return;
  }
  if (presence_.stays_local()) {
    draft.notice =
        "The controller is in Local mode: its own buttons jog. The next command puts it on-line again.";
    return;
  }
  draft.notice.clear();
  constexpr std::string_view types[] = {"M1M", "M2M", "M3M", "M4M"};
  constexpr std::string_view untold[] = {
      "Motor 1 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Setup, Motors, "
      "before the first move.",
      "Motor 2 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Setup, Motors, "
      "before the first move.",
      "Motor 3 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Setup, Motors, "
      "before the first move.",
      "Motor 4 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Setup, Motors, "
      "before the first move."};
  for (int i = 0; i < draft.axis_count; ++i)
    if (parameters_.value(types[i]) == 0) {
      draft.notice = untold[i];
      return;
    }
  if (nameplate_.has_slave() && draft.axis_count <= motors_per_controller) draft.notice = unused_slave;
}

}  // namespace hw::vxm
