#pragma once
// The nearest of many points, some of which are gone, wherever they lie: a balanced k-d tree.
#include <cmath>
#include <span>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

inline double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

class NearPoints {
 public:
  struct Entry {
    Point at;
    int owner = 0, place = 0;  ///< owners count from 0
  };
  static constexpr std::size_t most_found = 16;  ///< by one question
  explicit NearPoints(std::vector<Entry> entries);

  /// All of its points.
  void remove(int owner);
  /// None: there is no point left.
  [[nodiscard]] const Entry* nearest(Point from) const;
  /// The nearest of all but those of `owner`, the closest first. Returns how many `found` holds.
  std::size_t nearest(Point from, int owner, std::span<const Entry*> found) const;

 private:
  struct Search;
  struct Part {
    std::size_t first, last;
  };
  void divide(std::size_t first, std::size_t last);
  void take_away(std::size_t at);
  void look(Part part, Search& search) const;

  // A part of the points is divided by the one in its middle: what is less lies before it.
  std::vector<Entry> entries_;
  std::vector<int> left_;            ///< of the part with that middle: how many are still there
  std::vector<char> by_x_, gone_;    ///< of that middle
  std::vector<std::size_t> begins_;  ///< of an owner's places in `owned_`
  std::vector<std::size_t> owned_;
};

}  // namespace hw::drawing
