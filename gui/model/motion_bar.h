#pragma once
// Why nothing may be moved now, for the tips of disabled buttons.
#include <array>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw::gui {

class MotionBar {
 public:
  /// The catalog must outlive it.
  explicit MotionBar(const Catalog& catalog);

  /// Once a frame.
  void refresh(const Snapshot& now);
  /// A sentence that says when this ends; empty: motion is allowed. Valid until the next refresh().
  [[nodiscard]] std::string_view why() const { return why_; }
  /// The same for one axis, whose motor may have no current.
  [[nodiscard]] std::string_view why(AxisId axis, const Snapshot& now) const;

 private:
  const Catalog& catalog_;
  std::array<std::string, max_axes> power_is_off_;  ///< the sentence if the power is off
  std::string why_;
  bool known_ = false;  ///< `why_` was made from these two:
  LinkState link_ = LinkState::closed;
  ProgramState program_;
};

}  // namespace hw::gui
