#pragma once
// Builds widget ids and short texts on the stack, so that a frame at rest allocates nothing.
#include <string_view>

#include <fmt/core.h>

#include "core/base/units.h"

namespace hw::panels {

class Path {
 public:
  template <class... Args>
  explicit Path(fmt::format_string<Args...> format, Args&&... args) {
    const auto end = fmt::format_to_n(bytes_, sizeof bytes_, format, std::forward<Args>(args)...);
    size_ = end.size < sizeof bytes_ ? end.size : sizeof bytes_;
  }
  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }
  operator std::string_view() const { return view(); }  // NOLINT: converts on purpose

 private:
  char bytes_[128];
  std::size_t size_;
};

/// "Jog 1-" with a real minus.
inline Path with_minus(std::string_view name) {
  const bool minus = name.ends_with('-');
  return Path("{}{}", minus ? name.substr(0, name.size() - 1) : name, minus ? "\u2212" : "");
}

/// The sign of a direction, for display.
inline std::string_view sign_text(Sign sign) { return sign == Sign::plus ? "+" : "\u2212"; }

}  // namespace hw::panels
