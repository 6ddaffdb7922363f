#pragma once
// The effect of a stop, as the speeds of the axes show it.
#include <array>
#include <optional>

#include "core/devices/vme58/motions.h"

namespace hw::vme58 {

class StopEffect {
 public:
  StopEffect(const Wire& wire, const Readings& readings, const Motions& motions, const Catalog& catalog)
      : wire_(wire), readings_(readings), motions_(motions), catalog_(catalog) {}

  /// The state of one axis, or of all (-1).
  struct Seen {
    bool turns = false;
    bool slows = false;    ///< some axis has lost speed, or may yet
    bool overdue = false;  ///< some axis should long be at rest
  };
  Seen look(int axis, bool at_once);
  /// The stop was sent, or sent again.
  void stop_sent(int axis);
  /// The axis was seen turning since the stop was sent.
  [[nodiscard]] bool is_watched(int axis) const { return axes_[static_cast<std::size_t>(axis)].has_value(); }
  /// -1: all axes.
  void forget(int axis);

 private:
  struct SlowDown {
    Instant since{};      ///< first seen turning then
    Instant slower_at{};  ///< when it last lost speed, or the stop was sent again
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
