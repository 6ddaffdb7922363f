#pragma once
// The console without a display: the same frames, layout and input, drawn only when a picture is requested:
// through GL if available without a display (EGL surfaceless), else by the software rasteriser.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "gui/surface/raster.h"
#include "gui/surface/screen.h"

namespace hw::gui {

class GlCanvas;  // EGL context and frame buffer

enum class Renderer : std::uint8_t { best, software, gl };

class Offscreen : public Surface {
 public:
  /// Logical size and scale.
  explicit Offscreen(int width = 1440, int height = 900, float scale = 1, bool dark = true,
                     Renderer renderer = Renderer::best);
  ~Offscreen() override;

  Screen& screen() override { return screen_; }
  void resize(int width, int height, float scale) override;
  void frame(double now_s, const Draw& draw) override;
  Result<> screenshot(const std::string& path) override;

  /// Draws the last frame as a window would; the pixels stay in GL. False: this machine has no GL.
  bool draw_with_gl();
  /// Renders the last frame and returns its pixels, rows from the top.
  std::span<const std::uint32_t> render();
  [[nodiscard]] ImU32 pixel(int x, int y) const;
  [[nodiscard]] int width_px() const { return static_cast<int>(size_px_.x); }
  [[nodiscard]] int height_px() const { return static_cast<int>(size_px_.y); }
  /// The renderer that render() used last: "gl" or "software".
  [[nodiscard]] std::string_view renderer() const { return gl_ ? "gl" : "software"; }

 private:
  void render_software();

  Screen screen_;
  ImVec2 size_px_;
  Renderer wanted_;
  bool gl_tried_ = false;
  std::unique_ptr<GlCanvas> gl_;
  Raster raster_;
  std::vector<std::uint32_t> pixels_;
};

/// Rows from the top, R G B A in memory; the alpha is written as opaque.
Result<> write_png(const std::string& path, std::span<const std::uint32_t> pixels, int width, int height);

}  // namespace hw::gui
