#pragma once
// A stop that may not have reached the controller before its wire was lost: of a held jog, or one that was
// asked for. What then still moves is stopped when the wire is back; a stop may be said twice. Io thread.
#include <utility>

namespace hw {

class OwedStop {
 public:
  /// -1: all axes.
  void add(int axis) {
    axis_ = owed_ && axis_ != axis ? -1 : axis;
    owed_ = true;
  }
  [[nodiscard]] bool any() const { return owed_; }
  void forget() { owed_ = false; }
  /// The axis, and nothing is owed any more.
  [[nodiscard]] int take() {
    owed_ = false;
    return axis_;
  }

 private:
  bool owed_ = false;
  int axis_ = -1;
};

}  // namespace hw
