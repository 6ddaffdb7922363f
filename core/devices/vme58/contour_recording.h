#pragma once
// A contour as the board records it (data sheet, "Constant Velocity Contouring").
#include <array>

#include "core/device/sequence_draft.h"

namespace hw::vme58 {

struct ContourRecording {
  sequence::Move way_there;  ///< to the start of its lead-in
  std::array<std::int64_t, 2> end{};
};
/// Writes the contour, from CV to CE or CK. The fault names the piece: "Step 3.2 (arc)".
Result<ContourRecording> record_contour(SequenceDraft& draft, const sequence::Contour& contour);

}  // namespace hw::vme58
