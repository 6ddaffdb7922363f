#pragma once
// After the line was dirty, a value is shown only once two readings agree: the first may still be a late
// reply.
#include <cstdint>

namespace hw::arcus {

/// For one value of any kind.
class SecondLook {
 public:
  /// Whether this reading may be shown. `times_cleaned`: of the line.
  bool agrees(std::uint64_t reading, std::uint32_t times_cleaned) {
    const bool confirmed = read_since_ == times_cleaned && last_ == reading;
    if (shown_since_ != times_cleaned && confirmed) shown_since_ = times_cleaned;
    read_since_ = times_cleaned;
    last_ = reading;
    return shown_since_ == times_cleaned;
  }

 private:
  std::uint64_t last_ = 0;
  std::uint32_t shown_since_ = 0, read_since_ = ~0u;
};

}  // namespace hw::arcus
