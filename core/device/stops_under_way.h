#pragma once
// Which stops with a ramp are under way: asked again for the same, a stop is at once. One of another axis, or
// the first of all axes, is no second one.
#include <array>

#include "core/base/index.h"
#include "core/device/snapshot.h"

namespace hw {

class StopsUnderWay {
 public:
  /// `axis` -1: all.
  [[nodiscard]] bool ramps(int axis) const { return all_ > 0 || (axis >= 0 && one_[ix(axis)] > 0); }
  [[nodiscard]] bool any() const { return count_ > 0; }

  void begin(int axis, bool at_once) { count(axis, at_once, 1); }
  void end(int axis, bool at_once) { count(axis, at_once, -1); }

 private:
  void count(int axis, bool at_once, int by) {
    count_ += by;
    if (!at_once) (axis < 0 ? all_ : one_[ix(axis)]) += by;
  }

  std::array<int, max_axes> one_{};
  int all_ = 0, count_ = 0;
};

}  // namespace hw
