#include "panels/connect/connect.h"

#include <algorithm>

#include "core/device/registry.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

struct PortLook {
  Icon icon;
  Tone tone;
  std::string_view title;
};

PortLook look_of(const FoundPort& port) {
  switch (port.state) {
    case FoundPort::State::not_asked: return {Icon::ring, Tone::ink2, "Not asked yet"};
    case FoundPort::State::asking: return {Icon::clock, Tone::ink2, "Being asked"};
    case FoundPort::State::answers: return {Icon::check, Tone::ok, port.title};
    case FoundPort::State::busy: return {Icon::pause, Tone::warn, "In use"};
    case FoundPort::State::forbidden: return {Icon::warning, Tone::warn, "No permission"};
    case FoundPort::State::silent: return {Icon::cross, Tone::fault, "No answer"};
    case FoundPort::State::failed: break;
  }
  return {Icon::cross, Tone::fault, "Could not be opened"};
}

/// A numbered sentence.
void draw_point(Ui& ui, int number, std::string_view words, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text(ui, at, Face::body_bold, ui[Tone::ink2], Path("{}", number));
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(24), at.y));
  wrapped(ui, Face::body, Tone::ink2, words, width - 24);
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y));
  gap(ui, 4);
}

bool has_real_connection(Console& console) {
  return std::any_of(console.recent().list().begin(), console.recent().list().end(),
                     [](const RecentConnection& r) {
                       const auto address = Address::parse(r.address);
                       return address && !address->emulated();
                     });
}

}  // namespace

void Connect::draw(PageFrame& f) {
  Ui& ui = f.ui;
  const Box& a = f.area;
  if (f.tier == Tier::narrow) {
    begin_part(ui, "all", ui.px(a.width), ui.px(a.height), Tone::panel, 16);
    const float width = a.width - 32;
    draw_left(f, width);
    group_line(ui, 0);
    draw_ports(f, width);
    gap(ui, 16);
    draw_address(f, width);
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
    return {Mood::ok, fmt::format("{} {} on {} {}. Choose one, or start an emulator.", answering,
                                  answering == 1 ? "controller answers" : "controllers answer", ports.size(),
                                  ports.size() == 1 ? "port" : "ports")};
  if (console.ports().busy()) return {Mood::plain, "Looking which ports there are, and who answers."};
  if (const int open = console.faces(); open > 0)
    return {Mood::plain, fmt::format("{} open. Plug in another, type its address, or start an emulator.",
                                     open == 1 ? std::string("One controller is")
                                               : fmt::format("{} controllers are", open))};
  return {Mood::plain, "No controller is found yet. Plug one in, type its address, or start an emulator."};
}

void Connect::open(PageFrame& f, const std::string& address) {
  refused_.clear();
  if (auto opened = f.console.open(address); !opened) refused_ = opened.error().sentence();
}

// ---- left: what was used before

void Connect::draw_left(PageFrame& f, float width) {
  const bool newcomer = !has_real_connection(f.console);
  if (!f.console.recent().list().empty()) draw_recent(f, width);
  if (newcomer) draw_newcomer(f, width);
}

void Connect::draw_recent(PageFrame& f, float width) {
  Ui& ui = f.ui;
  section_title(ui, "Recent", {}, 56);
  const std::vector<RecentConnection> list = f.console.recent().list();  // opening one changes it
  const auto& ports = f.console.ports().ports();
  for (std::size_t i = 0; i < list.size(); ++i) {
    group_line(ui, 0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const auto address = Address::parse(list[i].address);
    const bool serial = address && address->transport == "serial";
    const bool here = serial && std::any_of(ports.begin(), ports.end(),
                                            [&](const FoundPort& p) { return p.path == address->where; });
    const bool gone = serial && !f.console.ports().busy() && !here && !ports.empty();
    const std::string name = !list[i].name.empty() ? list[i].name
                             : address             ? address->model
                                                   : list[i].address;
    const float right = at.x + ui.px(width - 104);
    draw_text_line(ui, at.x, right, at.y + ui.px(18), Face::body_bold, ui[Tone::ink], name);
    const float used = std::ceil(text_width(ui, Face::body_bold, name)) + ui.px(8);
    if (here || gone)
      draw_text_line(ui, at.x + used, right, at.y + ui.px(18), Face::small, ui[here ? Tone::ok : Tone::ink2],
                     here ? "here now" : "not plugged in");
    draw_text_line(ui, at.x, right, at.y + ui.px(37), Face::small, ui[Tone::ink2], list[i].address);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - 64), at.y + ui.px(12)));
    ButtonOptions o;
    o.width = 64;
    if (button(ui, Path("connect/recent/{}", i), "Open", o).clicked) open(f, list[i].address);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - 100), at.y + ui.px(12)));
    o = ButtonOptions();
    o.style = ButtonStyle::quiet;
    o.icon = Icon::cross;
    o.width = 32;
    o.tip = "Forget this connection";
    if (button(ui, Path("connect/recent/{}/forget", i), "", o).clicked)
      if (auto forgotten = f.console.recent().remove(list[i].address); !forgotten)
        f.toast(Mood::fault, forgotten.error().sentence());
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(56)));
  }
  group_line(ui, 0);
  gap(ui, 16);
}

void Connect::draw_newcomer(PageFrame& f, float width) {
  Ui& ui = f.ui;
  section_title(ui, "New here?", {}, f.console.recent().list().empty() ? 56 : 40);
  wrapped(ui, Face::body, Tone::ink2,
          "Start emulated controllers. They behave like the real ones, and nothing can break.", width);
  gap(ui, 12);
  ButtonOptions o;
  o.style = ButtonStyle::primary;
  o.width = width;
  o.height = 40;
  if (button(ui, "connect/demo", "Start the demo", o).clicked) f.console.start_demo();
  gap(ui, 16);
  draw_point(ui, 1, "Hold a jog button. Let go, and the axis stops.", width);
  draw_point(ui, 2, "Press F5 to rehearse a program before metal moves.", width);
  draw_point(ui, 3, "Esc stops everything, at any time.", width);
}

// ---- centre: what is plugged in

void Connect::draw_found(PageFrame& f, const Box& area) {
  Ui& ui = f.ui;
  const float width = area.width - 32;
  const float refused =
      refused_.empty() ? 0 : 8 + wrapped_height(ui, Face::body, refused_, ui.px(width)) / ui.scale;
  const float below = 64 + form_.height(f, width) + refused;
  ImGui::SetCursorScreenPos(ui.px(area.x, area.y));
  begin_part(ui, "ports", ui.px(area.width) - ui.hair(), ui.px(area.height - below), Tone::panel, 16);
  draw_ports(f, width);
  end_part();
  ImGui::SetCursorScreenPos(ui.px(area.x + 16, area.bottom() - below));
  group_line(ui, 0);
  gap(ui, 12);
  draw_address(f, width);
}

void Connect::draw_ports(PageFrame& f, float width) {
  Ui& ui = f.ui;
  PortFinder& finder = f.console.ports();
  const auto& ports = finder.ports();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(ui, "Found on this computer", {}, 56);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ButtonOptions look;
  look.disabled = finder.busy() ? "It is looking already." : "";
  const float look_width = button_width(ui, "Look again", look);
  const Path caption("{} {}. New cables appear by themselves.", ports.size(),
                     ports.size() == 1 ? "port" : "ports");
  if (width > 560)
    draw_text_right(ui, ImVec2(at.x + ui.px(width - look_width - 12), at.y + ui.px(20)), Face::small,
                    ui[Tone::ink2], finder.busy() ? std::string_view("Looking ...") : caption.view());
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - look_width), at.y + ui.px(12)));
  if (button(ui, "connect/look", "Look again", look).clicked) finder.look();
  ImGui::SetCursorScreenPos(after);
  group_line(ui, 0);
  for (std::size_t i = 0; i < ports.size(); ++i) draw_port(f, i, ports[i], width);
  if (!ports.empty()) return;
  gap(ui, 16);
  wrapped(ui, Face::body, Tone::ink2,
          "No port found. Plug the cable in: this list fills by itself. Or start an emulator.", width);
}

void Connect::draw_port(PageFrame& f, std::size_t index, const FoundPort& port, float width) {
  Ui& ui = f.ui;
  const PortLook look = look_of(port);
  const Tab* open_here = f.console.open_at(port.path);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ui.px(width);
  const bool answers = port.state == FoundPort::State::answers;
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(at.x + ui.px(6), at.y + ui.px(36)), ui.px(12),
            ui[look.tone]);
  const float left = at.x + ui.px(28), text_right = right - ui.px(204);
  const std::string title =
      open_here ? fmt::format("Open here, as {}", open_here->name()) : std::string(look.title);
  draw_text_line(ui, left, text_right, at.y + ui.px(25), Face::title_bold, ui[Tone::ink], title);
  std::string facts = port.path;
  if (!port.hardware.empty()) facts += ", " + port.hardware;
  if (!open_here && !port.sentence.empty()) facts += (answers ? ", " : ". ") + port.sentence;
  // Where it says what to do it may need a second line.
  const float facts_px = text_right - left;
  const float words = wrapped_height(ui, Face::body, facts, facts_px);
  ImGui::SetCursorScreenPos(ImVec2(left, at.y + ui.px(37)));
  wrapped(ui, Face::body, Tone::ink2, facts, facts_px / ui.scale);
  const float height = std::max(ui.px(72), ui.px(50) + words);
  const bool asking = port.state == FoundPort::State::asking;
  ButtonOptions action;
  action.width = 112;
  action.height = 40;
  action.disabled = asking ? "It is being asked." : "";
  ImGui::SetCursorScreenPos(ImVec2(right - ui.px(112), at.y + ui.px(16)));
  const std::string_view label = open_here ? "Show it" : answers ? "Connect" : "Ask again";
  const bool acted = button(ui, Path("connect/port/{}", index), label, action).clicked;
  ButtonOptions test;
  test.style = ButtonStyle::quiet;
  test.width = 76;
  test.height = 40;
  test.disabled = open_here ? "It is open here." : action.disabled;
  ImGui::SetCursorScreenPos(ImVec2(right - ui.px(196), at.y + ui.px(16)));
  const bool tested = button(ui, Path("connect/port/{}/test", index), "Test", test).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
  if (opened_path_ == port.path && !port.checks.empty()) draw_checks(f, index, port, 28, width);
  group_line(ui, 0);
  if (acted && answers && !open_here) return open(f, std::string(port.address));
  if (acted && open_here) return f.console.activate(const_cast<Tab&>(*open_here));
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
    const Path said("{}: {}",
                    check.result == R::good  ? "good"
                    : check.result == R::bad ? "bad"
                                             : "not reached",
                    check.found);
    show(ui, {Path("connect/port/{}/check/{}", index, i + 1), Kind::text, check.what, said, {}, false, {}},
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
  if (const std::string made = form_.draw(f, width); !made.empty()) open(f, made);
}

}  // namespace hw::panels
