#pragma once
// Joins paths with touching ends to chains, which are drawn without lifting the tool, and orders the chains
// for short travel between them.
#include <functional>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

struct Chain {
  std::vector<Curve> curves;
  int layer = 0;  ///< of its first path
  int entity = 0, line = 0;
  std::vector<int> paths;  ///< indexes in Drawing::paths
  [[nodiscard]] Point begin() const { return curves.front().from; }
  [[nodiscard]] Point end() const { return curves.back().to; }
  [[nodiscard]] bool closed() const { return curves.size() > 1 && begin() == end(); }
  [[nodiscard]] bool is_circle() const;
};

void turn_round(Chain& chain);
/// Index of a box of four lines around all other chains, such as margins; -1: none.
int box_around(const std::vector<Chain>& chains);
/// Joins the paths of shown layers, except those at indexes `without`, in the order of the file. Ends at most
/// `touching` apart are joined; across a gap the next curve begins at the end of the last.
std::vector<Chain> join(const Drawing& drawing, double touching, const std::vector<int>& without = {});

/// Length from `begin` to the first chain, and from each to the next. `in_turn`: of axes that move one after
/// the other.
double way_between(const std::vector<Chain>& chains, Point begin, bool in_turn = false);

/// Called now and then with the progress, 0 to 1. Return false to stop with the best order so far.
using Progress = std::function<bool(double done)>;
/// Orders by nearest neighbour, then improves by reversing parts of the order. Chains may be reversed, closed
/// chains begun at any of their points, circles anywhere. The old order is kept if no shorter one is found.
/// Long: for a worker.
void order(std::vector<Chain>& chains, Point begin, const Progress& progress = {});

}  // namespace hw::drawing
