#pragma once
// Where the tool of an emulated machine has been along a drawing, and whether it has done what was asked of
// it.
#include <utility>
#include <vector>

#include "core/device/language.h"
#include "core/session/conversion.h"

namespace hw {

struct DrawnTrack {
  /// Within one step, and with the tool down where it is more than a dot.
  void expect_every_vertex() const;
  /// With the tool down it stays within the tolerance and one step of the drawing.
  void expect_nothing_beside() const;

  static constexpr double per_unit = 200;
  Conversion made;
  Rehearsal rehearsal;
  int out = 0;  ///< of the tool, by its place in the catalog

 private:
  [[nodiscard]] drawing::Point at(std::size_t n) const;
  [[nodiscard]] bool down(std::size_t n) const { return (rehearsal.track[n].outputs >> out & 1u) != 0; }
  [[nodiscard]] double nearest_pass(drawing::Point to, bool dot) const;
  [[nodiscard]] std::vector<std::pair<drawing::Point, drawing::Point>> drawn_lines() const;
};

}  // namespace hw
