#pragma once
// Draws the draw lists of a frame with GL: the font atlas, and pictures, which are uploaded when first seen.
// One object per GL context, which is current whenever the object is used.
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <imgui.h>

#include "gui/surface/pictures.h"

namespace hw::gui {

class GlTextures {
 public:
  /// Draws through ImGui's GL3 backend. The draw lists are restored afterwards, except for the atlas:
  /// commands with an older one get the name of the present one.
  void render(ImDrawData& data, const Pictures& pictures);
  void forget();  ///< the context is about to be destroyed

 private:
  struct Known {
    std::weak_ptr<const Picture> picture;
    unsigned name = 0;
  };
  void bring(const std::shared_ptr<const Picture>& picture);
  void drop_those_gone();

  std::map<const void*, Known> known_;
  std::vector<std::pair<ImDrawCmd*, ImTextureID>> renamed_;
};

}  // namespace hw::gui
