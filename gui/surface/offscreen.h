#pragma once
// The console without a display. Frames, layout and input are the same; the software rasteriser draws a frame
// only when a picture is requested.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "gui/surface/raster.h"
#include "gui/surface/screen.h"

namespace hw::gui {

class Offscreen : public Surface {
 public:
  /// Logical size and scale.
  explicit Offscreen(int width = 1440, int height = 900, float scale = 1, bool dark = true);

  Screen& screen() override { return screen_; }
  void resize(int width, int height, float scale) override;
  void frame(double now_s, const Draw& draw) override;
  Result<> screenshot(const std::string& path) override;

  /// Renders the last frame and returns its pixels, rows from the top. Valid until the next call.
  std::span<const std::uint32_t> render();
  [[nodiscard]] ImU32 pixel(int x, int y) const;
  [[nodiscard]] int width_px() const { return static_cast<int>(size_px_.x); }
  [[nodiscard]] int height_px() const { return static_cast<int>(size_px_.y); }

 private:
  Screen screen_;
  ImVec2 size_px_;
  Raster raster_;
};

/// Rows from the top, R G B A in memory; the alpha is written as opaque.
Result<> write_png(const std::string& path, std::span<const std::uint32_t> pixels, int width, int height);

}  // namespace hw::gui
