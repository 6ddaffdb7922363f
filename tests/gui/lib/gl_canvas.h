#pragma once
// The GL of a window, without a display: an EGL surfaceless context and a frame buffer of its own. What the
// software rasteriser draws is compared with it, and the cost of a frame is measured on it.
#include <cstdint>
#include <memory>
#include <vector>

#include <imgui.h>

#include "gui/surface/gl_textures.h"
#include "gui/surface/screen.h"

namespace hw::gui {

class GlCanvas {
 public:
  /// Null when this machine has no surfaceless GL.
  static std::unique_ptr<GlCanvas> open();
  ~GlCanvas();
  GlCanvas(const GlCanvas&) = delete;
  GlCanvas& operator=(const GlCanvas&) = delete;

  /// Draws the last frame of the screen through ImGui's GL3 backend and waits until it is finished. False
  /// when GL failed.
  bool draw(const Screen& screen);
  /// The last drawing, rows from the top. False when GL failed.
  bool read(std::vector<std::uint32_t>& pixels);

 private:
  struct Egl;
  explicit GlCanvas(std::unique_ptr<Egl> egl);
  bool size_to(int width, int height);

  std::unique_ptr<Egl> egl_;
  GlTextures textures_;
  unsigned frame_buffer_ = 0, colour_ = 0;
  int width_ = 0, height_ = 0, atlas_generation_ = 0;
};

}  // namespace hw::gui
