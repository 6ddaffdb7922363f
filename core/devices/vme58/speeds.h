#pragma once
// At which speed an axis goes, and how it comes there: VL and AC.
#include "core/devices/vme58/own_setting.h"

namespace hw::vme58 {

/// Of one motion, in whole counts; 0: as the axis is set.
struct WholePace {
  std::int64_t speed = 0, acceleration = 0;
};

class Speeds {
 public:
  Speeds(Readings& readings, const Selection& selection, Commands& commands, Queues& queues,
         const Motions& motions, const Catalog& catalog, Snapshot& draft)
      : velocity("VL", AxisValue::maximum_velocity, readings, selection, commands, queues, motions, catalog,
                 draft),
        acceleration("AC", AxisValue::acceleration, readings, selection, commands, queues, motions, catalog,
                     draft) {}

  OwnSetting velocity, acceleration;

  /// What the pace has of its own is borrowed, the rest is as the user has it.
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
  /// The one whose cell this is; null: neither.
  OwnSetting* shown_at(std::optional<AxisValue> cell);
};

}  // namespace hw::vme58
