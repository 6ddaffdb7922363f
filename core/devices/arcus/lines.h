#pragma once
// Inputs, outputs and motor power.
#include <string>

#include "core/device/tool_off.h"
#include "core/devices/arcus/second_look.h"
#include "core/devices/arcus/set_up.h"

namespace hw::arcus {

class Lines {
 public:
  Lines(const Console& console, Conversation& conversation, const SetUp& setup)
      : console_(console), conversation_(conversation), setup_(setup) {}

  Task<Result<>> read(Priority priority);
  /// Until `until` the inputs are also read between the questions of a round, and reported at once.
  void watch_inputs(Instant until) { watched_until_ = until; }
  [[nodiscard]] bool glance_is_due() const;
  Task<> glance();
  Task<Result<>> set_output(intent::SetOutput request);
  Task<Result<>> set_power(intent::SetPower request);
  /// Sends each command even if another fails. The next round reads the outputs.
  Task<Result<>> switch_tool_off(ToolOff tool);

  /// The user's own text may have switched a motor: the next round reads the lines.
  void look_soon() { due_ = true; }
  /// True once.
  [[nodiscard]] bool are_due() { return std::exchange(due_, false); }

 private:
  [[nodiscard]] std::string holder_of(int output) const;
  void show_to_watchers(std::int64_t inputs);
  void show_inputs(std::int64_t inputs, Instant asked_at);

  const Console& console_;
  Conversation& conversation_;
  const SetUp& setup_;
  SecondLook look_, glance_look_;
  bool due_ = false;
  Instant watched_until_{}, glanced_at_{};
};

}  // namespace hw::arcus
