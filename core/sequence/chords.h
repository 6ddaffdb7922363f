#pragma once
// An arc as straight lines that lie close to it, for what cannot go along it.
#include <utility>

namespace hw::sequence {

class Chords {
 public:
  /// From (dx, dy), as seen from the centre, that far around it, counterclockwise. No chord lies more than
  /// `tolerance` beside the arc, in the unit of dx and dy; none is of more than half a circle.
  Chords(double dx, double dy, double degrees, double tolerance);
  [[nodiscard]] int count() const { return count_; }
  /// Where chord `n` of 1 to count() ends, as seen from the centre.
  [[nodiscard]] std::pair<double, double> end(int n) const;

 private:
  double radius_, begin_, turn_;  ///< radians
  int count_;
};

}  // namespace hw::sequence
