#pragma once
// Gives commands without a window the limits that the console keeps for a controller.
#include <string>

#include "core/device/snapshot.h"
#include "core/session/profile.h"
#include "core/session/session.h"

namespace hw::app {

class KeptLimits {
 public:
  /// Sets the limits of the controller's profile for this session. Sends nothing. Reports a damaged profile.
  explicit KeptLimits(Session& session);
  /// The sentence of a notice, with positions in the units of the profile.
  [[nodiscard]] std::string words_of(const Notice& notice) const;

 private:
  const Session& session_;
  Profile profile_;
};

}  // namespace hw::app
