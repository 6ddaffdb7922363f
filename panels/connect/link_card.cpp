#include "panels/connect/link_card.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/session/transport_list.h"
#include "gui/shell/console.h"
#include "gui/shell/port_examiner.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/connect/link_bars.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float fix_width = 172;
constexpr double look_every_s = 1, examine_every_s = 3;

/// Bytes before the first answer, perhaps at another rate or from a controller being switched on, do not
/// count against the wire.
void listen_to(const TrafficLog& log, Instant first_answer, TalkRecorder& recorder) {
  constexpr std::uint64_t enough = 4096;  // entries: some minutes of a link at rest
  const std::uint64_t end = log.first_record() + log.records();
  for (std::uint64_t n = end - std::min(enough, log.records()); n < end; ++n) {
    const TrafficLog::Entry entry = log.entry(n);
    if (entry.at < first_answer) continue;
    recorder.record(entry.at, entry.way, entry.kind, entry.bytes);
  }
}

std::string_view label_of(const LinkFinding& finding, Path& room) {
  switch (finding.fix) {
    case LinkFinding::Fix::set_adapter_timer: return "Set timer to 1 ms";
    case LinkFinding::Fix::raise_rate: return (room = Path("Raise to {}", finding.rate)).view();
    case LinkFinding::Fix::change_address: return "Change address";
    case LinkFinding::Fix::none: break;
  }
  return {};
}

bool is_port(const Tab& tab) {
  const TransportInfo* way = find_transport(tab.address().transport);
  return way && way->is_port;
}

}  // namespace

bool LinkCard::is_of(const Tab& tab) const { return !of_.empty() && of_ == address_of_all(tab).text(); }

bool LinkCard::is_open(PageFrame& f) {
  follow_raise(f);
  const auto& tabs = f.console.tabs();
  if (of_.empty()) return false;
  if (std::any_of(tabs.begin(), tabs.end(), [this](const auto& tab) { return is_of(*tab); })) return true;
  fold();
  return false;
}

void LinkCard::toggle(PageFrame& f, const Tab& tab, bool address) {
  if (raise_.under_way()) return;
  const bool folds = is_of(tab) && !address;
  fold();
  if (folds) return;
  of_ = address_of_all(tab).text();
  address_ = of_;
  changes_address_ = address || !tab.now().link.connected();
  if (address) type_into(f.ui, "connect/doctor/address");
  examined_at_s_ = f.ui.now_s;
  if (PortExaminer* examiner = f.console.ports().examiner(); examiner && is_port(tab))
    examiner->examine(tab.address().where);
}

/// Raising the rate outlives the controller's tab, which is closed and reopened meanwhile.
void LinkCard::follow_raise(PageFrame& f) {
  if (!raise_.under_way()) return;
  f.ui.wake_in(0.1);
  if (std::exchange(wants_back_, false)) raise_.go_back(f.console);
  raise_.tick(f.console);
  const auto& tabs = f.console.tabs();
  if (std::any_of(tabs.begin(), tabs.end(), [this](const auto& tab) { return is_of(*tab); })) return;
  if (const Tab* there = raise_.tab(f.console)) of_ = address_ = address_of_all(*there).text();
}

/// Updates the facts once a second, not in each frame.
void LinkCard::look(PageFrame& f, Tab& tab) {
  f.ui.wake_in(look_every_s);
  if (looked_at_s_ >= 0 && f.ui.now_s - looked_at_s_ < look_every_s) return;
  looked_at_s_ = f.ui.now_s;
  facts_ = LinkFacts();
  TalkRecorder recorder;
  const std::vector<Tab*> all = tab.bus ? tab.bus->members : std::vector<Tab*>{&tab};
  for (Tab* member : all) {
    facts_.answers = facts_.answers && member->now().link.connected();
    listen_to(member->desk().records.traffic, member->desk().records.events.first_answer_at(), recorder);
  }
  facts_.talk = recorder.measure();
  facts_.is_line = !tab.catalog().can.window;
  facts_.rate = rate_of(tab);
  if (!tab.emulated()) facts_.rates = tab.catalog().can.bauds;
  if (const int param = find_rate_param(tab.catalog()); param >= 0)
    facts_.rate_is_set_by = tab.catalog().params[static_cast<std::size_t>(param)].mnemonic;
  PortExaminer* examiner = f.console.ports().examiner();
  if (examiner && is_port(tab) && f.ui.now_s - examined_at_s_ >= examine_every_s) {
    examiner->examine(tab.address().where);  // so that a program closed meanwhile is no longer named
    examined_at_s_ = f.ui.now_s;
  }
  const ExaminedPort* port = examiner && is_port(tab) ? examiner->find(tab.address().where) : nullptr;
  if (port) {
    facts_.port_looked_at = true;
    facts_.holder = port->holder;
    facts_.adapter_waits = port->adapter_waits;
    facts_.adapter_timer = port->adapter_timer;
    facts_.adapter_timer_can_be_set = port->adapter_timer_can_be_set;
    if (!port->refused.empty()) refused_ = port->refused;
  }
  now_ = link_budget(facts_);
  then_ = best_link_budget(facts_);
  summary_ = link_summary(facts_);
  findings_ = examine_link(facts_);
}

void LinkCard::draw(PageFrame& f, Tab& tab, float width, bool address_offered) {
  Ui& ui = f.ui;
  address_offered_ = address_offered || changes_address_;
  look(f, tab);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (height_ > 0)
    draw_across(ui, at.y, at.y + height_, ui[Tone::well], ui[Tone::ink]);
  else
    ui.wake_in(0);
  const float left = 28;
  const auto stand = [&](float space) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), ImGui::GetCursorScreenPos().y + ui.px(space)));
  };
  stand(12);
  draw_summary(ui, tab, width - left);
  if (facts_.talk.questions > 0) {
    stand(8);
    draw_budget(ui, width - left);
  }
  stand(8);
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    draw_finding(f, tab, i, width - left);
    stand(0);
  }
  if (raise_.step() != RateRaise::Step::idle) draw_steps(f, width - left);
  stand(0);
  if (changes_address_) draw_address(f, tab, width - left);
  height_ = ImGui::GetCursorScreenPos().y + ui.px(8) - at.y;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height_));
}

void LinkCard::draw_summary(Ui& ui, const Tab& tab, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const TalkMeasure& t = facts_.talk;
  const LinkHealth& link = tab.now().link;
  const std::string_view words = !link.connected() && !link.sentence.view().empty() ? link.sentence.view()
                                 : summary_.empty() ? std::string_view("No query has been answered yet.")
                                                    : std::string_view(summary_);
  wrapped(ui, Face::body_bold, Tone::ink, words, width);
  const float end = at.y + wrapped_height(ui, Face::body_bold, words, ui.px(width));
  show(ui, {"connect/doctor", Kind::text, "Link doctor", words, {}, false, {}},
       {at, ImVec2(at.x + ui.px(width), end)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, end));
  if (t.questions == 0) return;
  const Path times("{} queries measured: the quickest {}, half of them below {}, 99 of 100 below {}.",
                   t.questions, in_millis(t.least), in_millis(t.median), in_millis(t.slowest_of_hundred));
  wrapped(ui, Face::small, Tone::ink2, times, width);
  const float below = end + wrapped_height(ui, Face::small, times, ui.px(width));
  show(ui, {"connect/doctor/round_trip", Kind::text, "Round trip", times, {}, false, {}},
       {ImVec2(at.x, end), ImVec2(at.x + ui.px(width), below)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, below));
}

void LinkCard::draw_budget(Ui& ui, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool better = then_.whole() < now_.whole();
  draw_link_bar(ui, "connect/doctor/now", better ? "Now" : "Takes", at, width, now_, now_.whole());
  float y = at.y + ui.px(32);
  if (better) {
    draw_link_bar(ui, "connect/doctor/then", "Then", ImVec2(at.x, y), width, then_, now_.whole());
    y += ui.px(32);
  }
  draw_link_legend(ui, ImVec2(at.x, y), width, now_);
  ImGui::SetCursorScreenPos(ImVec2(at.x, y + ui.px(20)));
}

void LinkCard::draw_finding(PageFrame& f, Tab& tab, std::size_t index, float width) {
  Ui& ui = f.ui;
  const LinkFinding finding = findings_[index];  // a copy, because the remedy changes the list
  using State = LinkFinding::State;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool offered = finding.fix == LinkFinding::Fix::change_address && address_offered_;
  const bool has_fix = finding.fix != LinkFinding::Fix::none && !offered;
  const float words_px = ui.px(width - 24 - (has_fix ? fix_width + 16 : 0));
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + ui.px(width), at.y + ui.hair()),
                                            ui[Tone::line]);
  const Icon icon = finding.state == State::good    ? Icon::check
                    : finding.state == State::wrong ? Icon::cross
                                                    : Icon::warning;
  const Tone tone = finding.state == State::good    ? Tone::ok
                    : finding.state == State::wrong ? Tone::fault
                                                    : Tone::warn;
  draw_icon(ImGui::GetWindowDrawList(), icon, ImVec2(at.x + ui.px(6), at.y + ui.px(16)), ui.px(12), ui[tone]);
  const float left = at.x + ui.px(24);
  ImGui::SetCursorScreenPos(ImVec2(left, at.y + ui.px(5)));
  wrapped(ui, Face::body_bold, Tone::ink, finding.what, words_px / ui.scale);
  const float what_px = wrapped_height(ui, Face::body_bold, finding.what, words_px);
  ImGui::SetCursorScreenPos(ImVec2(left, at.y + ui.px(5) + what_px));
  wrapped(ui, Face::small, Tone::ink2, finding.why, words_px / ui.scale);
  const float why_px = wrapped_height(ui, Face::small, finding.why, words_px);
  const float height = std::max(ui.px(44), ui.px(12) + what_px + why_px);
  const std::string shown = fmt::format("{}. {}", finding.what, finding.why);
  show(ui, {Path("connect/doctor/finding/{}", index + 1), Kind::text, "Finding", shown, {}, false, {}},
       {at, ImVec2(left + words_px, at.y + height)});
  if (has_fix) {
    ButtonOptions o;
    o.width = fix_width;
    if (finding.fix == LinkFinding::Fix::raise_rate)
      o.disabled = raise_.under_way() ? "It is running." : tab.why_not_move();
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - fix_width), at.y + ui.px(6)));
    Path room("");
    if (button(ui, Path("connect/doctor/fix/{}", index + 1), label_of(finding, room), o).clicked)
      mend(f, tab, finding);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
}

void LinkCard::mend(PageFrame& f, Tab& tab, const LinkFinding& finding) {
  using Fix = LinkFinding::Fix;
  looked_at_s_ = -1;
  if (finding.fix == Fix::set_adapter_timer)
    if (PortExaminer* examiner = f.console.ports().examiner())
      examiner->set_adapter_timer(tab.address().where, 1);
  if (finding.fix == Fix::raise_rate) raise_.start(f.console, tab, finding.rate);
  if (finding.fix == Fix::change_address) {
    changes_address_ = true;
    type_into(f.ui, "connect/doctor/address");
  }
}

/// Draws the steps of raising the rate, each with a tick when done. The last step is the way back.
void LinkCard::draw_steps(PageFrame& f, float width) {
  Ui& ui = f.ui;
  using Step = RateRaise::Step;
  const Step now = raise_.step();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = at.x, y = at.y + ui.px(16);
  const bool went_back = now == Step::back || now == Step::set_back || now == Step::store_back;
  const auto step = [&](Step own, std::string_view words) {
    const bool past = now == Step::done || (!went_back && now != Step::failed && now > own);
    const bool here = now == own;
    const float wide = ui.px(20) + std::ceil(text_width(ui, Face::body, words)) + ui.px(20);
    if (x > at.x && x + wide > at.x + ui.px(width)) x = at.x, y += ui.px(24);
    draw_icon(ImGui::GetWindowDrawList(),
              past   ? Icon::check
              : here ? Icon::clock
                     : Icon::ring,
              ImVec2(x + ui.px(6), y), ui.px(12),
              ui[past   ? Tone::ok
                 : here ? Tone::ink
                        : Tone::ink3]);
    draw_text_line(ui, x + ui.px(20), x + wide, y, here ? Face::body_bold : Face::body,
                   ui[past || here ? Tone::ink : Tone::ink3], words);
    x += wide;
  };
  step(Step::set, "set");
  step(Step::store, "store the set-up");
  step(Step::ask, Path("ask at {}", raise_.new_rate()));
  if (now != Step::done) step(Step::back, Path("else back to {}", raise_.old_rate()));
  y += ui.px(16);
  const bool waits = raise_.waits_for_power(f.console);
  const std::string_view words =
      waits ? std::string_view("Switch the controller off and on. The console asks until it answers.")
            : std::string_view(raise_.words());
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
  if (!words.empty()) {
    const float room = width - (waits ? fix_width + 16 : 0);
    wrapped(ui, Face::body, now == Step::failed ? Tone::warn : Tone::ink, words, room);
    y = std::max(y + wrapped_height(ui, Face::body, words, ui.px(room)), ImGui::GetCursorScreenPos().y);
    if (waits) {
      ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - fix_width), y - ui.px(24)));
      ButtonOptions o;
      o.width = fix_width;
      if (button(ui, "connect/doctor/back", Path("Back to {}", raise_.old_rate()), o).clicked)
        wants_back_ = true;
      y += ui.px(12);
    }
  }
  show(ui, {"connect/doctor/raise", Kind::text, "Raise", words, {}, false, {}},
       {at, ImVec2(at.x + ui.px(width), y)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, y + ui.px(8)));
}

void LinkCard::draw_address(PageFrame& f, Tab& tab, float width) {
  Ui& ui = f.ui;
  constexpr float open_width = 112, name_width = 76;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(20), Face::body_bold, ui[Tone::ink],
                 "Address");
  FieldOptions o;
  o.face = Face::code_field;
  o.width = width - name_width - open_width - 16;
  o.error = !refused_.empty();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name_width + 8), at.y + ui.px(4)));
  const Field field = text_field(ui, "connect/doctor/address", "Address", address_, o);
  if (field.edited) refused_.clear();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - open_width), at.y + ui.px(4)));
  ButtonOptions b;
  b.width = open_width;
  b.disabled = address_.empty()             ? "Type an address first."
               : tab.now().link.connected() ? tab.why_not_move()
                                            : "";
  const bool clicked = button(ui, "connect/doctor/address/open", "Try there", b).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(44)));
  if (!refused_.empty()) {
    wrapped(ui, Face::small, Tone::fault, refused_, width);
    show(ui, {"connect/doctor/refused", Kind::text, "Refused", refused_, {}, false, {}},
         {ImVec2(at.x, at.y + ui.px(44)), ImVec2(at.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  }
  if (!(clicked || (field.entered && b.disabled.empty()))) return;
  const std::string wanted = address_;
  const auto opened = open_elsewhere(f.console, tab, wanted);
  if (!opened) {
    refused_ = opened.error().sentence();
    return;
  }
  of_ = address_ = address_of_all(**opened).text();
  refused_.clear();
  looked_at_s_ = -1;
}

}  // namespace hw::panels
