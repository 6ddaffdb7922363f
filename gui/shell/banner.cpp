// Draws the banner over the centre.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <imgui_internal.h>

#include "core/device/refusals.h"
#include "gui/model/bus.h"
#include "gui/model/goes_on.h"
#include "gui/shell/banner_subject.h"
#include "gui/shell/console.h"
#include "gui/shell/follow.h"
#include "gui/shell/messages.h"
#include "gui/widgets/area.h"
#include "gui/widgets/message.h"

namespace hw::gui {

int unset_in(const Tab& tab) {
  for (int i = 0; i < tab.now().axis_count; ++i)
    if (const int param = unset_before_moving(tab.catalog(), tab.now(), AxisId{static_cast<std::uint8_t>(i)});
        param >= 0)
      return param;
  return -1;
}

BannerSubject banner_subject(Tab& tab, const Layout& layout, const Box& below) {
  using Kind = BannerSubject::Kind;
  const bool narrow = layout.tier == Tier::narrow;
  Tab& worst = tab.bus && !narrow ? tab.bus->worst() : tab;
  if (worst.now().link.state == LinkState::lost) return {Kind::lost, &worst};
  if (narrow || below.empty() || tab.panels.in_front == "setup")
    return {};  // the status line reports the controllers in error too
  if (tab.now().link.connected())
    if (FollowOffer offer = offer_to_follow(tab);
        !offer.address.empty() && offer.why_not.empty() && offer.address != tab.view.follow_left)
      return {Kind::moved, &tab, -1, std::move(offer)};
  if (tab.view.unset_read) return {};
  if (const int param = unset_in(tab); param >= 0) return {Kind::unset, &tab, param};
  return {};
}

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

/// A banner over the status line is a window of its own above the other regions.
void begin_over(Ui& ui, std::string_view id, const Rect& r, bool over_status) {
  if (over_status) {
    begin_region(ui, "banner", r, Tone::panel, ImVec2(0, 0));
    if (ImGui::IsWindowAppearing()) bring_to_front();
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

/// The place of a banner: at full height, or as one bar.
struct BannerPlace {
  Box box;
  bool bar = false, over_status = false;
};

/// The banner has its full height unless that leaves too few rows of traffic; then it is a bar. Folded, it is
/// one line.
BannerPlace place_of(const Ui& ui, const Layout& layout, const Box& below, const Banner& what, bool actions,
                     bool folded) {
  constexpr float one_line = 36, traffic_at_least = 150;
  if (below.empty()) return {layout.status, true, true};
  const float bar = folded ? one_line : banner_bar_height;
  const float whole = banner_height(ui, what, below.width, actions);
  if (!folded && below.height - whole >= traffic_at_least)
    return {{below.x, below.y, below.width, whole}, false, false};
  return {{below.x, below.y, below.width, std::min(bar, below.height)}, true, false};
}

/// Draws the messages beside a banner that covers the status line, unless the last frame has drawn them at
/// the terminal.
float draw_messages_beside(Ui& ui, Toasts& toasts, const Box& line) {
  const Widget* strip = ui.registry.find("message/strip");
  if (toasts.list().empty() || (strip && strip->rect.max.y <= ui.px(line.y))) return 0;
  constexpr float width = 52, height = 28;
  draw_messages(
      ui, toasts,
      in_pixels(ui, {line.right() - width - 4, line.y + (line.height - height) / 2, width, height}));
  return width + 8;
}

/// Returns the action pressed, or -1; `taken` receives the height taken from the part below.
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
  const int picked = place.bar ? banner_bar(ui, id, what, actions, folded && !place.over_status)
                               : banner(ui, id, what, actions);
  if (beside > 0) end_part();
  end_over(place.over_status);
  return picked;
}

float draw_lost(Ui& ui, Console& console, Tab& tab, const Layout& layout, const Box& below) {
  const LinkHealth& link = tab.now().link;
  const std::string title = fmt::format("No answer from {} since {}.", tab.bus ? tab.id() : tab.name(),
                                        console.time_of_day(link.lost_at));
  const bool others = tab.bus && tab.bus->connected() > 0;
  const std::string went_on = running_words(tab, Tense::past);
  const std::string sentences = fmt::format(
      "{}{}\n{}Use its power switch to be sure: Stop does not reach it now, and is sent first when it "
      "answers. Its state is then read again; nothing moves by itself.",
      others ? "The others answer, so port and baud rate are right. " : "", link.sentence.view(),
      went_on.empty() ? "No motion was seen when the link was lost. "
                      : fmt::format("When the link was lost, {}. ", went_on));
  // The last sentence may not fit into a bar.
  std::string brief = went_on.empty() ? "No motion was seen." : went_on + ".";
  brief[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(brief[0])));
  brief = "Stop does not reach it: use its power switch. " + brief;
  char attempt[64];
  const Banner what{
      Severity::fault, Icon::plug, title, sentences, next_attempt(ui, console, link, attempt), brief};
  FollowOffer offer = offer_to_follow(tab);
  const bool moved = !offer.address.empty();
  const bool may_follow = moved && offer.why_not.empty();
  const bool folds = !below.empty(), folded = tab.view.banner_folded && folds;
  std::array<Action, 4> all;
  std::size_t count = 0;
  if (moved) all[count++] = {.id = "fault/follow", .label = offer.label, .main = may_follow};
  all[count++] = {.id = "fault/try_now", .label = "Try now", .main = !may_follow};
  if (folds) all[count++] = {.id = "fault/fold", .label = folded ? "Unfold" : "Fold"};
  // The folded text fits only without the report.
  if (!folded) all[count++] = {.id = "fault/report", .label = "Copy this report", .brief = "Report"};
  const std::span<const Action> actions(all.data(), count);
  float taken = 0;
  const int picked = show_banner(ui, console, layout, below, "fault/lost", what, actions, taken, folded);
  if (picked < 0) return taken;
  const std::string_view chosen = actions[static_cast<std::size_t>(picked)].id;
  if (chosen == "fault/follow") tab.view.follow_to = std::move(offer.address);
  if (chosen == "fault/try_now") console.reconnect(tab);
  if (chosen == "fault/fold") tab.view.banner_folded = !tab.view.banner_folded;
  if (chosen == "fault/report") {
    ImGui::SetClipboardText(report(console, tab).c_str());
    console.toast(Severity::ok, "The report is in the clipboard.");
  }
  return taken;
}

/// The banner about a parameter that the user must choose before the first move.
float draw_unset(Ui& ui, Console& console, Tab& tab, int param, const Layout& layout, const Box& below) {
  const ParamInfo& info = tab.catalog().params[static_cast<std::size_t>(param)];
  const Banner what{Severity::warn, Icon::warning, "Before the first move", info.before_moving};
  const Action actions[] = {
      {.id = "fault/setup", .label = "Choose it in Setup", .brief = "Choose it", .main = true},
      {.id = "fault/unset_read", .label = "Leave it"}};
  float taken = 0;
  const int picked = show_banner(ui, console, layout, below, "fault/unset", what, actions, taken);
  if (picked == 0) console.show_panel("setup", "setup/" + info.mnemonic);
  if (picked == 1) tab.view.unset_read = true;
  return taken;
}

/// The banner about a controller that stores another name or rate than its address.
float draw_moved(Ui& ui, Console& console, Tab& tab, const FollowOffer& offer, const Layout& layout,
                 const Box& below) {
  const Banner what{Severity::warn, Icon::plug, "The controller keeps another rate",
                    "Follow it to connect at the new rate from now on: the controller has stored it. Nothing "
                    "moves; its state is read again."};
  const Action actions[] = {{.id = "fault/follow", .label = offer.label, .main = true},
                            {.id = "fault/follow_left", .label = "Leave it"}};
  float taken = 0;
  const int picked = show_banner(ui, console, layout, below, "fault/moved", what, actions, taken);
  if (picked == 0) tab.view.follow_to = offer.address;
  if (picked == 1) decline_follow(tab, offer);
  return taken;
}

}  // namespace

float draw_banner(Ui& ui, Console& console, Tab& tab, const BannerSubject& subject, const Layout& layout,
                  const Box& below) {
  using Kind = BannerSubject::Kind;
  switch (subject.kind) {
    case Kind::lost: return draw_lost(ui, console, *subject.tab, layout, below);
    case Kind::moved: return draw_moved(ui, console, tab, subject.offer, layout, below);
    case Kind::unset: return draw_unset(ui, console, tab, subject.param, layout, below);
    case Kind::nothing: break;
  }
  return 0;
}

}  // namespace hw::gui
