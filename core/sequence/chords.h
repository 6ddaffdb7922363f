#pragma once
// An arc as straight lines close to it, for machines without arcs.
#include <utility>

namespace hw::sequence {

class Chords {
 public:
  /// From (dx, dy), relative to the centre, by `degrees` counterclockwise. No chord lies more than
  /// `tolerance` from the arc, in the unit of dx and dy; none spans more than half a circle.
  Chords(double dx, double dy, double degrees, double tolerance);
  [[nodiscard]] int count() const { return count_; }
  /// End of chord `n`, from 1 to count(), relative to the centre.
  [[nodiscard]] std::pair<double, double> end(int n) const;

 private:
  double radius_, begin_, turn_;  ///< radians
  int count_;
};

}  // namespace hw::sequence
