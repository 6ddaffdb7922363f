#include "panels/connect/link_bars.h"

#include <algorithm>
#include <array>

#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float bar_name_column = 84, whole_column = 80, bar_height = 28;

struct Part {
  std::string_view word, legend;
  Duration takes;
  Tone fill, ink;
  bool hatched = false;
};

std::array<Part, 4> shares_of(const LinkBudget& b) {
  return {Part{"question", "bytes on the wire", b.question, Tone::ink2, Tone::panel},
          Part{"answer", "bytes on the wire", b.answer, Tone::ink2, Tone::panel},
          Part{"adapter waits", "adapter holds bytes back", b.adapter, Tone::warn_t, Tone::warn, true},
          Part{"rest", "controller and computer", b.rest, Tone::edge, Tone::ground}};
}

void draw_part(Ui& ui, const Rect& r, const Part& part) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(r.min, r.max, ui[part.fill]);
  if (!part.hatched) return;
  list->PushClipRect(r.min, r.max, true);
  const float height = r.max.y - r.min.y;
  for (float x = r.min.x - height; x < r.max.x; x += ui.px(8))
    list->AddLine(ImVec2(x, r.max.y), ImVec2(x + height, r.min.y), ui[Tone::warn], ui.hair());
  list->PopClipRect();
}

}  // namespace

void draw_link_bar(Ui& ui, std::string_view id, std::string_view name, ImVec2 at, float width,
                   const LinkBudget& budget, Duration scale) {
  const float middle = at.y + ui.px(bar_height / 2), right = at.x + ui.px(width);
  draw_text_line(ui, at.x, at.x + ui.px(bar_name_column - 8), middle, Face::body_bold, ui[Tone::ink], name);
  const float begin = at.x + ui.px(bar_name_column), room = right - ui.px(whole_column) - begin;
  float x = begin;
  for (const Part& part : shares_of(budget)) {
    if (part.takes <= Duration::zero() || scale <= Duration::zero()) continue;
    const float wide =
        std::max(1.0f, std::floor(room * static_cast<float>(seconds(part.takes) / seconds(scale))));
    const Rect r{ImVec2(x, at.y), ImVec2(std::max(x + 1, x + wide - ui.hair()), at.y + ui.px(bar_height))};
    draw_part(ui, r, part);
    const Path words("{} {:.1f}", part.word, seconds(part.takes) * 1e3);
    const float words_wide = std::ceil(text_width(ui, Face::small_bold, words));
    if (words_wide + ui.px(12) <= wide) {
      const ImVec2 from(x + ui.px(6), std::floor(middle - ui.line(Face::small_bold) / 2));
      if (part.hatched)
        draw_fill(ui,
                  {ImVec2(from.x - ui.px(2), from.y),
                   ImVec2(from.x + words_wide + ui.px(2), from.y + ui.line(Face::small_bold))},
                  ui[part.fill], 0);
      draw_text(ui, from, Face::small_bold, ui[part.ink], words);
    }
    x += wide;
  }
  const std::string whole = in_millis(budget.whole());
  draw_text_right(ui, ImVec2(right, std::floor(middle - ui.line(Face::body_bold) / 2)), Face::body_bold,
                  ui[Tone::ink], whole);
  const Path shown("{}: query {:.1f}, reply {:.1f}, adapter {:.1f}, controller and computer {:.1f}", whole,
                   seconds(budget.question) * 1e3, seconds(budget.answer) * 1e3,
                   seconds(budget.adapter) * 1e3, seconds(budget.rest) * 1e3);
  show(ui, {id, Kind::text, name, shown, {}, false, {}}, {at, ImVec2(right, at.y + ui.px(bar_height))});
}

void draw_link_legend(Ui& ui, ImVec2 at, float width, const LinkBudget& budget) {
  float x = at.x + ui.px(bar_name_column);
  std::string_view last_legend;
  for (const Part& part : shares_of(budget)) {
    if (part.takes <= Duration::zero() || part.legend == last_legend) continue;
    last_legend = part.legend;
    const float wide = std::ceil(text_width(ui, Face::small, part.legend));
    if (x + ui.px(16) + wide > at.x + ui.px(width)) break;
    draw_part(ui, {ImVec2(x, at.y + ui.px(5)), ImVec2(x + ui.px(10), at.y + ui.px(15))}, part);
    draw_text(ui, ImVec2(x + ui.px(16), at.y + ui.px(2)), Face::small, ui[Tone::ink2], part.legend);
    x += ui.px(16) + wide + ui.px(20);
  }
}

}  // namespace hw::panels
