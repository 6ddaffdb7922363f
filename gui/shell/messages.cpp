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
#include "gui/shell/console.h"
#include "gui/shell/follow.h"
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

/// For a controller that runs several programs at once: the running ones, and the line if there is only one.
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
  run.who = fmt::format("{}{} {} {}", tab.catalog().program.slot_word, running > 1 ? "s" : "", numbers,
                        running > 1 ? "are" : "is");
  if (running > 1) return run;
  run.stored_line = threads[static_cast<std::size_t>(last)].line;
  run.line = tab.desk().texts.live_line(0, run.stored_line);
  run.left_s = tab.desk().follower.left_s();
  return run;
}

/// "Program 2 has stopped in error in line 19: V2=5/V1." The cause is omitted: the controller does not report
/// it, and axes in error are named beside it.
std::string failed_threads(Tab& tab) {
  ProgramTexts& texts = tab.desk().texts;
  std::string said;
  const int count = std::min(tab.catalog().program.threads, max_threads);
  for (int n = 0; n < count; ++n) {
    const ThreadState& thread = tab.now().threads[static_cast<std::size_t>(n)];
    if (!thread.known || thread.run != RunState::error) continue;
    said += fmt::format("{}{} {} stopped with an error", said.empty() ? "" : " ",
                        tab.catalog().program.slot_word, n);
    const int line = texts.live_line(0, thread.line);
    if (line >= 0)
      said += fmt::format(" in line {}: {}.", line + 1, line_of(texts.text(0), line));
    else
      said += fmt::format(" at line {} of its stored code.", thread.line);
  }
  return said;
}

RunPlace run_place(Tab& tab) {
  if (tab.catalog().program.threads > 0) return place_of_threads(tab);
  Desk& desk = tab.desk();
  const RunFollower::Place place = desk.follower.place();
  RunPlace run;
  run.left_s = desk.follower.left_s();
  if (place.slot >= 0) run.line = desk.texts.live_line(place.slot, place.command);
  run.pass = place.pass, run.passes = place.passes;
  return run;
}

/// On a bus the device stands for its only axis: "02 moves to ...", not "Axis X moves to ...".
void name_device(StatusSentence& said, const Tab& tab) {
  if (!tab.bus || tab.catalog().axes.size() != 1) return;
  std::string name = tab.catalog().axes[0].description, text(said.text.view());
  for (const bool at_the_beginning : {false, true}) {
    if (name.empty()) return;
    if (at_the_beginning) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    if (const std::size_t at = text.find(name); at != text.npos) text.replace(at, name.size(), tab.id());
  }
  said.text = text;
}

/// The parameter to choose before this controller's first move; -1: none.
int unset_in(const Tab& tab) {
  for (int i = 0; i < tab.now().axis_count; ++i)
    if (const int param = unset_before_moving(tab.catalog(), tab.now(), AxisId{static_cast<std::uint8_t>(i)});
        param >= 0)
      return param;
  return -1;
}

/// The subject of the banner over the centre. Without room for one, the status line and STOP ALL report the
/// others of a bus.
struct BannerSubject {
  enum class What : std::uint8_t { nothing, lost, moved, unset };
  What what = What::nothing;
  Tab* tab = nullptr;
  int param = -1;       ///< unset
  FollowOffer offer{};  ///< moved
};

BannerSubject banner_subject(Tab& tab, const Layout& layout) {
  using What = BannerSubject::What;
  const bool narrow = layout.tier == Tier::narrow;
  Tab& worst = tab.bus && !narrow ? tab.bus->worst() : tab;
  if (worst.now().link.state == LinkState::lost) return {What::lost, &worst};
  if (narrow || tab.centre_panel == "setup") return {};  // the status line reports it too
  if (tab.now().link.connected())
    if (FollowOffer offer = offer_to_follow(tab);
        !offer.address.empty() && offer.why_not.empty() && offer.address != tab.follow_left)
      return {What::moved, &tab, -1, std::move(offer)};
  if (tab.unset_read) return {};
  if (const int param = unset_in(tab); param >= 0) return {What::unset, &tab, param};
  return {};
}

StatusSentence sentence_alone(Console& console, Tab& tab, const Layout& layout) {
  const bool in_banner =
      !tab.unset_read && unset_in(tab) >= 0 && banner_subject(tab, layout).what == BannerSubject::What::unset;
  const auto held = tab.jog.control();
  StatusSentence said = status_sentence(
      {tab.catalog(), tab.now(), tab.clock(), held, tab.jog.jogging(),
       [&](AxisId a, Steps s) { return std::string(format_with_unit(s, tab.unit(a)).view()); },
       [&](AxisId a, Pps v) { return std::string(format_speed(v, tab.unit(a)).view()); },
       [&](Instant when) { return console.time_of_day(when); }, run_place(tab), failed_threads(tab),
       tab.unset_read || in_banner});
  name_device(said, tab);
  return said;
}

/// "01, 02 and 03 move.": the moving devices of the bus other than `but`; empty: none.
std::string who_moves(const Bus& bus, const Tab* but) {
  std::vector<std::string_view> ids;
  for (const Tab* member : bus.members)
    if (member != but && is_motion(worst_state(member->now(), member->clock()))) ids.push_back(member->id());
  return ids.empty() ? std::string()
                     : fmt::format("{} {}.", in_words(ids), ids.size() == 1 ? "moves" : "move");
}

/// "02 and 04" of a bus, or their number if there are more; empty: all motors have power.
std::string who_is_powerless(const Bus& bus) {
  constexpr std::size_t most_named = 4;
  std::vector<std::string_view> ids;
  for (const Tab* member : bus.members)
    if (powerless(member->catalog(), member->now(), AxisId{0})) ids.push_back(member->id());
  if (ids.size() > 1 && ids.size() == bus.members.size()) return fmt::format("all {} motors", ids.size());
  return ids.size() > most_named ? fmt::format("{} of {} motors", ids.size(), bus.members.size())
                                 : in_words(ids);
}

/// For a bus: its worst state, and the other devices that move.
StatusSentence sentence_of(Console& console, Tab& tab, const Layout& layout) {
  if (!tab.bus) return sentence_alone(console, tab, layout);
  Tab& worst = tab.bus->worst();
  const std::string others = who_moves(*tab.bus, &worst);
  const bool all_is_well = is_motion(worst_state(worst.now(), worst.clock()));
  if (all_is_well && !others.empty() && !tab.jog.control())
    return {Severity::motion, fmt::format("{} Esc stops everything.", who_moves(*tab.bus, nullptr))};
  StatusSentence said = sentence_alone(console, worst, layout);
  if (said.severity == Severity::plain && worst_state(worst.now(), worst.clock()) == State::off)
    return {Severity::plain,
            fmt::format("Motor power of {} is off. Switch it on to move.", who_is_powerless(*tab.bus))};
  if (&worst != &tab && !speaks_of(said.text.view(), worst.id()))
    said.text = fmt::format("{}: {}", worst.id(), said.text.view());
  if (!all_is_well && !others.empty()) said.text = fmt::format("{} {}", said.text.view(), others);
  return said;
}

/// Marks values in RAM that are not stored, at the right of the status line in any state. Returns its width.
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
  o.tip = "It is in the controller's RAM only and gone when it is switched off. Store it in Setup.";
  const float width = button_width(ui, words, o);
  ImGui::SetCursorScreenPos(ui.px(line.right() - width - 8, line.y + (line.height - 28) / 2));
  if (button(ui, "status/unsaved", words, o).clicked) console.show_panel("setup");
  return width + 16;
}

/// The error that the line tells of is cleared there, of the axis that it names; a stop is of all of them.
/// Returns its width.
float draw_clear(Ui& ui, Tab& tab, const Box& line, float taken) {
  Tab& of = tab.bus ? tab.bus->worst() : tab;
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
  o.height = 28;
  o.tip = way->help;
  const float width = button_width(ui, words, o);
  ImGui::SetCursorScreenPos(ui.px(line.right() - taken - width - 8, line.y + (line.height - 28) / 2));
  if (button(ui, "status/clear", words, o).clicked) of.send_followed(way->wish);
  return width + 16;
}

bool linked(const Tab& tab) {
  const LinkState state = tab.now().link.state;
  return state == LinkState::good || state == LinkState::late;
}

/// The newest message at the right of the line, if no title row had room for it: at most half of the
/// remaining width. Returns its width.
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

}  // namespace

void draw_status_line(Ui& ui, Console& console, const Layout& layout) {
  begin_region(ui, "status", in_pixels(ui, layout.status), Tone::ground);
  const Rect r = in_pixels(ui, layout.status);
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, ImVec2(r.max.x, r.min.y + ui.hair()), ui[Tone::line]);
  Tab* tab = console.active();
  StatusSentence said;
  float taken = 0;
  if (tab) {
    said = sentence_of(console, *tab, layout);
    taken = draw_unsaved(ui, console, *tab, layout.status);
    taken += draw_clear(ui, *tab, layout.status, taken);
  } else if (!console.page().empty()) {
    said = console.page_object(console.page()).status(console);
  }
  taken += draw_messages_in(ui, console, layout.status, taken);
  const SeverityLook look = severity_look(said.severity);
  const float middle = r.centre().y, left = r.min.x + ui.px(16);
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(left + ui.px(6), std::floor(middle)), ui.px(12),
            ui[look.tone]);
  draw_text_in_two_lines(ui, left + ui.px(24), r.max.x - ui.px(16 + taken), middle, Face::body, ui[Tone::ink],
                         said.text);
  show(ui, {"status/text", Kind::text, "Status", said.text, {}, false, {}},
       {r.min, ImVec2(r.max.x - ui.px(taken), r.max.y)});
  end_region();
}

// ---- banner

namespace {

std::string report(const Console& console, const Tab& tab) {
  const LinkHealth& link = tab.now().link;
  return fmt::format(
      "{} ({}) at {}\nlost at {}, {} attempts since\n{}\ntimeouts {}, bytes not understood {}\n", tab.name(),
      tab.catalog().name, tab.address().text(), console.time_of_day(link.lost_at), link.attempts,
      link.sentence.view(), link.timeouts, link.unparsed_bytes);
}

/// "Attempt 5 in 3 s."; requests a frame for the next change of the number.
std::string_view next_attempt(Ui& ui, const Console& console, const LinkHealth& link,
                              std::span<char> buffer) {
  const double wait = seconds(link.next_attempt - console.clock());
  const double whole = std::ceil(wait);
  const auto end = wait > 0 ? fmt::format_to_n(buffer.data(), buffer.size(), "Attempt {} in {:.0f} s.",
                                               link.attempts + 1, whole)
                            : fmt::format_to_n(buffer.data(), buffer.size(), "Attempt {} is under way.",
                                               std::max(1, link.attempts));
  if (wait > 0) ui.wake_in(wait - (whole - 1) + 0.001);
  return {buffer.data(), std::min(end.size, buffer.size())};
}

/// A banner over the status line is a separate window above the other regions.
void begin_over(Ui& ui, std::string_view id, const Rect& r, bool over_status) {
  if (over_status) {
    begin_region(ui, "banner", r, Tone::panel, ImVec2(0, 0));
    if (ImGui::IsWindowAppearing()) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  } else {
    ImGui::SetCursorScreenPos(r.min);
    begin_part(ui, std::string(id).c_str(), r.width(), r.height(), Tone::panel, 0, false);
  }
}
void end_over(bool over_status) {
  if (over_status)
    end_region();
  else
    end_part();
}

/// The place of a banner: full height, or one bar.
struct BannerPlace {
  Box box;
  bool bar = false, over_status = false;
};

/// Full height if possible; a bar if that would leave too few rows of traffic.
BannerPlace place_of(const Ui& ui, const Layout& layout, const Box& below, const Banner& what, bool actions,
                     bool folded) {
  constexpr float bar = 48, traffic_at_least = 150;
  if (below.empty()) return {layout.status, true, true};
  const float whole = banner_height(ui, what, below.width, actions);
  if (!folded && below.height - whole >= traffic_at_least)
    return {{below.x, below.y, below.width, whole}, false, false};
  return {{below.x, below.y, below.width, std::min(bar, below.height)}, true, false};
}

/// Of a status line that a banner covers: messages keep a place there too.
float draw_messages_beside(Ui& ui, Toasts& toasts, const Box& line) {
  if (toasts.list().empty()) return 0;
  constexpr float width = 52, height = 28;
  draw_messages(
      ui, toasts,
      in_pixels(ui, {line.right() - width - 4, line.y + (line.height - height) / 2, width, height}));
  return width + 8;
}

/// Returns the action pressed; `taken` is the height taken from the part below.
int show_banner(Ui& ui, Console& console, const Layout& layout, const Box& below, std::string_view id,
                const Banner& what, std::span<const Action> actions, float& taken, bool folded = false) {
  const BannerPlace place = place_of(ui, layout, below, what, !actions.empty(), folded);
  taken = place.over_status ? 0 : place.box.height;
  const Rect r = in_pixels(ui, place.box);
  begin_over(ui, id, r, place.over_status);
  const float beside = place.over_status ? draw_messages_beside(ui, console.toasts(), place.box) : 0;
  if (beside > 0) {
    ImGui::SetCursorScreenPos(r.min);
    begin_part(ui, "bar", r.width() - ui.px(beside), r.height(), Tone::panel, 0, false);
  }
  const int picked = place.bar ? banner_bar(ui, id, what, actions) : banner(ui, id, what, actions);
  if (beside > 0) end_part();
  end_over(place.over_status);
  return picked;
}

float draw_lost(Ui& ui, Console& console, Tab& tab, const Layout& layout, const Box& below) {
  const LinkHealth& link = tab.now().link;
  const std::string title = fmt::format("No answer from {} since {}.", tab.bus ? tab.id() : tab.name(),
                                        console.time_of_day(link.lost_at));
  const bool others = tab.bus && tab.bus->connected() > 0;
  const std::string went_on = what_goes_on(tab, Tense::past);
  const std::string sentences = fmt::format(
      "{}{}\n{}Stop does not reach it now, and goes out first when it answers: to be sure, use its power "
      "switch. "
      "Then its state is read afresh; nothing moves by itself.",
      others ? "The others answer, so port and baud rate are right. " : "", link.sentence.view(),
      went_on.empty() ? "Nothing was seen to move when the link went. "
                      : fmt::format("When the link went, {}. ", went_on));
  // A bar may have no room for its last sentence.
  std::string brief = went_on.empty() ? "Nothing was seen to move." : went_on + ".";
  brief[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(brief[0])));
  brief = "Stop does not reach it: use its power switch. " + brief;
  char attempt[64];
  const Banner what{
      Severity::fault, Icon::plug, title, sentences, next_attempt(ui, console, link, attempt), brief};
  FollowOffer offer = offer_to_follow(tab);
  const bool moved = !offer.address.empty();
  const bool may_follow = moved && offer.why_not.empty();
  const Action all[] = {{.id = "fault/follow", .label = offer.label, .main = may_follow},
                        {.id = "fault/try_now", .label = "Try now", .main = !may_follow},
                        {.id = "fault/fold", .label = tab.banner_folded ? "Unfold" : "Fold"},
                        {.id = "fault/report", .label = "Copy this report", .brief = "Report"}};
  // When folded, its text fits only if the report is left out.
  const std::span<const Action> actions =
      std::span(all).subspan(moved ? 0 : 1, (moved ? 3u : 2u) + (tab.banner_folded ? 0 : 1));
  float taken = 0;
  const int picked =
      show_banner(ui, console, layout, below, "fault/lost", what, actions, taken, tab.banner_folded);
  if (picked < 0) return taken;
  const std::string_view chosen = actions[static_cast<std::size_t>(picked)].id;
  if (chosen == "fault/follow") tab.follow_to = std::move(offer.address);
  if (chosen == "fault/try_now") console.reconnect(tab);
  if (chosen == "fault/fold") tab.banner_folded = !tab.banner_folded;
  if (chosen == "fault/report") {
    ImGui::SetClipboardText(report(console, tab).c_str());
    console.toast(Severity::ok, "The report is in the clipboard.");
  }
  return taken;
}

/// Banner about a value to choose in the set-up before the first move.
float draw_unset(Ui& ui, Console& console, Tab& tab, int param, const Layout& layout, const Box& below) {
  const ParamInfo& info = tab.catalog().params[static_cast<std::size_t>(param)];
  const Banner what{Severity::warn, Icon::warning, "Before the first move", info.before_moving};
  const Action actions[] = {
      {.id = "fault/setup", .label = "Choose it in Setup", .brief = "Choose it", .main = true},
      {.id = "fault/unset_read", .label = "Leave it"}};
  float taken = 0;
  const int picked = show_banner(ui, console, layout, below, "fault/unset", what, actions, taken);
  if (picked == 0) console.show_panel("setup", "setup/" + info.mnemonic);
  if (picked == 1) tab.unset_read = true;
  return taken;
}

/// Banner about a controller that stores another rate than the one it was opened with.
float draw_moved(Ui& ui, Console& console, Tab& tab, const FollowOffer& offer, const Layout& layout,
                 const Box& below) {
  const Banner what{Severity::warn, Icon::plug, "It keeps another rate",
                    "It was given the new rate here, and has stored it. Follow it, and it is found there the "
                    "next time too. Nothing moves by that; its state is read afresh."};
  const Action actions[] = {{.id = "fault/follow", .label = offer.label, .main = true},
                            {.id = "fault/follow_left", .label = "Leave it"}};
  float taken = 0;
  const int picked = show_banner(ui, console, layout, below, "fault/moved", what, actions, taken);
  if (picked == 0) tab.follow_to = offer.address;
  if (picked == 1) leave_where_it_is(tab, offer);
  return taken;
}

}  // namespace

float draw_banner(Ui& ui, Console& console, Tab& tab, const Layout& layout, const Box& below) {
  using What = BannerSubject::What;
  const BannerSubject subject = banner_subject(tab, layout);
  switch (subject.what) {
    case What::lost: return draw_lost(ui, console, *subject.tab, layout, below);
    case What::moved: return draw_moved(ui, console, tab, subject.offer, layout, below);
    case What::unset: return draw_unset(ui, console, tab, subject.param, layout, below);
    case What::nothing: break;
  }
  return 0;
}

}  // namespace hw::gui
