#pragma once
// Nearest neighbours among many points with removal, for any distribution: a balanced k-d tree.
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
  static constexpr std::size_t most_found = 16;  ///< by one search
  explicit NearPoints(std::vector<Entry> entries);

  /// Removes all points of an owner.
  void remove(int owner);
  /// Null: no points left.
  [[nodiscard]] const Entry* nearest(Point from) const;
  /// The nearest points of other owners than `owner`, closest first. Returns how many were found.
  std::size_t nearest(Point from, int owner, std::span<const Entry*> found) const;

 private:
  struct Search;
  struct Part {
    std::size_t first, last;
  };
  void divide(std::size_t first, std::size_t last);
  void take_away(std::size_t at);
  void look(Part part, Search& search) const;

  // Each part is divided by its middle point; smaller ones lie before it.
  std::vector<Entry> entries_;
  std::vector<int> left_;            ///< points left in the part divided by that middle point
  std::vector<char> by_x_, gone_;    ///< of that middle point
  std::vector<std::size_t> begins_;  ///< of an owner's places in `owned_`
  std::vector<std::size_t> owned_;
};

}  // namespace hw::drawing
