#pragma once
// The effects of a text in the controllers' own language that the pump must know. Pure.
#include "core/device/intent.h"
#include "core/device/text_meaning.h"
#include "core/devices/arcus/codec.h"

namespace hw::arcus {

/// Further facts that the meaning of a text depends on.
struct Addressing {
  int own = -1;              ///< address of the device that it is typed to; -1: it has none
  bool reports_end = false;  ///< AR=1: it reports the end of a move itself (DMX manual, AR)
};

TextMeaning meaning_of(const Forms& forms, const intent::SendText& text, Addressing addressing);

/// The axis that "PX=0", "TX500", "STOPX" name; -1: none. With one axis it need not be named.
int axis_named_in(const Forms& forms, std::string_view text);

}  // namespace hw::arcus
