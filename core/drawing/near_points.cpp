#include "core/drawing/near_points.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/index.h"

namespace hw::drawing {

static std::size_t middle_of(std::size_t first, std::size_t last) { return first + (last - first) / 2; }

NearPoints::NearPoints(std::vector<Entry> entries)
    : entries_(std::move(entries)),
      left_(entries_.size()),
      by_x_(entries_.size()),
      gone_(entries_.size(), false) {
  divide(0, entries_.size());
  int owners = 0;
  for (const Entry& e : entries_) owners = std::max(owners, e.owner + 1);
  begins_.assign(ix(owners) + 1, 0);
  for (const Entry& e : entries_) ++begins_[ix(e.owner) + 1];
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  owned_.resize(entries_.size());
  std::vector<std::size_t> next = begins_;
  for (std::size_t i = 0; i < entries_.size(); ++i) owned_[next[ix(entries_[i].owner)]++] = i;
}

void NearPoints::divide(std::size_t first, std::size_t last) {
  if (first == last) return;
  Box box;
  for (std::size_t i = first; i < last; ++i) box.add(entries_[i].at);
  const bool by_x = box.high.x - box.low.x > box.high.y - box.low.y;
  const std::size_t middle = middle_of(first, last);
  const auto at = [&](std::size_t i) { return entries_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [by_x](const Entry& a, const Entry& b) {
    return by_x ? a.at.x < b.at.x : a.at.y < b.at.y;
  });
  by_x_[middle] = by_x;
  left_[middle] = static_cast<int>(last - first);
  divide(first, middle);
  divide(middle + 1, last);
}

void NearPoints::remove(int owner) {
  if (ix(owner) + 1 >= begins_.size()) return;
  for (std::size_t i = begins_[ix(owner)]; i < begins_[ix(owner) + 1]; ++i)
    if (!gone_[owned_[i]]) take_away(owned_[i]);
}

void NearPoints::take_away(std::size_t at) {
  gone_[at] = true;
  for (std::size_t first = 0, last = entries_.size();;) {
    const std::size_t middle = middle_of(first, last);
    --left_[middle];
    if (middle == at) return;
    (at < middle ? last : first) = at < middle ? middle : middle + 1;
  }
}

struct NearPoints::Search {
  Point from;
  int owner;  ///< owner whose points are ignored
  std::span<const Entry*> found;
  std::size_t count = 0;
  std::array<double, most_found> distances{};

  /// Points further away are ignored.
  [[nodiscard]] double reach() const {
    return count < found.size() ? std::numeric_limits<double>::infinity() : distances[count - 1];
  }
  void take(const Entry& e) {
    const double d = hw::drawing::distance(e.at, from);
    if (e.owner == owner || !(d < reach())) return;
    if (count < found.size()) ++count;
    std::size_t i = count - 1;
    for (; i > 0 && distances[i - 1] > d; --i) distances[i] = distances[i - 1], found[i] = found[i - 1];
    distances[i] = d, found[i] = &e;
  }
};

void NearPoints::look(Part part, Search& search) const {
  if (part.first == part.last) return;
  const std::size_t middle = middle_of(part.first, part.last);
  if (left_[middle] == 0) return;
  const Entry& e = entries_[middle];
  if (!gone_[middle]) search.take(e);
  const double beyond = by_x_[middle] ? search.from.x - e.at.x : search.from.y - e.at.y;
  const Part low{part.first, middle}, high{middle + 1, part.last};
  look(beyond < 0 ? low : high, search);
  if (std::fabs(beyond) < search.reach()) look(beyond < 0 ? high : low, search);
}

const NearPoints::Entry* NearPoints::nearest(Point from) const {
  const Entry* found = nullptr;
  nearest(from, -1, {&found, 1});
  return found;
}

std::size_t NearPoints::nearest(Point from, int owner, std::span<const Entry*> found) const {
  Search search{from, owner, found.first(std::min<std::size_t>(found.size(), most_found))};
  look({0, entries_.size()}, search);
  return search.count;
}

}  // namespace hw::drawing
