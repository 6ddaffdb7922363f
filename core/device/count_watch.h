#pragma once
// Notices where somebody else has set the count of an axis: another program on the wire, or a hand at the
// controller. It counts elsewhere now, and no motion could have brought it there in the time: neither one
// that nobody saw between two looks at an axis that stands, nor the one that is under way. What lies within
// such a motion looks like one, and nobody can tell them apart.
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw {

class CountWatch {
 public:
  explicit CountWatch(const Catalog& catalog) : catalog_(catalog) {}

  /// Something goes out that may set a count, or move: what is seen next is taken as it is.
  void disturbed() { seen_ = {}, flights_ = {}; }
  /// After each whole round of status: a bit for each axis whose count somebody has set. It is told once.
  [[nodiscard]] std::uint32_t look(const Snapshot& now);

 private:
  /// A digit that was lost on the way is another number for one round: each is seen twice.
  struct Seen {
    std::optional<Steps> stood, once;  ///< once: behind it, or before there is one
    Instant stood_at{}, once_at{};     ///< last, and first
    Duration took{};                   ///< from the one to the other
  };
  /// Of a move of the console's own.
  struct Flight {
    struct Reading {
      Steps place{};
      Instant when{};
    };
    std::optional<Reading> at, apart;  ///< apart: the first to which no way leads from there
    double rate = 0;                   ///< steps/s, as last read
  };
  struct World {
    std::uint32_t restarts = 0;
    std::uint64_t timeouts = 0;
    bool operator==(const World&) const = default;
  };
  [[nodiscard]] bool can_tell(const AxisState& axis) const;
  [[nodiscard]] bool was_set(Seen& seen, const AxisState& axis) const;
  [[nodiscard]] Steps reach(const AxisState& axis, Duration time) const;
  [[nodiscard]] bool is_own_move(const AxisState& axis) const;
  [[nodiscard]] bool leapt(Flight& flight, const AxisState& axis) const;
  [[nodiscard]] std::uint32_t look_at_moves(const Snapshot& now);

  const Catalog& catalog_;
  std::array<Seen, max_axes> seen_{};
  std::array<Flight, max_axes> flights_{};
  World world_;
};

/// "The count of axis X was changed ..."
[[nodiscard]] std::string say_count_was_set(const Catalog& catalog, int axis);

}  // namespace hw
