#pragma once
// Pictures among what ImGui draws: pixels that somebody has made, shown by GL and by the software rasteriser
// alike. A picture never changes; another one is another picture.
#include <cstdint>
#include <memory>
#include <vector>

#include <imgui.h>

namespace hw::gui {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  ///< rows from the top, R G B A in memory, straight alpha
};

/// Those of one frame: they live until the next one is drawn.
class Pictures {
 public:
  /// In this frame; for ImDrawList::AddImage.
  ImTextureID show(std::shared_ptr<const Picture> picture);
  /// Null: it is none of them (but the font atlas).
  [[nodiscard]] const Picture* find(ImTextureID id) const;
  [[nodiscard]] const std::vector<std::shared_ptr<const Picture>>& shown() const { return shown_; }
  void begin_frame() { shown_.clear(); }

 private:
  std::vector<std::shared_ptr<const Picture>> shown_;
};

}  // namespace hw::gui
