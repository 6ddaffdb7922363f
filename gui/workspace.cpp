#include "gui/workspace.h"

#include <array>

#include <fmt/format.h>

#include "gui/area.h"
#include "gui/console.h"
#include "gui/messages.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

/// One controller's workspace in one frame.
struct Work {
  Ui& ui;
  Console& console;
  Tab& tab;
  const Layout& layout;

  [[nodiscard]] bool wanted(const PanelEntry& entry) const {
    return !entry.wanted || entry.wanted(tab.catalog(), tab.bench().present);
  }
  void draw(std::size_t index, const Box& area, bool rail = false) const {
    const PanelEntry& entry = console.list().panels[index];
    auto& panel = tab.panels[index];
    if (!panel) panel = entry.make();
    Frame frame{
        {ui, console, area, layout.tier, rail, tab.clock()}, tab, tab.catalog(), tab.now(), tab.bench()};
    ImGui::PushID(entry.id.data(), entry.id.data() + entry.id.size());
    panel->draw(frame);
    ImGui::PopID();
  }
  /// All panels of a place, one under the other.
  void draw_all(Place place, const Box& area, bool rail = false) const {
    for (std::size_t i = 0; i < console.list().panels.size(); ++i)
      if (console.list().panels[i].place == place && wanted(console.list().panels[i])) draw(i, area, rail);
  }
};

/// A border that can be dragged; a double click restores.
void splitter(Ui& ui, std::string_view id, const Box& hit, bool vertical, float& value, float direction,
              float restore) {
  const Rect r = in_pixels(ui, hit);
  const ImVec2 keep = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(r.min);
  const Touch t = touch(ui, {id, Kind::slider, "Border", {}, {}, false, {}}, ImVec2(r.width(), r.height()));
  if (t.hovered || t.held)
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (t.held && ImGui::IsMouseDown(0)) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    value += direction * (vertical ? moved.x : moved.y) / ui.scale;
  }
  if (t.double_clicked) value = restore;
  if (t.hovered || t.held || t.ring)
    ImGui::GetWindowDrawList()->AddRectFilled(r.min, r.max, ui[t.held ? Tone::edge : Tone::line]);
  ImGui::SetCursorScreenPos(keep);
}

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
  Ui& ui = w.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = at.x + ui.px(4);
  for (std::size_t i = 0; i < items.count; ++i) {
    const TabItem& item = items.items[i];
    const bool on = item.id == chosen.id;
    const float width = std::ceil(text_width(ui, Face::body_bold, item.title)) + ui.px(32);
    char id[48];
    const auto end = fmt::format_to_n(id, sizeof id, "tab/{}", item.id);
    ImGui::SetCursorScreenPos(ImVec2(x, at.y));
    const Touch t = touch(
        ui, {{id, std::min(end.size, sizeof id)}, Kind::tab, item.title, on ? "on" : "off", {}, false, {}},
        ImVec2(width, ui.px(40)));
    draw_text_centred(ui, t.rect, on ? Face::body_bold : Face::body,
                      ui[on || t.hovered ? Tone::ink : Tone::ink2], item.title);
    if (on)
      ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(t.rect.min.x + ui.px(12), t.rect.max.y - ui.px(2)),
                                                ImVec2(t.rect.max.x - ui.px(12), t.rect.max.y),
                                                ui[Tone::ink]);
    if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
    if (t.clicked) w.tab.centre_panel = item.id;
    x = t.rect.max.x;
  }
  const float y = at.y + ui.px(40);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, y - ui.hair()),
                                            ImVec2(at.x + ImGui::GetWindowWidth(), y), ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
}

void draw_chosen(const Work& w, const TabItem& chosen, const Box& area) {
  if (chosen.panel >= 0) {
    begin_part(w.ui, "work", 0, w.ui.px(area.height), Tone::panel, 0, false);
    w.draw(static_cast<std::size_t>(chosen.panel), area);
  } else {
    begin_part(w.ui, "work", 0, w.ui.px(area.height), Tone::panel, 16);
    const Box inner{area.x + 16, area.y, area.width - 32, area.height};
    w.draw_all(chosen.panel == -1 ? Place::left : Place::right, inner);
  }
  end_part();
}

void draw_centre(const Work& w) {
  const Box& box = w.layout.centre;
  Ui& ui = w.ui;
  begin_area(ui, "centre", box, Tone::panel, 0);
  float below = below_height(box.height - 40, w.console.splitters, w.layout.tier);
  const TabItems items = tab_items(w, below == 0);
  if (items.count == 0) return end_area();
  const TabItem& chosen = items.chosen(w.tab.centre_panel);
  draw_panel_tabs(w, items, chosen);
  draw_banner(ui, w.console, w.tab, w.layout);
  const float top = ImGui::GetCursorScreenPos().y / ui.scale;
  if (box.bottom() - top - below < 160) below = std::max(0.0f, box.bottom() - top - 160);
  const Box work{box.x, top, box.width, box.bottom() - top - below};
  draw_chosen(w, chosen, work);
  if (below > 0) {
    const Box area{box.x, work.bottom(), box.width, below};
    ImGui::SetCursorScreenPos(ui.px(area.x, area.y));
    begin_part(ui, "below", 0, ui.px(area.height), Tone::panel, 0, false);
    w.draw_all(Place::below, area);
    end_part();
    const Rect line = in_pixels(ui, area);
    ImGui::GetWindowDrawList()->AddRectFilled(line.min, ImVec2(line.max.x, line.min.y + ui.hair()),
                                              ui[Tone::line]);
    if (w.layout.tier == Tier::wide)
      splitter(ui, "splitter/below", {box.x, area.y - 3, box.width, 6}, false, w.console.splitters.below, -1,
               Splitters().below);
  }
  end_area();
}

// ---- side columns

void draw_left(const Work& w) {
  const Box& box = w.layout.left;
  Ui& ui = w.ui;
  begin_area(ui, "left", box, Tone::panel, 16);
  line_right_of(ui, in_pixels(ui, box));
  const Box inner{box.x + 16, box.y, box.width - 32, box.height};
  w.draw_all(Place::top_left, inner);
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(box.x), top));
  const float left_over = ui.px(box.bottom()) - top;
  begin_part(ui, "rest", ui.px(box.width) - ui.hair(), left_over, Tone::panel, 16);
  w.draw_all(Place::left, {inner.x, top / ui.scale, inner.width, left_over / ui.scale});
  end_part();
  if (w.layout.tier == Tier::wide)
    splitter(ui, "splitter/left", {box.right() - 4, box.y, 4, box.height}, true, w.console.splitters.left, 1,
             Splitters().left);
  end_area();
}

void draw_right(const Work& w, const Box& box, bool over_centre) {
  Ui& ui = w.ui;
  begin_area(ui, over_centre ? "right over" : "right", box, Tone::panel, 0, over_centre);
  const Rect r = in_pixels(ui, box);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.min.x + ui.hair(), r.max.y),
                                            ui[over_centre ? Tone::edge : Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(r.min.x + ui.hair(), r.min.y));
  begin_part(ui, "parts", r.width() - ui.hair(), r.height(), Tone::panel, 16);
  w.draw_all(Place::right, {box.x + 16, box.y, box.width - 32, box.height});
  end_part();
  if (w.layout.tier == Tier::wide)
    splitter(ui, "splitter/right", {box.x, box.y, 4, box.height}, true, w.console.splitters.right, -1,
             Splitters().right);
  end_area();
}

void draw_rail(const Work& w) {
  const Box& box = w.layout.right;
  Ui& ui = w.ui;
  begin_area(ui, "rail", box, Tone::panel, 0);
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
  w.draw_all(Place::right, {box.x, box.y + 40, box.width, box.height - 40}, true);
  end_area();
  if (!w.console.right_open) return;
  const float width = 272;
  draw_right(w, {box.x - width, box.y, width, box.height}, true);
}

void draw_strip(const Work& w) {
  const Box& box = w.layout.left;
  begin_area(w.ui, "left", box, Tone::panel, 16);
  line_below(w.ui, in_pixels(w.ui, box));
  w.draw_all(Place::top_left, {box.x + 16, box.y, box.width - 32, box.height});
  end_area();
}

void draw_page(Ui& ui, Console& console, const Layout& layout) {
  const Box body{0, layout.stop.bottom(), layout.status.width, layout.status.y - layout.stop.bottom()};
  begin_area(ui, "page", body, Tone::panel, 0);
  PageFrame frame{ui, console, body, layout.tier, false, console.clock()};
  console.page_object(console.page()).draw(frame);
  end_area();
}

}  // namespace

float strip_height(const Tab& tab) {
  return strip_row_height * static_cast<float>((tab.catalog().axes.size() + 1) / 2);
}

void draw_workspace(Ui& ui, Console& console, const Layout& layout) {
  Tab* tab = console.active();
  if (!tab) {
    if (!console.page().empty()) draw_page(ui, console, layout);
    return;
  }
  const Work work{ui, console, *tab, layout};
  if (layout.tier == Tier::narrow)
    draw_strip(work);
  else
    draw_left(work);
  draw_centre(work);
  if (layout.right_is_rail)
    draw_rail(work);
  else if (!layout.right.empty())
    draw_right(work, layout.right, false);
}

}  // namespace hw::gui
