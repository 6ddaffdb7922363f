#include "panels/position/unit_chooser.h"

#include <vector>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/popup.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr std::string_view own_conversion = "another conversion";

/// The load of the axis in the profile; empty: none, or incomplete.
std::string_view unit_chosen(const Frame& f, std::size_t axis) {
  const AxisProfile& request = f.tab.settings.profile.axes[axis];
  if (request.unit_choice == own_unit_choice && request.own_unit.per_step != 0) return request.own_unit.name;
  for (const UnitChoice& choice : f.catalog.units)
    if (choice.label == request.unit_choice) return choice.unit;
  return {};
}

/// The common real unit of all axes that have one: "mm"; "real units" if they differ; empty if none has one.
std::string_view real_unit(const Frame& f) {
  std::string_view found;
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const std::string_view unit = unit_chosen(f, i);
    if (unit.empty()) continue;
    if (!found.empty() && found != unit) return "real units";
    found = unit;
  }
  return found;
}

/// The controller's own unit.
std::string own_unit(const Frame& f) {
  const std::string unit = counted_unit(f.catalog, f.now, f.catalog.step_word);
  return unit.empty() ? f.catalog.step_word : unit;
}

bool shows_real(const Frame& f) {
  return !f.tab.settings.profile.unit.empty() && f.tab.settings.profile.unit != f.catalog.step_word;
}

ButtonOptions opener_options() {
  ButtonOptions o;
  o.icon_after = Icon::chevron_down;
  o.tip = "Steps or real units";
  return o;
}

void use(Frame& f, std::string unit) {
  f.tab.settings.profile.unit = std::move(unit);
  f.tab.settings.edited();
}

}  // namespace

// A closed-loop axis counts in other steps than an open-loop one.
std::string_view shown_unit(const Frame& f) {
  const std::string_view real = real_unit(f);
  if (shows_real(f) && !real.empty()) return real;
  const std::string& first = f.tab.settings.unit(AxisId{0}).name;
  for (std::size_t i = 1; i < f.catalog.axes.size(); ++i)
    if (f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(i)}).name != first) return f.catalog.step_word;
  return first;
}

float unit_chooser_width(const Frame& f) {
  const float natural = button_width(f.ui, shown_unit(f), opener_options());
  return f.tier == Tier::medium ? natural - 8 : natural;  // beside a title and a badge
}

void UnitChooser::draw_axis(Frame& f, std::size_t i) {
  const AxisInfo& axis = f.catalog.axes[i];
  AxisProfile& request = f.tab.settings.profile.axes[i];
  const std::string counted = counted_unit(f.catalog, f.now, f.catalog.step_word, static_cast<int>(i));
  std::vector<std::string_view> names{counted};
  int chosen = 0;
  for (const UnitChoice& choice : f.catalog.units) {
    names.push_back(choice.label);
    if (choice.label == request.unit_choice) chosen = static_cast<int>(names.size()) - 1;
  }
  names.push_back(own_conversion);
  if (request.unit_choice == own_unit_choice) chosen = static_cast<int>(names.size()) - 1;
  gap(f.ui, 6);
  text(f.ui, Face::small, Tone::ink2, axis.description.empty() ? axis.name : axis.description);
  DropdownOptions o;
  o.width = 336;
  const int picked = dropdown(f.ui, Path("dro/unit/axis/{}", axis.name), axis.description, names, chosen, o);
  if (picked >= 0) {
    const bool own = picked == static_cast<int>(names.size()) - 1;
    request.unit_choice = picked == 0 ? std::string()
                          : own       ? std::string(own_unit_choice)
                                      : std::string(names[static_cast<std::size_t>(picked)]);
    use(f, "real");
  }
  if (request.unit_choice.empty()) return;
  ImGui::SameLine();
  ToggleOptions toggle;
  toggle.state = request.reversed ? ToggleState::on : ToggleState::off;
  toggle.width = 116;
  toggle.tip = "The real unit counts opposite to the steps.";
  if (toggle_lamp(f.ui, Path("dro/unit/reversed/{}", axis.name), "reversed", toggle).clicked) {
    request.reversed = !request.reversed;
    use(f, f.tab.settings.profile.unit);
  }
  if (request.unit_choice != own_unit_choice) return;
  gap(f.ui, 4);
  if (own_[i].draw(f, AxisId{static_cast<std::uint8_t>(i)}, request)) use(f, "real");
}

void UnitChooser::draw(Frame& f) {
  Ui& ui = f.ui;
  ButtonOptions opener = opener_options();
  opener.width = unit_chooser_width(f);
  const Touch t = button(ui, "dro/unit", shown_unit(f), opener);
  float rows = 3.1f + 1.9f * static_cast<float>(f.catalog.axes.size());
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i)
    if (f.tab.settings.profile.axes[i].unit_choice == own_unit_choice) rows += OwnUnitForm::rows;
  if (!begin_popup(ui, "unit", t, 492, rows)) return;
  const std::string_view real = real_unit(f);
  if (popup_row(ui, "dro/unit/steps", own_unit(f), "as the controller counts", !shows_real(f)))
    use(f, f.catalog.step_word);
  if (popup_row(ui, "dro/unit/real", real.empty() ? "real units" : real, {}, shows_real(f) && !real.empty(),
                real.empty() ? "First choose the mechanics of an axis below." : ""))
    use(f, "real");
  popup_line(ui);
  ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x + ui.px(12), ImGui::GetCursorScreenPos().y));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.px(8, 4));
  ImGui::BeginGroup();
  gap(ui, 8);
  text(ui, Face::body_bold, Tone::ink, "Mechanics of each axis");
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) draw_axis(f, i);
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  end_popup();
}

}  // namespace hw::panels
