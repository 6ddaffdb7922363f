#include "panels/bus_rows.h"

#include <algorithm>

#include "gui/area.h"
#include "gui/axis_look.h"
#include "gui/console.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/digits.h"
#include "gui/widgets/row.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "panels/axis_extras.h"
#include "panels/jog_button.h"
#include "panels/path.h"
#include "panels/unit_chooser.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float row_height = 48, jog_width = 32, between = 4, most_of_column = 0.55f;
constexpr AxisId only{0};

/// What needs somebody: faults, lost and stale ones.
bool in_trouble(const Tab& tab) {
  return badness(worst_state(tab.now(), tab.clock())) >= badness(State::stale);
}

DigitsState digits_state(const Tab& tab) {
  const AxisState& a = tab.now().axes[0];
  const State state = state_of(tab.now(), 0, tab.clock());
  if (!a.position_known || a.position_doubtful) return DigitsState::untrusted;
  if (state == State::lost || state == State::stale || state == State::connecting) return DigitsState::stale;
  return state == State::off ? DigitsState::off : DigitsState::good;
}

}  // namespace

void BusRows::draw(Frame& f) {
  if (f.tier == Tier::narrow) return draw_strip(f);
  draw_title(f);
  const auto all = static_cast<float>(f.tab.bus->members.size()) * row_height;
  const float room = std::max(3 * row_height, f.area.height * most_of_column);
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
  const Bus& bus = *f.tab.bus;
  const std::size_t trouble = static_cast<std::size_t>(
      std::count_if(bus.members.begin(), bus.members.end(), [](const Tab* t) { return in_trouble(*t); }));
  const Path words("{} of {} answer{}{}", bus.connected(), bus.members.size(), trouble ? ", trouble: " : "",
                   [&] { return trouble ? fmt::format("{}", trouble) : std::string(); }());
  float x = at.x + ui.px(40);
  if (f.bench.present) {
    ImGui::SetCursorScreenPos(ImVec2(x, at.y + ui.px(12)));
    emulated_badge(ui, "dro/emulated");
    x += badge_width(ui, Icon::emulated, "EMULATED") + ui.px(8);
  }
  const float chooser = unit_chooser_width(f);
  const float right = at.x + ui.px(f.area.width - chooser - 8);
  draw_text_line(ui, x, right, at.y + ui.px(22), Face::small, ui[trouble ? Tone::warn : Tone::ink2], words);
  show(ui, {"bus/summary", Kind::text, "Bus", words, {}, false, words},
       {ImVec2(x, at.y), ImVec2(right, at.y + ui.px(44))});
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - chooser), at.y + ui.px(6)));
  draw_unit_chooser(f);
  ImGui::SetCursorScreenPos(after);
}

// Rows do not move under the hand that is about to press one.
void BusRows::sort(const Bus& bus, bool may_move) {
  if (order_.size() == bus.members.size() && !may_move) return;
  order_ = bus.members;
  std::stable_partition(order_.begin(), order_.end(), [](const Tab* t) { return in_trouble(*t); });
}

void BusRows::draw_rows(Frame& f, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect all{at, ImVec2(at.x + f.ui.px(f.area.width), at.y + f.ui.px(height))};
  sort(*f.tab.bus, !all.contains(ImGui::GetIO().MousePos));
  begin_part(f.ui, "bus/rows", f.ui.px(f.area.width), f.ui.px(height), Tone::panel, 0);
  const float width = ImGui::GetContentRegionAvail().x / f.ui.scale;
  for (Tab* member : order_) draw_row(f, *member, width);
  end_part();
}

void BusRows::draw_row(Frame& f, Tab& member, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string_view id = member.id();
  const StateLook& state = look_of(worst_state(member.now(), member.clock()));
  RowOptions o;
  o.height = row_height;
  o.chosen = &member == &f.tab;
  o.bad = state.tone == Tone::fault;
  o.value = state.small;
  ImGui::PushID(&member);
  const Touch t = row(ui, Path("bus/{}", id), id, o);
  const Rect r{at, ImVec2(at.x + ui.px(width), t.rect.max.y)};
  draw_text_line(ui, r.min.x + ui.px(8), r.max.x, r.min.y + ui.px(15), Face::title_bold, ui[Tone::ink], id);
  const std::string& name = member.profile.axes[0].name;
  draw_text_line(ui, r.min.x + ui.px(36), r.min.x + ui.px(96), r.min.y + ui.px(15), Face::small,
                 ui[Tone::ink2], name);
  const float middle = r.min.y + ui.px(35);
  draw_icon(ImGui::GetWindowDrawList(), state.icon, ImVec2(r.min.x + ui.px(14), middle), ui.px(10),
            ui[state.tone]);
  draw_text_line(ui, r.min.x + ui.px(26), r.min.x + ui.px(104), middle, Face::small_bold, ui[state.tone],
                 state.word);
  show(ui, {Path("dro/{}/state", id), Kind::text, "State", state.word, {}, false, {}},
       {ImVec2(r.min.x, middle - ui.px(10)), ImVec2(r.min.x + ui.px(104), middle + ui.px(10))});
  draw_controls(f, member, r);
  ImGui::PopID();
  if (t.clicked) f.console.activate(member);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
}

void BusRows::draw_controls(Frame& f, Tab& member, const Rect& r) {
  Ui& ui = f.ui;
  const float jogs = ui.px(2 * jog_width + between);
  HoldOptions o;
  o.width = o.height = jog_width;
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    const float x = r.max.x - jogs + (sign == Sign::plus ? ui.px(jog_width + between) : 0);
    ImGui::SetCursorScreenPos(ImVec2(x, r.min.y + ui.px((row_height - jog_width) / 2)));
    o.icon = sign == Sign::minus ? Icon::back : Icon::play;
    draw_jog_button(ui, member, only, sign, "", o);
  }
  const DisplayUnit& unit = member.unit(only);
  const AxisState& a = member.now().axes[0];
  const NumberText number = format_position(a.position, unit);
  const bool never = a.seen_at == Instant{} && !a.position_known;
  DigitsOptions d;
  d.face = Face::digits26;
  d.state = digits_state(member);
  const float left = r.min.x + ui.px(96);
  d.width = (r.max.x - jogs - ui.px(8) - left) / ui.scale;
  ImGui::SetCursorScreenPos(ImVec2(left, r.min.y + ui.px(8)));
  const bool chosen = &member == &f.tab;
  d.tip =
      chosen ? "Click to copy it, to make it zero, or to say where the axis stands." : "Click to choose it.";
  const Touch t = digits(ui, Path("dro/{}/position", member.id()), Path("Position of {}", member.id()),
                         never ? std::string_view("-") : number.view(), unit.real ? unit.name : "", d);
  if (chosen)
    menu_.draw(f, only, t);
  else if (t.clicked)
    f.console.activate(member);
}

/// A narrow window: the chosen one, and a list to choose another from.
void BusRows::draw_strip(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto& members = f.tab.bus->members;
  std::vector<std::string_view> names;
  for (const Tab* member : members) names.push_back(member->id());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(20)));
  const int picked = dropdown(ui, "bus/choose", "Controller", names, static_cast<int>(f.tab.bus->chosen));
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(96), at.y + ui.px(12)));
  begin_part(ui, "bus/chosen", ui.px(std::min(360.0f, f.area.width - 96)), ui.px(row_height), Tone::panel, 0,
             false);
  draw_row(f, f.tab, ImGui::GetContentRegionAvail().x / ui.scale);
  end_part();
  if (picked >= 0) f.console.activate(*members[static_cast<std::size_t>(picked)]);
}

}  // namespace hw::panels
