#pragma once
// Pictures among ImGui's drawing: pixels made elsewhere, shown by GL and by the software rasteriser alike. A
// picture never changes; a new content is a new picture.
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
  /// Null: not a picture of this frame (but the font atlas).
  [[nodiscard]] const Picture* find(ImTextureID id) const;
  [[nodiscard]] const std::vector<std::shared_ptr<const Picture>>& shown() const { return shown_; }
  void begin_frame() { shown_.clear(); }

 private:
  std::vector<std::shared_ptr<const Picture>> shown_;
};

}  // namespace hw::gui
