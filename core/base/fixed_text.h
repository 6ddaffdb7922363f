#pragma once
// Text of bounded length that lives inside a snapshot: copying it never allocates.
#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

namespace hw {

template <std::size_t N>
class FixedText {
 public:
  constexpr FixedText() = default;
  FixedText(std::string_view text) { assign(text); }    // NOLINT: converts on purpose
  FixedText(const char* text) { assign(text); }         // NOLINT
  FixedText(const std::string& text) { assign(text); }  // NOLINT

  /// Keeps the first N bytes; what does not fit is cut at a character boundary (UTF-8).
  void assign(std::string_view text) {
    std::size_t n = std::min(text.size(), N);
    if (n < text.size())
      while (n > 0 && (static_cast<unsigned char>(text[n]) & 0xC0) == 0x80) --n;
    if (n > 0) std::memcpy(bytes_.data(), text.data(), n);
    size_ = n;
  }
  void clear() { size_ = 0; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }
  operator std::string_view() const { return view(); }  // NOLINT
  friend bool operator==(const FixedText& a, const FixedText& b) { return a.view() == b.view(); }

 private:
  std::array<char, N> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace hw
