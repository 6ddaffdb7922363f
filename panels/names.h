#pragma once
// The names of a list, built on the stack, so that a frame at rest allocates nothing.
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace hw::panels {

class Names {
 public:
  void add(std::string_view name) {
    if (count_ < all_.size()) all_[count_++] = name;
  }
  [[nodiscard]] std::size_t size() const { return count_; }
  operator std::span<const std::string_view>() const { return {all_.data(), count_}; }  // NOLINT

 private:
  std::array<std::string_view, 48> all_;
  std::size_t count_ = 0;
};

}  // namespace hw::panels
