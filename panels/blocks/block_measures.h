#pragma once
// Measures of the column of blocks, in logical pixels.

namespace hw::panels {

constexpr float block_height = 40, block_gap = 4, block_indent = 20;
constexpr float closer_below = 900;  ///< in a narrower panel the buttons of its bar stand closer: one row ...
constexpr float brief_below = 760;   ///< ... and have shorter labels
constexpr float refusal_height = 36;    ///< two lines below a block that was refused
constexpr float block_time_width = 68;  ///< column of the times; the lines stand left of it

constexpr float tools_in_words = 560;  ///< of an open block; in less, some are icons
constexpr float field_label_width = 148, field_line_height = 36;  ///< of an open block

}  // namespace hw::panels
