#pragma once
// What the answers of these controllers look like: a late one is taken for no answer that looks different.
// Nothing but DN is answered with a device name, nothing but ID with the product. Pure functions.
#include <functional>
#include <string_view>

#include "core/devices/arcus/codec.h"
#include "core/link/owed_answers.h"

namespace hw::arcus::looks {

inline constexpr Look name{1}, product{2}, version{3};
inline constexpr Look number{4}, numbers{5};
inline constexpr Look done{6};  ///< OK, or ? and why not
inline constexpr Look text{7};  ///< a stored line, or the answer to the user's own text: anything but a name

/// Of the answer to that text, which asks for a number unless it says otherwise; the user's own text may ask
/// for anything.
Look of_question(const Forms& forms, std::string_view question);
Look of_text(const Forms& forms, std::string_view command);

bool is_version(std::string_view text);

/// How many bytes at the front are whole texts other than the one that is waited for. npos, 0: see
/// unasked_at_front().
std::size_t others_at_front(std::string_view bytes, const std::function<bool(std::string_view)>& is_it);

}  // namespace hw::arcus::looks
