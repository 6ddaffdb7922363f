#include "gui/widgets/plot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <fmt/core.h>

#include "gui/model/units_format.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr float title_height = 20, label_height = 20, label_width = 52;

struct PlotField {
  Rect inside;  ///< of the axes, in pixels
  PlotRange x, y;
  [[nodiscard]] float px(float v) const { return inside.min.x + x.share(v) * inside.width(); }
  [[nodiscard]] float py(float v) const { return inside.max.y - y.share(v) * inside.height(); }
};

int tick_decimals(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

void draw_grid(Ui& ui, const PlotField& f, const PlotOptions& o) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  // Lines that would be too close are halved in number.
  const int across = std::max(2, static_cast<int>(f.inside.width() / ui.px(100)));
  const int up =
      std::max(2, static_cast<int>(f.inside.height() / ui.px(f.inside.height() < ui.px(120) ? 40 : 32)));
  const double x_step = grid_step(f.x, across), y_step = grid_step(f.y, up);
  for (double v = std::ceil(f.y.min / y_step) * y_step; v <= f.y.max + y_step * 1e-6; v += y_step) {
    const float y = std::floor(f.py(static_cast<float>(v)));
    list->AddRectFilled(ImVec2(f.inside.min.x, y), ImVec2(f.inside.max.x, y + ui.hair()), ui[Tone::line]);
    const NumberText number = format_number(v, tick_decimals(y_step));
    draw_text_right(ui, ImVec2(f.inside.min.x - ui.px(6), y - ui.line(Face::small) / 2), Face::small,
                    ui[Tone::ink3], number);
  }
  float free_from = f.inside.min.x - ui.px(40);
  for (double v = std::ceil(f.x.min / x_step) * x_step; v <= f.x.max + x_step * 1e-6; v += x_step) {
    const float x = std::floor(f.px(static_cast<float>(v)));
    list->AddRectFilled(ImVec2(x, f.inside.min.y), ImVec2(x + ui.hair(), f.inside.max.y), ui[Tone::line]);
    if (!o.x_labels) continue;
    NumberText number = format_number(v, tick_decimals(x_step));
    const bool last = v + x_step > f.x.max + x_step * 1e-6;
    if (last && !o.x_unit.empty()) number.append(" "), number.append(o.x_unit);
    const float width = std::ceil(text_width(ui, Face::small, number));
    const float left = std::min(x - width / 2, f.inside.max.x - width);
    if (left < free_from) continue;
    draw_text(ui, ImVec2(left, f.inside.max.y + ui.px(4)), Face::small, ui[Tone::ink3], number);
    free_from = left + width + ui.px(8);
  }
}

/// Adds at most two points for each column of pixels: the lowest and the highest, in their order.
void path_of(const PlotField& f, std::span<const float> xs, std::span<const float> ys) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  float column = 0, low = 0, high = 0;
  bool any = false, low_first = true;
  const auto emit = [&] {
    if (!any) return;
    list->PathLineTo(ImVec2(column, low_first ? low : high));
    if (low != high) list->PathLineTo(ImVec2(column, low_first ? high : low));
  };
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const float x = std::floor(f.px(xs[i])), y = f.py(ys[i]);
    if (any && x == column) {
      if (y < low) low = y, low_first = false;
      if (y > high) high = y, low_first = true;
      continue;
    }
    emit();
    column = x, low = high = y, any = true, low_first = true;
  }
  emit();
}

/// ImGui draws each dash through its path, so the points are moved out of it first. Their memory is kept.
void stroke_dashed(Ui& ui, ImU32 colour, float width) {
  static thread_local std::vector<ImVec2> points;
  ImDrawList* list = ImGui::GetWindowDrawList();
  points.assign(list->_Path.begin(), list->_Path.end());
  list->PathClear();
  const float dash = ui.px(6), gap_length = ui.px(4);
  float walked = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ImVec2 a = points[i - 1], b = points[i];
    const float dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    for (float at = 0; at < length;) {
      const float phase = std::fmod(walked, dash + gap_length);
      const bool on = phase < dash;
      const float run = std::min(length - at, (on ? dash : dash + gap_length) - phase + 0.01f);
      const float s = at / length, e = (at + run) / length;
      if (on)
        list->AddLine(ImVec2(a.x + dx * s, a.y + dy * s), ImVec2(a.x + dx * e, a.y + dy * e), colour, width);
      at += run, walked += run;
    }
  }
}

bool gap_before(const PlotTrace& t, std::size_t point) {
  return std::binary_search(t.gaps.begin(), t.gaps.end(), point);
}

/// Draws one stroke from gap to gap.
void draw_trace(Ui& ui, const PlotField& f, const PlotTrace& t) {
  const std::size_t n = std::min(t.x.size(), t.y.size());
  const float width = t.width * ui.hair();
  for (std::size_t begin = 0, end; begin < n; begin = end) {
    for (end = begin + 1; end < n && !gap_before(t, end);) ++end;
    path_of(f, t.x.subspan(begin, end - begin), t.y.subspan(begin, end - begin));
    if (t.dashed)
      stroke_dashed(ui, ui[t.tone], width);
    else
      ImGui::GetWindowDrawList()->PathStroke(ui[t.tone], 0, width);
  }
}

void words_on_well(Ui& ui, const PlotField& f, ImVec2 at, ImU32 colour, std::string_view words) {
  const float width = std::ceil(text_width(ui, Face::small, words));
  at.x = std::clamp(at.x, f.inside.min.x, std::max(f.inside.min.x, f.inside.max.x - width - ui.px(2)));
  at.y = std::clamp(at.y, f.inside.min.y, std::max(f.inside.min.y, f.inside.max.y - ui.line(Face::small)));
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x - ui.px(2), at.y),
                                            ImVec2(at.x + width + ui.px(2), at.y + ui.line(Face::small)),
                                            ui[Tone::well]);
  draw_text(ui, at, Face::small, colour, words);
}

void draw_names(Ui& ui, const PlotField& f, std::span<const PlotTrace> traces) {
  const float line = ui.line(Face::small);
  float before = -2 * line;  // top of the previous name, which the next name must not touch
  for (const PlotTrace& t : traces) {
    if (t.name.empty() || t.y.empty()) continue;
    const float width = std::ceil(text_width(ui, Face::small, t.name)), y = f.py(t.y.back());
    float top = std::clamp(t.name_above ? y - line - ui.px(4) : y + ui.px(4), f.inside.min.y,
                           std::max(f.inside.min.y, f.inside.max.y - line));
    if (std::abs(top - before) < line)
      top = before + (top < before && before - line >= f.inside.min.y ? -line : line);
    words_on_well(ui, f, ImVec2(f.inside.max.x - width - ui.px(8), top), ui[t.tone], t.name);
    before = top;
  }
}

void draw_marks(Ui& ui, const PlotField& f, std::span<const PlotMark> marks) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const PlotMark& m : marks) {
    if (m.x < f.x.min || m.x > f.x.max) continue;
    const float x = std::floor(f.px(m.x));
    for (float y = f.inside.min.y; y < f.inside.max.y; y += ui.px(4))
      list->AddRectFilled(ImVec2(x, y), ImVec2(x + ui.hair(), y + ui.px(2)), ui[Tone::ink]);
    if (!m.words.empty())
      words_on_well(ui, f, ImVec2(x + ui.px(8), f.inside.max.y - ui.px(32)), ui[Tone::ink], m.words);
  }
}

/// The values under the mouse, as one text: "63.0 ms: command 400, encoder 398".
std::string_view cursor_words(std::span<char> out, std::span<const PlotTrace> traces, const PlotOptions& o,
                              float x) {
  const auto end =
      fmt::format_to_n(out.data(), out.size(), "{:.1f}{}{}", x, o.x_unit.empty() ? "" : " ", o.x_unit);
  std::size_t size = std::min(end.size, out.size());
  bool first = true;
  for (const PlotTrace& t : traces) {
    float v = 0;
    if (t.name.empty() || !value_at(t, x, v)) continue;
    // The name at the trace may end in its last value, which is left out here.
    const auto space = t.name.find(' ');
    const auto more =
        fmt::format_to_n(out.data() + size, out.size() - size, "{} {} {:.{}f}", first ? ":" : ",",
                         t.name.substr(0, space), v, std::fabs(v) < 10 ? 1 : 0);
    size = std::min(size + more.size, out.size());
    first = false;
  }
  return {out.data(), size};
}

void draw_cursor(Ui& ui, std::string_view id, const PlotField& f, std::span<const PlotTrace> traces,
                 const PlotOptions& o, PlotCursor& cursor, bool here) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float x = std::floor(f.px(cursor.x));
  list->AddRectFilled(ImVec2(x, f.inside.min.y), ImVec2(x + ui.hair(), f.inside.max.y),
                      with_alpha(ui[Tone::ink], 0.45f));
  for (const PlotTrace& t : traces) {
    float v = 0;
    if (!t.name.empty() && value_at(t, cursor.x, v))
      list->AddCircleFilled(ImVec2(x + ui.hair() * 0.5f, f.py(v)), ui.px(3), ui[t.tone]);
  }
  if (!here) return;
  char words[192];
  const std::string_view at_cursor = cursor_words(words, traces, o, cursor.x);
  words_on_well(ui, f, ImVec2(x + ui.px(8), f.inside.min.y + ui.px(4)), ui[Tone::ink], at_cursor);
  char path[96];
  const auto end = fmt::format_to_n(path, sizeof path, "{}/cursor", id);
  show(ui, {{path, std::min(end.size, sizeof path)}, Kind::text, "under the mouse", at_cursor}, f.inside);
}

}  // namespace

void PlotRange::take(std::span<const float> values) {
  for (const float v : values) min = std::min(min, v), max = std::max(max, v);
}

void PlotRange::widen(float share_of_it) {
  const float air = max > min ? (max - min) * share_of_it : 1.0f;
  min -= air, max += air;
}

double grid_step(PlotRange r, int most) {
  const double raw = std::max(1e-9, static_cast<double>(r.max - r.min)) / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= raw * (1 - 1e-9)) return m * power;
  return 10 * power;
}

bool value_at(const PlotTrace& t, float x, float& value) {
  const std::size_t n = std::min(t.x.size(), t.y.size());
  if (n == 0 || x < t.x[0] || x > t.x[n - 1]) return false;
  const auto behind = static_cast<std::size_t>(
      std::lower_bound(t.x.begin(), t.x.begin() + static_cast<std::ptrdiff_t>(n), x) - t.x.begin());
  if (behind == 0 || t.x[behind] == t.x[behind - 1]) {
    value = t.y[behind];
    return true;
  }
  if (gap_before(t, behind)) return false;
  const float share = (x - t.x[behind - 1]) / (t.x[behind] - t.x[behind - 1]);
  value = t.y[behind - 1] + share * (t.y[behind] - t.y[behind - 1]);
  return true;
}

void plot(Ui& ui, std::string_view id, std::string_view label, std::span<const PlotTrace> traces,
          const PlotOptions& o, PlotCursor& cursor) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect whole{at, ImVec2(at.x + width_px(ui, o.width), at.y + ui.px(o.height))};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(whole.min, whole.max, ui[Tone::well]);
  PlotField f{{ImVec2(whole.min.x + ui.px(label_width), whole.min.y + ui.px(title_height)),
               ImVec2(whole.max.x - ui.px(16), whole.max.y - ui.px(o.x_labels ? label_height + 4 : 4))},
              o.x,
              o.y};
  if (f.x.max <= f.x.min) f.x.max = f.x.min + 1;
  if (f.y.max <= f.y.min) f.y.max = f.y.min + 1;
  ImGui::Dummy(ImVec2(whole.width(), whole.height()));
  ImGui::SetCursorScreenPos(ImVec2(at.x, whole.max.y));
  show(ui, {id, Kind::text, label, o.words}, whole);
  if (f.inside.width() < ui.px(40) || f.inside.height() < ui.px(16)) return;
  draw_text(ui, ImVec2(f.inside.min.x, whole.min.y + ui.px(2)), Face::small, ui[Tone::ink2], o.title);
  if (o.band.max > o.band.min)
    list->AddRectFilled(ImVec2(f.inside.min.x, f.py(o.band.max)), ImVec2(f.inside.max.x, f.py(o.band.min)),
                        ui[Tone::raised]);
  draw_grid(ui, f, o);
  const bool any = std::any_of(traces.begin(), traces.end(), [](const PlotTrace& t) { return !t.y.empty(); });
  if (!any) {
    if (o.empty.empty()) return;
    const ImVec2 middle = f.inside.centre();
    const ImVec2 half(text_width(ui, Face::body, o.empty) / 2 + ui.px(8), ui.line(Face::body) / 2);
    list->AddRectFilled(ImVec2(middle.x - half.x, middle.y - half.y),
                        ImVec2(middle.x + half.x, middle.y + half.y),
                        ui[Tone::well]);  // hides the grid behind the words
    draw_text_centred(ui, f.inside, Face::body, ui[Tone::ink2], o.empty);
    return;
  }
  list->PushClipRect(f.inside.min, f.inside.max, true);
  for (const PlotTrace& t : traces) draw_trace(ui, f, t);
  draw_marks(ui, f, o.marks);
  draw_names(ui, f, traces);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool here = ImGui::IsWindowHovered() && f.inside.contains(mouse);
  const std::size_t self = std::hash<std::string_view>()(id);
  if (here)
    cursor = {true, f.x.min + (mouse.x - f.inside.min.x) / f.inside.width() * (f.x.max - f.x.min), self};
  else if (cursor.of == self)
    cursor.shown = false;
  if (cursor.shown) draw_cursor(ui, id, f, traces, o, cursor, here);
  list->PopClipRect();
}

}  // namespace hw::gui
