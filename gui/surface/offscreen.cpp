#include "gui/surface/offscreen.h"

#include <stb/stb_image_write.h>

#include "core/session/user_files.h"

namespace hw::gui {
namespace {

Fonts built(float scale) {
  Fonts fonts;
  fonts.build(scale);
  return fonts;
}

ImVec2 picture_size(int width, int height, float scale) {
  return ImVec2(std::floor(static_cast<float>(width) * scale + 0.5f),
                std::floor(static_cast<float>(height) * scale + 0.5f));
}

}  // namespace

Offscreen::Offscreen(int width, int height, float scale, bool dark)
    : screen_(built(scale), dark), size_px_(picture_size(width, height, scale)) {}

void Offscreen::resize(int width, int height, float scale) {
  size_px_ = picture_size(width, height, scale);
  screen_.set_scale(scale);
}

void Offscreen::frame(double now_s, const Draw& draw) { screen_.frame(now_s, size_px_, draw); }

std::span<const std::uint32_t> Offscreen::render() {
  if (!screen_.draw_data()) return {};
  AlphaTexture texture;
  unsigned char* alpha = nullptr;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &texture.width, &texture.height);
  texture.alpha = alpha;
  raster_.clear(width_px(), height_px(), screen_.theme()[Tone::ground]);
  raster_.draw(*screen_.draw_data(), texture, screen_.pictures());
  return raster_.pixels();
}

ImU32 Offscreen::pixel(int x, int y) const { return raster_.at(x, y); }

Result<> Offscreen::screenshot(const std::string& path) {
  const std::span<const std::uint32_t> pixels = render();
  if (pixels.empty())
    return fail(FaultKind::internal, "No frame has been drawn yet, so there is no picture.");
  return write_png(path, pixels, width_px(), height_px());
}

Result<> write_png(const std::string& path, std::span<const std::uint32_t> pixels, int width, int height) {
  std::vector<unsigned char> rgb;
  rgb.reserve(pixels.size() * 3);
  for (const std::uint32_t p : pixels)
    for (int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT})
      rgb.push_back(static_cast<unsigned char>(p >> shift));
  // The library's own file output does not notice a full disk.
  std::string png;
  const auto take = [](void* to, void* bytes, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  };
  if (!stbi_write_png_to_func(take, &png, width, height, 3, rgb.data(), width * 3))
    return fail(FaultKind::internal, "There was no memory for the picture " + path + ".",
                "Nothing was saved.");
  Result<> written = write_file(path, png);
  if (!written) written.error().done = "The picture was not saved.";
  return written;
}

}  // namespace hw::gui
