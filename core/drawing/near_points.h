#pragma once
// Points in a grid of cells: the nearest one that is still there.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

inline double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

class NearPoints {
 public:
  struct Entry {
    Point at;
    int owner = 0, place = 0;
  };
  explicit NearPoints(const std::vector<Entry>& entries) {
    for (const Entry& e : entries) box_.add(e.at);
    const double width = box_.high.x - box_.low.x, height = box_.high.y - box_.low.y;
    const double each = std::sqrt(std::max(width * height, 1e-12) /
                                  static_cast<double>(std::max<std::size_t>(entries.size(), 1)));
    size_ = std::max({each * 1.5, std::max(width, height) / most_cells, 1e-9});
    columns_ = static_cast<int>(width / size_) + 1;
    rows_ = static_cast<int>(height / size_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const Entry& e : entries) cell(column(e.at), row(e.at)).push_back(e);
  }

  void remove(Point at, int owner) {
    auto& entries = cell(column(at), row(at));
    std::erase_if(entries, [&](const Entry& e) { return e.owner == owner && e.at == at; });
  }

  /// Those in cells around, nearest rings first, until `done` says that no further one matters: it is given
  /// the least distance that may still come.
  template <class Take, class Done>
  void around(Point from, Take take, Done done) const {
    const int c = std::clamp(column(from), 0, columns_ - 1), r = std::clamp(row(from), 0, rows_ - 1);
    const int furthest = std::max(columns_, rows_);
    for (int ring = 0; ring <= furthest; ++ring) {
      if (ring > 0 && done((ring - 1) * size_)) return;
      for (int row = r - ring; row <= r + ring; ++row) {
        if (row < 0 || row >= rows_) continue;
        const bool whole = row == r - ring || row == r + ring;
        for (int column = c - ring; column <= c + ring; column += whole || ring == 0 ? 1 : 2 * ring)
          if (column >= 0 && column < columns_)
            for (const Entry& e : cells_[index(column, row)]) take(e);
      }
    }
  }

  /// None: there is no point left.
  [[nodiscard]] const Entry* nearest(Point from) const {
    const Entry* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    around(
        from,
        [&](const Entry& e) {
          if (const double d = distance(e.at, from); d < least) least = d, best = &e;
        },
        [&](double closest) { return closest >= least + outside(from); });
    return best;
  }

 private:
  static constexpr double most_cells = 2000;
  /// A point beside the box is further from its cells than the rings tell.
  [[nodiscard]] double outside(Point p) const {
    const double dx = std::max({box_.low.x - p.x, p.x - box_.high.x, 0.0});
    const double dy = std::max({box_.low.y - p.y, p.y - box_.high.y, 0.0});
    return std::hypot(dx, dy);
  }
  [[nodiscard]] int column(Point p) const { return static_cast<int>(std::floor((p.x - box_.low.x) / size_)); }
  [[nodiscard]] int row(Point p) const { return static_cast<int>(std::floor((p.y - box_.low.y) / size_)); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  std::vector<Entry>& cell(int column, int row) { return cells_[index(column, row)]; }

  Box box_;
  double size_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<Entry>> cells_;
};

}  // namespace hw::drawing
