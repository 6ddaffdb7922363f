#pragma once
// Lists the chains of a drawing in drawing order: length, travel to it and duration of each. A chain chosen
// here is lit in the picture, and vice versa. The chosen chain, or a box around all others, can be left out.
// Ids: `drawing/chain/N`, from 1, `drawing/leave_out`, `drawing/draw_all`.
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
    const std::vector<double>& seconds;  ///< by chain; a missing duration is unknown
    bool busy;                           ///< other work is under way
    bool all;                            ///< no chain was left out
  };
  enum class Request : std::uint8_t { nothing, leave_out, draw_all };
  static constexpr float bar_height = 40;
  /// Draws at ImGui's cursor, logical size; with bar_height only the bar. The user can leave out the chain of
  /// may_be_left_out().
  Request draw(gui::Frame& frame, const Shown& shown, float width, float height);
  /// The chosen chain, else the box around all others; -1: none.
  [[nodiscard]] int may_be_left_out(const Conversion& made) const;
  /// The chosen chain; -1: none.
  [[nodiscard]] int chosen() const { return chosen_; }
  void choose(int chain) { chosen_ = chain, into_view_ = chain >= 0; }

 private:
  Request draw_bar(gui::Frame& frame, const Shown& shown, float width);

  int chosen_ = -1;
  bool into_view_ = false;
};

}  // namespace hw::panels
