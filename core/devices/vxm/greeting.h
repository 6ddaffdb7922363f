#pragma once
// What comes back on V when nothing is known of the controller yet. Pure.
#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace hw::vxm {

/// So long is waited for more of an answer.
inline constexpr std::uint16_t greeting_quiet_ms = 20;
inline constexpr std::uint16_t slow_greeting_quiet_ms = 45;  // bytes come up to 40 ms apart

struct Greeting {
  char state = 0;
  bool echo = false;
  bool sense = true;  ///< false: bytes that no VXM sends
  [[nodiscard]] bool is_a_vxm() const { return state && sense; }
};
Greeting read_greeting(std::string_view bytes);

/// Nothing came back; at `rate` baud, 0: the wire has none.
tl::unexpected<Fault> nobody_greets(int rate);
/// What came back is no VXM's.
tl::unexpected<Fault> no_vxm_greets(std::string_view bytes, int rate);

}  // namespace hw::vxm
