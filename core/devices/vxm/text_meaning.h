#pragma once
// The meaning of a raw text for the pump, before it is sent. Pure.
#include <string_view>

#include "core/device/text_meaning.h"
#include "core/devices/vxm/text_pieces.h"

namespace hw::vxm {

/// `now`: decides which commands are taken. `own_move`: a move of the console runs, which D ends as a whole.
/// In a stored program D ends one index, and the program goes on.
TextMeaning meaning_of(std::string_view text, const Listening& now, bool own_move);

}  // namespace hw::vxm
