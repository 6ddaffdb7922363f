#pragma once
// Text of bounded length, for snapshots: copying never allocates, and costs as much as the text is long.
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
  FixedText(const FixedText& text) : size_(text.size_) { copy(text.bytes_.data()); }
  FixedText& operator=(const FixedText& text) {
    size_ = text.size_;
    copy(text.bytes_.data());
    return *this;
  }
  FixedText(std::string_view text) { assign(text); }    // NOLINT: converts on purpose
  FixedText(const char* text) { assign(text); }         // NOLINT
  FixedText(const std::string& text) { assign(text); }  // NOLINT

  /// A text that is too long is cut behind a whole word, with an ellipsis; a single long word behind a whole
  /// UTF-8 character.
  void assign(std::string_view text) {
    if (text.size() <= N) return take(text);
    constexpr std::string_view ellipsis = "\xE2\x80\xA6";
    const std::size_t space = N > ellipsis.size() ? text.rfind(' ', N - ellipsis.size()) : text.npos;
    if (space != text.npos && space > 0) {
      take(text.substr(0, space));
      std::memcpy(bytes_.data() + size_, ellipsis.data(), ellipsis.size());
      size_ += ellipsis.size();
      return;
    }
    std::size_t n = N;
    while (n > 0 && (static_cast<unsigned char>(text[n]) & 0xC0) == 0x80) --n;
    take(text.substr(0, n));
  }
  void clear() { size_ = 0; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }
  operator std::string_view() const { return view(); }  // NOLINT
  friend bool operator==(const FixedText& a, const FixedText& b) { return a.view() == b.view(); }

 private:
  void take(std::string_view text) {
    size_ = text.size();
    copy(text.data());
  }
  void copy(const char* from) {
    if (size_ > 0) std::memmove(bytes_.data(), from, size_);
  }

  std::array<char, N> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace hw
