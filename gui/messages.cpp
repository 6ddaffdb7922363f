#include "gui/messages.h"

#include <cmath>

#include <fmt/format.h>
#include <imgui_internal.h>

#include "gui/area.h"
#include "gui/console.h"
#include "gui/status_sentence.h"
#include "gui/widgets/button.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

struct MoodLook {
  Icon icon;
  Tone tone;
};

MoodLook look_of(Mood mood) {
  switch (mood) {
    case Mood::ok: return {Icon::check, Tone::ok};
    case Mood::motion: return {Icon::play, Tone::motion};
    case Mood::warn: return {Icon::warning, Tone::warn};
    case Mood::fault: return {Icon::diamond_solid, Tone::fault};
    case Mood::plain: break;
  }
  return {Icon::ring, Tone::ink2};
}

StatusSentence sentence_of(Console& console, Tab& tab) {
  const auto held = tab.jog.control();
  return status_sentence(
      {tab.catalog(), tab.now(), tab.clock(), held, tab.jog.jogging(),
       [&](AxisId a, Steps s) { return std::string(format_with_unit(s, tab.unit(a)).view()); },
       [&](AxisId a, Pps v) { return std::string(format_speed(v, tab.unit(a)).view()); },
       [&](Instant when) { return console.time_of_day(when); }});
}

/// What is in RAM and not stored: at the right of the status line, whatever else is true. Returns its width.
float draw_unsaved(Ui& ui, Console& console, Tab& tab, const Box& line) {
  const Snapshot& now = tab.now();
  if (!tab.catalog().can.store || (!now.unsaved_setup && !now.unsaved_programs)) return 0;
  const std::string_view words = now.unsaved_setup && now.unsaved_programs ? "Set-up and programs not stored"
                                 : now.unsaved_setup                       ? "Set-up not stored"
                                                                           : "Program not stored";
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.icon = Icon::warning;
  o.height = 28;
  o.tip = "It is in the controller's RAM only and gone when it is switched off. Store it in Setup.";
  const float width = button_width(ui, words, o);
  ImGui::SetCursorScreenPos(ui.px(line.right() - width - 8, line.y + (line.height - 28) / 2));
  if (button(ui, "status/unsaved", words, o).clicked) console.show_panel("setup");
  return width + 16;
}

}  // namespace

void draw_status_line(Ui& ui, Console& console, const Layout& layout) {
  begin_area(ui, "status", layout.status, Tone::ground, 16);
  const Rect r = in_pixels(ui, layout.status);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.max.x, r.min.y + ui.hair()), ui[Tone::line]);
  Tab* tab = console.active();
  StatusSentence said;
  float taken = 0;
  if (tab) {
    said = sentence_of(console, *tab);
    taken = draw_unsaved(ui, console, *tab, layout.status);
  } else if (!console.page().empty()) {
    said = console.page_object(console.page()).status(console);
  }
  const MoodLook look = look_of(said.mood);
  const float middle = r.centre().y, left = r.min.x + ui.px(16);
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(left + ui.px(6), std::floor(middle)), ui.px(12),
            ui[look.tone]);
  draw_text_line(ui, left + ui.px(24), r.max.x - ui.px(16 + taken), middle, Face::body, ui[Tone::ink],
                 said.text);
  show(ui, {"status/text", Kind::text, "Status", said.text, {}, false, {}}, r);
  end_area();
}

// ---- banner

namespace {

struct Banner {
  Mood mood;
  Icon icon;
  std::string title, sentences;
};

void draw_banner_box(Ui& ui, const Banner& banner, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float x = ImGui::GetWindowPos().x, width = ImGui::GetWindowWidth();
  const Tone tone = banner.mood == Mood::fault ? Tone::fault : Tone::warn;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(ImVec2(x, at.y), ImVec2(x + width, at.y + height),
                      ui[banner.mood == Mood::fault ? Tone::fault_t : Tone::warn_t]);
  list->AddRectFilled(ImVec2(x, at.y), ImVec2(x + ui.px(3), at.y + height), ui[tone]);
  draw_icon(list, banner.icon, ImVec2(x + ui.px(24), at.y + ui.px(22)), ui.px(14), ui[tone]);
}

void draw_attempt(Ui& ui, const Console& console, const Tab& tab) {
  const LinkHealth& link = tab.now().link;
  const double wait = seconds(link.next_attempt - console.clock());
  char words[64];
  if (wait > 0) {
    const double whole = std::ceil(wait);
    *fmt::format_to_n(words, sizeof words - 1, "Attempt {} in {:.0f} s.", link.attempts + 1, whole).out = 0;
    ui.wake_in(wait - (whole - 1) + 0.001);  // when the number changes
  } else {
    *fmt::format_to_n(words, sizeof words - 1, "Attempt {} is under way.", std::max(1, link.attempts)).out =
        0;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(8), at.y + ui.px(6)));
  named_text(ui, "fault/attempt", Face::body, Tone::ink2, words);
}

/// Title, sentences, then the row of actions that `actions` draws.
template <class Actions>
void draw_whole_banner(Ui& ui, const Banner& banner, Actions&& actions) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float x = ImGui::GetWindowPos().x, width = ImGui::GetWindowWidth() - ui.px(44 + 16);
  const float words = wrapped_height(ui, Face::body, banner.sentences, width);
  const float height = ui.px(12 + 24 + 8 + 32 + 12) + words;
  draw_banner_box(ui, banner, height);
  draw_text_line(ui, x + ui.px(44), x + ui.px(44) + width, at.y + ui.px(22), Face::title_bold, ui[Tone::ink],
                 banner.title);
  ImGui::SetCursorScreenPos(ImVec2(x + ui.px(44), at.y + ui.px(36)));
  wrapped(ui, Face::body, Tone::ink, banner.sentences, width / ui.scale);
  ImGui::SetCursorScreenPos(ImVec2(x + ui.px(44), at.y + ui.px(44) + words));
  actions();
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
}

std::string report(const Console& console, const Tab& tab) {
  const LinkHealth& link = tab.now().link;
  return fmt::format(
      "{} ({}) at {}\nlost at {}, {} attempts since\n{}\ntimeouts {}, bytes not understood {}\n", tab.name(),
      tab.catalog().name, tab.address().text(), console.time_of_day(link.lost_at), link.attempts,
      link.sentence.view(), link.timeouts, link.unparsed_bytes);
}

void draw_lost(Ui& ui, Console& console, Tab& tab) {
  const LinkHealth& link = tab.now().link;
  Banner banner{Mood::fault, Icon::plug,
                fmt::format("{} does not answer since {}.", tab.name(), console.time_of_day(link.lost_at)),
                std::string(link.sentence.view())};
  banner.sentences += banner.sentences.empty() ? "" : " ";
  banner.sentences +=
      "Stop does not reach it: to be sure, use its power switch. When it is back its state is read afresh; "
      "nothing moves by itself.";
  draw_whole_banner(ui, banner, [&] {
    if (button(ui, "fault/try_now", "Try now").clicked) console.reconnect(tab);
    ImGui::SameLine();
    const ImVec2 row = ImGui::GetCursorScreenPos();
    draw_attempt(ui, console, tab);
    ImGui::SameLine();
    ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x + ui.px(8), row.y));
    ButtonOptions quiet;
    quiet.style = ButtonStyle::quiet;
    if (button(ui, "fault/report", "Copy this report", quiet).clicked) {
      ImGui::SetClipboardText(report(console, tab).c_str());
      console.toast(Mood::ok, "The report is in the clipboard.");
    }
  });
}

/// Something must be chosen in the set-up before the first move.
void draw_unset(Ui& ui, Console& console, Tab& tab, int param) {
  const ParamInfo& info = tab.catalog().params[static_cast<std::size_t>(param)];
  const Banner banner{Mood::warn, Icon::warning, "Before the first move", info.before_moving};
  draw_whole_banner(ui, banner, [&] {
    if (button(ui, "fault/setup", "Choose it in Setup").clicked)
      console.show_panel("setup", "setup/" + info.mnemonic);
  });
}

}  // namespace

void draw_banner(Ui& ui, Console& console, Tab& tab, const Layout& layout) {
  const Snapshot& now = tab.now();
  if (now.link.state == LinkState::lost) return draw_lost(ui, console, tab);
  if (layout.tier == Tier::narrow || tab.centre_panel == "setup") return;  // the status line says it as well
  for (int i = 0; i < now.axis_count; ++i)
    if (const int param = unset_before_moving(tab.catalog(), now, AxisId{static_cast<std::uint8_t>(i)});
        param >= 0)
      return draw_unset(ui, console, tab, param);
}

// ---- toasts

void draw_toasts(Ui& ui, Console& console, const Layout& layout) {
  if (console.toasts().list().empty()) return;
  const float width = std::min(360.0f, layout.centre.width - 32);
  const float text_px = ui.px(width - 16 - 24 - 32);
  float bottom = ui.px(layout.centre.bottom() - 16);
  int dismissed = 0;
  const auto& list = console.toasts().list();
  for (auto toast = list.rbegin(); toast != list.rend(); ++toast) {
    const float words = wrapped_height(ui, Face::body, toast->text, text_px);
    const float height = std::max(ui.px(40), words + ui.px(20));
    const Box box{layout.centre.right() - 16 - width, (bottom - height) / ui.scale, width, height / ui.scale};
    const std::string id = fmt::format("toast/{}", toast->number);
    begin_area(ui, id.c_str(), box, Tone::raised, 0, true);
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    const Rect r = in_pixels(ui, box);
    const MoodLook look = look_of(toast->mood);
    draw_outline(ui, r, ui[toast->mood == Mood::fault ? Tone::fault : Tone::edge], 0);
    draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(r.min.x + ui.px(20), r.min.y + ui.px(20)),
              ui.px(12), ui[look.tone]);
    ImGui::SetCursorScreenPos(ImVec2(r.min.x + ui.px(40), r.min.y + ui.px(10)));
    wrapped(ui, Face::body, Tone::ink, toast->text, width - 16 - 24 - 32);
    show(ui, {id, Kind::text, "Message", toast->text, {}, false, {}}, r);
    ImGui::SetCursorScreenPos(ImVec2(r.max.x - ui.px(32), r.min.y + ui.px(4)));
    ButtonOptions o;
    o.style = ButtonStyle::quiet;
    o.icon = Icon::cross;
    o.width = 32;
    if (button(ui, id + "/close", "", o).clicked) dismissed = toast->number;
    end_area();
    bottom -= height + ui.px(8);
  }
  if (dismissed) console.toasts().dismiss(dismissed);
}

}  // namespace hw::gui
