#include "panels/path/path_sheet.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gui/model/units_format.h"
#include "gui/surface/raster.h"
#include "panels/path/path_overlays.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;
namespace {

constexpr ImU32 paper = IM_COL32_WHITE, ink = IM_COL32(0x33, 0x33, 0x33, 0xff),
                zero = IM_COL32(0x88, 0x88, 0x88, 0xff), line = IM_COL32(0xdd, 0xdd, 0xdd, 0xff);

std::uint32_t over(std::uint32_t ground, std::uint32_t pixel) {
  const unsigned alpha = pixel >> IM_COL32_A_SHIFT & 255u;
  std::uint32_t out = IM_COL32_A_MASK;
  for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT})
    out |= ((pixel >> shift & 255u) * alpha + (ground >> shift & 255u) * (255u - alpha)) / 255u << shift;
  return out;
}

}  // namespace

/// Draws lines and text as ImGui does, into pixels of its own.
class PathSheet::Pen {
 public:
  explicit Pen(const Ui& ui) : font_(ui.font(Face::title)), list_(ImGui::GetDrawListSharedData()) {
    list_._ResetForNewFrame();
    list_.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list_.PushClipRect(ImVec2(0, 0), ImVec2(width, height));
  }
  [[nodiscard]] float line_height() const { return font_->FontSize; }
  [[nodiscard]] float text_width(std::string_view s) const {
    return font_->CalcTextSizeA(font_->FontSize, FLT_MAX, 0, s.data(), s.data() + s.size()).x;
  }
  /// `at` is the top left corner, moved so that the text stays on the sheet.
  void text(ImVec2 at, std::string_view s) {
    const ImVec2 kept(std::clamp(at.x, 0.0f, std::max(0.0f, width - text_width(s))),
                      std::clamp(at.y, 0.0f, height - line_height()));
    list_.AddText(font_, font_->FontSize, ImVec2(std::floor(kept.x), std::floor(kept.y)), ink, s.data(),
                  s.data() + s.size());
  }
  void rule(ImVec2 min, ImVec2 max, ImU32 colour) { list_.AddRectFilled(min, max, colour); }
  void edge(ImVec2 from, ImVec2 to) { list_.AddLine(from, to, zero, 2); }
  [[nodiscard]] Picture pixels() {
    ImDrawList* lists[] = {&list_};
    ImDrawData data;
    data.CmdLists = lists, data.CmdListsCount = 1;
    unsigned char* alpha = nullptr;
    AlphaTexture texture;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &texture.width, &texture.height);
    texture.alpha = alpha;
    Raster raster;
    raster.clear(width, height, paper);
    raster.draw(data, texture, Pictures());
    return {width, height, {raster.pixels().begin(), raster.pixels().end()}};
  }

 private:
  ImFont* font_;
  ImDrawList list_;
};

PathSheet::PathSheet(const Frame& f, const PathSubject& s, const drawing::Box3& box,
                     const drawing::Projection& projection, bool equal)
    : box_(box) {
  const Directions all = directions_of(f, s.axes);
  for (std::size_t n = 0; n < all.count; ++n)
    names_[n] = fmt::format("{} {}", all.all[n].name, unit_name(s, all.all[n]));
  Pen pen(f.ui);
  const float row = pen.line_height();
  const bool flat = projection.flat();
  in_ = {ImVec2(flat ? 6 * row : 3 * row, 2 * row), ImVec2(width - 2 * row, height - 3 * row)};
  view_ = drawing::PathView(box, projection, in_.width(), in_.height(), equal);
  if (flat)
    draw_rulers(pen);
  else
    draw_edges(pen);
  ground_ = pen.pixels();
}

ImVec2 PathSheet::at(Point3 p) const {
  const drawing::Point px = view_.to_px(p);
  return ImVec2(in_.min.x + static_cast<float>(px.x), in_.min.y + static_cast<float>(px.y));
}

void PathSheet::draw_rulers(Pen& pen) const {
  const float row = pen.line_height();
  const Point3 low = view_.from_px({0, view_.height_px()}), high = view_.from_px({view_.width_px(), 0});
  const double across = step_over(high.x - low.x, in_.width(), 8 * row),
               up = step_over(high.y - low.y, in_.height(), 5 * row);
  const auto colour = [](double v, double step) { return std::fabs(v) < step * 1e-6 ? zero : line; };
  for (double v = std::ceil(low.x / across) * across; v <= high.x; v += across) {
    const float x = std::floor(at({v, 0}).x);
    pen.rule(ImVec2(x, in_.min.y), ImVec2(x + 1, in_.max.y), colour(v, across));
    const NumberText number = format_number(v, decimals_of(across));
    pen.text(ImVec2(x - pen.text_width(number) / 2, in_.max.y + row / 3), number);
  }
  for (double v = std::ceil(low.y / up) * up; v <= high.y; v += up) {
    const float y = std::floor(at({0, v}).y);
    pen.rule(ImVec2(in_.min.x, y), ImVec2(in_.max.x, y + 1), colour(v, up));
    const NumberText number = format_number(v, decimals_of(up));
    pen.text(ImVec2(in_.min.x - row / 2 - pen.text_width(number), y - row / 2), number);
  }
  pen.text(ImVec2(in_.max.x - pen.text_width(names_[0]), in_.max.y + row * 1.6f), names_[0]);
  pen.text(ImVec2(row / 2, row / 3), names_[1]);
}

/// Draws the edges from the low corner, each with its range at its end.
void PathSheet::draw_edges(Pen& pen) const {
  const auto put = [&](Point3 end, const std::string& name, double low, double high) {
    const ImVec2 to = at(end);
    pen.edge(at(box_.low), to);
    const int decimals = decimals_of(std::max(high - low, 1e-9) / 1000);
    const std::string words = fmt::format("{}: {} to {}", name, format_number(low, decimals).view(),
                                          format_number(high, decimals).view());
    pen.text(ImVec2(to.x - pen.text_width(words) / 2, to.y + pen.line_height() / 3), words);
  };
  const Point3 low = box_.low, high = box_.high;
  put({high.x, low.y, low.z}, names_[0], low.x, high.x);
  put({low.x, high.y, low.z}, names_[1], low.y, high.y);
  put({low.x, low.y, high.z}, names_[2], low.z, high.z);
}

Picture PathSheet::with(const Picture& path) const {
  Picture sheet = ground_;
  const int left = static_cast<int>(in_.min.x), top = static_cast<int>(in_.min.y);
  for (int y = 0; y < std::min(path.height, height - top); ++y)
    for (int x = 0; x < std::min(path.width, width - left); ++x) {
      std::uint32_t& there =
          sheet.pixels[static_cast<std::size_t>(top + y) * width + static_cast<std::size_t>(left + x)];
      there = over(there, path.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(path.width) +
                                      static_cast<std::size_t>(x)]);
    }
  return sheet;
}

}  // namespace hw::panels
