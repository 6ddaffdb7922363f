// Draws the centre of the connection page: open controllers, plugged-in ports, and connections used before.
#include <algorithm>

#include "core/session/session.h"
#include "gui/shell/console.h"
#include "gui/shell/emulator_server.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/connect/connect.h"
#include "panels/connect/place_row.h"
#include "panels/connect/points.h"
#include "panels/connect/served_lines.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float doctor_width = 100, change_width = 128;

struct PortLook {
  Icon icon;
  Tone tone;
  std::string_view title;
};

PortLook look_of(const FoundPort& port) {
  switch (port.state) {
    case FoundPort::State::not_asked: return {Icon::ring, Tone::ink2, "Not identified yet"};
    case FoundPort::State::asking: return {Icon::clock, Tone::ink2, "Being identified"};
    case FoundPort::State::answers: return {Icon::check, Tone::ok, port.title};
    case FoundPort::State::busy: return {Icon::pause, Tone::warn, "In use"};
    case FoundPort::State::forbidden: return {Icon::warning, Tone::warn, "No permission"};
    case FoundPort::State::silent: return {Icon::cross, Tone::fault, "No answer"};
    case FoundPort::State::failed: break;
  }
  return {Icon::cross, Tone::fault, "Could not be opened"};
}

/// The row of an open controller.
PlaceRow row_of(const LinkHealth& link) {
  PlaceRow row;
  switch (link.state) {
    case LinkState::good: row = {Icon::check, Tone::ok, {}, {}, "open", Tone::ok}; break;
    case LinkState::late: row = {Icon::clock, Tone::warn, {}, {}, "late", Tone::warn}; break;
    case LinkState::connecting: row = {Icon::clock, Tone::ink2, {}, {}, "connecting", Tone::ink2}; break;
    case LinkState::lost:
    case LinkState::closed: row = {Icon::cross, Tone::fault, {}, {}, "no answer", Tone::fault}; break;
  }
  return row;
}

/// Joins facts on the stack: "ttyUSB0, 9600 baud, firmware 1.34, 11.2 ms".
template <std::size_t n>
std::string_view facts_of(const Tab& tab, char (&room)[n]) {
  const Address& address = address_of_all(tab);
  const LinkHealth& link = tab.now().link;
  char* out = room;
  const auto put = [&]<class... Args>(fmt::format_string<Args...> format, Args&&... args) {
    out = fmt::format_to_n(out, room + n - out, format, std::forward<Args>(args)...).out;
    out = std::min(out, room + n);
  };
  put("{}", address.emulated() ? std::string_view("emulator in this program") : short_place(address.where));
  if (address.where.empty() && !address.emulated()) put("{}", address.transport);
  if (const int rate = rate_of(tab); rate > 0) put(", {} baud", rate);
  if (!tab.now().identity.firmware.view().empty()) put(", firmware {}", tab.now().identity.firmware.view());
  if (link.connected() && link.round_trip > Duration::zero())
    put(", {:.1f} ms a question", seconds(link.round_trip) * 1e3);
  return {room, static_cast<std::size_t>(out - room)};
}

}  // namespace

/// The open tab of an address. Any emulator of the same model matches, because each start makes a new
/// emulator.
Tab* find_open(const Console& console, const Address& address) {
  for (const auto& tab : console.tabs())
    if (Console::is_face(*tab) && address_of_all(*tab) == address) return tab.get();
  return nullptr;
}

void Connect::draw_found(PageFrame& f, const Box& area) {
  Ui& ui = f.ui;
  const float width = area.width - 32;
  const float refused =
      refused_.empty() ? 0 : 8 + wrapped_height(ui, Face::body, refused_, ui.px(width)) / ui.scale;
  const bool folded = card_.is_open(f) && !form_shown_;
  if (!card_.is_open(f)) form_shown_ = false;
  const float below = 64 + (folded ? 40 : form_.height(f, width)) + refused;
  ImGui::SetCursorScreenPos(ui.px(area.x + 16, area.y));
  draw_found_title(f, width);
  ImGui::SetCursorScreenPos(ui.px(area.x, area.y + 57));
  begin_part(ui, "ports", ui.px(area.width) - ui.hair(), ui.px(area.height - below - 57), Tone::panel, 16);
  draw_rows(f, width);
  end_part();
  ImGui::SetCursorScreenPos(ui.px(area.x + 16, area.bottom() - below));
  group_line(ui, 0);
  gap(ui, 12);
  draw_address(f, width);
}

void Connect::draw_found_title(PageFrame& f, float width) {
  Ui& ui = f.ui;
  PortFinder& finder = f.console.ports();
  const std::size_t ports = finder.ports().size();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool has_last =
      std::any_of(recent_.begin(), recent_.end(), [](const Recent& r) { return r.last_time; });
  const bool all_open = std::all_of(recent_.begin(), recent_.end(), [&](const Recent& r) {
    return !r.last_time || find_open(f.console, r.address);
  });
  ButtonOptions all;
  all.style = ButtonStyle::primary;
  all.disabled = all_open ? "All of them are open." : "";
  ButtonOptions look;
  look.style = has_last ? ButtonStyle::quiet : ButtonStyle::normal;
  look.disabled = finder.busy() ? "The search is running." : "";
  float right = width;
  const auto stand = [&](float wide) {
    right -= wide;
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(right), at.y + ui.px(12)));
  };
  bool opens_all = false;
  if (has_last) {
    const std::string_view label = width > 480 ? "Open all as last time" : "Open all";
    stand(button_width(ui, label, all));
    opens_all = button(ui, "connect/open_all", label, all).clicked;
    right -= between;
  }
  stand(button_width(ui, "Look again", look));
  if (button(ui, "connect/look", "Look again", look).clicked) finder.look();
  const std::string_view title = width > 400 ? "Found on this computer" : "Found";
  draw_text_line(ui, at.x, at.x + ui.px(right - 8), at.y + ui.px(28), Face::title_bold, ui[Tone::ink], title);
  const float caption_left = std::ceil(text_width(ui, Face::title_bold, title)) + ui.px(12);
  const Path whole("{} {}. New cables appear by themselves.", ports, ports == 1 ? "port" : "ports");
  const Path brief("{} {}", ports, ports == 1 ? "port" : "ports");
  const float room = ui.px(right - 12) - caption_left;
  const std::string_view caption = finder.busy() ? std::string_view("Looking ...")
                                   : text_width(ui, Face::small, whole) <= room ? whole.view()
                                                                                : brief.view();
  if (text_width(ui, Face::small, caption) <= room)
    draw_text_line(ui, at.x + caption_left, at.x + ui.px(right - 8), at.y + ui.px(29), Face::small,
                   ui[Tone::ink2], caption);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(56)));
  group_line(ui, 0);
  if (opens_all) open_last_time(f);
}

/// Draws open controllers that have no port in this list, the ports, and connections used before that are not
/// visible now.
void Connect::draw_rows(PageFrame& f, float width) {
  Ui& ui = f.ui;
  const auto& ports = f.console.ports().ports();
  const auto is_port = [&](const Tab& tab) {
    return std::any_of(ports.begin(), ports.end(),
                       [&](const FoundPort& p) { return p.path == tab.address().where; });
  };
  const auto& tabs = f.console.tabs();
  for (std::size_t i = 0, shown = 0; i < tabs.size(); ++i)
    if (Console::is_face(*tabs[i]) && !is_port(*tabs[i])) draw_open(f, shown++, *tabs[i], width);
  for (std::size_t i = 0; i < ports.size(); ++i) draw_port(f, i, ports[i], width);
  bool any_place = false;
  for (std::size_t i = 0; i < recent_.size(); ++i) {
    const Recent& r = recent_[i];
    if (!r.understood || r.address.emulated() || r.address.transport == "serial" ||
        r.address.transport == "usb" || find_open(f.console, r.address))
      continue;
    any_place = true;
    draw_place(f, i, width);
  }
  if (!ports.empty() || any_place || !tabs.empty()) return;
  gap(ui, 16);
  wrapped(ui, Face::body, Tone::ink2,
          "Plug the cable in or start an emulator: no port is found yet. This list updates itself.", width);
}

void Connect::draw_open(PageFrame& f, std::size_t index, Tab& tab, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Tab& shown = tab.bus ? tab.bus->worst() : tab;
  PlaceRow row = row_of(shown.now().link);
  char room[160];
  row.title = tab.bus ? tab.bus->name() : tab.name();
  row.facts = facts_of(shown, room);
  row.chosen = card_.is_of(tab);
  const bool wide = width > 640, connected = shown.now().link.connected();
  const float show_width = wide ? 112 : 64;
  EmulatorServer* server = f.console.ports().server();
  // A bus is served as a whole, whichever member is chosen.
  const std::string& served_key = (tab.bus ? *tab.bus->members.front() : tab).settings.key;
  const bool serves = tab.emulated() && tab.session();
  const float own = serves ? serve_width : wide && !connected ? change_width : 0;
  const float used = show_width + between + doctor_width + (own > 0 ? between + own : 0);
  const float height = draw_place_row(ui, row, width, used);
  RowButtons buttons(ui, width);
  const bool shows = buttons.press(Path("connect/here/{}", index), "Show", show_width);
  ButtonOptions quiet;
  quiet.style = ButtonStyle::quiet;
  quiet.on = row.chosen;
  const bool doctor =
      buttons.press(Path("connect/here/{}/doctor", index), "Link doctor", doctor_width, quiet);
  quiet.on = false;
  bool changes = false;
  const ServedEmulator* served = nullptr;
  if (serves) {
    buttons.stand(serve_width);
    served = server ? server->find(served_key) : nullptr;
    const auto& options = address_of_all(tab).options;
    const auto wire = options.find("wire");
    const bool takes_time = wire != options.end() && wire->second == "real";
    // A board cannot be served: each program has a bus of its own.
    const std::string_view why_not =
        !server ? not_served_here
        : takes_time && !tab.catalog().can.window
            ? "Serve another emulator at the right: on a wire with byte times, this console would receive "
              "the other program's replies as its own."
            : std::string_view();
    if (serve_switch(ui, Path("connect/here/{}/serve", index), "Serve", served, why_not, serve_width)) {
      // On a bus, the session of any device leads to the shared wire.
      turn_serving(ui, *server, served_key, address_of_all(tab), tab.session());
      served = server->find(served_key);
    }
  } else if (own > 0) {
    changes = buttons.press(Path("connect/here/{}/change", index), "Change address", change_width, quiet);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
  if (served) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(place_mark), at.y + height));
    draw_served(ui, Path("connect/here/{}", index), *served, width - place_mark, true);
    ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y));
  }
  if (row.chosen) card_.draw(f, tab, width, own > 0 && !serves);
  group_line(ui, 0);
  if (doctor || changes) card_.toggle(f, tab, changes);
  if (shows) f.console.activate(tab);
}

/// Draws a network connection or a board. Only opening it shows whether it is there.
void Connect::draw_place(PageFrame& f, std::size_t index, float width) {
  Ui& ui = f.ui;
  const Recent& r = recent_[index];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  PlaceRow row;
  row.title = r.name;
  row.facts = r.place;
  row.state = "used before";
  const float wide = width > 640 ? 112 : 64;
  const float height = draw_place_row(ui, row, width, wide);
  RowButtons buttons(ui, width);
  const bool opens = buttons.press(Path("connect/place/{}", index), "Open", wide);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
  group_line(ui, 0);
  if (opens) open(f, std::string(r.entry.address));  // a copy: opening changes the list
}

void Connect::draw_port(PageFrame& f, std::size_t index, const FoundPort& port, float width) {
  Ui& ui = f.ui;
  const PortLook look = look_of(port);
  Tab* open_here = const_cast<Tab*>(f.console.open_at(port.path));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool answers = port.state == FoundPort::State::answers, wide = width > 640;
  const float main_width = wide ? 112 : 88, test_width = open_here ? doctor_width : 76;
  PlaceRow row;
  if (open_here) row = row_of(open_here->now().link);
  if (!open_here) row.mark = look.icon, row.tone = look.tone;
  char room[160], words[400];
  const std::string_view comma = port.hardware.empty() ? "" : ", ";
  const auto end =
      open_here
          ? fmt::format_to_n(words, sizeof words, "{}{}{}", facts_of(*open_here, room), comma, port.hardware)
          : fmt::format_to_n(words, sizeof words, "{}{}{}{}{}", port.path, comma, port.hardware,
                             port.sentence.empty() ? ""
                             : answers             ? ", "
                                                   : ". ",
                             port.sentence);
  const std::string_view facts(words, std::min(end.size, sizeof words));
  row.title = open_here ? (open_here->bus ? open_here->bus->name() : open_here->name()) : look.title;
  row.facts = facts;
  row.chosen = open_here && card_.is_of(*open_here);
  const bool changes_too = open_here && wide && !open_here->now().link.connected();
  const float height = draw_place_row(
      ui, row, width, main_width + between + test_width + (changes_too ? between + change_width : 0));
  const bool asking = port.state == FoundPort::State::asking;
  ButtonOptions action;
  action.disabled = asking && !open_here ? "The controller is being identified." : "";
  RowButtons buttons(ui, width);
  const std::string_view label = open_here ? "Show it" : answers ? "Connect" : "Identify";
  const bool acted = buttons.press(Path("connect/port/{}", index), label, main_width, action);
  ButtonOptions test;
  test.style = ButtonStyle::quiet;
  test.disabled = action.disabled;
  test.on = row.chosen;
  const bool tested = buttons.press(Path("connect/port/{}/test", index), open_here ? "Link doctor" : "Test",
                                    test_width, test);
  test.on = false;
  const bool changes = changes_too && buttons.press(Path("connect/port/{}/change", index), "Change address",
                                                    change_width, test);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
  if (row.chosen) card_.draw(f, *open_here, width, changes_too);
  if (!open_here && opened_path_ == port.path && !port.checks.empty())
    draw_checks(f, index, port, place_mark, width);
  group_line(ui, 0);
  if (open_here && (tested || changes)) return card_.toggle(f, *open_here, changes);
  if (acted && answers && !open_here) return open(f, std::string(port.address));
  if (acted && open_here) return f.console.activate(*open_here);
  if (acted || tested) {
    opened_path_ = port.path;
    f.console.ports().ask(std::string(port.path));
  }
}

void Connect::draw_checks(PageFrame& f, std::size_t index, const FoundPort& port, float left, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float cell = (width - left) / static_cast<float>(std::max<std::size_t>(1, port.checks.size()));
  for (std::size_t i = 0; i < port.checks.size(); ++i) {
    const FoundPort::Check& check = port.checks[i];
    using R = FoundPort::Check::Result;
    const Tone tone = check.result == R::good ? Tone::ok : check.result == R::bad ? Tone::fault : Tone::ink3;
    const Icon icon = check.result == R::good  ? Icon::check
                      : check.result == R::bad ? Icon::cross
                                               : Icon::ring_dot;
    const float x = at.x + ui.px(left + cell * static_cast<float>(i)), end = x + ui.px(cell - 8);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddCircle(ImVec2(x + ui.px(15), at.y + ui.px(24)), ui.px(15), ui[tone], 0, ui.px(2));
    draw_icon(list, icon, ImVec2(x + ui.px(15), at.y + ui.px(24)), ui.px(12), ui[tone]);
    draw_text_line(ui, x + ui.px(40), end, at.y + ui.px(16), Face::body_bold,
                   ui[check.result == R::bad ? Tone::fault : Tone::ink], check.what);
    draw_text_line(ui, x + ui.px(40), end, at.y + ui.px(34), Face::small, ui[Tone::ink2], check.found);
    const Path words("{}: {}",
                     check.result == R::good  ? "good"
                     : check.result == R::bad ? "bad"
                                              : "not reached",
                     check.found);
    show(ui, {Path("connect/port/{}/check/{}", index, i + 1), Kind::text, check.what, words, {}, false, {}},
         {ImVec2(x, at.y + ui.px(8)), ImVec2(end, at.y + ui.px(44))});
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), at.y + ui.px(56)));
  int number = 1;
  for (const std::string& advice : port.advice) {
    draw_point(ui, number++, advice, width - left);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), ImGui::GetCursorScreenPos().y));
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + ui.px(8)));
}

}  // namespace hw::panels
