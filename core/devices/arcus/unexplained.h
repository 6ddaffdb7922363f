#pragma once
// Changes of a value that nothing explains which was sent.
#include <algorithm>

namespace hw::arcus {

/// Of one value of the controller. What goes out while it is being asked may change the answer or the next.
class Unexplained {
 public:
  /// How much had gone out when the value was asked for.
  enum class Mark : int {};

  void may_be_set() { ++sent_; }
  [[nodiscard]] Mark ask() const { return static_cast<Mark>(sent_); }
  /// True: nothing has gone out since the answer before was asked for, so a change is nobody's.
  bool answered(Mark asked) {
    const bool nothing_sent = sent_ == answered_;
    answered_ = std::max(answered_, static_cast<int>(asked));
    return nothing_sent;
  }
  /// What has gone out explains nothing any more.
  Mark settle() {
    answered_ = sent_;
    return ask();
  }

 private:
  int sent_ = 0, answered_ = 0;
};

}  // namespace hw::arcus
