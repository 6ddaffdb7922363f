// The right column of the connection page: emulators to start.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/registry.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/connect/connect.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float option_row = 40;

/// Without the maker. Of a board its options say which one it is.
std::string_view title_of(const Catalog& c) {
  return c.can.window ? std::string_view(c.short_name)
                      : std::string_view(c.name).substr(c.name.rfind(' ') + 1);
}

}  // namespace

void Connect::draw_emulators(PageFrame& f, float width) {
  Ui& ui = f.ui;
  section_title(ui, "Emulators", {}, 56);
  for (const DeviceType& type : device_types()) {
    const auto made = type.make_catalog({});
    if (!made) continue;
    const Catalog& catalog = *made;
    group_line(ui, 0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(24), Face::title_bold, ui[Tone::ink],
                   title_of(catalog));
    ImGui::SetCursorScreenPos(
        ImVec2(at.x + ui.px(width) - badge_width(ui, Icon::emulated, "EMULATED"), at.y + ui.px(14)));
    emulated_badge(ui, Path("connect/emulator/{}/badge", type.model));
    draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(48), Face::small, ui[Tone::ink2],
                   catalog.summary);
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(64)));
    std::string address = fmt::format("{}@emulator", type.model);
    float below = 64;  // each option in a line of its own
    for (const OptionInfo& option : catalog.options) {
      ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(below)));
      below += option_row;
      auto choice = std::find_if(choices_.begin(), choices_.end(), [&](const Choice& c) {
        return c.model == type.model && c.key == option.key;
      });
      if (choice == choices_.end()) {
        choices_.push_back({std::string(type.model), option.key, 0});
        choice = choices_.end() - 1;
      }
      std::vector<std::string_view> names;
      for (const auto& [value, label] : option.choices) names.push_back(label);
      DropdownOptions o;
      if (catalog.options.size() > 1)  // one under the other, the first beside Start
        o.width = below > 64 + option_row ? width : width - 72;
      const int picked = dropdown(ui, Path("connect/emulator/{}/{}", type.model, option.key), option.key,
                                  names, choice->chosen, o);
      if (picked >= 0) choice->chosen = picked;
      if (choice->chosen > 0)
        address +=
            fmt::format(",{}={}", option.key, option.choices[static_cast<std::size_t>(choice->chosen)].first);
    }
    ButtonOptions start;
    start.width = 64;
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - 64), at.y + ui.px(64)));
    if (button(ui, Path("connect/emulator/{}", type.model), "Start", start).clicked) open(f, address);
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(std::max(64 + option_row, below) + 8)));
  }
  group_line(ui, 0);
  gap(ui, 16);
  text(ui, Face::body_bold, Tone::ink, "For your own programs");
  gap(ui, 4);
  wrapped(ui, Face::small, Tone::ink2,
          "Each emulator can also serve a port, so that EPICS, Python or LabVIEW talk to it:", width);
  gap(ui, 4);
  if (!device_types().empty())
    wrapped(ui, Face::code_time, Tone::ink,
            fmt::format("handwheel emulate {}\n  --tcp 127.0.0.1:4001", device_types()[0].model), width);
}

}  // namespace hw::panels
