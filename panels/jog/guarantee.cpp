#include "panels/jog/guarantee.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "gui/model/tab.h"
#include "gui/model/tap_size.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/jog/jog_units.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr double longest_silence_s = 1.3;  // until the watchdog acts for a hung program

/// `guard` runs in the controller too, but whether it works is not certain: JogGuardFacts::doubt.
enum class EndsBy : std::uint8_t { controller, guard, watchdog, program, nothing };

/// The weakest guarantee of all axes that the pad jogs.
struct Guarantee {
  EndsBy by = EndsBy::controller;
  Steps way{};                        ///< the longest travel; if nothing ends it, per second
  const DisplayUnit* unit = nullptr;  ///< unit of its axis
  std::string_view axis = {};         ///< set where units differ
};

Guarantee of_axis(const Tab& tab, AxisId id) {
  const Snapshot& now = tab.now();
  const AxisState& axis = now.axes[id.index];
  if (axis.travel_holds() && axis.travel.has_minus && axis.travel.has_plus)
    return {EndsBy::controller,
            std::max(axis.travel.plus - axis.commanded(), axis.commanded() - axis.travel.minus)};
  const double speed = held_speed(tab, id).value;
  if (now.jog_guard.state == JogGuard::State::installed)
    return {EndsBy::guard, Steps(std::llround(speed * seconds(now.jog_guard.silence)))};
  if (now.link.jog_ends == JogEnds::with_program) return {EndsBy::program, {}};
  if (now.link.jog_ends == JogEnds::never) return {EndsBy::nothing, Steps(std::llround(speed))};
  return {EndsBy::watchdog, Steps(std::llround(speed * longest_silence_s))};
}

Guarantee guarantee_of(const Frame& f) {
  Guarantee all;
  for_each_axis(f, [&](const Tab& tab, AxisId id) {
    Guarantee one = of_axis(tab, id);
    one.unit = &tab.settings.units().length(id);
    one.axis = tab.catalog().axes[id.index].name;
    if (!all.unit || one.by > all.by || (one.by == all.by && one.way > all.way)) all = one;
  });
  if (!unit_of_taps(f.tab)) all.unit = &common_unit(f), all.axis = {};
  return all;
}

struct Words {
  std::string_view by, verb, tip;
  Tone tone;
};
Words words_on(EndsBy by) {
  switch (by) {
    case EndsBy::controller:
      return {"controller", "stops it",
              "A held jog is sent as a move to your limit. The controller ends it there even if this program "
              "dies.",
              Tone::ok};
    case EndsBy::guard:
      return {
          "controller", "a guess",
          "The guard in the controller stops a held jog when it has received nothing for a while; the axis "
          "then ramps down. No real hardware has confirmed this yet, so the watchdog stays on too.",
          Tone::ok};
    case EndsBy::watchdog:
      return {"watchdog", "stops it",
              "A separate process stops a held jog: within 0.3 s if this program dies, within 1.3 s if it "
              "hangs, each followed by the ramp. The distance shown is that of 1.3 s at this speed.",
              Tone::ink};
    case EndsBy::program:
      return {"this program", "ends it", "The controller is emulated in this program, and ends with it.",
              Tone::ink};
    case EndsBy::nothing: break;
  }
  return {
      "no guard", "stops it",
      "Set both limits of the axis, so that the controller ends the jog there. Otherwise, if this program "
      "dies, a held jog runs on to a limit switch: its watchdog does not run, or does not reach this wire.",
      Tone::fault};
}

/// The touch of this area. ImGui's cursor stays.
Touch touch_at(Ui& ui, const About& about, const Rect& rect) {
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(rect.min);
  const Touch touched = touch(ui, about, ImVec2(rect.width(), rect.height()));
  ImGui::SetCursorScreenPos(cursor);
  return touched;
}

}  // namespace

bool draw_guarantee(const Frame& f, const Rect& place) {
  const LinkState link = f.tab.now().link.state;
  if (link != LinkState::good && link != LinkState::late) return false;
  Ui& ui = f.ui;
  const Guarantee guarantee = guarantee_of(f);
  const Words words = words_on(guarantee.by);
  const bool known = guarantee.way > Steps(0);
  const NumberText length = format_with_unit(guarantee.way, *guarantee.unit);
  const Path way("{}{}{}", guarantee.axis, guarantee.axis.empty() ? "" : " ", length.view());
  const std::string_view bound = guarantee.by == EndsBy::controller ? "within " : "";
  const Path whole = guarantee.by == EndsBy::guard     ? Path("{}, {}", way.view(), words.verb)
                     : guarantee.by == EndsBy::nothing ? Path("{} per second", way.view())
                                                       : Path("{}: {}{}", words.verb, bound, way.view()),
             longest("{} at this speed", whole.view());
  const bool opens = f.catalog.jog_guard.offered();
  const float chevron = opens ? ui.px(14) : 0;
  const float by_width = std::ceil(text_width(ui, Face::small_bold, words.by)) + ui.px(20);
  const auto fits = [&](std::string_view rest) {
    return by_width + text_width(ui, Face::small, rest) + chevron <= place.width();
  };
  const bool with_speed = known && guarantee.by == EndsBy::watchdog && fits(longest.view());
  const std::string_view rest = with_speed                    ? longest.view()
                                : known && fits(whole.view()) ? whole.view()
                                                              : words.verb;
  const float width = by_width + std::ceil(text_width(ui, Face::small, rest)) + chevron;
  const float middle = place.centre().y, half = ui.px(std::min(24.0f, place.height() / ui.px(1)) / 2);
  const Rect badge{ImVec2(place.min.x, std::floor(middle - half)),
                   ImVec2(std::min(place.max.x, place.min.x + width), std::floor(middle + half))};
  const About about{"jog/guarantee", opens ? Kind::button : Kind::text, words.by, rest, {}, false, words.tip};
  const Touch pressed = opens ? touch_at(ui, about, badge) : Touch();
  if (pressed.hovered || pressed.held) draw_fill(ui, badge, ui[pressed.held ? Tone::sel : Tone::hover]);
  draw_outline(ui, badge, ui[guarantee.by == EndsBy::nothing ? Tone::fault : Tone::edge]);
  const float left = badge.min.x + ui.px(8);
  draw_text_line(ui, left, badge.max.x, middle, Face::small_bold, ui[words.tone], words.by);
  draw_text_line(ui, left + by_width - ui.px(16), badge.max.x - chevron, middle, Face::small, ui[Tone::ink2],
                 rest);
  if (opens) {
    draw_icon(ImGui::GetWindowDrawList(), Icon::chevron_down,
              ImVec2(std::floor(badge.max.x - ui.px(12)), std::floor(middle)), ui.px(12), ui[Tone::ink2]);
    draw_ring(ui, pressed);
  } else {
    show(ui, about, badge);
  }
  return pressed.clicked;
}

}  // namespace hw::panels
