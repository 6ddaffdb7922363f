#pragma once
// What a raw text does, as far as it must be known before it is sent. Pure.
#include <string_view>

#include "core/device/text_meaning.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {

/// ST, SA, SD, KL.
bool stops_motion(Op op);
/// With such a command a motion begins that the queue tells of.
bool moves_in_queue(Op op);
bool is_question(const TextCommand& command);
/// What its reply looks like, on a board with so many axes.
ReplyForm reply_form(const TextCommand& question, int axes);

/// `context` is that in which the board reads it, on a board with so many axes. A stop is a text of nothing
/// but stops. Which axes a bare ST stops is not known while texts may wait that select others: it is none,
/// and takes its turn behind them.
TextMeaning meaning_of(std::string_view text, Context context, int axes);

}  // namespace hw::vme58
