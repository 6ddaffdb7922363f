#pragma once
// The looks of the VXM's replies, and the question that may be asked while replies are outstanding. Pure.
#include <optional>

#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/text_pieces.h"
#include "core/link/station.h"

namespace hw::vxm {

namespace reply_kind {
inline constexpr ReplyKind letter{1};    ///< V
inline constexpr ReplyKind position{2};  ///< X, Y, Z, T, and D in Local mode: sign and seven digits
inline constexpr ReplyKind number{3};    ///< PM, M, @, get...: a few digits
inline constexpr ReplyKind text{4};      ///< getD0, getD1: digits with points or dashes between
inline constexpr ReplyKind raw{5};       ///< ?, ~, $: one byte that may be any
inline constexpr ReplyKind prompt{6};    ///< K, rsm
inline constexpr ReplyKind lines{7};     ///< lst
}  // namespace reply_kind

/// ReplyKind of the reply to this command of a raw text.
ReplyKind reply_kind_of(const TextCommand& command);

/// A question that the controller answers in this state, by a reply that looks like none of the outstanding
/// ones.
std::optional<Station::Unmistakable> unmistakable(const OutstandingReplies& outstanding, Instant now,
                                                  const Listening& listening, bool echoes);

}  // namespace hw::vxm
