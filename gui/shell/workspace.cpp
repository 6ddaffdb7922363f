#include "gui/shell/workspace.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>
#include <imgui_internal.h>

#include "gui/shell/banner_subject.h"
#include "gui/shell/console.h"
#include "gui/shell/messages.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/tabs.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

/// The workspace of a controller in one frame.
struct Work {
  Ui& ui;
  Console& console;
  Tab& tab;
  const Layout& layout;

  [[nodiscard]] bool wanted(const PanelEntry& entry) const { return !entry.wanted || entry.wanted(tab); }
  void draw(std::size_t index, const Box& area, bool rail = false) const {
    const PanelEntry& entry = console.list().panels[index];
    Tab& of = entry.of_bus && tab.bus ? *tab.bus->members.front() : tab;
    auto& panel = of.panels.all[index];
    if (!panel) panel = entry.make();
    Frame frame{{ui, console, area, layout.tier, rail, of.clock()}, of, of.catalog(), of.now(), of.bench()};
    ImGui::PushID(&of);  // buttons of different controllers must differ: press_guard.h
    ImGui::PushID(entry.id.data(), entry.id.data() + entry.id.size());
    panel->draw(frame);
    ImGui::PopID();
    ImGui::PopID();
  }
  /// Draws all panels of a place, one below the other.
  void draw_all(Place place, const Box& area, bool rail = false) const {
    for (std::size_t i = 0; i < console.list().panels.size(); ++i)
      if (console.list().panels[i].place == place && wanted(console.list().panels[i])) draw(i, area, rail);
  }
  [[nodiscard]] bool has(Place place) const {
    const auto panels = console.list().panels;
    return std::any_of(panels.begin(), panels.end(),
                       [&](const PanelEntry& entry) { return entry.place == place && wanted(entry); });
  }
  /// A scrolling part has its own scroll position for each controller or bus.
  void begin_own_part(const char* name, float width, float height, float padding, bool scrolls = true) const {
    ImGui::PushID(tab.bus ? static_cast<const void*>(tab.bus.get()) : &tab);
    begin_part(ui, name, width, height, Tone::panel, padding, scrolls);
  }
  static void end_own_part() {
    end_part();
    ImGui::PopID();
  }
};

// ---- centre

struct TabItem {
  std::string_view id, title;
  int panel;  ///< -1: the left column, -2: the right column
};

struct TabItems {
  std::array<TabItem, 16> items;
  std::size_t count = 0;
  void add(TabItem item) {
    if (count < items.size()) items[count++] = item;
  }
  [[nodiscard]] const TabItem& chosen(std::string_view id) const {
    for (std::size_t i = 0; i < count; ++i)
      if (items[i].id == id) return items[i];
    for (std::size_t i = 0; i < count; ++i)
      if (items[i].panel >= 0) return items[i];
    return items[0];
  }
};

TabItems tab_items(const Work& w, bool below_is_tab) {
  TabItems items;
  const bool narrow = w.layout.tier == Tier::narrow;
  if (narrow) items.add({"jog", "Jog", -1});
  const auto panels = w.console.list().panels;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const bool here = panels[i].place == Place::centre || (panels[i].place == Place::below && below_is_tab);
    if (here && w.wanted(panels[i])) items.add({panels[i].id, panels[i].title, static_cast<int>(i)});
  }
  if (narrow) items.add({"io", "I/O and limits", -2});
  return items;
}

void draw_panel_tabs(const Work& w, const TabItems& items, const TabItem& chosen) {
  std::array<std::array<char, 48>, 16> ids;
  std::array<PanelTab, 16> tabs;
  int active = -1;
  for (std::size_t i = 0; i < items.count; ++i) {
    const auto end = fmt::format_to_n(ids[i].data(), ids[i].size(), "tab/{}", items.items[i].id);
    tabs[i] = {{ids[i].data(), std::min(end.size, ids[i].size())}, items.items[i].title};
    if (items.items[i].id == chosen.id) active = static_cast<int>(i);
  }
  ImGui::SetCursorScreenPos(
      ImVec2(ImGui::GetCursorScreenPos().x + w.ui.px(16), ImGui::GetCursorScreenPos().y));
  const int picked = panel_tabs(w.ui, {tabs.data(), items.count}, active);
  if (picked >= 0) w.tab.panels.in_front = items.items[static_cast<std::size_t>(picked)].id;
  ImGui::SetCursorScreenPos(ImVec2(w.ui.px(w.layout.centre.x), ImGui::GetCursorScreenPos().y));
}

bool stands_in(Place side, Place place) {
  return place == side || (side == Place::right && place == Place::lower_right);
}

/// Draws a part of a side column shown as a tab: its panels in the list from `first` up to `end`.
void draw_tab_column(const Work& w, const char* name, Place side, const Box& area, std::size_t first,
                     std::size_t end) {
  ImGui::SetCursorScreenPos(w.ui.px(area.x, area.y));
  w.begin_own_part(name, w.ui.px(area.width), w.ui.px(area.height), 16);
  const auto panels = w.console.list().panels;
  for (std::size_t i = first; i < end; ++i)
    if (stands_in(side, panels[i].place) && w.wanted(panels[i]))
      w.draw(i, {area.x + 16, area.y, area.width - 32, area.height});
  Work::end_own_part();
}

/// Draws a side column as a tab. Its last panel is beside the others if both fit.
void draw_side_tab(const Work& w, Place side, const Box& area) {
  constexpr float column_at_least = 264;
  const auto panels = w.console.list().panels;
  std::size_t first = panels.size(), last = 0;
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (stands_in(side, panels[i].place) && w.wanted(panels[i])) first = std::min(first, i), last = i;
  if (area.width < 2 * column_at_least || first >= last)
    return draw_tab_column(w, "all", side, area, 0, panels.size());
  const float half = std::floor(area.width / 2);
  draw_tab_column(w, "first", side, {area.x, area.y, half, area.height}, 0, last);
  draw_tab_column(w, "last", side, {area.x + half, area.y, area.width - half, area.height}, last, last + 1);
}

/// A panel that would get less than its least height is drawn higher and scrolls.
void draw_scrolled(const Work& w, std::size_t panel, const Box& area) {
  const float comfort = std::max(320.0f, w.console.list().panels[panel].least_height);
  const float scrolled = ImGui::GetScrollY() / w.ui.scale;
  w.draw(panel, {area.x, area.y - scrolled, area.width, comfort});
  ImGui::SetCursorScreenPos(w.ui.px(area.x, area.y - scrolled + comfort));
  ImGui::Dummy(ImVec2(1, 0));
}

void draw_chosen(const Work& w, const TabItem& chosen, const Box& area) {
  const auto panel = static_cast<std::size_t>(std::max(chosen.panel, 0));
  const float needs = chosen.panel >= 0 ? w.console.list().panels[panel].least_height : 0;
  const bool scrolls = needs > area.height;
  ImGui::PushID(chosen.panel);
  w.begin_own_part("work", 0, w.ui.px(area.height), 0, scrolls);
  if (scrolls)
    draw_scrolled(w, panel, area);
  else if (chosen.panel >= 0)
    w.draw(panel, area);
  else
    draw_side_tab(w, chosen.panel == -1 ? Place::left : Place::right, area);
  Work::end_own_part();
  ImGui::PopID();
}

BannerSubject draw_centre(const Work& w) {
  const Box& box = w.layout.centre;
  Ui& ui = w.ui;
  begin_region(ui, "centre", in_pixels(ui, box), Tone::panel, ImVec2(0, 0));
  const float centre_height = box.height - 40;
  const bool below_is_tab = below_height(centre_height, w.console.splitters, w.layout.tier) == 0;
  const TabItems items = tab_items(w, below_is_tab);
  if (items.count == 0) {
    end_region();
    return {};
  }
  const TabItem& chosen = items.chosen(w.tab.panels.in_front);
  const float wanted_below =
      chosen.panel >= 0 ? w.console.list().panels[static_cast<std::size_t>(chosen.panel)].good_height : 0;
  float below = below_height(centre_height, w.console.splitters, w.layout.tier, wanted_below);
  draw_panel_tabs(w, items, chosen);
  const float top = ImGui::GetCursorScreenPos().y / ui.scale;
  if (box.bottom() - top - below < 160) below = std::max(0.0f, box.bottom() - top - 160);
  const Box work{box.x, top, box.width, box.bottom() - top - below};
  draw_chosen(w, chosen, work);
  const Box area{box.x, work.bottom(), box.width, below};
  BannerSubject subject = banner_subject(w.tab, w.layout, area);
  const float banner_height = draw_banner(ui, w.console, w.tab, subject, w.layout, area);
  if (below > 0) {
    const Box rest{area.x, area.y + banner_height, area.width, area.height - banner_height};
    ImGui::SetCursorScreenPos(ui.px(rest.x, rest.y));
    begin_part(ui, "below", 0, ui.px(rest.height), Tone::panel, 0, false);
    w.draw_all(Place::below, rest);
    end_part();
    const Rect line = in_pixels(ui, area);
    ImGui::GetWindowDrawList()->AddRectFilled(line.min, ImVec2(line.max.x, line.min.y + ui.hair()),
                                              ui[Tone::line]);
    const bool wide = w.layout.tier == Tier::wide;
    Splitters& sizes = w.console.splitters;
    float& set = wide ? sizes.below : sizes.below_medium;
    float shown = below;
    splitter(ui, "splitter/below", in_pixels(ui, {box.x, area.y, box.width, 1}), false, shown,
             wide ? SplitRange{152, 700, Splitters().below} : SplitRange{108, 320, Splitters().below_medium},
             -1);
    if (shown != below) set = shown;
  }
  end_region();
  return subject;
}

// ---- side columns

void draw_left(const Work& w) {
  const Box& box = w.layout.left;
  Ui& ui = w.ui;
  begin_region(ui, "left", in_pixels(ui, box), Tone::panel);
  line_right_of(ui, in_pixels(ui, box));
  const Box inner{box.x + 16, box.y, box.width - 32, box.height};
  w.draw_all(Place::top_left, inner);
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(box.x), top));
  const float left_over = ui.px(box.bottom()) - top;
  w.begin_own_part("rest", ui.px(box.width) - ui.hair(), left_over, 16);
  w.draw_all(Place::left, {inner.x, top / ui.scale, inner.width, left_over / ui.scale});
  Work::end_own_part();
  if (w.layout.tier == Tier::wide)
    splitter(ui, "splitter/left", in_pixels(ui, {box.right() - 1, box.y, 1, box.height}), true,
             w.console.splitters.left, {264, 400, Splitters().left}, 1);
  end_region();
}

/// Pinned panels have their full height, unless the user opened the part below and both do not fit. Returns
/// their height, logical.
float draw_pinned(const Work& w, const Box& box, float left, float width, float below) {
  Ui& ui = w.ui;
  const float room = std::max(1.0f, box.height - below);
  ImGui::SetCursorScreenPos(ImVec2(left, ui.px(box.y)));
  w.begin_own_part("parts", width, ui.px(room), 16);
  w.draw_all(Place::right, {box.x + 16, box.y, box.width - 32, box.height});
  const float end = ImGui::GetCursorScreenPos().y + ImGui::GetScrollY();
  Work::end_own_part();
  return std::min(room, std::ceil(end / ui.scale - box.y));
}

/// The part below gets the remaining height and scrolls separately. It folds when it is too low.
void draw_right_parts(const Work& w, const Box& box, float left, float width) {
  Ui& ui = w.ui;
  constexpr float open_from = 160, open_least = 280;
  if (!w.has(Place::lower_right)) {
    draw_pinned(w, box, left, width, 0);
    return;
  }
  const Fold fold = w.console.lower_right;
  const float least =
      fold == Fold::open ? std::min(open_least, std::floor(box.height / 2)) : lower_right_title;
  const float pinned = draw_pinned(w, box, left, width, least);
  const float rest = box.height - pinned;
  const bool folded = fold == Fold::folded || (fold == Fold::automatic && rest < open_from);
  const Box area{box.x, box.y + pinned, box.width, folded ? lower_right_title : rest};
  if (pinned >= box.height - least)  // the pinned part reaches below it
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(left, ui.px(area.y) - ui.hair()),
                                              ImVec2(left + width, ui.px(area.y)), ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(left, ui.px(area.y)));
  w.begin_own_part("lower", width, ui.px(area.height), 16, false);
  w.draw_all(Place::lower_right, {box.x + 16, area.y, box.width - 32, area.height});
  Work::end_own_part();
}

void draw_right(const Work& w, const Box& box, bool over_centre) {
  Ui& ui = w.ui;
  begin_region(ui, over_centre ? "right over" : "right", in_pixels(ui, box), Tone::panel, ImVec2(0, 0));
  // A region that appears later than the others is otherwise drawn under them.
  if (over_centre && ImGui::IsWindowAppearing()) bring_to_front();
  const Rect r = in_pixels(ui, box);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.min.x + ui.hair(), r.max.y),
                                            ui[over_centre ? Tone::edge : Tone::line]);
  draw_right_parts(w, box, r.min.x + ui.hair(), r.width() - ui.hair());
  if (w.layout.tier == Tier::wide)
    splitter(ui, "splitter/right", in_pixels(ui, {box.x, box.y, 1, box.height}), true,
             w.console.splitters.right, {240, 400, Splitters().right}, -1);
  end_region();
}

void draw_rail(const Work& w) {
  const Box& box = w.layout.right;
  Ui& ui = w.ui;
  begin_region(ui, "rail", in_pixels(ui, box), Tone::panel, ImVec2(0, 0));
  const Rect r = in_pixels(ui, box);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.min.x + ui.hair(), r.max.y), ui[Tone::line]);
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.icon = w.console.right_open ? Icon::chevron_right : Icon::chevron_left;
  o.width = 40;
  o.height = 40;
  o.tip = w.console.right_open ? "Fold inputs, outputs and bench" : "Inputs, outputs and bench";
  ImGui::SetCursorScreenPos(ui.px(box.x + 8, box.y));
  if (button(ui, "rail/open", "", o).clicked) w.console.right_open = !w.console.right_open;
  ImGui::SetCursorScreenPos(ui.px(box.x, box.y + 40));
  for (const Place place : {Place::right, Place::lower_right})
    w.draw_all(place, {box.x, box.y + 40, box.width, box.height - 40}, true);
  end_region();
  if (!w.layout.unfolded.empty()) draw_right(w, w.layout.unfolded, w.layout.unfolded_covers);
}

void draw_strip(const Work& w) {
  const Box& box = w.layout.left;
  begin_region(w.ui, "left", in_pixels(w.ui, box), Tone::panel);
  line_below(w.ui, in_pixels(w.ui, box));
  w.draw_all(Place::top_left, {box.x + 16, box.y, box.width - 32, box.height});
  end_region();
}

void draw_page(Ui& ui, Console& console, const Layout& layout) {
  const Box body{0, layout.stop.bottom(), layout.status.width, layout.status.y - layout.stop.bottom()};
  begin_region(ui, "page", in_pixels(ui, body), Tone::panel, ImVec2(0, 0));
  PageFrame frame{ui, console, body, layout.tier, false, console.clock()};
  console.page_object(console.page()).draw(frame);
  end_region();
}

/// The sheet lies between the left and the right column, so that limits stay visible.
Box place_of_sheet(const Layout& layout, bool controller) {
  constexpr float wanted = 440;
  if (controller && layout.tier == Tier::narrow) return layout.centre;
  Box box{0, layout.stop.bottom(), layout.status.width, layout.status.y - layout.stop.bottom()};
  float left = box.x, right = box.right();
  if (controller) {
    left = layout.left.right();
    right = layout.right.x;
    if (!layout.unfolded.empty() && layout.unfolded.x - left >= wanted) right = layout.unfolded.x;
  }
  box.width = std::min(wanted, right - left);
  box.x = right - box.width;
  return box;
}

}  // namespace

void draw_sheet(Ui& ui, Console& console, const Layout& layout) {
  const Box box = place_of_sheet(layout, console.active() != nullptr);
  const Rect r = in_pixels(ui, box);
  begin_region(ui, "sheet", r, Tone::panel, ImVec2(0, 0));
  if (ImGui::IsWindowAppearing()) bring_to_front();
  PageFrame frame{ui, console, box, layout.tier, false, console.clock()};
  console.help_object().draw(frame);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.min.x + ui.hair(), r.max.y), ui[Tone::edge]);
  end_region();
}

float strip_height(const Tab& tab) {
  const std::size_t axes = tab.catalog().axes.size();
  return strip_row_height(axes) * static_cast<float>((axes + 1) / 2);
}

BannerSubject draw_workspace(Ui& ui, Console& console, const Layout& layout) {
  Tab* tab = console.active();
  if (!tab) {
    if (!console.page().empty()) draw_page(ui, console, layout);
    return {};
  }
  const Work work{ui, console, *tab, layout};
  if (layout.tier == Tier::narrow)
    draw_strip(work);
  else
    draw_left(work);
  BannerSubject subject = draw_centre(work);
  if (layout.right_is_rail)
    draw_rail(work);
  else if (!layout.right.empty())
    draw_right(work, layout.right, false);
  return subject;
}

}  // namespace hw::gui
