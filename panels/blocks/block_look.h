#pragma once
// Chooses the units of blocks: for each axis the unit that the console shows, else the sequence's own unit.
#include <array>
#include <cstdint>
#include <span>

#include "core/sequence/editor.h"
#include "core/sequence/words.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class BlockLook {
 public:
  /// Call once a frame. Returns true when the look has changed.
  bool follow(const gui::Frame& frame, const sequence::Editor& editor);
  /// The units now shown for the axes.
  std::span<const gui::DisplayUnit> units(const gui::Frame& frame);
  [[nodiscard]] const sequence::Look& look() const { return look_; }

 private:
  sequence::Look look_;
  std::array<gui::DisplayUnit, max_axes> units_;  ///< the units from which the look was made
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace hw::panels
