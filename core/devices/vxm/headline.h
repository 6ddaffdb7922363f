#pragma once
// The one sentence about what needs the user's attention most.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/presence.h"

namespace hw::vxm {

class Headline {
 public:
  Headline(const Console& console, const Presence& presence, const Nameplate& nameplate,
           const Parameters& setup)
      : console_(console), presence_(presence), nameplate_(nameplate), parameters_(setup) {}

  /// Called each round: nothing in it allocates while all is well.
  void show() const;

 private:
  const Console& console_;
  const Presence& presence_;
  const Nameplate& nameplate_;
  const Parameters& parameters_;
};

}  // namespace hw::vxm
