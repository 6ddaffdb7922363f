#pragma once
// Places all parts of the window, from the window size alone. Pure; all lengths are logical pixels.
#include <cstddef>
#include <cstdint>

namespace hw::gui {

/// By logical window size. In a smaller window these parts collapse, in this order: captions, the right
/// column to a rail, the rehearsal to a line, steps, the terminal, the tabs to a menu, the left column to a
/// strip. STOP ALL, positions, limit lamps and the status line never collapse.
enum class Tier : std::uint8_t { wide, medium, narrow };

/// Logical pixels.
struct Box {
  float x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] float right() const { return x + width; }
  [[nodiscard]] float bottom() const { return y + height; }
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// Narrow: the strip of positions shows two axes in a row; more than four axes have one line each.
constexpr float strip_row_height(std::size_t axes) { return axes > 4 ? 40 : 64; }

/// Sizes dragged by the user; a double click restores them. Kept between runs.
struct Splitters {
  float left = 304, right = 272, below = 300, below_medium = 116;
  bool operator==(const Splitters&) const = default;
};

struct Layout {
  Tier tier = Tier::wide;
  Box brand, tabs, add, link, stop;  ///< parts of the top bar; `tabs` shrinks first
  Box left, centre, right, status;   ///< narrow: left is the strip of positions, right is empty
  float tab_width = 176;
  bool controller_menu = false;  ///< one menu instead of tabs
  bool right_is_rail = false;
  Box unfolded;                  ///< the right column beside its rail while it is open
  bool unfolded_covers = false;  ///< it lies over the centre, which is too narrow to shrink
};

struct LayoutInput {
  float width = 1440, height = 900;  ///< of the window
  int controllers = 1;               ///< number of tabs (including the connection page while it is shown)
  float strip_height = 0;            ///< narrow: height that the positions need
  bool right_open = false;           ///< medium: the rail is unfolded
  Splitters splitters;
};

Layout lay_out(const LayoutInput& input);

/// The height of the lower part in a centre of this height: at least three rows of traffic. 0: it does not
/// fit and becomes a tab. `wanted` is the good height of the panel above it: see PanelEntry::good_height. A
/// banner takes its rows from the lower part, so that nothing above moves when it appears.
float below_height(float centre_height, const Splitters& splitters, Tier tier, float wanted = 0);

}  // namespace hw::gui
