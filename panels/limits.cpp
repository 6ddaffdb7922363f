#include "panels/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "gui/model/axis_look.h"
#include "gui/surface/ui.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/kept_legible.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float signal_height = 28;

/// Width for the longest name of an axis; a device of a bus has two figures.
float names_width(const Frame& f, float least) {
  float longest = 0;
  for (const AxisInfo& axis : f.catalog.axes)
    longest = std::max(longest, text_width(f.ui, Face::body_bold, axis.name));
  return std::max(least, std::ceil(longest / f.ui.scale) + 8);
}
float with_home_name(const Frame& f) { return names_width(f, 24); }

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

bool shows_more_than_limits(const Catalog& c) {
  return std::any_of(c.axes.begin(), c.axes.end(),
                     [](const AxisInfo& axis) { return axis.home_input || axis.alarm_input; });
}

}  // namespace

/// Tooltips must not cover the lamps.
void Limits::draw(Frame& f) {
  const float title = f.rail ? 20 : 40, left = ImGui::GetWindowPos().x;
  const float top = ImGui::GetCursorScreenPos().y + f.ui.px(title);
  if (f.rail)
    f.catalog.axes.size() > 4 ? draw_brief_rail(f) : draw_rail(f);
  else if (shows_more_than_limits(f.catalog))
    draw_with_home(f);
  else
    draw_limits(f);
  const ImVec2 end(left + ImGui::GetWindowWidth(), ImGui::GetCursorScreenPos().y);
  keep_legible(f.ui, {ImVec2(left, top), end});
}

void Limits::draw_limits(Frame& f) {
  Ui& ui = f.ui;
  section_title(ui, "Limits", {}, 40);
  const float name_width = names_width(f, 28), cell = (f.area.width - name_width) / 2;
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

/// A lamp with its name, in the line of an axis.
struct Limits::Signal {
  Path id{""};
  std::string_view label, word;
  LampShape shape = LampShape::square;
  LampState state = LampState::off;
  bool on = false;
};

/// The signals of an axis: two limits, home, alarm.
class Limits::Signals {
 public:
  void add(const Signal& signal) { signals_[count_++] = signal; }
  [[nodiscard]] std::span<const Signal> list() const { return {signals_.data(), count_}; }

 private:
  std::array<Signal, 4> signals_;
  std::size_t count_ = 0;
};

/// The words in the title. Faults come first.
struct Limits::Summary {
  std::string on, alerts;
  int on_count = 0, alert_count = 0;
  bool known = true;

  void add(const std::string& axis, const Signal& signal) {
    if (!signal.on) return;
    const bool alert = signal.state == LampState::hit;
    ++(alert ? alert_count : on_count);
    std::string& all = alert ? alerts : on;
    all += fmt::format("{}{} {}", all.empty() ? "" : ", ", axis, signal.label);
  }
  [[nodiscard]] bool warns() const { return !known || !alerts.empty(); }
  [[nodiscard]] std::string_view words() const {
    if (!known) return "not known";
    if (!alerts.empty()) return alerts;
    if (!on.empty()) return on;
    return "all clear";
  }
};

/// Draws four lamps per axis in a line. The title names the active signals.
void Limits::draw_with_home(Frame& f) {
  Ui& ui = f.ui;
  Summary summary;
  const ImVec2 title = ImGui::GetCursorScreenPos();
  section_title(ui, "Limits and home", {}, 40);
  const float names = with_home_name(f);
  if (f.catalog.axes.size() > 4)
    draw_in_halves(f, names, summary);
  else
    for (int i = 0; i < static_cast<int>(f.catalog.axes.size()); ++i) draw_signals(f, i, names, summary);
  const float end = title.x + ui.px(f.area.width);
  const float room = ui.px(f.area.width - 12) - text_width(ui, Face::body_bold, "Limits and home");
  const bool alerts = summary.alert_count > 0;
  const Path count("{} {}", alerts ? summary.alert_count : summary.on_count, alerts ? "hit" : "on");
  const bool fits = text_width(ui, Face::small, summary.words()) <= room;
  const std::string_view text = fits ? summary.words() : count.view();
  draw_text_right(ui, ImVec2(end, title.y + ui.px(12)), Face::small,
                  ui[summary.warns() ? Tone::warn : Tone::ink2], text);
  group_line(ui, 10);
}

/// Draws many axes in two halves side by side, with lamps below shared names.
void Limits::draw_in_halves(Frame& f, float names, Summary& summary) {
  Ui& ui = f.ui;
  constexpr float names_height = 20, apart = 16, sign_cell = 28, word_cell = 36;
  const int axes = static_cast<int>(f.catalog.axes.size()), rows = (axes + 1) / 2;
  const float half = std::floor((f.area.width - apart) / 2) + apart;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float used = names;  // width used in a half
  for (int i = 0; i < axes; ++i) {
    const ImVec2 corner(at.x + ui.px(half * static_cast<float>(i / rows)),
                        at.y + ui.px(names_height + signal_height * static_cast<float>(i % rows)));
    Signals signals;
    const bool sure = find_signals(f, i, signals, summary);
    draw_text_line(ui, corner.x, corner.x + ui.px(names), corner.y + ui.px(signal_height / 2),
                   Face::body_bold, ui[Tone::ink], f.catalog.axes[static_cast<std::size_t>(i)].name);
    used = names;
    for (const Signal& signal : signals.list()) {
      const float cell = signal.label.size() > 3 ? word_cell : sign_cell;
      const float x = corner.x + ui.px(used);
      if (i % rows == 0)
        draw_text_centred(
            ui, {ImVec2(x + ui.px(7 - cell), at.y), ImVec2(x + ui.px(7 + cell), at.y + ui.px(names_height))},
            Face::small, ui[Tone::ink2], signal.label);
      draw_signal(f, signal, sure, ImVec2(x, corner.y), cell, false);
      used += cell;
    }
  }
  ImGui::SetCursorScreenPos(
      ImVec2(at.x, at.y + ui.px(names_height + signal_height * static_cast<float>(rows))));
}

/// Returns true when the signals are known and fresh.
bool Limits::find_signals(const Frame& f, int i, Signals& signals, Summary& summary) {
  const AxisState& a = f.now.axes[static_cast<std::size_t>(i)];
  const AxisInfo& info = f.catalog.axes[static_cast<std::size_t>(i)];
  const bool sure = a.limits_known && f.connected() && !is_old(f.now, i, f.clock);
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    const bool hit = sign == Sign::minus ? a.limit_minus : a.limit_plus;
    signals.add({Path("io/limit/{}/{}", info.name, letter(sign)), sign_text(sign), hit ? "HIT" : "clear",
                 LampShape::square, hit ? LampState::hit : LampState::off, hit});
  }
  if (info.home_input)
    signals.add({Path("io/home/{}", info.name), "home", a.home ? "on" : "off", LampShape::round,
                 a.home ? LampState::on : LampState::off, a.home});
  if (info.alarm_input)
    signals.add({Path("io/alarm/{}", info.name), "alarm", a.alarm ? "ALARM" : "clear", LampShape::square,
                 a.alarm ? LampState::hit : LampState::off, a.alarm});
  summary.known = summary.known && sure;
  if (sure)
    for (const Signal& signal : signals.list()) summary.add(info.name, signal);
  return sure;
}

void Limits::draw_signals(Frame& f, int i, float names, Summary& summary) {
  Ui& ui = f.ui;
  Signals signals;
  const bool sure = find_signals(f, i, signals, summary);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(names), at.y + ui.px(14), Face::body_bold, ui[Tone::ink],
                 f.catalog.axes[static_cast<std::size_t>(i)].name);
  // A sign is narrower than a word.
  constexpr float sign_cell = 40;
  const float word_cell = (f.area.width - names - 2 * sign_cell) / 2;
  float x = names;
  for (const Signal& signal : signals.list()) {
    const float cell = signal.label.size() > 3 ? word_cell : sign_cell;
    draw_signal(f, signal, sure, ImVec2(at.x + ui.px(x), at.y), cell, true);
    x += cell;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(signal_height)));
}

void Limits::draw_signal(Frame& f, const Signal& s, bool sure, ImVec2 at, float cell, bool named) {
  Ui& ui = f.ui;
  const Rect r{at, ImVec2(at.x + ui.px(cell), at.y + ui.px(signal_height))};
  const float middle = std::floor(r.centre().y);
  draw_lamp(ui, ImVec2(r.min.x + ui.px(7), middle), 12, s.shape, sure ? s.state : LampState::unknown);
  const Tone tone = s.on && s.state == LampState::hit ? Tone::warn : s.on ? Tone::ink : Tone::ink2;
  if (named)
    draw_text_line(ui, r.min.x + ui.px(18), r.max.x, middle, s.on ? Face::small_bold : Face::small, ui[tone],
                   s.label);
  const Path value("{}{}", s.word, sure ? "" : "?");
  show(ui, {s.id, Kind::lamp, s.label, value, {}, false, value}, r);
}

/// Draws a line for each of many axes: the axis between its two lamps, below shared signs.
void Limits::draw_brief_rail(Frame& f) {
  Ui& ui = f.ui;
  constexpr float title = 20, signs = 18, line = 21;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float middle = std::floor(top.x + ui.px(f.area.width / 2)), apart = ui.px(17);
  const auto words = [&](float x, float y, Face face, Tone tone, std::string_view text) {
    draw_text_centred(ui, {ImVec2(x - ui.px(28), y), ImVec2(x + ui.px(28), y + ui.px(16))}, face, ui[tone],
                      text);
  };
  words(middle, top.y, Face::small_bold, Tone::ink, "Limits");
  for (const Sign sign : {Sign::minus, Sign::plus})
    words(sign == Sign::minus ? middle - apart : middle + apart, top.y + ui.px(title), Face::small,
          Tone::ink2, sign_text(sign));
  const int axes = static_cast<int>(f.catalog.axes.size());
  for (int i = 0; i < axes; ++i) {
    const float y = top.y + ui.px(title + signs + line * static_cast<float>(i));
    const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
    bool hit = false;
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const LimitLook look = look_of(f, i, sign);
      hit = hit || look.state == LampState::hit;
      const float x = sign == Sign::minus ? middle - apart : middle + apart;
      draw_lamp(ui, ImVec2(x, y + ui.px(8)), 12, LampShape::square, look.state);
      show(ui,
           {Path("io/limit/{}/{}", name, letter(sign)), Kind::lamp, name, look.word, {}, false, look.word},
           {ImVec2(x - ui.px(10), y), ImVec2(x + ui.px(10), y + ui.px(line))});
    }
    words(middle, y, hit ? Face::small_bold : Face::small, hit ? Tone::warn : Tone::ink2, name);
  }
  ImGui::SetCursorScreenPos(ImVec2(top.x, top.y + ui.px(title + signs + line * static_cast<float>(axes))));
  group_line(ui, 8);
}

/// Draws lamps above their names. With more than two axes, both lamps are in a line with the axis between
/// them.
void Limits::draw_rail(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float middle = top.x + ui.px(f.area.width / 2), apart = ui.px(15);
  float y = top.y;
  const auto words = [&](float x, Face face, Tone tone, std::string_view text) {
    draw_text_centred(ui, {ImVec2(x - ui.px(28), y), ImVec2(x + ui.px(28), y + ui.px(16))}, face, ui[tone],
                      text);
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
