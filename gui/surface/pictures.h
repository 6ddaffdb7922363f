#pragma once
// Pictures in ImGui's draw lists. Both GL and the software rasteriser can draw them. A picture never changes:
// new content needs a new picture.
#include <cstdint>
#include <memory>
#include <vector>

#include <imgui.h>

namespace hw::gui {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  ///< rows from the top, R G B A in memory, straight alpha
};

/// The pictures of one frame: they live until the next frame is drawn.
class Pictures {
 public:
  /// Adds a picture to this frame; for ImDrawList::AddImage.
  ImTextureID show(std::shared_ptr<const Picture> picture);
  /// Returns null when the id is not a picture of this frame, as for the font atlas.
  [[nodiscard]] const Picture* find(ImTextureID id) const;
  [[nodiscard]] const std::vector<std::shared_ptr<const Picture>>& shown() const { return shown_; }
  void begin_frame() { shown_.clear(); }

 private:
  std::vector<std::shared_ptr<const Picture>> shown_;
};

}  // namespace hw::gui
