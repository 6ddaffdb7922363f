#include "panels/connect/connect.h"

#include <algorithm>

#include "core/device/registry.h"
#include "core/session/last_end.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/connect/place_row.h"
#include "panels/connect/points.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

/// When the last run ended; empty: unknown, as after a crash.
static std::string when_closed(const ClosingTime& when, const std::string& today) {
  if (when.date.empty()) return {};
  return fmt::format("closed {} {}", when.date == today ? "today" : when.date, when.time);
}

void draw_point(Ui& ui, int number, std::string_view words, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text(ui, at, Face::body_bold, ui[Tone::ink2], Path("{}", number));
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(24), at.y));
  wrapped(ui, Face::body, Tone::ink2, words, width - 24);
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y));
  gap(ui, 4);
}

void Connect::draw(PageFrame& f) {
  Ui& ui = f.ui;
  const Box& a = f.area;
  look_at_recent(f.console);
  if (const Tab* tab = f.console.take_link_to_examine()) {
    card_.unfold(f, *tab);
    log_shown_ = false;
  }
  if (log_shown_) return draw_log(f);
  if (f.tier == Tier::narrow) {
    begin_part(ui, "all", ui.px(a.width), ui.px(a.height), Tone::panel, 16);
    const float width = a.width - 32;
    draw_found_title(f, width);
    draw_rows(f, width);
    gap(ui, 16);
    draw_address(f, width);
    group_line(ui, 0);
    draw_left(f, width);
    group_line(ui);
    draw_emulators(f, width);
    end_part();
    return;
  }
  const float left = f.tier == Tier::wide ? 304 : 264, right = f.tier == Tier::wide ? 272 : 240;
  const auto column = [&](const char* name, float x, float width) {
    ImGui::SetCursorScreenPos(ui.px(a.x + x, a.y));
    begin_part(ui, name, ui.px(width), ui.px(a.height), Tone::panel, 16, x != left);
    line_right_of(ui, in_pixels(ui, {a.x + x, a.y, width, a.height}));
  };
  column("left", 0, left);
  draw_left(f, left - 32);
  end_part();
  column("found", left, a.width - left - right);
  draw_found(f, {a.x + left, a.y, a.width - left - right, a.height});
  end_part();
  column("emulators", a.width - right, right);
  draw_emulators(f, right - 32);
  end_part();
}

StatusSentence Connect::status(Console& console) {
  const auto& ports = console.ports().ports();
  const auto answering = std::count_if(
      ports.begin(), ports.end(), [](const FoundPort& p) { return p.state == FoundPort::State::answers; });
  if (answering > 0)
    return {Severity::ok, Path("{} {} on {} {}. Choose one, or start an emulator.", answering,
                               answering == 1 ? "controller answers" : "controllers answer", ports.size(),
                               ports.size() == 1 ? "port" : "ports")
                              .view()};
  if (console.ports().busy()) return {Severity::plain, "Searching for ports and controllers."};
  constexpr std::string_view another = "Plug in another controller, type its address, or start an emulator.";
  if (const int open = console.faces(); open > 1)
    return {Severity::plain, Path("{} controllers are open. {}", open, another).view()};
  else if (open == 1)
    return {Severity::plain, Path("One controller is open. {}", another).view()};
  return {Severity::plain,
          "Plug a controller in, type its address, or start an emulator: no controller is found yet."};
}

void Connect::open(PageFrame& f, const std::string& address) {
  refused_.clear();
  if (auto opened = f.console.open(address); !opened) refused_ = opened.error().sentence();
}

/// Opens the connections of the last run that are not open yet. The first of them comes to the front.
void Connect::open_last_time(PageFrame& f) {
  std::vector<std::string> all;
  for (const Recent& r : recent_)
    if (r.last_time && !find_open(f.console, r.address)) all.push_back(r.entry.address);
  refused_.clear();
  Tab* front = nullptr;
  for (auto address = all.rbegin(); address != all.rend(); ++address) {
    auto opened = f.console.open(*address);
    if (!opened) refused_ += (refused_.empty() ? "" : " ") + opened.error().sentence();
    if (opened && !front) front = *opened;
  }
  if (front) f.console.activate(*front);
}

/// Does work only when the list has changed.
void Connect::look_at_recent(Console& console) {
  const auto& list = console.recent().list();
  const auto same = [&](const Recent& r, const RecentConnection& c) {
    return r.entry == c && r.last_time == console.recent().is_of_last_time(c.address);
  };
  if (recent_.size() == list.size() && std::equal(recent_.begin(), recent_.end(), list.begin(), same)) return;
  recent_.clear();
  for (const RecentConnection& entry : list) {
    Recent r;
    r.entry = entry;
    if (auto address = Address::parse(entry.address)) r.address = std::move(*address), r.understood = true;
    r.last_time = console.recent().is_of_last_time(entry.address);
    r.name = !entry.name.empty() ? entry.name : r.understood ? r.address.model : entry.address;
    for (const Catalog& catalog : catalogs_.all())
      if (entry.name.empty() && r.understood && catalog.model == r.address.model) r.name = catalog.short_name;
    describe_place(r);
    recent_.push_back(std::move(r));
  }
}

/// "ttyUSB1, 9600 baud". The name of a bus contains its ids, as in its tab, unless the user has given it
/// another name.
void Connect::describe_place(Recent& r) {
  const Address& address = r.address;
  const bool somewhere = r.understood && !address.where.empty();
  const std::string_view place = somewhere ? short_place(address.where) : std::string_view(r.entry.address);
  const bool named_by_place = !somewhere || address.transport == "serial";
  r.place = address.emulated() ? std::string("emulator")
            : named_by_place   ? std::string(place)
                               : fmt::format("{} {}", address.transport, place);
  if (const auto baud = address.options.find("baud"); baud != address.options.end())
    r.place += fmt::format(", {} baud", baud->second);
  const auto id = address.options.find("id");
  if (id == address.options.end()) return;
  const std::size_t range = id->second.find('-');
  if (range == std::string::npos || !r.entry.name.empty())
    r.place += fmt::format(", id {}", id->second);
  else
    r.name += fmt::format(" {}\u2013{}", id->second.substr(0, range), id->second.substr(range + 1));
}

// ---- left: connections used before

void Connect::draw_left(PageFrame& f, float width) {
  Ui& ui = f.ui;
  const bool newcomer = std::none_of(recent_.begin(), recent_.end(),
                                     [](const Recent& r) { return r.understood && !r.address.emulated(); });
  float title_height = 56;  // as in the other columns
  for (const bool last_time : {true, false}) {
    const auto belongs = [&](const Recent& r) { return r.last_time == last_time; };
    if (std::none_of(recent_.begin(), recent_.end(), belongs)) continue;
    last_time ? draw_last_time_title(f, width) : section_title(ui, "Used before", {}, title_height);
    title_height = 48;
    for (std::size_t i = 0; i < recent_.size(); ++i)
      if (belongs(recent_[i])) draw_recent(f, i, width);
    group_line(ui, 0);
    if (!last_time) continue;
    gap(ui, 8);
    wrapped(ui, Face::small, Tone::ink2,
            "Restores tabs, units, names and limits, and moves nothing. A controller that does not answer "
            "opens when it does.",
            width);
    gap(ui, 8);
  }
  if (newcomer) draw_newcomer(f, width);
  draw_log_button(f);
}

/// Draws the title of the last connections with the end of that run: "closed today 09:48".
void Connect::draw_last_time_title(PageFrame& f, float width) {
  constexpr float height = 56;
  constexpr Duration read_again_after = std::chrono::minutes(1);  // "today" ends at midnight
  const Instant now = f.console.clock();
  if (closed_read_at_ == Instant() || now - closed_read_at_ >= read_again_after) {
    closed_words_ = when_closed(f.console.recent().last_end(), date_of_today());
    closed_read_at_ = now;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(f.ui, "As last time", closed_words_, height);
  show(f.ui, {"connect/last_time", Kind::text, "As last time", closed_words_},
       {at, ImVec2(at.x + f.ui.px(width), at.y + f.ui.px(height))});
}

void Connect::draw_recent(PageFrame& f, std::size_t i, float width) {
  if (i >= recent_.size()) return;
  Ui& ui = f.ui;
  const Recent& r = recent_[i];
  constexpr float open_width = 60, cross_width = 28;
  group_line(ui, 0);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Tab* tab = find_open(f.console, r.address);
  const auto& ports = f.console.ports().ports();
  const bool serial = r.understood && r.address.transport == "serial";
  const bool here = serial && std::any_of(ports.begin(), ports.end(),
                                          [&](const FoundPort& p) { return p.path == r.address.where; });
  // The list names ports as the system does: links to ports and pseudo-terminals are not listed.
  const bool listed = serial && r.address.where.starts_with("/dev/tty");
  const bool gone = listed && !f.console.ports().busy() && !here && !ports.empty();
  const bool answers = tab && tab->now().link.connected();
  const std::string_view state = tab    ? (answers ? "open" : "no answer")
                                 : here ? "here now"
                                 : gone ? "not plugged in"
                                        : "";
  const Icon mark = tab ? (answers ? Icon::check : Icon::warning) : gone ? Icon::plug : Icon::ring;
  const Tone tone = tab ? (answers ? Tone::ok : Tone::warn) : Tone::ink2;
  draw_icon(ImGui::GetWindowDrawList(), mark, ImVec2(at.x + ui.px(6), at.y + ui.px(18)), ui.px(12), ui[tone]);
  const float left = at.x + ui.px(24), right = at.x + ui.px(width - open_width - cross_width - 8);
  draw_text_line(ui, left, right, at.y + ui.px(18), Face::body_bold, ui[Tone::ink], r.name);
  const float used = std::ceil(text_width(ui, Face::body_bold, r.name)) + ui.px(8);
  if (left + used + ui.px(40) < right)
    draw_text_line(ui, left + used, right, at.y + ui.px(18), Face::small, ui[tone], state);
  draw_text_line(ui, left, right, at.y + ui.px(37), Face::small, ui[Tone::ink2], r.place);
  show(ui, {Path("connect/recent/{}/state", i), Kind::text, r.name, state, {}, false, r.entry.address},
       {at, ImVec2(right, at.y + ui.px(52))});
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - open_width), at.y + ui.px(12)));
  ButtonOptions o;
  o.width = open_width;
  o.tip = r.entry.address;
  const bool opens = button(ui, Path("connect/recent/{}", i), tab ? "Show" : "Open", o).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - open_width - cross_width - 4), at.y + ui.px(12)));
  o = ButtonOptions();
  o.style = ButtonStyle::quiet;
  o.icon = Icon::cross;
  o.width = cross_width;
  o.tip = "Forget this connection";
  const bool forgets = button(ui, Path("connect/recent/{}/forget", i), "", o).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(56)));
  if (opens && tab) f.console.activate(*tab);
  if (opens && !tab)
    return open(f, std::string(r.entry.address));  // a copy, because opening changes the list
  if (!forgets) return;
  if (auto forgotten = f.console.recent().remove(std::string(r.entry.address)); !forgotten)
    f.toast(Severity::fault, forgotten.error().sentence());
}

void Connect::draw_newcomer(PageFrame& f, float width) {
  Ui& ui = f.ui;
  section_title(ui, "New here?", {}, recent_.empty() ? 56 : 40);
  wrapped(ui, Face::body, Tone::ink2,
          "Start emulated controllers. They behave like real ones, and nothing can break.", width);
  gap(ui, 12);
  const bool other_is_primary =
      std::any_of(recent_.begin(), recent_.end(), [](const Recent& r) { return r.last_time; });
  ButtonOptions o;
  o.style = other_is_primary ? ButtonStyle::normal : ButtonStyle::primary;
  o.width = width;
  o.height = 40;
  if (button(ui, "connect/demo", "Start the demo", o).clicked) f.console.start_demo();
  gap(ui, 16);
  draw_point(ui, 1, "Hold a jog button. Let go, and the axis stops.", width);
  draw_point(ui, 2, "Press F5 to rehearse a program before metal moves.", width);
  draw_point(ui, 3, "Esc stops everything, at any time.", width);
}

// ---- below: controllers that are not found automatically

void Connect::draw_address(PageFrame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(100), at.y + ui.px(20), Face::body_bold, ui[Tone::ink], "By address");
  FieldOptions o;
  o.face = Face::code_field;
  o.height = 40;
  o.width = width - 104 - 96;
  const std::string_view model = device_types().empty() ? std::string_view("MODEL") : device_types()[0].model;
  const Path placeholder("{}@tcp:192.168.1.40:4001", model);
  o.placeholder = placeholder;
  o.error = !refused_.empty();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), at.y));
  const Field field = text_field(ui, "connect/address", "Address", address_, o);
  if (field.edited) refused_.clear();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - 88), at.y));
  ButtonOptions b;
  b.width = 88;
  b.height = 40;
  b.disabled = address_.empty() ? "Type an address first." : "";
  const bool clicked = button(ui, "connect/open", "Open", b).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(44)));
  if (!refused_.empty()) {
    wrapped(ui, Face::body, Tone::fault, refused_, width);
    show(ui, {"connect/refused", Kind::text, "Refused", refused_, {}, false, {}},
         {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
  }
  if ((field.entered || clicked) && !address_.empty()) open(f, address_);
  gap(ui, 4);
  if (card_.is_open(f) && !form_shown_) {
    ButtonOptions shows;
    shows.style = ButtonStyle::quiet;
    shows.icon_after = Icon::chevron_up;
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), ImGui::GetCursorScreenPos().y));
    if (button(ui, "connect/form/show", "By its parts, or search", shows).clicked) form_shown_ = true;
    return;
  }
  if (const std::string made = form_.draw(f, width); !made.empty()) open(f, made);
}

}  // namespace hw::panels
