#include "gui/shell/messages.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <imgui_internal.h>

#include "core/device/refusals.h"
#include "gui/model/axis_look.h"
#include "gui/model/bus.h"
#include "gui/model/clearing.h"
#include "gui/model/goes_on.h"
#include "gui/model/status_sentence.h"
#include "gui/shell/banner_subject.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

struct SeverityLook {
  Icon icon;
  Tone tone;
};

SeverityLook severity_look(Severity severity) {
  switch (severity) {
    case Severity::ok: return {Icon::check, Tone::ok};
    case Severity::motion: return {Icon::play, Tone::motion};
    case Severity::warn: return {Icon::warning, Tone::warn};
    case Severity::fault: return {Icon::diamond_solid, Tone::fault};
    case Severity::plain: break;
  }
  return {Icon::ring, Tone::ink2};
}

/// For a controller that runs several programs at once: the running programs, and the line if only one runs.
RunPlace place_of_threads(Tab& tab) {
  const auto& threads = tab.now().threads;
  const int count = std::min(tab.catalog().program.threads, max_threads);
  RunPlace run;
  std::string numbers;
  int running = 0, last = -1;
  for (int n = 0; n < count; ++n) {
    const ThreadState& thread = threads[static_cast<std::size_t>(n)];
    if (!thread.known || thread.run != RunState::running) continue;
    numbers += fmt::format("{}{}", running == 0 ? "" : ", ", n);
    ++running, last = n;
  }
  if (running == 0) return run;
  run.subject = fmt::format("{}{} {} {}", tab.catalog().program.slot_word, running > 1 ? "s" : "", numbers,
                            running > 1 ? "are" : "is");
  if (running > 1) return run;
  run.stored_line = threads[static_cast<std::size_t>(last)].line;
  run.line = tab.desk().programs.texts.live_line(0, run.stored_line);
  run.left_s = tab.desk().programs.follower.left_s();
  return run;
}

/// "Program 2 has stopped in error in line 19: V2=5/V1." The controller does not report the cause; axes in
/// error are named beside the sentence.
std::string failed_threads(Tab& tab) {
  ProgramTexts& texts = tab.desk().programs.texts;
  std::string sentence;
  const int count = std::min(tab.catalog().program.threads, max_threads);
  for (int n = 0; n < count; ++n) {
    const ThreadState& thread = tab.now().threads[static_cast<std::size_t>(n)];
    if (!thread.known || thread.run != RunState::error) continue;
    sentence += fmt::format("{}{} {} stopped with an error", sentence.empty() ? "" : " ",
                            tab.catalog().program.slot_word, n);
    const int line = texts.live_line(0, thread.line);
    if (line >= 0)
      sentence += fmt::format(" in line {}: {}.", line + 1, line_of(texts.text(0), line));
    else
      sentence += fmt::format(" at line {} of its stored code.", thread.line);
  }
  return sentence;
}

RunPlace run_place(Tab& tab) {
  if (tab.catalog().program.threads > 0) return place_of_threads(tab);
  Desk& desk = tab.desk();
  const RunFollower::Place place = desk.programs.follower.place();
  RunPlace run;
  run.left_s = desk.programs.follower.left_s();
  if (place.slot >= 0) run.line = desk.programs.texts.live_line(place.slot, place.command);
  run.pass = place.pass, run.passes = place.passes;
  return run;
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

std::string_view motion_part(const StatusSentence& sentence) {
  const std::string_view all = sentence.text;
  return all.substr(all.size() - std::min(all.size(), sentence.goes_on));
}
/// The text before motion_part().
std::string_view fault_part(const StatusSentence& sentence) {
  const std::string_view all = sentence.text;
  return all.substr(0, all.size() - motion_part(sentence).size());
}

/// On a bus the device is named instead of its only axis: "02 moves to ...", not "Axis X moves to ...".
void name_device(StatusSentence& sentence, const Tab& tab) {
  if (!tab.bus || tab.catalog().axes.size() != 1) return;
  std::string name = tab.catalog().axes[0].description;
  if (name.empty()) return;
  std::string worse(fault_part(sentence)), goes_on(motion_part(sentence));
  for (const bool at_the_beginning : {false, true}) {
    if (at_the_beginning) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    replace_all(worse, name, tab.id());
    replace_all(goes_on, name, tab.id());
  }
  sentence.goes_on = goes_on.size();
  sentence.text = worse + goes_on;
}

StatusSentence sentence_alone(Console& console, Tab& tab, const BannerSubject& banner) {
  const bool in_banner = banner.kind == BannerSubject::Kind::unset && banner.tab == &tab;
  const auto held = tab.jog.control();
  StatusSentence sentence = status_sentence(
      {tab.catalog(), tab.now(), tab.clock(), held, tab.jog.jogging(),
       [&](AxisId a, Steps s) { return std::string(format_with_unit(s, tab.settings.unit(a)).view()); },
       [&](AxisId a, Pps v) { return std::string(format_speed(v, tab.settings.unit(a)).view()); },
       [&](Instant when) { return console.time_of_day(when); }, run_place(tab), failed_threads(tab),
       tab.view.unset_read || in_banner});
  name_device(sentence, tab);
  return sentence;
}

/// "01, 02 and 03 move." Names the devices of the bus that move, except `but`; empty: none moves.
std::string moving_devices(const Bus& bus, const Tab* but) {
  std::vector<std::string_view> ids;
  for (const Tab* member : bus.members)
    if (member != but && is_motion(worst_state(member->now(), member->clock()))) ids.push_back(member->id());
  return ids.empty() ? std::string()
                     : fmt::format("{} {}.", in_words(ids), ids.size() == 1 ? "moves" : "move");
}

/// "02 and 04": the devices of a bus whose motors have no power, or their number if there are more; empty:
/// none.
std::string motors_without_power(const Bus& bus) {
  constexpr std::size_t most_named = 4;
  std::vector<std::string_view> ids;
  for (const Tab* member : bus.members)
    if (powerless(member->catalog(), member->now(), AxisId{0})) ids.push_back(member->id());
  if (ids.size() > 1 && ids.size() == bus.members.size()) return fmt::format("all {} motors", ids.size());
  return ids.size() > most_named ? fmt::format("{} of {} motors", ids.size(), bus.members.size())
                                 : in_words(ids);
}

/// The sentence of a bus gives its worst state, and the other devices that move.
StatusSentence sentence_of(Console& console, Tab& tab, const BannerSubject& banner) {
  if (!tab.bus) return sentence_alone(console, tab, banner);
  Tab& worst = tab.bus->most_urgent();
  const std::string others = moving_devices(*tab.bus, &worst);
  const bool all_is_well =
      is_motion(worst_state(worst.now(), worst.clock())) && !needs_attention(worst.now());
  if (all_is_well && !others.empty() && !tab.jog.control())
    return {Severity::motion, fmt::format("{} Esc stops everything.", moving_devices(*tab.bus, nullptr))};
  StatusSentence sentence = sentence_alone(console, worst, banner);
  if (sentence.severity == Severity::plain && worst_state(worst.now(), worst.clock()) == State::off)
    return {Severity::plain,
            fmt::format("Motor power of {} is off. Switch it on to move.", motors_without_power(*tab.bus))};
  if (&worst != &tab && !mentions(sentence.text.view(), worst.id()))
    sentence.text = fmt::format("{}: {}", worst.id(), sentence.text.view());
  if (!all_is_well && !others.empty()) add_running_words(sentence, others);
  return sentence;
}

/// Draws the mark of values in RAM that are not stored, at the right of the status line in any state. Returns
/// its width.
float draw_unsaved(Ui& ui, Console& console, Tab& tab, const Box& line) {
  const Snapshot& now = tab.now();
  if (!tab.catalog().can.store || (!now.unsaved_setup && !now.unsaved_programs)) return 0;
  const std::string_view words = line.width < 960 ? "Not stored"
                                 : now.unsaved_setup && now.unsaved_programs
                                     ? "Set-up and programs not stored"
                                 : now.unsaved_setup ? "Set-up not stored"
                                                     : "Program not stored";
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.icon = Icon::warning;
  o.icon_tone = Tone::warn;
  o.height = 28;
  o.tip = "Store it in Setup: it is only in the controller's RAM and lost at power-off.";
  const float width = button_width(ui, words, o);
  ImGui::SetCursorScreenPos(ui.px(line.right() - width - 8, line.y + (line.height - 28) / 2));
  if (button(ui, "status/unsaved", words, o).clicked) console.show_panel("setup");
  return width + 16;
}

/// Draws the button that clears the error of the device and axis named in the line; after a stop it clears
/// all of them. Returns its width.
float draw_clear(Ui& ui, Tab& tab, const Box& line, float taken) {
  Tab& of = tab.bus ? tab.bus->most_urgent() : tab;
  const std::optional<Clearing> way = first_clearing(of.catalog(), of.now());
  if (!way) return 0;
  const bool of_axis = !way->of_all && of.catalog().axes.size() > 1;
  const std::string_view whose = of.bus                         ? of.id()
                                 : of_axis                      ? of.catalog().axes[way->axis.index].name
                                 : way->stops_all()             ? std::string_view()
                                 : of.catalog().axes.size() > 1 ? "all"
                                                                : std::string_view();
  char words[32];
  *fmt::format_to_n(words, sizeof words - 1, "{}{}{}", way->stops_all() ? "Stop" : "Clear",
                    whose.empty() ? "" : " ", whose)
       .out = 0;
  ButtonOptions o;
  o.style = ButtonStyle::outlined;  // a raised button is hardly visible on this line in the light theme
  o.height = 28;
  o.tip = way->help;
  const float width = button_width(ui, words, o);
  ImGui::SetCursorScreenPos(ui.px(line.right() - taken - width - 8, line.y + (line.height - 28) / 2));
  if (button(ui, "status/clear", words, o).clicked) of.send_followed(way->request);
  return width + 16;
}

bool linked(const Tab& tab) {
  const LinkState state = tab.now().link.state;
  return state == LinkState::good || state == LinkState::late;
}

/// Draws the newest message at the right of the line, in at most half of the remaining width, if no title row
/// has shown it. Returns its width.
float draw_messages_in(Ui& ui, Console& console, const Box& line, float taken) {
  Toasts& toasts = console.toasts();
  for (const auto& tab : console.tabs())
    toasts.look_at_controller(tab.get(), {linked(*tab), is_motion(worst_state(tab->now(), tab->clock()))});
  if (toasts.in_frame.shown || toasts.list().empty()) return 0;
  const float width = std::min(432.0f, std::floor((line.width - taken) / 2)), height = line.height - 4;
  draw_messages(
      ui, toasts,
      in_pixels(ui, {line.right() - taken - width - 4, line.y + (line.height - height) / 2, width, height}));
  return width + 12;
}

/// Whether draw_text_in_two_lines() shows the whole text.
bool fits_in_two_lines(const Ui& ui, std::string_view words, float room) {
  if (text_width(ui, Face::body, words) <= room) return true;
  const char* const begin = words.data();
  const char* const end =
      ui.font(Face::small)->CalcWordWrapPositionA(1.0f, begin, begin + words.size(), room);
  words.remove_prefix(static_cast<std::size_t>(end - begin));
  while (words.starts_with(' ')) words.remove_prefix(1);
  return text_width(ui, Face::small, words) <= room;
}

/// If the sentence does not fit, the fault loses its last words, and the motion stays complete.
FixedText<800> words_for(const Ui& ui, const StatusSentence& sentence, float room) {
  FixedText<800> words = sentence.text;
  std::string_view worse = fault_part(sentence);
  if (worse.ends_with(' ')) worse.remove_suffix(1);
  while (sentence.goes_on > 0 && !worse.empty() && !fits_in_two_lines(ui, words, room)) {
    const std::size_t space = worse.rfind(' ');
    worse = worse.substr(0, space == worse.npos ? 0 : space);
    words = worse.empty() ? std::string(motion_part(sentence))
                          : fmt::format("{}\u2026 {}", worse, motion_part(sentence));
  }
  return words;
}

}  // namespace

void draw_status_line(Ui& ui, Console& console, const Layout& layout, const BannerSubject& in_banner) {
  begin_region(ui, "status", in_pixels(ui, layout.status), Tone::ground);
  const Rect r = in_pixels(ui, layout.status);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.max.x, r.min.y + ui.hair()), ui[Tone::line]);
  Tab* tab = console.active();
  StatusSentence sentence;
  float taken = 0;
  if (tab) {
    sentence = sentence_of(console, *tab, in_banner);
    taken = draw_unsaved(ui, console, *tab, layout.status);
    taken += draw_clear(ui, *tab, layout.status, taken);
  } else if (!console.page().empty()) {
    sentence = console.page_object(console.page()).status(console);
  }
  taken += draw_messages_in(ui, console, layout.status, taken);
  const SeverityLook look = severity_look(sentence.severity);
  const float middle = r.centre().y, left = r.min.x + ui.px(16);
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(left + ui.px(6), std::floor(middle)), ui.px(12),
            ui[look.tone]);
  const float begin = left + ui.px(24), end = r.max.x - ui.px(16 + taken);
  const FixedText<800> words = words_for(ui, sentence, end - begin);
  draw_text_in_two_lines(ui, begin, end, middle, Face::body, ui[Tone::ink], words);
  if (words != sentence.text && ImGui::IsWindowHovered() &&
      ImGui::IsMouseHoveringRect(ImVec2(begin, r.min.y), ImVec2(end, r.max.y)))
    ui.note_cut(sentence.text);
  show(ui, {"status/text", Kind::text, "Status", sentence.text, {}, false, {}},
       {r.min, ImVec2(r.max.x - ui.px(taken), r.max.y)});
  end_region();
}

}  // namespace hw::gui
