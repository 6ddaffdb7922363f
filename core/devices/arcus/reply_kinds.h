#pragma once
// The looks of these controllers' replies: a late reply is never taken for one with a different look. Only DN
// is answered with a device name, only ID with the product. Pure functions.
#include <functional>
#include <string_view>

#include "core/devices/arcus/codec.h"
#include "core/link/outstanding_replies.h"

namespace hw::arcus::reply_kinds {

inline constexpr ReplyKind name{1}, product{2}, version{3};
inline constexpr ReplyKind number{4}, numbers{5};
inline constexpr ReplyKind done{6};  ///< OK, or ? and why not
inline constexpr ReplyKind text{
    7};  ///< a stored line, or the answer to the user's own text: anything but a name

/// The look of the reply to this text. The driver's questions ask for a number, with few exceptions; the
/// user's own text may ask for anything.
ReplyKind of_question(const Forms& forms, std::string_view question);
ReplyKind of_text(const Forms& forms, std::string_view command);

bool is_version(std::string_view text);

/// Length of the complete texts at the front that are not the awaited one. npos, 0: see
/// unsolicited_at_front().
std::size_t others_at_front(std::string_view bytes, const std::function<bool(std::string_view)>& is_it);

}  // namespace hw::arcus::reply_kinds
