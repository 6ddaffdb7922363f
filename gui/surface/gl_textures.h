#pragma once
// Draws with GL what the draw lists of a frame show: the font atlas, and pictures, which it brings to GL when
// they are first seen. A GL context has one of these and is current whenever it is used.
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <imgui.h>

#include "gui/surface/pictures.h"

namespace hw::gui {

class GlTextures {
 public:
  /// Through ImGui's GL3 backend. The draw lists are as before afterwards, but for the atlas: what was drawn
  /// with an older one has the name of the present one.
  void render(ImDrawData& data, const Pictures& pictures);
  void forget();  ///< the context goes

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
