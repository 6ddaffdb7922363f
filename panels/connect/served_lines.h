#pragma once
// The switch that serves an emulator to other programs, and where they find it.
#include <memory>
#include <string>
#include <string_view>

#include "gui/shell/emulator_server.h"
#include "gui/surface/ui.h"

namespace hw::panels {

constexpr float serve_width = 104;

/// At ImGui's cursor. What is served now; null: nothing. `session`: of the emulator that is open; null: one
/// of its own.
const gui::ServedEmulator* serve_switch(gui::Ui& ui, std::string_view id, std::string_view label,
                                        gui::EmulatorServer& server, const std::string& key,
                                        const Address& address, std::shared_ptr<Session> session,
                                        float width);
/// Places with a button that copies each, how many programs are there, or why it is not served. Ids begin
/// with `id`. `shared`: the console speaks on the same wire.
void draw_served(gui::Ui& ui, std::string_view id, const gui::ServedEmulator& served, float width,
                 bool shared);

}  // namespace hw::panels
