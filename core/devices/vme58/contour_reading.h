#pragma once
// A contour from its recording, as contour_recording.h has written it.
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
/// CV, CD to CE or CK, the way there, CX at the begin of `commands`; none: something else.
[[nodiscard]] std::optional<ContourRead> read_contour(std::span<const TextCommand> commands,
                                                      const ReadText& frame, const Catalog& catalog);

}  // namespace hw::vme58
