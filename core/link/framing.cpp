#include "core/link/framing.h"

namespace hw {
namespace {

std::optional<std::size_t> behind_first(std::string_view received, std::string_view ends) {
  const auto at = received.find_first_of(ends);
  return at == received.npos ? std::nullopt : std::optional<std::size_t>(at + 1);
}

}  // namespace

std::optional<std::size_t> ReplyShape::complete(std::string_view received) const {
  switch (kind) {
    case Kind::none: return 0;
    case Kind::fixed: return received.size() >= count ? std::optional<std::size_t>(count) : std::nullopt;
    case Kind::quiet_end: return std::nullopt;
    case Kind::message: return behind_first(received, std::string_view("\0", 1));
    case Kind::text: return behind_first(received, std::string_view("\r\0", 2));
    case Kind::lines: break;
  }
  std::size_t end = 0;
  for (int i = 0; i < count; ++i) {
    const auto at = received.find(terminator, end);
    if (at == std::string_view::npos) return std::nullopt;
    end = at + 1;
  }
  return end;
}

}  // namespace hw
