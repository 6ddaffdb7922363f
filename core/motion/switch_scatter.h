#pragma once
// Repeatability of an axis' switches: at each approach a switch acts at another offset from its place. The
// same seed gives the same series.
#include <array>
#include <cstdint>

namespace hw::motion {

class SwitchScatter {
 public:
  enum class Of : std::uint8_t { minus, plus, home, index };

  /// Restarts the series. Reach 0: all switches act at their places.
  void begin(std::int64_t reach, std::int64_t seed) {
    *this = SwitchScatter();
    reach_ = reach;
    seed_ = static_cast<std::uint64_t>(seed);
  }
  [[nodiscard]] std::int64_t reach() const { return reach_; }

  /// Offset from its place at this approach, or at the next.
  [[nodiscard]] std::int64_t shift(Of which, bool next = false) const {
    if (reach_ <= 0) return 0;
    const Approach& a = approaches_[static_cast<std::size_t>(which)];
    const std::uint64_t turn = 4 * (a.number + (next ? 1 : 0)) + static_cast<std::uint64_t>(which);
    const auto values = static_cast<std::uint64_t>(2 * reach_ + 1);
    return static_cast<std::int64_t>(mixed(mixed(seed_) + turn) % values) - reach_;
  }
  /// Call when the load has moved. An approach ends when the switch has acted and the load has left the whole
  /// band in which it may act. Until then the offset stays, so that the switch never chatters.
  void moved(Of which, bool acts, bool clear_of_band) {
    Approach& a = approaches_[static_cast<std::size_t>(which)];
    a.acted = a.acted || acts;
    if (a.acted && clear_of_band) end_approach(which);
  }
  void end_approach(Of which) {
    Approach& a = approaches_[static_cast<std::size_t>(which)];
    ++a.number;
    a.acted = false;
  }

 private:
  struct Approach {
    std::uint64_t number = 0;
    bool acted = false;
  };

  /// SplitMix64: each number depends only on its index in the series, in every build.
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  }

  std::int64_t reach_ = 0;
  std::uint64_t seed_ = 0;
  std::array<Approach, 4> approaches_{};
};

}  // namespace hw::motion
