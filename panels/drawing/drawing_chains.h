#pragma once
// The chains of a drawing in the order in which they are drawn: how long each is, the way to it, and how long
// it takes. Choosing one lights it in the picture, and the other way round; it, or a box around all else, can
// be left out. Ids: `drawing/chain/N`, from 1, `drawing/leave_out`, `drawing/draw_all`.
#include <optional>
#include <vector>

#include "core/session/conversion.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class DrawingChains {
 public:
  struct Shown {
    const drawing::Drawing& drawing;
    const Conversion& made;
    const std::vector<double>& seconds;  ///< by chain; those that are missing are not known
    bool busy;                           ///< something else is being worked out
    bool all;                            ///< nothing was left out
  };
  enum class Wish : std::uint8_t { nothing, leave_out, draw_all };
  static constexpr float bar_height = 40;
  /// At ImGui's cursor, logical size; in bar_height without the list. Leaves out what may_be_left_out()
  /// tells.
  Wish draw(gui::Frame& frame, const Shown& shown, float width, float height);
  /// The chain that is chosen, else the box around all others; -1: none.
  [[nodiscard]] int may_be_left_out(const Conversion& made) const;
  /// -1: none.
  [[nodiscard]] int chosen() const { return chosen_; }
  void choose(int chain) { chosen_ = chain, into_view_ = chain >= 0; }

 private:
  Wish draw_bar(gui::Frame& frame, const Shown& shown, float width);

  int chosen_ = -1;
  bool into_view_ = false;
};

}  // namespace hw::panels
