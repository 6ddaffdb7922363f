#pragma once
// What the speeds of the axes show of a stop.
#include <array>
#include <optional>

#include "core/devices/vme58/motions.h"

namespace hw::vme58 {

class StopEffect {
 public:
  StopEffect(const Wire& wire, const Readings& readings, const Motions& motions, const Catalog& catalog)
      : wire_(wire), readings_(readings), motions_(motions), catalog_(catalog) {}

  /// Of one axis, or of all (-1).
  struct Seen {
    bool turns = false;
    bool slows = false;    ///< some axis has lost speed, or may yet
    bool overdue = false;  ///< some axis should have stood long ago
  };
  Seen look(int axis, bool at_once);
  /// It was told, or told again.
  void told(int axis);
  /// It has been seen turning since it was told.
  [[nodiscard]] bool is_watched(int axis) const { return axes_[static_cast<std::size_t>(axis)].has_value(); }
  /// -1: all.
  void forget(int axis);

 private:
  struct SlowDown {
    Instant since{};      ///< first seen turning then
    Instant slower_at{};  ///< it has lost speed, or was told again
    std::int64_t first = 0, least = 0;
  };
  const SlowDown& look_at(int axis);
  [[nodiscard]] double acceleration(int axis) const;
  [[nodiscard]] Duration effect_patience(int axis, const SlowDown& seen) const;
  [[nodiscard]] Duration longest_ramp(int axis, const SlowDown& seen) const;

  const Wire& wire_;
  const Readings& readings_;
  const Motions& motions_;
  const Catalog& catalog_;
  std::array<std::optional<SlowDown>, most_axes> axes_{};
};

}  // namespace hw::vme58
