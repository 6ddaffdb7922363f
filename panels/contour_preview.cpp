#include "panels/contour_preview.h"

#include <algorithm>
#include <cmath>

#include "gui/units_format.h"
#include "gui/widgets/plot.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;
using sequence::ContourPath;
using sequence::PathPoint;
namespace {

constexpr float left_margin = 62, bottom_margin = 24, top_margin = 12, right_margin = 16;

/// From counts to pixels, the same scale both ways.
class Map {
 public:
  Map(const Rect& in, const ContourPath& path, PathPoint here) {
    PathPoint low = path.park, high = path.park;
    const auto take = [&](PathPoint p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    };
    for (const PathPoint& p : path.points) take(p);
    const double size = std::max({high.x - low.x, high.y - low.y, 1.0});
    // The axes are shown where they stand unless that would make the path small.
    if (std::fabs(here.x - low.x) < 3 * size && std::fabs(here.y - low.y) < 3 * size) take(here);
    const double air = 0.06 * std::max(high.x - low.x, high.y - low.y) + 1;
    low = {low.x - air, low.y - air}, high = {high.x + air, high.y + air};
    counts_a_pixel_ = std::max((high.x - low.x) / in.width(), (high.y - low.y) / in.height());
    const PathPoint middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    left_ = middle.x - counts_a_pixel_ * in.width() / 2;
    bottom_ = middle.y - counts_a_pixel_ * in.height() / 2;
    in_ = in;
  }
  [[nodiscard]] ImVec2 at(PathPoint p) const {
    return ImVec2(in_.min.x + static_cast<float>((p.x - left_) / counts_a_pixel_),
                  in_.max.y - static_cast<float>((p.y - bottom_) / counts_a_pixel_));
  }
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double bottom() const { return bottom_; }
  [[nodiscard]] double counts(float pixels) const { return counts_a_pixel_ * pixels; }

 private:
  Rect in_{};
  double counts_a_pixel_ = 1, left_ = 0, bottom_ = 0;
};

void draw_grid(Ui& ui, const Rect& in, const Map& map) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double width = map.counts(in.width()), height = map.counts(in.height());
  const int lines = std::max(2, static_cast<int>(in.width() / ui.px(90)));
  const double step = grid_step({0, static_cast<float>(width)}, lines);
  for (double v = std::ceil(map.left() / step) * step; v <= map.left() + width; v += step) {
    const float x = std::floor(map.at({v, 0}).x);
    list->AddRectFilled(ImVec2(x, in.min.y), ImVec2(x + ui.hair(), in.max.y), ui[Tone::line]);
    const NumberText number = format_number(v, 0);
    const float w = std::ceil(text_width(ui, Face::small, number));
    if (x + w / 2 < in.max.x)
      draw_text(ui, ImVec2(x - w / 2, in.max.y + ui.px(4)), Face::small, ui[Tone::ink3], number);
  }
  for (double v = std::ceil(map.bottom() / step) * step; v <= map.bottom() + height; v += step) {
    const float y = std::floor(map.at({0, v}).y);
    list->AddRectFilled(ImVec2(in.min.x, y), ImVec2(in.max.x, y + ui.hair()), ui[Tone::line]);
    draw_text_right(ui, ImVec2(in.min.x - ui.px(6), y - ui.line(Face::small) / 2), Face::small,
                    ui[Tone::ink3], format_number(v, 0));
  }
}

void draw_lead_in(Ui& ui, ImVec2 from, ImVec2 to) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  for (float at = 0; at < length; at += ui.px(5)) {
    const ImVec2 p(std::floor(from.x + dx * at / length), std::floor(from.y + dy * at / length));
    list->AddRectFilled(p, ImVec2(p.x + ui.hair(), p.y + ui.hair()), ui[Tone::ink2]);
  }
}

void draw_path(Ui& ui, const Map& map, const ContourPath& path) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool any_on =
      std::any_of(path.legs.begin(), path.legs.end(), [](auto& l) { return l.outputs_on > 0; });
  for (const ContourPath::Leg& leg : path.legs) {
    for (std::size_t i = leg.first; i < leg.first + leg.size; ++i) list->PathLineTo(map.at(path.points[i]));
    const bool strong = leg.outputs_on > 0 || !any_on;
    list->PathStroke(ui[strong ? Tone::ink : Tone::ink3], 0, (strong ? 2.0f : 1.0f) * ui.hair());
  }
  const ImVec2 begin = map.at(path.points.front());
  list->AddRectFilled(ImVec2(begin.x - ui.px(5), begin.y), ImVec2(begin.x + ui.px(6), begin.y + ui.hair()),
                      ui[Tone::ink]);
  list->AddRectFilled(ImVec2(begin.x, begin.y - ui.px(5)), ImVec2(begin.x + ui.hair(), begin.y + ui.px(6)),
                      ui[Tone::ink]);
}

void draw_here(Ui& ui, const Rect& in, ImVec2 at) {
  if (!in.contains(at)) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 faint = with_alpha(ui[Tone::motion], 0.45f);
  const float x = std::floor(at.x), y = std::floor(at.y);
  list->AddRectFilled(ImVec2(x, in.min.y), ImVec2(x + ui.hair(), in.max.y), faint);
  list->AddRectFilled(ImVec2(in.min.x, y), ImVec2(in.max.x, y + ui.hair()), faint);
  list->AddCircle(at, ui.px(6), ui[Tone::motion], 0, 2 * ui.hair());
}

}  // namespace

void draw_contour_preview(Frame& f, AxisId right, AxisId up, const ContourPath* path, std::string_view words,
                          float width, float height) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect whole{at, ImVec2(at.x + ui.px(width), at.y + ui.px(height))};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(whole.min, whole.max, ui[Tone::well]);
  ImGui::Dummy(ImVec2(whole.width(), whole.height()));
  ImGui::SetCursorScreenPos(ImVec2(at.x, whole.max.y));
  show(ui, {"contour/view", Kind::text, "Path of the contour", words}, whole);
  const Rect in{ImVec2(at.x + ui.px(left_margin), at.y + ui.px(top_margin)),
                ImVec2(whole.max.x - ui.px(right_margin), whole.max.y - ui.px(bottom_margin))};
  if (in.width() < ui.px(40) || in.height() < ui.px(40)) return;
  if (!path || path->legs.empty())
    return draw_text_centred(ui, in, Face::body, ui[Tone::ink2], "Nothing to draw yet.");
  const AxisState& a = f.now.axes[right.index];
  const AxisState& b = f.now.axes[up.index];
  const PathPoint here{static_cast<double>(a.position.value), static_cast<double>(b.position.value)};
  const Map map(in, *path, here);
  draw_grid(ui, in, map);
  list->PushClipRect(in.min, in.max, true);
  draw_lead_in(ui, map.at(path->park), map.at(path->points.front()));
  draw_path(ui, map, *path);
  if (a.position_known && b.position_known && f.connected()) draw_here(ui, in, map.at(here));
  list->PopClipRect();
}

}  // namespace hw::panels
