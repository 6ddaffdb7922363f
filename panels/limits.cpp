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

bool tells_more_than_limits(const Catalog& c) {
  return std::any_of(c.axes.begin(), c.axes.end(),
                     [](const AxisInfo& axis) { return axis.home_input || axis.alarm_input; });
}

std::string_view sign_text(Sign sign) { return sign == Sign::plus ? "+" : "\u2212"; }

}  // namespace

void Limits::draw(Frame& f) {
  if (f.rail) return draw_rail(f);
  Ui& ui = f.ui;
  if (tells_more_than_limits(f.catalog)) return draw_with_home(f);
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
  // A sign needs less room than a word.
  const float name_width = 24, sign_cell = 40, word_cell = (f.area.width - name_width - 2 * sign_cell) / 2;
  std::string on, alerts;
  bool known = true;
  const auto say = [](std::string& all, std::string_view words) {
    all += (all.empty() ? "" : ", ") + std::string(words);
  };
  const ImVec2 title = ImGui::GetCursorScreenPos();
  section_title(ui, "Limits and home", {}, 40);
  for (int i = 0; i < static_cast<int>(f.catalog.axes.size()); ++i) {
    const AxisState& a = f.now.axes[static_cast<std::size_t>(i)];
    const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool sure = a.limits_known && f.connected() && !is_old(f.now, i, f.clock);
    known = known && sure;
    draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(14), Face::body_bold, ui[Tone::ink],
                   name);
    float x = name_width;
    const auto one = [&](std::string_view id, std::string_view label, bool lit, LampShape shape,
                         LampState state, std::string_view word) {
      const float cell = label.size() > 3 ? word_cell : sign_cell;
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
      if (lit && sure) say(alert ? alerts : on, Path("{} {}", name, label));
      x += cell;
    };
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const LimitLook look = look_of(f, i, sign);
      const bool hit = sign == Sign::minus ? a.limit_minus : a.limit_plus;
      one(Path("io/limit/{}/{}", name, letter(sign)), sign_text(sign), hit, LampShape::square, look.state,
          hit ? "HIT" : "clear");
    }
    const AxisInfo& info = f.catalog.axes[static_cast<std::size_t>(i)];
    if (info.home_input)
      one(Path("io/home/{}", name), "home", a.home, LampShape::round, a.home ? LampState::on : LampState::off,
          a.home ? "on" : "off");
    if (info.alarm_input)
      one(Path("io/alarm/{}", name), "alarm", a.alarm, LampShape::square,
          a.alarm ? LampState::hit : LampState::off, a.alarm ? "ALARM" : "clear");
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(28)));
  }
  const std::string_view words = !known            ? std::string_view("not known")
                                 : !alerts.empty() ? std::string_view(alerts)
                                 : on.empty()      ? std::string_view("all clear")
                                                   : std::string_view(on);
  const float end = title.x + ui.px(f.area.width);
  const float room = ui.px(f.area.width - 12) - text_width(ui, Face::body_bold, "Limits and home");
  const float width = std::min(room, std::ceil(text_width(ui, Face::small, words)));
  draw_text_line(ui, end - width, end + 1, title.y + ui.px(20), Face::small,
                 ui[!known || !alerts.empty() ? Tone::warn : Tone::ink2], words);
  group_line(ui, 10);
}

/// One lamp over its name; of more than two axes both lamps stand in a line, with the axis between them.
void Limits::draw_rail(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float middle = top.x + ui.px(f.area.width / 2), apart = ui.px(15);
  float y = top.y;
  const auto words = [&](float x, Face face, Tone tone, std::string_view said) {
    draw_text_centred(ui, {ImVec2(x - ui.px(28), y), ImVec2(x + ui.px(28), y + ui.px(16))}, face, ui[tone],
                      said);
  };
  words(middle, Face::small_bold, Tone::ink, "Limits");
  y += ui.px(20);
  const bool many = f.catalog.axes.size() > 2;
  for (int i = 0; i < static_cast<int>(f.catalog.axes.size()); ++i) {
    const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const LimitLook look = look_of(f, i, sign);
      const bool hit = look.state == LampState::hit;
      const float x = std::floor(!many ? middle : sign == Sign::minus ? middle - apart : middle + apart);
      const float half = ui.px(many ? 14 : f.area.width / 2);
      draw_lamp(ui, ImVec2(x, y + ui.px(8)), 12, LampShape::square, look.state);
      show(ui,
           {Path("io/limit/{}/{}", name, letter(sign)), Kind::lamp, name, look.word, {}, false, look.word},
           {ImVec2(x - half, y), ImVec2(x + half, y + ui.px(36))});
      y += ui.px(18);
      words(x, hit ? Face::small_bold : Face::small, hit ? Tone::warn : Tone::ink2,
            many ? sign_text(sign) : Path("{}{}", name, sign_text(sign)).view());
      y += many ? -ui.px(18) : ui.px(20);
    }
    if (!many) continue;
    y += ui.px(18);
    words(middle, Face::small_bold, Tone::ink2, name);
    y += ui.px(20);
  }
  ImGui::SetCursorScreenPos(ImVec2(top.x, y));
  group_line(ui, 8);
}

}  // namespace hw::panels
