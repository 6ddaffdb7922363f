#pragma once
// What the pump must know of a raw text before it is sent. Pure.
#include <string_view>

#include "core/device/text_meaning.h"
#include "core/devices/vxm/text_pieces.h"

namespace hw::vxm {

/// `now`: what the controller takes. `own_move`: what runs is a move of the console, which D ends as a whole;
/// of a stored program it ends one index, and the program goes on.
TextMeaning meaning_of(std::string_view text, const Listening& now, bool own_move);

}  // namespace hw::vxm
