#pragma once
// The effects of a raw text that must be known before it is sent. Pure.
#include <string_view>

#include "core/device/text_meaning.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {

/// ST, SA, SD, KL.
bool stops_motion(Op op);
/// The command begins a motion that keeps its queue occupied.
bool moves_in_queue(Op op);
bool is_question(const TextCommand& command);
/// The form of its reply, on a board with `axes` axes.
ReplyForm reply_form(const TextCommand& question, int axes);

/// `context`: in which the board reads the text. `axes`: the number of axes of the board. Only a text of
/// nothing but stops is a stop. A bare ST is none, as waiting texts may still select other axes: it takes its
/// turn behind them.
TextMeaning meaning_of(std::string_view text, Context context, int axes);

}  // namespace hw::vme58
