#pragma once
// The place of everything, from the window size alone. Pure: logical pixels in, rectangles out.
#include <cstddef>
#include <cstdint>

namespace hw::gui {

/// By logical window size. What collapses, in the order of the look: captions, right column to a rail,
/// rehearsal to a line, steps, terminal, tabs to a menu, left column to a strip. STOP ALL, positions, limit
/// lamps and the status line never do.
enum class Tier : std::uint8_t { wide, medium, narrow };

/// Logical pixels.
struct Box {
  float x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] float right() const { return x + width; }
  [[nodiscard]] float bottom() const { return y + height; }
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// Narrow: two axes a row in the strip of positions; of more than four each has one line only.
constexpr float strip_row_height(std::size_t axes) { return axes > 4 ? 40 : 64; }

/// Sizes dragged by the user; a double click restores them. Kept between runs.
struct Splitters {
  float left = 304, right = 272, below = 300, below_medium = 116;
  bool operator==(const Splitters&) const = default;
};

struct Layout {
  Tier tier = Tier::wide;
  Box brand, tabs, add, link, stop;  ///< of the top bar; `tabs` shrinks first
  Box left, centre, right, status;   ///< narrow: left is the strip of positions, right is empty
  float tab_width = 176;
  bool controller_menu = false;  ///< one menu instead of tabs
  bool right_is_rail = false;
  Box unfolded;                  ///< the right column beside its rail while it is open
  bool unfolded_covers = false;  ///< it lies over the centre, which has no room to give
};

struct LayoutInput {
  float width = 1440, height = 900;  ///< of the window
  int controllers = 1;               ///< number of tabs (including the connection page while it is shown)
  float strip_height = 0;            ///< narrow: height that the positions need
  bool right_open = false;           ///< medium: the rail is unfolded
  Splitters splitters;
};

Layout lay_out(const LayoutInput& input);

/// Height of the lower part in a centre of that height, at least three rows of traffic; 0: no room, it
/// becomes a tab. `wanted`: of the panel above it, see PanelEntry::good_height. A banner takes rows from the
/// part: nothing above it may shift when one appears.
float below_height(float centre_height, const Splitters& splitters, Tier tier, float wanted = 0);

}  // namespace hw::gui
