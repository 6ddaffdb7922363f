#pragma once
// Measures of the column of blocks, in logical pixels.

namespace hw::panels {

constexpr float block_height = 40, block_gap = 4, block_indent = 20;
constexpr float closer_below = 900;     ///< in a narrower panel the buttons are closer together, in one row
constexpr float brief_below = 760;      ///< in a narrower panel the buttons have shorter labels too
constexpr float refusal_height = 36;    ///< two lines below a block that was refused
constexpr float block_time_width = 68;  ///< column of the times, right of the lines

constexpr float tools_in_words = 560;  ///< an open block narrower than this has icons for some tools
constexpr float field_label_width = 148, field_line_height = 36;  ///< of an open block

}  // namespace hw::panels
