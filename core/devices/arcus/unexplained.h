#pragma once
// Changes of a value that no sent command explains.
#include <algorithm>

namespace hw::arcus {

/// Watches one value of the controller. A command sent while the value is being asked for may change this
/// reply or the next.
class Unexplained {
 public:
  /// How much had been sent when the value was asked for.
  enum class Mark : int {};

  void may_be_set() { ++sent_; }
  [[nodiscard]] Mark ask() const { return static_cast<Mark>(sent_); }
  /// True: nothing was sent since the previous reply was asked for, so a change is unexplained.
  bool answered(Mark asked) {
    const bool nothing_sent = sent_ == answered_;
    answered_ = std::max(answered_, static_cast<int>(asked));
    return nothing_sent;
  }
  /// Commands sent so far explain no later change.
  Mark settle() {
    answered_ = sent_;
    return ask();
  }

 private:
  int sent_ = 0, answered_ = 0;
};

}  // namespace hw::arcus
