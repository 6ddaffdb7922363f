#include "gui/shell/top_bar.h"

#include <fmt/core.h>

#include "gui/model/axis_look.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/popup.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/tabs.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

void stand_at(Ui& ui, float x, float y) { ImGui::SetCursorScreenPos(ui.px(x, y)); }

/// Names the controllers that Stop does not reach, or counts them if the names do not fit; empty: it reaches
/// all.
std::string not_reached(const Ui& ui, const Console& console, float room_px) {
  std::string names;
  int lost = 0;
  for (const auto& tab : console.tabs()) {
    if (tab->now().link.state != LinkState::lost) continue;
    names += (lost++ == 0 ? "" : ", ") + std::string(tab->bus ? tab->id() : tab->name());
  }
  if (lost == 0) return names;
  const std::string named = "does not reach " + names;
  if (text_width(ui, Face::small_bold, named) <= room_px) return named;
  return fmt::format("does not reach {} of {}", lost, console.tabs().size());
}

void draw_stop(Ui& ui, Console& console, const Layout& layout) {
  stand_at(ui, layout.stop.x, layout.stop.y);
  const Touch t = stop_button(ui, ui.px(layout.stop.width, layout.stop.height),
                              not_reached(ui, console, ui.px(layout.stop.width - 16)));
  if (t.clicked) console.stop_all();  // set on the press
}

void draw_menu(Ui& ui, Console& console, const Touch& opener) {
  Tab* tab = console.active();
  if (!begin_popup(ui, "menu", opener, 264, 9)) return;
  const std::string_view none = tab ? "" : "No controller is in front.";
  const std::string_view no_reset = !tab ? none
                                    : !tab->catalog().can.reset
                                        ? "This controller cannot be reset over the wire."
                                        : "";
  if (popup_row(ui, "menu/names", "Names ...", {}, false, none)) console.dialogs.names(*tab);
  if (popup_row(ui, "menu/reconnect", "Connect again", {}, false, none)) console.reconnect(*tab);
  if (popup_row(ui, "menu/reset", "Reset controller ...", {}, false, no_reset)) console.dialogs.reset(*tab);
  const bool close = popup_row(ui, "menu/close", "Close controller", "Ctrl W", false, none);
  popup_line(ui);
  if (popup_row(ui, "menu/connect", "Connect another", "+")) console.show_page(console.list().pages[0].id);
  if (popup_row(ui, "menu/theme", console.dark() ? "Light theme" : "Dark theme"))
    console.set_dark(!console.dark());
  char percent[16];
  *fmt::format_to_n(percent, sizeof percent - 1, "now {:.0f} %", console.size() * 100).out = 0;
  if (popup_row(ui, "menu/larger", "Larger", "Ctrl +")) console.step_size(1);
  if (popup_row(ui, "menu/smaller", "Smaller", percent)) console.step_size(-1);
  if (popup_row(ui, "menu/help", console.help_open() ? "Close the help" : "Help", "?")) console.toggle_help();
  end_popup();
  if (close) console.dialogs.close_controller(console, *tab);
}

void draw_help(Ui& ui, Console& console, float x) {
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.width = 32;
  o.tip = "Keys and the manual";
  o.on = console.help_open();
  stand_at(ui, x, 12);
  if (button(ui, "help", "?", o).clicked) console.toggle_help();
}

/// The logo opens the menu; the help is beside it if it fits.
void draw_sign(Ui& ui, Console& console, const Layout& layout) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool help = layout.tier == Tier::medium;
  const float width = help ? 52 : layout.brand.width;
  stand_at(ui, 0, 0);
  const Touch t =
      touch(ui, {"menu", Kind::button, "Menu", {}, {}, false, "Menu"}, ui.px(width, layout.brand.height));
  if (t.hovered || t.held) list->AddRectFilled(t.rect.min, t.rect.max, ui[Tone::hover]);
  draw_brand(list, ui.px(width / 2, layout.brand.height / 2), ui.px(28), ui[Tone::ink], ui[Tone::motion]);
  if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
  draw_menu(ui, console, t);
  if (help) draw_help(ui, console, width);
}

void draw_brand_and_menu(Ui& ui, Console& console, const Layout& layout) {
  if (layout.tier != Tier::wide) return draw_sign(ui, console, layout);
  const float middle = ui.px(layout.brand.height / 2);
  draw_brand(ImGui::GetWindowDrawList(), ImVec2(ui.px(30), middle), ui.px(28), ui[Tone::ink],
             ui[Tone::motion]);
  draw_text_line(ui, ui.px(56), ui.px(layout.brand.width), middle, Face::title_bold, ui[Tone::ink],
                 "Handwheel");
  ButtonOptions quiet;
  quiet.style = ButtonStyle::quiet;
  const float menu_width = button_width(ui, "Menu", quiet);
  stand_at(ui, layout.brand.right() - 4 - menu_width, 12);
  const Touch menu = button(ui, "menu", "Menu", quiet);
  draw_menu(ui, console, menu);
  draw_help(ui, console, layout.brand.right() - 8 - menu_width - 32);
}

ControllerTab tab_face(Console& console, Tab& tab) {
  const StateLook& state = look_of(worst_state(tab));
  return {tab.name(), state.icon, state.tone, state.small, tab.emulated(), console.active() == &tab};
}

void draw_page_tab(Ui& ui, Console& console, float x, float width, float height) {
  for (const PageEntry& page : console.list().pages) {
    if (page.id != console.page()) continue;
    stand_at(ui, x, 0);
    const std::string id = fmt::format("page/{}", page.id);
    const Touch t = touch(ui, {id, Kind::tab, page.title, "on", {}, false, {}}, ui.px(width, height));
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(t.rect.min, t.rect.max, ui[Tone::panel]);
    list->AddRectFilled(t.rect.min, ImVec2(t.rect.max.x, ui.px(2)), ui[Tone::ink]);
    line_right_of(ui, t.rect);
    const float middle = t.rect.centre().y;
    const bool first = &page == &console.list().pages[0];
    draw_icon(list, first ? Icon::plus : Icon::info, ImVec2(t.rect.min.x + ui.px(22), std::floor(middle)),
              ui.px(12), ui[Tone::ink2]);
    draw_text_line(ui, t.rect.min.x + ui.px(40), t.rect.max.x, middle, Face::body_bold, ui[Tone::ink],
                   page.title);
  }
}

/// Draws a button with the controller in front, or the controller in the worst state. Its list shows all
/// controllers.
void draw_controller_menu(Ui& ui, Console& console, const Layout& layout) {
  ControllerTab face{"Controllers", Icon::none};
  face.active = true;
  if (Tab* active = console.active()) face = tab_face(console, *active);
  for (const PageEntry& page : console.list().pages)
    if (page.id == console.page()) face.name = page.title;
  stand_at(ui, layout.tabs.x, 0);
  const Touch t = controller_tab(ui, "controller/menu", face, layout.tabs.width);
  draw_icon(ImGui::GetWindowDrawList(), Icon::chevron_down,
            ImVec2(t.rect.max.x - ui.px(16), t.rect.min.y + ui.px(19)), ui.px(12), ui[Tone::ink2]);
  if (!begin_popup(ui, "controllers", t, 300, static_cast<float>(console.faces() + 1))) return;
  Tab* chosen = nullptr;
  int number = 0;
  for (const auto& each : console.tabs()) {
    Tab& tab = *each;
    if (!Console::is_face(tab)) continue;
    const StateLook& state = look_of(worst_state(tab));
    const std::string caption = fmt::format("{}{}", state.small, tab.emulated() ? ", EMULATED" : "");
    if (popup_row(ui, fmt::format("controller/{}", ++number), tab.name(), caption, &tab == console.active()))
      chosen = &tab;
  }
  if (popup_row(ui, "controller/new", "Connect another")) console.show_page(console.list().pages[0].id);
  end_popup();
  if (chosen) console.activate(*chosen);
}

void draw_controllers(Ui& ui, Console& console, const Layout& layout) {
  if (layout.controller_menu) return draw_controller_menu(ui, console, layout);
  float x = layout.tabs.x;
  Tab* chosen = nullptr;
  int number = 0;
  for (const auto& each : console.tabs()) {
    Tab& tab = *each;
    if (!Console::is_face(tab)) continue;
    const std::string id = fmt::format("controller/{}", ++number);
    stand_at(ui, x, 0);
    if (controller_tab(ui, id, tab_face(console, tab), layout.tab_width).clicked) chosen = &tab;
    x += layout.tab_width;
  }
  if (!console.page().empty()) draw_page_tab(ui, console, x, layout.tab_width, layout.tabs.height);
  if (chosen) console.activate(*chosen);
  if (console.page() == console.list().pages[0].id) return;
  stand_at(ui, layout.add.x, 0);
  const Touch add = touch(ui,
                          {"controller/new",
                           Kind::button,
                           "Connect another controller",
                           {},
                           {},
                           false,
                           "Connect another controller"},
                          ui.px(layout.add.width, layout.add.height));
  if (add.hovered || add.held)
    ImGui::GetWindowDrawList()->AddRectFilled(add.rect.min, add.rect.max, ui[Tone::hover]);
  line_right_of(ui, add.rect);
  draw_icon(ImGui::GetWindowDrawList(), Icon::plus, ImVec2(add.rect.centre().x, add.rect.centre().y),
            ui.px(14), ui[Tone::ink2]);
  if (add.ring) draw_outline(ui, add.rect, ui[Tone::ink], 0, ui.px(2));
  if (add.clicked) console.show_page(console.list().pages[0].id);
}

struct LinkWords {
  std::string_view word;
  Tone tone;
  int bars;
};

LinkWords link_words(const LinkHealth& link) {
  switch (link.state) {
    case LinkState::good: return {"Link good", Tone::ok, link.round_trip < Millis(40) ? 4 : 3};
    case LinkState::late: return {"Link late", Tone::warn, 2};
    case LinkState::lost: return {"Link lost", Tone::fault, 0};
    case LinkState::closed: return {"Closed", Tone::ink2, 0};
    case LinkState::connecting: break;
  }
  return {"Connecting", Tone::ink2, 1};
}

void draw_link(Ui& ui, Console& console, const Layout& layout) {
  if (layout.link.empty()) return;
  const Rect r = in_pixels(ui, layout.link);
  LinkWords words{"No link yet", Tone::ink2, 0};
  char second[64] = "nothing connected";
  Tab* tab = console.active();
  if (tab) {
    const LinkHealth& link = (tab->bus ? tab->bus->worst() : *tab).now().link;
    words = link_words(link);
    const double ms = seconds(link.round_trip) * 1e3;
    if (tab->bus && tab->bus->connected() < tab->bus->members.size())
      *fmt::format_to_n(second, sizeof second - 1, "{} of {} answer", tab->bus->connected(),
                        tab->bus->members.size())
           .out = 0;
    else if (link.state == LinkState::lost || link.state == LinkState::closed ||
             link.state == LinkState::connecting)
      *fmt::format_to_n(second, sizeof second - 1, "attempt {}", std::max(1, link.attempts)).out = 0;
    else if (layout.tier == Tier::wide && link.polls_per_second >= 0.95f)
      *fmt::format_to_n(second, sizeof second - 1, "{:.1f} ms, {:.0f} polls/s", ms, link.polls_per_second)
           .out = 0;
    else if (layout.tier == Tier::wide && link.polls_per_second > 0)
      *fmt::format_to_n(second, sizeof second - 1, "{:.1f} ms, polled every {:.0f} s", ms,
                        1 / link.polls_per_second)
           .out = 0;
    else
      *fmt::format_to_n(second, sizeof second - 1, "{:.1f} ms", ms).out = 0;
  } else if (!console.tabs().empty()) {
    words.word = "Controllers";
    *fmt::format_to_n(second, sizeof second - 1, "{} open", console.faces()).out = 0;
  }
  if (tab && ImGui::IsMouseHoveringRect(r.min, r.max))
    ImGui::GetWindowDrawList()->AddRectFilled(r.min, r.max, ui[Tone::hover]);
  const bool bars = tab && layout.tier == Tier::wide;
  const float right = r.max.x - ui.px(bars ? 48 : 16);
  draw_text_right(ui, ImVec2(right, ui.px(12)), Face::small_bold, ui[words.tone], words.word);
  draw_text_right(ui, ImVec2(right, ui.px(29)), Face::small, ui[Tone::ink2], second);
  if (bars)
    draw_signal(ImGui::GetWindowDrawList(), ImVec2(r.max.x - ui.px(38), ui.px(19)), ui.px(22), words.bars,
                ui[words.tone], ui[Tone::line]);
  char value[96];
  *fmt::format_to_n(value, sizeof value - 1, "{}, {}", words.word, second).out = 0;
  if (!tab) return show(ui, {"link/health", Kind::text, words.word, value, {}, false, {}}, r);
  std::string_view why = tab->now().link.sentence.view();
  if (why.empty()) why = "Shows how the time of a query is spent, and how to shorten it.";
  stand_at(ui, layout.link.x, layout.link.y);
  const Touch t = touch(ui, {"link/health", Kind::button, words.word, value, {}, false, why},
                        ImVec2(r.max.x - r.min.x, r.max.y - r.min.y));
  if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
  if (t.clicked) console.examine_link(*tab);
}

}  // namespace

void draw_top_bar(Ui& ui, Console& console, const Layout& layout) {
  const Box bar{0, 0, layout.stop.right(), layout.stop.height};
  begin_region(ui, "top", in_pixels(ui, bar), Tone::ground, ImVec2(0, 0));
  draw_stop(ui, console, layout);
  line_below(ui, in_pixels(ui, {0, 0, layout.stop.x, bar.height}));
  draw_brand_and_menu(ui, console, layout);
  draw_controllers(ui, console, layout);
  draw_link(ui, console, layout);
  end_region();
}

}  // namespace hw::gui
