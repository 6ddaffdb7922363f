#pragma once
// Readouts, variables and analog inputs: those being watched are read each round, the rest in turn.
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/device/in_turn.h"
#include "core/devices/arcus/conversation.h"

namespace hw::arcus {

class Readouts {
 public:
  /// `loop_is` gets the StepNLoop state of an axis.
  Readouts(const Console& console, Conversation& conversation,
           std::function<void(int axis, std::int64_t state)> loop_is);

  void watch(std::uint32_t groups) { watched_ = groups; }
  /// Takes a value that came with another reply.
  void put(std::string_view id, std::int64_t value);
  /// The move mode as last read.
  [[nodiscard]] bool incremental() const { return incremental_; }
  /// The move mode; none: not read since the controller was connected or switched on.
  [[nodiscard]] std::optional<bool> known_incremental() const;

  /// The move mode, where the status does not contain it.
  Task<Result<>> read_mode(Priority priority);
  Task<Result<>> read_watched();
  /// Reads one readout that is not watched, and one analog input.
  Task<Result<>> read_in_turn();
  Task<Result<>> read_variable(int number, Priority priority);
  Task<Result<>> read_analog(int number, Priority priority);

 private:
  Task<Result<>> read(int index, Priority priority);

  const Console& console_;
  Conversation& conversation_;
  std::function<void(int, std::int64_t)> loop_is_;
  std::vector<bool> by_status_;  ///< readouts contained in the status
  std::uint32_t watched_ = 0;
  InTurn readouts_, variables_, analog_;
  bool incremental_ = false;
};

}  // namespace hw::arcus
