#pragma once
// One sentence on the most urgent matter for the user.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/presence.h"

namespace hw::vxm {

class Headline {
 public:
  Headline(const Console& console, const Presence& presence, const Identification& identification)
      : console_(console), presence_(presence), identification_(identification) {}

  /// Called each round: allocates nothing while all is well.
  void show() const;

 private:
  const Console& console_;
  const Presence& presence_;
  const Identification& identification_;
};

}  // namespace hw::vxm
