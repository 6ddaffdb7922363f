#pragma once
// Handles unsolicited messages of the controller.
#include <string_view>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/headline.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Unasked {
 public:
  Unasked(const Console& console, Presence& presence, Nameplate& nameplate, const Slots& slots, Hold& hold,
          UnderWay& under_way, const Headline& headline)
      : console_(console),
        presence_(presence),
        nameplate_(nameplate),
        slots_(slots),
        hold_(hold),
        under_way_(under_way),
        headline_(headline) {}

  void heard(const Message& message);

 private:
  void heard_prompt();
  void heard_held(std::string_view command);
  void heard_error(char letter);
  void heard_limit();

  const Console& console_;
  Presence& presence_;
  Nameplate& nameplate_;
  const Slots& slots_;
  Hold& hold_;
  UnderWay& under_way_;
  const Headline& headline_;
};

}  // namespace hw::vxm
