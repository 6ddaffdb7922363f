#include "panels/limits.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gui/axis_look.h"
#include "gui/ui.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;

namespace {

struct LimitLook {
  LampState state;
  std::string_view word;
};

LimitLook look_of(const Frame& f, int axis, Sign sign) {
  const AxisState& a = f.now.axes[static_cast<std::size_t>(axis)];
  const bool hit = sign == Sign::minus ? a.limit_minus : a.limit_plus;
  if (!a.limits_known || !f.connected())
    return {LampState::unknown, a.limits_known ? (hit ? "HIT?" : "clear?") : "?"};
  if (is_old(f.now, axis, f.clock)) return {LampState::unknown, hit ? "HIT?" : "clear?"};
  return hit ? LimitLook{LampState::hit, "HIT"} : LimitLook{LampState::off, "clear"};
}

/// It homes onto a switch of its own, and tells whether the axis stands on it.
bool tells_home(const Catalog& c) {
  return std::any_of(c.homing_modes.begin(), c.homing_modes.end(),
                     [](const HomingMode& mode) { return mode.id == "home"; });
}

std::string_view sign_text(Sign sign) { return sign == Sign::plus ? "+" : "\u2212"; }

}  // namespace

void Limits::draw(Frame& f) {
  if (f.rail) return draw_rail(f);
  Ui& ui = f.ui;
  if (tells_home(f.catalog)) return draw_with_home(f);
  section_title(ui, "Limits", {}, 40);
  const float name_width = 28, cell = (f.area.width - name_width) / 2;
  for (int i = 0; i < static_cast<int>(f.catalog.axes.size()); ++i) {
    const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(14), Face::body_bold, ui[Tone::ink],
                   name);
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const LimitLook look = look_of(f, i, sign);
      LampOptions o;
      o.shape = LampShape::square;
      o.state = look.state;
      o.word = look.word;
      o.width = cell;
      o.height = 28;
      const float x = name_width + (sign == Sign::plus ? cell : 0);
      ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(x), at.y));
      lamp(ui, Path("io/limit/{}/{}", name, letter(sign)), Path("{}{}", name, sign_text(sign)), o);
    }
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(28)));
  }
  group_line(ui, 10);
}

/// Four lamps an axis in a line; what is on stands in the title in words.
void Limits::draw_with_home(Frame& f) {
  Ui& ui = f.ui;
  const float name_width = 24, cell = (f.area.width - name_width) / 4;
  std::string on;
  const auto say = [&](std::string_view words) { on += (on.empty() ? "" : ", ") + std::string(words); };
  const ImVec2 title = ImGui::GetCursorScreenPos();
  section_title(ui, "Limits and home", {}, 40);
  for (int i = 0; i < static_cast<int>(f.catalog.axes.size()); ++i) {
    const AxisState& a = f.now.axes[static_cast<std::size_t>(i)];
    const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool sure = a.limits_known && f.connected() && !is_old(f.now, i, f.clock);
    draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(14), Face::body_bold, ui[Tone::ink],
                   name);
    float x = name_width;
    const auto one = [&](std::string_view id, std::string_view label, bool lit, LampShape shape,
                         LampState state, std::string_view word) {
      const Rect r{ImVec2(at.x + ui.px(x), at.y), ImVec2(at.x + ui.px(x + cell), at.y + ui.px(28))};
      const float middle = std::floor(r.centre().y);
      draw_lamp(ui, ImVec2(r.min.x + ui.px(7), middle), 12, shape, sure ? state : LampState::unknown);
      const bool alert = lit && state == LampState::hit;
      draw_text_line(ui, r.min.x + ui.px(18), r.max.x, middle, lit ? Face::small_bold : Face::small,
                     ui[alert ? Tone::warn
                        : lit ? Tone::ink
                              : Tone::ink2],
                     label);
      const Path value("{}{}", word, sure ? "" : "?");
      show(ui, {id, Kind::lamp, label, value, {}, false, value}, r);
      if (lit && sure) say(Path("{} {}", name, label));
      x += cell;
    };
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const LimitLook look = look_of(f, i, sign);
      const bool hit = sign == Sign::minus ? a.limit_minus : a.limit_plus;
      one(Path("io/limit/{}/{}", name, letter(sign)), sign_text(sign), hit, LampShape::square, look.state,
          hit ? "HIT" : "clear");
    }
    one(Path("io/home/{}", name), "home", a.home, LampShape::round, a.home ? LampState::on : LampState::off,
        a.home ? "on" : "off");
    one(Path("io/alarm/{}", name), "alarm", a.alarm, LampShape::square,
        a.alarm ? LampState::hit : LampState::off, a.alarm ? "ALARM" : "clear");
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(28)));
  }
  const std::string_view words = on.empty() ? std::string_view("all clear") : std::string_view(on);
  draw_text_right(ui, ImVec2(title.x + ui.px(f.area.width), title.y + ui.px(12)), Face::small,
                  ui[on.empty() ? Tone::ink2 : Tone::warn], words);
  group_line(ui, 10);
}

void Limits::draw_rail(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  float y = top.y;
  const float middle = top.x + ui.px(f.area.width / 2);
  const auto line = [&](Face face, Tone tone, std::string_view words) {
    draw_text_centred(ui, {ImVec2(top.x, y), ImVec2(top.x + ui.px(f.area.width), y + ui.px(16))}, face,
                      ui[tone], words);
    y += ui.px(20);
  };
  line(Face::small_bold, Tone::ink, "Limits");
  for (int i = 0; i < static_cast<int>(f.catalog.axes.size()); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
      const LimitLook look = look_of(f, i, sign);
      const Rect r{ImVec2(top.x, y), ImVec2(top.x + ui.px(f.area.width), y + ui.px(36))};
      draw_lamp(ui, ImVec2(std::floor(middle), y + ui.px(8)), 12, LampShape::square, look.state);
      y += ui.px(18);
      const bool hit = look.state == LampState::hit;
      line(hit ? Face::small_bold : Face::small, hit ? Tone::warn : Tone::ink2,
           Path("{}{}", name, sign_text(sign)));
      show(ui,
           {Path("io/limit/{}/{}", name, letter(sign)), Kind::lamp, name, look.word, {}, false, look.word},
           r);
    }
  ImGui::SetCursorScreenPos(ImVec2(top.x, y));
  group_line(ui, 8);
}

}  // namespace hw::panels
