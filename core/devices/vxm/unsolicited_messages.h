#pragma once
// Handles unsolicited messages of the controller.
#include <string_view>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/headline.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class UnsolicitedMessages {
 public:
  UnsolicitedMessages(const Console& console, Presence& presence, Identification& identification,
                      const Slots& slots, Hold& hold, UnderWay& under_way, const Headline& headline)
      : console_(console),
        presence_(presence),
        identification_(identification),
        slots_(slots),
        hold_(hold),
        under_way_(under_way),
        headline_(headline) {}

  void received(const Message& message);

 private:
  void received_prompt();
  void received_held(std::string_view command);
  void received_error(char letter);
  void received_limit();

  const Console& console_;
  Presence& presence_;
  Identification& identification_;
  const Slots& slots_;
  Hold& hold_;
  UnderWay& under_way_;
  const Headline& headline_;
};

}  // namespace hw::vxm
