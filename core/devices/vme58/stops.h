#pragma once
// Sends stops and checks that they take effect. A stop of all axes goes through the mailbox and also empties
// the queues; a stop of one axis goes through the ring, if that is free.
#include "core/device/stop.h"
#include "core/devices/vme58/programs.h"

namespace hw::vme58 {

class Stops {
 public:
  Stops(Wire& wire, Readings& readings, Selection& selection, Conversation& conversation, Motions& motions,
        Speeds& speeds, Programs& programs, Effects& effects, StopEffect& effect, AllStop& all_stop,
        NextRound& next, const Catalog& catalog, Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        conversation_(conversation),
        motions_(motions),
        speeds_(speeds),
        programs_(programs),
        effects_(effects),
        effect_(effect),
        all_stop_(all_stop),
        next_(next),
        catalog_(catalog),
        snapshot_(snapshot) {}

  Task<Result<>> send(StopOrder order);
  /// SA, all axes: the mailbox has no place for an axis, and the ring cannot be written without reading it
  /// first.
  [[nodiscard]] LastWill last_will() const;
  /// Progress according to the latest round.
  StopProgress progress(const StopOrder& order);
  void forget();

 private:
  Task<Result<>> stop_motion(int axis, bool at_once, bool jog);
  Task<Result<>> stop_by_text(std::string text);
  Task<Result<bool>> stop_axis(std::string selector);
  [[nodiscard]] bool stops_alone(int axis) const;
  void stopping(int axis, bool at_once);
  void stands(int axis);
  StopProgress without_effect(int axis);
  [[nodiscard]] const std::string& name(int axis) const {
    return catalog_.axes[static_cast<std::size_t>(axis)].name;
  }

  Wire& wire_;
  Readings& readings_;
  Selection& selection_;
  Conversation& conversation_;
  Motions& motions_;
  Speeds& speeds_;
  Programs& programs_;
  Effects& effects_;
  StopEffect& effect_;
  AllStop& all_stop_;
  NextRound& next_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
  bool widened_ = false;  ///< a stop of one axis became a stop of all, and an axis still moves
};

}  // namespace hw::vme58
