#pragma once
// Speed and acceleration of the axes: VL and AC.
#include "core/device/target_check.h"
#include "core/devices/vme58/own_setting.h"

namespace hw::vme58 {

class Speeds {
 public:
  Speeds(Readings& readings, const Selection& selection, Commands& commands, Queues& queues,
         const Motions& motions, const Catalog& catalog, Snapshot& snapshot)
      : velocity("VL", AxisValue::maximum_velocity, readings, selection, commands, queues, motions, catalog,
                 snapshot),
        acceleration("AC", AxisValue::acceleration, readings, selection, commands, queues, motions, catalog,
                     snapshot) {}

  OwnSetting velocity, acceleration;

  /// Borrows the settings that `pace` gives; the others keep the user's values.
  Task<Result<>> borrow(int axis, WholePace pace);
  Task<Result<>> give_back(int axis, Priority priority);
  Task<Result<>> give_all_back(Priority priority);
  Task<Result<>> give_back_behind_motions(Priority priority);

  void note(const TextCommand& command);
  void forget_put(int axis) { velocity.forget_put(axis), acceleration.forget_put(axis); }
  void take_queues(unsigned all_free) { velocity.take_queues(all_free), acceleration.take_queues(all_free); }
  void take(int axis) { velocity.take(axis), acceleration.take(axis); }
  void wire_lost() { velocity.wire_lost(), acceleration.wire_lost(); }
  void forget() { velocity.forget(), acceleration.forget(); }
  /// The setting shown in `cell`; null: neither.
  OwnSetting* shown_at(std::optional<AxisValue> cell);
};

}  // namespace hw::vme58
