#include "panels/position/bus_rows.h"

#include <algorithm>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/position/axis_extras.h"
#include "panels/position/axis_line.h"
#include "panels/position/unit_chooser.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float bus_row_height = axis_line_height, most_of_column = 0.55f, margin = 16;
constexpr AxisId only{0};

/// Whether a controller needs attention: a fault, or a lost or stale link.
bool in_trouble(const Tab& tab) {
  return badness(worst_state(tab.now(), tab.clock())) >= badness(State::stale);
}

}  // namespace

void BusRows::draw(Frame& f) {
  if (f.tier == Tier::narrow) return draw_strip(f);
  draw_title(f);
  const auto all = static_cast<float>(f.tab.bus->members.size()) * bus_row_height;
  const float room = std::max(3 * bus_row_height, f.area.height * most_of_column);
  draw_rows(f, std::min(all, room));
  group_line(f.ui, 0);
  const float extras = axis_extras_height(f.catalog, only);
  if (extras == 0) return;
  draw_axis_extras(f, only, ImGui::GetCursorScreenPos(), f.ui.px(f.area.width));
  group_line(f.ui, 0);
}

void BusRows::draw_title(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(ui, "Bus", {}, 44);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  if (f.bench.present) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(40), at.y + ui.px(12)));
    emulated_badge(ui, "dro/emulated");
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - unit_chooser_width(f)), at.y + ui.px(6)));
  chooser_.draw(f);
  ImGui::SetCursorScreenPos(after);
  draw_summary(f, f.area.width);
}

/// Draws the number of controllers that respond, and the menu for the position of the chosen controller.
void BusRows::draw_summary(Frame& f, float width) {
  Ui& ui = f.ui;
  constexpr float height = 32;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Bus& bus = *f.tab.bus;
  int trouble = 0;
  const Tab* first = nullptr;
  for (const Tab* member : bus.members) {
    if (!in_trouble(*member)) continue;
    ++trouble;
    if (!first) first = member;
  }
  const Path answers("{} of {} answer", bus.connected(), bus.members.size());
  const Path all("{}, trouble: {}", answers.view(), trouble);
  const std::string_view words = first ? all.view() : answers.view();
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.height = 28;
  o.tip = "Copy its position, set it to zero, or set it.";
  const Path label("Set {}", f.tab.id());
  o.width = button_width(ui, label, o);
  const float left = at.x + ui.px(width - o.width);
  const Path shows("Show {}", first ? first->id() : "");
  const float end = left - (first ? std::ceil(text_width(ui, Face::small, shows)) + ui.px(12) : 0);
  const Path brief("trouble: {}", trouble);
  const bool fits = !first || text_width(ui, Face::small, words) <= end - at.x;
  draw_text_line(ui, at.x, end, at.y + ui.px(height / 2 - 2), Face::small,
                 ui[first ? Tone::warn : Tone::ink2], fits ? words : brief.view());
  show(ui, {"bus/summary", Kind::text, "Bus", words, {}, false, words},
       {at, ImVec2(end, at.y + ui.px(height))});
  ImGui::SetCursorScreenPos(ImVec2(end + ui.px(8), at.y + ui.px(6)));
  if (first && link(ui, "bus/trouble", shows)) ui.registry.scroll_to(Path("bus/{}", first->id()).view());
  ImGui::SetCursorScreenPos(ImVec2(left, at.y));
  menu_.draw(f, only, button(ui, Path("dro/{}/menu", f.tab.id()), label, o));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(height)));
}

void BusRows::draw_rows(Frame& f, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect all{at, ImVec2(at.x + f.ui.px(f.area.width), at.y + f.ui.px(height))};
  // The highlight spans the column from border to border, so that it is visible from afar.
  ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x - margin), at.y));
  begin_part(f.ui, "bus/rows", f.ui.px(f.area.width + 2 * margin) - f.ui.hair(), f.ui.px(height), Tone::panel,
             margin);
  const float width = ImGui::GetContentRegionAvail().x / f.ui.scale;
  // Rows are always in the order of their ids: they have jog buttons and must not change places.
  for (Tab* member : f.tab.bus->members) draw_row(f, *member, width);
  end_part();
  ImGui::SetCursorScreenPos(ImVec2(at.x, all.max.y));
}

void BusRows::draw_row(Frame& f, Tab& member, float width) {
  const std::string_view id = member.id();
  const Path row_id("bus/{}", id);
  AxisLine line;
  line.id = row_id;
  line.name = id;
  line.label = member.settings.profile.axes[0].name;
  line.state = worst_state(member.now(), member.clock());
  line.chosen = &member == &f.tab;
  if (!line.chosen) line.tip = "Click to choose it.";
  ImGui::PushID(&member);
  const AxisLineTouch touched = draw_axis_line(f.ui, member, only, line, width);
  ImGui::PopID();
  if (touched.pressed || touched.number.clicked) f.console.activate(member);
}

/// For a narrow window: draws the chosen controller, and a list to choose another.
void BusRows::draw_strip(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto& members = f.tab.bus->members;
  std::vector<std::string_view> names;
  for (const Tab* member : members) names.push_back(member->id());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(16)));
  const int picked = dropdown(ui, "bus/choose", "Controller", names, static_cast<int>(f.tab.bus->chosen));
  constexpr float left = 96, gap_after = 16;
  const float row = std::min(360.0f, f.area.width - left);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), at.y + ui.px(10)));
  begin_part(ui, "bus/chosen", ui.px(row), ui.px(bus_row_height), Tone::panel, 12, false);
  draw_row(f, f.tab, ImGui::GetContentRegionAvail().x / ui.scale);
  end_part();
  const float rest = f.area.width - left - row - gap_after;
  if (rest >= 160) {
    const ImVec2 corner(at.x + ui.px(left + row + gap_after), at.y + ui.px(6));
    ImGui::SetCursorScreenPos(corner);
    if (f.bench.present) emulated_badge(ui, "dro/emulated");
    ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + ui.px(26)));
    draw_summary(f, rest);
  }
  if (picked >= 0) f.console.activate(*members[static_cast<std::size_t>(picked)]);
}

}  // namespace hw::panels
