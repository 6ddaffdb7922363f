#pragma once
// Draws ImGui's draw lists into memory without a GPU. Triangles, clip rectangles, interpolated colours,
// filtering of the font atlas and alpha blending are those of GL. The same lists give the same pixels on
// every computer.
#include <cstdint>
#include <span>
#include <vector>

#include <imgui.h>

#include "gui/surface/pictures.h"

namespace hw::gui {

/// 8 bit coverage, as ImFontAtlas::GetTexDataAsAlpha8 gives it.
struct AlphaTexture {
  const unsigned char* alpha = nullptr;
  int width = 0, height = 0;
};

class Raster {
 public:
  /// Sets the size in pixels and fills with an opaque colour.
  void clear(int width, int height, ImU32 colour);
  void draw(const ImDrawData& data, const AlphaTexture& texture, const Pictures& pictures);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Rows from the top, R G B A in memory.
  [[nodiscard]] std::span<const std::uint32_t> pixels() const { return pixels_; }
  [[nodiscard]] ImU32 at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }

 private:
  struct Clip {
    int x0, y0, x1, y1;
  };
  void draw_command(const ImDrawList& list, const ImDrawCmd& command, const Clip& clip);
  void draw_picture(const Picture& picture, const ImDrawList& list, const ImDrawCmd& command,
                    const Clip& clip);
  bool draw_as_rect(const ImDrawVert* a, const ImDrawVert* b, const ImDrawVert* c, const ImDrawVert* d,
                    const Clip& clip);
  void fill_rect(const Clip& r, ImU32 colour);
  void textured_rect(const ImDrawVert& min, const ImDrawVert& max, const Clip& r);
  void triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const Clip& clip);
  template <class Shade>
  void scan(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const Clip& clip, Shade&& shade);
  [[nodiscard]] unsigned sample(float u, float v) const;
  std::uint32_t* row(int y) {
    return pixels_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }

  std::vector<std::uint32_t> pixels_;
  AlphaTexture texture_;
  int width_ = 0, height_ = 0;
};

}  // namespace hw::gui
