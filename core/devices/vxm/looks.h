#pragma once
// The looks of the VXM's replies, and the question that may be asked while replies are owed. Pure.
#include <optional>

#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/text_pieces.h"
#include "core/link/station.h"

namespace hw::vxm {

namespace look {
inline constexpr Look letter{1};    ///< V
inline constexpr Look position{2};  ///< X, Y, Z, T, and D in Local mode: sign and seven digits
inline constexpr Look number{3};    ///< PM, M, @, get...: a few digits
inline constexpr Look text{4};      ///< getD0, getD1: digits with points or dashes between
inline constexpr Look raw{5};       ///< ?, ~, $: one byte that may be any
inline constexpr Look prompt{6};    ///< K, rsm
inline constexpr Look lines{7};     ///< lst
}  // namespace look

/// Look of the reply to this command of a raw text.
Look look_of(const TextCommand& command);

/// A question that the controller answers in this state, by a reply that looks like none owed.
std::optional<Station::Unmistakable> unmistakable(const OwedAnswers& owed, Instant now,
                                                  const Listening& listening, bool echoes);

}  // namespace hw::vxm
