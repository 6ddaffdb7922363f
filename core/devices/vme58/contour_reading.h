#pragma once
// Reads a contour back from a recording written by contour_recording.h.
#include <cstddef>
#include <optional>
#include <span>

#include "core/device/sequence_reading.h"
#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {

struct ContourRead {
  sequence::Contour contour;
  std::size_t length = 0;  ///< commands
};
/// Reads CV, CD to CE or CK, the move to the start and CX at the front of `commands`; none: they do not form
/// a contour.
[[nodiscard]] std::optional<ContourRead> read_contour(std::span<const TextCommand> commands,
                                                      const ReadText& frame, const Catalog& catalog);

}  // namespace hw::vme58
