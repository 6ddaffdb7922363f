#pragma once
// Reads the reply to V when nothing is known of the controller yet. Pure.
#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace hw::vxm {

/// Silence that ends the reply.
inline constexpr std::uint16_t greeting_quiet_ms = 20;
inline constexpr std::uint16_t slow_greeting_quiet_ms = 45;  // bytes come up to 40 ms apart

struct Greeting {
  char state = 0;
  bool echo = false;
  bool sense = true;  ///< false: bytes that no VXM sends
  [[nodiscard]] bool is_a_vxm() const { return state && sense; }
};
Greeting read_greeting(std::string_view bytes);

/// No reply at `rate` baud; 0: the wire has no rate.
tl::unexpected<Fault> no_greeting(int rate);
/// The reply is not a VXM's.
tl::unexpected<Fault> no_vxm_greets(std::string_view bytes, int rate);

}  // namespace hw::vxm
