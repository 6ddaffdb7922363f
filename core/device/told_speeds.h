#pragma once
// What a program text has said of one set of speeds so far, so that each motion finds those that it is to
// have.
#include <optional>

#include "core/device/sequence_draft.h"

namespace hw {

class ToldSpeeds {
 public:
  /// What has to be said so that a motion has the speeds that are wanted; 0: nothing. None: one is to be as
  /// the controller has it, and the text has changed that.
  std::optional<StepSpeeds> towards(const StepSpeeds& wanted) {
    StepSpeeds say;
    if (!high_.towards(wanted.high, say.high) || !low_.towards(wanted.low, say.low) ||
        !ramp_.towards(wanted.ramp_ms, say.ramp_ms))
      return std::nullopt;
    return say;
  }
  /// Behind text of somebody else's, which may have said others.
  void doubt() { high_.doubt(false), low_.doubt(false), ramp_.doubt(false); }
  /// At the begin of steps that are repeated and say speeds themselves.
  void begin_repeated() { high_.doubt(true), low_.doubt(true), ramp_.doubt(true); }

 private:
  template <class Value>
  struct Told {
    Value value{};  ///< 0: another than the controller's own, nobody knows which
    bool changed = false;
    bool towards(Value wanted, Value& say) {
      if (wanted == Value{}) return !changed;
      if (!changed || value != wanted) say = wanted;
      value = wanted, changed = true;
      return true;
    }
    void doubt(bool any) {
      if (any || changed) value = Value{}, changed = true;
    }
  };
  Told<std::int64_t> high_, low_;
  Told<double> ramp_;
};

/// Whether any step says speeds, loops entered.
bool says_speeds(const sequence::StepList& steps);

}  // namespace hw
