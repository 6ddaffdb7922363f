#pragma once
// What the parts of the pump share, and nobody else sees.
#include <exception>
#include <string>

#include <fmt/core.h>

#include "core/device/pump.h"

namespace hw {

/// A controller's status may lag behind the command by a round or two.
constexpr int fast_polls_after_a_command = 3;

constexpr std::string_view stopped_first = "A stop came first. This was not sent.";

inline Fault failed_inside(const char* what, const std::exception& defect) {
  return Fault(FaultKind::internal, fmt::format("The {} failed inside: {}.", what, defect.what()),
               "What the controller did with it is not known.", "Look at its state before the next command.");
}

struct Pump::Job {
  Intent intent;
  bool is_query = false;
  bool recovers = false;           ///< may be what makes a silent controller answer again
  std::uint64_t stops_before = 0;  ///< for those whom the text is for, on this wire
  std::string text;
  Duration patience{};
  Result<std::string> reply{std::string()};
  Suspended asker;
  bool answered = false;
  explicit Job(Intent i) : intent(std::move(i)) {}
};

}  // namespace hw
