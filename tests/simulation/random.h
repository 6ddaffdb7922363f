#pragma once
// All chance of the search comes from here, and all of it from one seed: the same seed draws the same plan on
// every machine. (The distributions of the standard library differ from one to the next.)
#include <cstdint>
#include <vector>

namespace hw::simulation {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {  // a counter through a mixing function: any two seeds are far apart
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
  }
  /// Both ends are among the answers.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// True in so many of a hundred cases.
  bool percent(int cases) { return between(1, 100) <= cases; }
  std::int64_t sign() { return percent(50) ? 1 : -1; }
  /// The small much more often than the large: each doubling of the span is equally likely.
  std::int64_t mostly_small(std::int64_t low, std::int64_t high) {
    std::int64_t span = high - low;
    while (span > 1 && percent(50)) span /= 2;
    return low + between(0, span);
  }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(between(0, static_cast<std::int64_t>(all.size()) - 1))];
  }

 private:
  std::uint64_t state_;
};

}  // namespace hw::simulation
