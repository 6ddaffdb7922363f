#include "panels/connect/served_lines.h"

#include <algorithm>

#include "gui/widgets/button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

bool serve_switch(Ui& ui, std::string_view id, std::string_view label, const ServedEmulator* served,
                  std::string_view why_not, float width) {
  ToggleOptions o;
  o.width = width;
  o.tip = "Other programs on this computer reach this emulator by TCP, or as a serial port.";
  o.disabled = why_not;
  o.state = !served                    ? ToggleState::off
            : !served->trouble.empty() ? ToggleState::refused
            : served->tcp.empty()      ? ToggleState::sending
                                       : ToggleState::on;
  return toggle_lamp(ui, id, label, o).clicked;
}

void turn_serving(Ui& ui, EmulatorServer& server, const std::string& key, const Address& address,
                  std::shared_ptr<Session> session) {
  if (server.find(key))
    server.end(key);
  else
    server.serve(key, address, std::move(session));
  ui.wake_in(0);
}

namespace {

/// Draws an address in monospace, with Copy at its right.
void draw_served_place(Ui& ui, std::string_view id, std::string_view kind, const std::string& place,
                       float width) {
  constexpr float copy_width = 56;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Path words("{} {}", kind, place);
  draw_text_line(ui, at.x, at.x + ui.px(width - copy_width - 4), at.y + ui.px(12), Face::code_time,
                 ui[Tone::ink], words);
  show(ui, {Path("{}/{}", id, kind), Kind::text, kind, place, {}, false, {}},
       {at, ImVec2(at.x + ui.px(width - copy_width), at.y + ui.px(24))});
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.width = copy_width;
  o.height = 28;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - copy_width), at.y - ui.px(2)));
  if (button(ui, Path("{}/{}/copy", id, kind), "Copy", o).clicked) ImGui::SetClipboardText(place.c_str());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(26)));
}

}  // namespace

void draw_served(Ui& ui, std::string_view id, const ServedEmulator& served, float width, bool shared) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto sentence = [&](Tone tone, std::string_view words) {
    wrapped(ui, Face::small, tone, words, width);
    ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + ui.px(4)));
  };
  if (!served.trouble.empty()) {
    show(ui, {Path("{}/serve/trouble", id), Kind::text, "Trouble", served.trouble, {}, false, {}},
         {at, ImVec2(at.x + ui.px(width), at.y + ui.px(16))});
    return sentence(Tone::fault, served.trouble);
  }
  if (served.tcp.empty()) return sentence(Tone::ink2, "Starting ...");
  draw_served_place(ui, id, "tcp", served.tcp, width);
  if (!served.terminal.empty()) draw_served_place(ui, id, "port", served.terminal, width);
  const Path clients(
      "{} {} connected by TCP.{}", served.clients, served.clients == 1 ? "program is" : "programs are",
      shared ? " It shares the wire with this console, and also receives the console's replies." : "");
  show(ui, {Path("{}/clients", id), Kind::text, "Clients", clients, {}, false, {}},
       {ImGui::GetCursorScreenPos(), ImVec2(at.x + ui.px(width), ImGui::GetCursorScreenPos().y + ui.px(16))});
  sentence(Tone::ink2, clients);
}

}  // namespace hw::panels
