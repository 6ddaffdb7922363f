#pragma once
// The speeds that a program text has set so far, so that each motion gets its own.
#include <optional>

#include "core/device/sequence_draft.h"

namespace hw {

class WrittenSpeeds {
 public:
  /// The speeds to be written so that a motion has the wanted speeds; 0: nothing to write. None: one of them
  /// must be the controller's own, and the text has changed it.
  std::optional<StepSpeeds> towards(const StepSpeeds& wanted) {
    StepSpeeds needed;
    if (!high_.towards(wanted.high, needed.high) || !low_.towards(wanted.low, needed.low) ||
        !ramp_.towards(wanted.ramp_ms, needed.ramp_ms))
      return std::nullopt;
    return needed;
  }
  /// After foreign text, which may have set other speeds.
  void doubt() { high_.doubt(false), low_.doubt(false), ramp_.doubt(false); }
  /// At the beginning of repeated steps that set speeds themselves.
  void begin_repeated() { high_.doubt(true), low_.doubt(true), ramp_.doubt(true); }

 private:
  template <class Value>
  struct Written {
    Value value{};  ///< 0: not the controller's own, and unknown
    bool changed = false;
    bool towards(Value wanted, Value& needed) {
      if (wanted == Value{}) return !changed;
      if (!changed || value != wanted) needed = wanted;
      value = wanted, changed = true;
      return true;
    }
    void doubt(bool any) {
      if (any || changed) value = Value{}, changed = true;
    }
  };
  Written<std::int64_t> high_, low_;
  Written<double> ramp_;
};

/// Whether any step sets speeds, loops included.
bool sets_speeds(const sequence::StepList& steps);

}  // namespace hw
