#pragma once
// Paths whose ends touch become chains, which the tool draws without being lifted; and in which order they
// are drawn, so that the ways in between are short.
#include <functional>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

struct Chain {
  std::vector<Curve> curves;
  int layer = 0;  ///< of its first path
  int entity = 0, line = 0;
  std::vector<int> paths;  ///< places in Drawing::paths
  [[nodiscard]] Point begin() const { return curves.front().from; }
  [[nodiscard]] Point end() const { return curves.back().to; }
  [[nodiscard]] bool closed() const { return curves.size() > 1 && begin() == end(); }
  [[nodiscard]] bool is_circle() const;
};

void turn_round(Chain& chain);
/// A box of four lines around all the others, as margins are: its place; -1: there is none.
int box_around(const std::vector<Chain>& chains);
/// The paths of layers that are shown, but those at `without` in Drawing::paths. Ends no further apart than
/// `touching` are joined, in the order of the file; where a gap is bridged the next curve begins where the
/// last one ends.
std::vector<Chain> join(const Drawing& drawing, double touching, const std::vector<int>& without = {});

/// From `begin` to the first, and from each to the next.
double way_between(const std::vector<Chain>& chains, Point begin);

/// Told now and then how far it is, from 0 to 1; false: it ends with what it has.
using Progress = std::function<bool(double done)>;
/// The nearest next, then improved by turning round parts of the order. Chains may be turned round, closed
/// ones begun at any of their points, circles anywhere. The order they have stays where none that is found is
/// shorter. Long, for a worker.
void order(std::vector<Chain>& chains, Point begin, const Progress& progress = {});

}  // namespace hw::drawing
