#pragma once
// The time-stamped record of a wire. Written by the link (io thread), drained by one reader.
#include <cstdint>
#include <string>

#include "core/base/ring.h"
#include "core/time/clock.h"

namespace hw {

enum class Way : std::uint8_t { sent, received };
/// Why bytes were sent, or how received bytes were understood.
enum class TrafficKind : std::uint8_t { stop, intent, transfer, poll, unsolicited, unparsed };

struct TrafficEntry {
  Instant at{};
  Way way = Way::sent;
  TrafficKind kind = TrafficKind::intent;
  std::string bytes;  ///< as on the wire; a slot of the ring keeps its memory
};

/// Longer entries are recorded in pieces, so that the ring is bounded in bytes too.
inline constexpr std::size_t longest_traffic_entry = 1024;

using TrafficRing = Ring<TrafficEntry>;

}  // namespace hw
