#pragma once
// What every fuzz target needs.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace hw::fuzz {

/// Takes the input apart; zeros when it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool empty() const { return size_ == 0; }
  std::uint8_t next() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::string_view text(std::size_t count) {
    count = count < size_ ? count : size_;
    const std::string_view taken(reinterpret_cast<const char*>(data_), count);
    data_ += count;
    size_ -= count;
    return taken;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

inline void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace hw::fuzz
