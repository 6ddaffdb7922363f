#pragma once
// The limits that the console keeps for a controller, for commands without a window.
#include <string>

#include "core/device/snapshot.h"
#include "core/session/profile.h"
#include "core/session/session.h"

namespace hw::app {

class KeptLimits {
 public:
  /// Sets the limits of the controller's profile for this session; nothing is sent. A damaged profile is
  /// reported.
  explicit KeptLimits(Session& session);
  /// The sentence of a notice, with places in the units of the profile.
  [[nodiscard]] std::string words_of(const Notice& notice) const;

 private:
  const Session& session_;
  Profile profile_;
};

}  // namespace hw::app
