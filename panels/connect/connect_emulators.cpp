// Draws the right column of the connection page: emulators to start, and to serve to other programs.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "gui/shell/console.h"
#include "gui/shell/emulator_server.h"
#include "gui/widgets/area.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/connect/connect.h"
#include "panels/connect/served_lines.h"
#include "panels/names.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float option_row = 36, start_width = 64;

/// The title without the maker. A board is identified by its options.
std::string_view title_of(const Catalog& c) {
  return c.can.window ? std::string_view(c.short_name)
                      : std::string_view(c.name).substr(c.name.rfind(' ') + 1);
}

}  // namespace

void Connect::draw_emulators(PageFrame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(ui, "Emulators", {}, 56);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(
      ImVec2(at.x + ui.px(width) - badge_width(ui, Icon::emulated, "EMULATED"), at.y + ui.px(18)));
  emulated_badge(ui, "connect/emulator/badge");
  ImGui::SetCursorScreenPos(after);
  for (const Catalog& catalog : catalogs_.all()) {
    group_line(ui, 0);
    draw_emulator(f, catalog, width);
  }
  group_line(ui, 0);
  gap(ui, 12);
  text(ui, Face::body_bold, Tone::ink, "For your own programs");
  gap(ui, 4);
  wrapped(ui, Face::small, Tone::ink2,
          f.console.ports().server()
              ? "A served emulator answers EPICS, Python or LabVIEW as the real one would. It ends with "
                "Handwheel; for one that continues, use \"handwheel emulate\"."
              : not_served_here,
          width);
  gap(ui, 12);
}

void Connect::draw_emulator(PageFrame& f, const Catalog& catalog, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(20), Face::title_bold, ui[Tone::ink],
                 title_of(catalog));
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(40), Face::small, ui[Tone::ink2],
                 catalog.summary);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(52)));
  const std::string& address = draw_options(f, catalog, width);
  const float below = ImGui::GetCursorScreenPos().y;
  EmulatorServer* server = f.console.ports().server();
  const ServedEmulator* served = server ? server->find(catalog.model) : nullptr;
  const bool is_served = served && !served->tcp.empty();
  ButtonOptions start;
  start.width = start_width;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - start_width), at.y + ui.px(52)));
  const bool starts =
      button(ui, Path("connect/emulator/{}", catalog.model), is_served ? "Open" : "Start", start).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x, below));
  if (serve_switch(ui, Path("connect/emulator/{}/serve", catalog.model),
                   width > 220 ? "Serve to other programs" : "Serve to others", served,
                   server ? std::string_view() : not_served_here, width)) {
    turn_serving(ui, *server, catalog.model, Address::parse(address).value_or(Address()), nullptr);
    served = server->find(catalog.model);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, below + ui.px(36)));
  if (served) draw_served(ui, Path("connect/emulator/{}", catalog.model), *served, width, false);
  gap(ui, 8);
  if (!starts) return;
  open(f, is_served ? fmt::format("{}@{}:{}", catalog.model, catalog.can.window ? "bus" : "tcp", served->tcp)
                    : address);
}

/// Draws the chosen options below each other, the first beside Start. Returns the resulting address.
const std::string& Connect::draw_options(PageFrame& f, const Catalog& catalog, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  emulator_address_.assign(catalog.model).append("@emulator");
  float below = 0;
  for (const OptionInfo& option : catalog.options) {
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(below)));
    auto choice = std::find_if(choices_.begin(), choices_.end(), [&](const Choice& c) {
      return c.model == catalog.model && c.key == option.key;
    });
    if (choice == choices_.end()) {
      choices_.push_back({catalog.model, option.key, 0});
      choice = choices_.end() - 1;
    }
    Names names;
    for (const auto& [value, label] : option.choices) names.add(label);
    DropdownOptions o;
    o.width = below > 0 ? width : width - start_width - 8;
    const int picked = dropdown(ui, Path("connect/emulator/{}/{}", catalog.model, option.key), option.key,
                                names, choice->chosen, o);
    if (picked >= 0) choice->chosen = picked;
    if (choice->chosen > 0)
      fmt::format_to(std::back_inserter(emulator_address_), ",{}={}", option.key,
                     option.choices[static_cast<std::size_t>(choice->chosen)].first);
    below += option_row;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(std::max(option_row, below))));
  return emulator_address_;
}

}  // namespace hw::panels
