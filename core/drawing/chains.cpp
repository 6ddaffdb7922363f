#include "core/drawing/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/index.h"
#include "core/drawing/near_points.h"

namespace hw::drawing {
namespace {

Chain chain_of(const Path& path, int place) {
  return {path.curves, path.layer, path.entity, path.line, {place}};
}

void begin_at(Chain& closed, std::size_t curve) {
  std::rotate(closed.curves.begin(), closed.curves.begin() + static_cast<std::ptrdiff_t>(curve),
              closed.curves.end());
}

/// The nearest point of a circle; any point from its centre.
Point place_on_circle(const Curve& circle, Point to) {
  const Point middle = circle.centre;
  const double away = distance(middle, to);
  if (!(away > 0)) return circle.from;
  const double share = distance(middle, circle.from) / away;
  return {middle.x + (to.x - middle.x) * share, middle.y + (to.y - middle.y) * share};
}
void begin_circle_at(Chain& circle, Point at) { circle.curves[0].from = circle.curves[0].to = at; }

/// Whether a path is closed by itself and so joined to nothing.
bool is_ring(const Path& path) { return path.closed() || path.curves.front().from == path.curves.back().to; }

/// Joins the open ends of paths.
class Joining {
 public:
  /// `open`: indexes in Drawing::paths.
  Joining(const std::vector<Path>& paths, const std::vector<int>& open, double touching)
      : paths_(paths),
        open_(open),
        touching_(touching),
        ends_(entries(paths, open)),
        used_(open.size(), false) {}

  Chain grow(std::size_t first) {
    Chain chain = chain_at(first);
    use(first);
    while (extend(chain)) {
    }
    turn_round(chain);
    while (extend(chain)) {
    }
    turn_round(chain);
    if (chain.curves.size() > 1 && distance(chain.begin(), chain.end()) <= touching_)
      chain.curves.back().to = chain.begin();
    return chain;
  }
  [[nodiscard]] bool used(std::size_t i) const { return used_[i]; }

 private:
  static std::vector<NearPoints::Entry> entries(const std::vector<Path>& paths,
                                                const std::vector<int>& open) {
    std::vector<NearPoints::Entry> all;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const std::vector<Curve>& curves = paths[ix(open[i])].curves;
      all.push_back({curves.front().from, static_cast<int>(i), 0});
      all.push_back({curves.back().to, static_cast<int>(i), 1});
    }
    return all;
  }
  [[nodiscard]] Chain chain_at(std::size_t i) const { return chain_of(paths_[ix(open_[i])], open_[i]); }
  bool extend(Chain& chain) {
    const NearPoints::Entry* next = ends_.nearest(chain.end());
    if (!next || distance(next->at, chain.end()) > touching_) return false;
    const auto owner = static_cast<std::size_t>(next->owner);
    const bool from_its_end = next->place == 1;
    Chain more = chain_at(owner);
    if (from_its_end) turn_round(more);
    use(owner);
    more.curves.front().from = chain.end();
    chain.curves.insert(chain.curves.end(), more.curves.begin(), more.curves.end());
    chain.paths.push_back(more.paths.front());
    return true;
  }
  void use(std::size_t i) {
    used_[i] = true;
    ends_.remove(static_cast<int>(i));
  }

  const std::vector<Path>& paths_;
  const std::vector<int>& open_;
  double touching_;
  NearPoints ends_;
  std::vector<bool> used_;
};

/// Adds search points of a circle, one of them near to any of its points.
void add_places_of_circle(const Curve& circle, int owner, std::vector<NearPoints::Entry>& entries) {
  const double radius = distance(circle.centre, circle.from), half = radius / std::numbers::sqrt2;
  for (const Point p : {Point{radius, 0}, Point{half, half}, Point{0, radius}, Point{-half, half},
                        Point{-radius, 0}, Point{-half, -half}, Point{0, -radius}, Point{half, -half}})
    entries.push_back({{circle.centre.x + p.x, circle.centre.y + p.y}, owner, 0});
}

/// Orders chains by nearest neighbour.
std::vector<Chain> nearest_first(std::vector<Chain> chains, Point here, const Progress& progress) {
  std::vector<NearPoints::Entry> entries;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const int owner = static_cast<int>(i);
    if (chains[i].is_circle())
      add_places_of_circle(chains[i].curves[0], owner, entries);
    else if (chains[i].closed())
      for (std::size_t k = 0; k < chains[i].curves.size(); ++k)
        entries.push_back({chains[i].curves[k].from, owner, static_cast<int>(k)});
    else
      entries.push_back({chains[i].begin(), owner, 0}), entries.push_back({chains[i].end(), owner, -1});
  }
  NearPoints near(std::move(entries));
  std::vector<Chain> ordered;
  ordered.reserve(chains.size());
  while (const NearPoints::Entry* next = near.nearest(here)) {
    const int place = next->place;
    Chain& chain = chains[ix(next->owner)];
    near.remove(next->owner);
    if (chain.is_circle())
      begin_circle_at(chain, place_on_circle(chain.curves[0], here));
    else if (place < 0)
      turn_round(chain);
    else if (place > 0)
      begin_at(chain, ix(place));
    here = chain.end();
    ordered.push_back(std::move(chain));
    if (progress && ordered.size() % 1024 == 0 &&
        !progress(0.5 * static_cast<double>(ordered.size()) / static_cast<double>(chains.size()))) {
      for (Chain& c : chains)
        if (!c.curves.empty()) ordered.push_back(std::move(c));
      break;
    }
  }
  return ordered;
}

/// Reverses parts of the order as long as that shortens the way (2-opt on nearby ends).
class Turning {
 public:
  Turning(std::vector<Chain>& chains, Point begin) : chains_(chains), begin_(begin) {
    const NearPoints ends(entries(chains));
    near_begin_ = near(ends, begin, -1);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      near_.push_back(near(ends, chains[i].begin(), static_cast<int>(i)));
      near_.push_back(near(ends, chains[i].end(), static_cast<int>(i)));
    }
    for (std::size_t i = 0; i < chains.size(); ++i)
      order_.push_back(static_cast<int>(i)), place_.push_back(static_cast<int>(i));
    turned_.resize(chains.size(), 0);
  }

  void run(const Progress& progress) {
    bool better = true;
    for (int pass = 0; better && pass < most_passes; ++pass) {
      better = false;
      for (int i = -1; i + 1 < size(); ++i) {
        better = improve(i) || better;
        if (progress && i % 1024 == 0 && !progress(0.5 + 0.5 * (pass + double(i) / size()) / most_passes))
          return;
      }
    }
  }

  void apply() {
    std::vector<Chain> ordered;
    ordered.reserve(chains_.size());
    for (const int i : order_) {
      ordered.push_back(std::move(chains_[ix(i)]));
      if (turned_[ix(i)]) turn_round(ordered.back());
    }
    chains_ = std::move(ordered);
  }

 private:
  static constexpr int most_passes = 12;
  static constexpr std::size_t neighbours = 10;
  /// Chains with an end nearby, nearest first; -1: no more.
  using Near = std::array<int, neighbours>;

  static Near near(const NearPoints& ends, Point from, int owner) {
    std::array<const NearPoints::Entry*, neighbours> found{};
    const std::size_t count = ends.nearest(from, owner, found);
    Near near;
    near.fill(-1);
    for (std::size_t i = 0; i < count; ++i) near[i] = found[i]->owner;
    return near;
  }

  static std::vector<NearPoints::Entry> entries(const std::vector<Chain>& chains) {
    std::vector<NearPoints::Entry> all;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      all.push_back({chains[i].begin(), static_cast<int>(i), 0});
      all.push_back({chains[i].end(), static_cast<int>(i), 1});
    }
    return all;
  }
  [[nodiscard]] int size() const { return static_cast<int>(order_.size()); }
  /// The point where the tool leaves the chain at `place`; -1: the start of all chains.
  [[nodiscard]] Point leaves(int place) const {
    if (place < 0) return begin_;
    const int i = order_[ix(place)];
    return turned_[ix(i)] ? chains_[ix(i)].begin() : chains_[ix(i)].end();
  }
  [[nodiscard]] Point enters(int place) const {
    const int i = order_[ix(place)];
    return turned_[ix(i)] ? chains_[ix(i)].end() : chains_[ix(i)].begin();
  }
  /// Length of the way to the chain at `place`; 0 after the last.
  [[nodiscard]] double way_into(int place, Point from) const {
    return place < size() ? distance(from, enters(place)) : 0;
  }

  /// The chains near the end at which the tool leaves `place`.
  [[nodiscard]] const Near& near_where_it_leaves(int place) const {
    if (place < 0) return near_begin_;
    const int i = order_[ix(place)];
    return near_[2 * ix(i) + (turned_[ix(i)] ? 0 : 1)];
  }
  bool improve(int i) {
    const double now = distance(leaves(i), enters(i + 1));
    double most = least_gain;
    int best = i;
    for (const int chain : near_where_it_leaves(i)) {
      if (chain < 0) break;
      const int j = place_[ix(chain)];
      if (j <= i + 1) continue;
      const double before = now + way_into(j + 1, leaves(j));
      const double after = distance(leaves(i), leaves(j)) + way_into(j + 1, enters(i + 1));
      if (before - after > most) most = before - after, best = j;
    }
    if (best == i) return false;
    turn(i + 1, best);
    return true;
  }
  void turn(int first, int last) {
    std::reverse(order_.begin() + first, order_.begin() + last + 1);
    for (int p = first; p <= last; ++p) {
      const int i = order_[ix(p)];
      place_[ix(i)] = p;
      turned_[ix(i)] ^= 1;
    }
  }

  static constexpr double least_gain = 1e-9;
  std::vector<Chain>& chains_;
  Point begin_;
  Near near_begin_{};
  std::vector<Near> near_;  ///< for begin and end of each chain
  std::vector<int> order_, place_;
  std::vector<std::uint8_t> turned_;
};

/// Begins a circle at its point nearest to the previous or the next place, whichever makes the ways shorter.
void choose_begin_of_circle(Chain& circle, Point here, const Chain* next) {
  const Curve& curve = circle.curves[0];
  const auto way = [&](Point at) { return distance(here, at) + (next ? distance(at, next->begin()) : 0); };
  Point best = place_on_circle(curve, here);
  for (const Point other : {next ? place_on_circle(curve, next->begin()) : best, curve.from})
    if (way(other) < way(best)) best = other;
  begin_circle_at(circle, best);
}

/// Begins each closed chain where the ways to and from it are shortest.
void choose_begins(std::vector<Chain>& chains, Point here) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Chain& chain = chains[i];
    if (chain.is_circle()) choose_begin_of_circle(chain, here, i + 1 < chains.size() ? &chain + 1 : nullptr);
    if (chain.closed()) {
      std::size_t best = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < chain.curves.size(); ++k) {
        const Point at = chain.curves[k].from;
        const double way =
            distance(here, at) + (i + 1 < chains.size() ? distance(at, chains[i + 1].begin()) : 0);
        if (way < least) least = way, best = k;
      }
      begin_at(chain, best);
    }
    here = chain.end();
  }
}

}  // namespace

bool Chain::is_circle() const {
  return curves.size() == 1 && curves[0].kind == Curve::Kind::arc && std::fabs(curves[0].degrees) >= 360;
}

void turn_round(Chain& chain) {
  std::reverse(chain.curves.begin(), chain.curves.end());
  for (Curve& c : chain.curves) {
    std::swap(c.from, c.to);
    c.degrees = -c.degrees;
  }
}

std::vector<Chain> join(const Drawing& drawing, double touching, const std::vector<int>& without) {
  std::vector<bool> wanted(drawing.paths.size(), true);
  for (const int path : without)
    if (ix(path) < wanted.size()) wanted[ix(path)] = false;
  std::vector<int> open;
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < drawing.paths.size(); ++i) {
    const Path& path = drawing.paths[i];
    if (!wanted[i] || path.curves.empty() || !drawing.layers[ix(path.layer)].shown) continue;
    if (is_ring(path))
      chains.push_back(chain_of(path, static_cast<int>(i)));
    else
      open.push_back(static_cast<int>(i));
  }
  Joining joining(drawing.paths, open, touching);
  for (std::size_t i = 0; i < open.size(); ++i)
    if (!joining.used(i)) chains.push_back(joining.grow(i));
  std::stable_sort(chains.begin(), chains.end(),
                   [](const Chain& a, const Chain& b) { return a.entity < b.entity; });
  return chains;
}

/// Whether it is four lines along the axes.
static bool is_rectangle(const Chain& chain) {
  constexpr std::size_t sides = 4;
  return chain.closed() && chain.curves.size() == sides &&
         std::all_of(chain.curves.begin(), chain.curves.end(), [](const Curve& c) {
           return c.kind == Curve::Kind::line && (c.from.x == c.to.x) != (c.from.y == c.to.y);
         });
}

int box_around(const std::vector<Chain>& chains) {
  std::vector<Box> boxes(chains.size());
  int widest = -1;
  const auto width = [&boxes](int i) { return boxes[ix(i)].high.x - boxes[ix(i)].low.x; };
  for (int i = 0; ix(i) < chains.size(); ++i) {
    for (const Curve& curve : chains[ix(i)].curves) boxes[ix(i)].add(curve);
    if (is_rectangle(chains[ix(i)]) && (widest < 0 || width(i) > width(widest))) widest = i;
  }
  if (widest < 0 || chains.size() < 2) return -1;
  const Box& around = boxes[ix(widest)];
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& box = boxes[i];
    const bool within = box.low.x > around.low.x && box.low.y > around.low.y && box.high.x < around.high.x &&
                        box.high.y < around.high.y;
    if (i != ix(widest) && !within) return -1;
  }
  return widest;
}

double way_between(const std::vector<Chain>& chains, Point begin, bool in_turn) {
  double way = 0;
  for (const Chain& chain : chains) {
    const Point to = chain.begin();
    way += in_turn ? std::fabs(to.x - begin.x) + std::fabs(to.y - begin.y) : distance(begin, to);
    begin = chain.end();
  }
  return way;
}

void order(std::vector<Chain>& chains, Point begin, const Progress& progress) {
  std::vector<Chain> as_it_was = chains;
  choose_begins(as_it_was, begin);
  chains = nearest_first(std::move(chains), begin, progress);
  Turning turning(chains, begin);
  turning.run(progress);
  turning.apply();
  choose_begins(chains, begin);
  if (way_between(as_it_was, begin) <= way_between(chains, begin)) chains = std::move(as_it_was);
}

}  // namespace hw::drawing
