#pragma once
// The places to which a raw text sends the motors: interprets the program that its R runs, without time.
// Pure.
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/device/snapshot.h"
#include "core/device/text_goals.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/text_pieces.h"

namespace hw::vxm {

using ProgramContents = std::optional<std::vector<TextCommand>>;  ///< none: not known
/// The stored programs, before a text changes or runs them.
struct HeldPrograms {
  std::array<ProgramContents, program_count> contents;
  int selected = -1;             ///< -1: not known
  bool program_4_first = false;  ///< may run before the others, so their starting place is unknown
};
/// Applies a command of a text that changes the selected program.
void change(ProgramContents& selected, const TextCommand& command);

/// `now`: the commands that the controller takes in its present state.
TextGoals goals_of(std::string_view text, Listening now, HeldPrograms held, const Snapshot& snapshot);

}  // namespace hw::vxm
