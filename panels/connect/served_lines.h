#pragma once
// Draws the switch that serves an emulator to other programs, and the addresses where they find it.
#include <memory>
#include <string>
#include <string_view>

#include "gui/shell/emulator_server.h"
#include "gui/surface/ui.h"

namespace hw::panels {

constexpr float serve_width = 104;

/// Draws at ImGui's cursor. Returns true when the switch was pressed. `served`: the emulator as served now;
/// null: it is not served. `why_not`: why it cannot be served.
bool serve_switch(gui::Ui& ui, std::string_view id, std::string_view label, const gui::ServedEmulator* served,
                  std::string_view why_not, float width);
/// Starts or ends serving. `session` is that of the open emulator; null: a separate emulator is served.
void turn_serving(gui::Ui& ui, gui::EmulatorServer& server, const std::string& key, const Address& address,
                  std::shared_ptr<Session> session);
/// The sentence shown where the console cannot serve.
inline constexpr std::string_view not_served_here =
    "Use \"handwheel emulate\": this console runs in the time of a script, so it serves no emulator.";
/// Draws each address with a copy button, and the number of connected programs, or why the emulator is not
/// served. Ids begin with `id`. `shared`: the console uses the same wire.
void draw_served(gui::Ui& ui, std::string_view id, const gui::ServedEmulator& served, float width,
                 bool shared);

}  // namespace hw::panels
