#pragma once
// The chains of a drawing in the order in which they are drawn: how long each is, the way to it, and how long
// it takes. Choosing one lights it in the picture, and the other way round. Ids: `drawing/chain/N`, from 1.
#include <vector>

#include "core/session/conversion.h"
#include "gui/frame.h"

namespace hw::panels {

class DrawingChains {
 public:
  /// At ImGui's cursor, logical size. `seconds`: by chain; those that are missing are not known.
  void draw(gui::Frame& frame, const drawing::Drawing& drawing, const Conversion& made,
            const std::vector<double>& seconds, float width, float height);
  /// -1: none.
  [[nodiscard]] int chosen() const { return chosen_; }
  void choose(int chain) { chosen_ = chain, into_view_ = true; }

 private:
  int chosen_ = -1;
  bool into_view_ = false;
};

}  // namespace hw::panels
