#pragma once
// What the two halves of the pump share, and nobody else sees.
#include <string>

#include "core/device/pump.h"

namespace hw {

/// A controller's status may lag behind the command by a round or two.
constexpr int fast_polls_after_a_command = 3;

struct Pump::Job {
  Intent intent;
  bool is_query = false;
  bool recovers = false;  ///< may be what makes a silent controller answer again
  std::string text;
  Duration patience{};
  Result<std::string> reply{std::string()};
  Suspended asker;
  bool answered = false;
  explicit Job(Intent i) : intent(std::move(i)) {}
};

}  // namespace hw
