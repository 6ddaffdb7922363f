#pragma once
// Program texts as the commands that they store, for conversion between steps and texts.
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/device/sequence_reading.h"
#include "core/device/text_remarks.h"
#include "core/devices/vxm/program.h"

namespace hw::vxm {

struct PlacedCommand {
  Command command;
  Stretch at;
};

struct PlacedProgram {
  std::vector<PlacedCommand> commands;
  Stretch at;             ///< from its heading to the next one
  std::string_view name;  ///< the remark behind its heading
};

struct CommandText {
  std::array<std::optional<PlacedProgram>, program_count> programs;
  TextRemarks remarks;  ///< except those behind headings

  /// The fault names the line of a mistake, or of text that is no part of a program.
  static Result<CommandText> read(std::string_view text);

 private:
  explicit CommandText(std::string_view text) : remarks(text) {}
};

[[nodiscard]] Operations operations_of(std::string_view text);
/// `text`: lines from the middle of a program.
[[nodiscard]] bool may_set_speeds(std::string_view text);

}  // namespace hw::vxm
