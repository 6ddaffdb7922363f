#pragma once
// Draws the draw lists of a frame with GL. Owns the textures of the font atlas and of the pictures, which are
// uploaded when first drawn. There is one object for each GL context, which must be current when the object
// is used.
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <imgui.h>

#include "gui/surface/pictures.h"

namespace hw::gui {

class GlTextures {
 public:
  /// Draws through ImGui's GL3 backend. The draw lists are restored afterwards, except that commands with an
  /// older atlas keep the name of the present atlas.
  void render(ImDrawData& data, const Pictures& pictures);
  void forget();  ///< call before the context is destroyed

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
