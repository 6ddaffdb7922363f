#pragma once
// What is read first after the line was dirty is shown when two readings agree: of the first nobody knows yet
// whether all that was late has come.
#include <cstdint>

namespace hw::arcus {

/// Of one value, whatever it is made of.
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
