#pragma once
// Measures that several panels share, in logical pixels.

namespace hw::panels {

constexpr float close_between = 4, between = 8, wide_between = 16;  ///< between neighbouring cells
constexpr float between_columns = 24;
constexpr float toolbar_height = 56;                        ///< the row of buttons at the top of a panel
constexpr float title_height = 36;                          ///< the title of a section
constexpr float list_row_height = 36, remove_width = 36;    ///< for a list that is edited in place
constexpr float side_width = 272, narrow_side_width = 232;  ///< the column beside a panel's main area

}  // namespace hw::panels
