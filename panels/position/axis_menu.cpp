#include "panels/position/axis_menu.h"

#include <imgui.h>

#include "core/device/backlash_moves.h"
#include "core/device/refusals.h"
#include "core/device/travel_check.h"
#include "gui/model/clearing.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/popup.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Draws "It stands at [     ]". Returns the text, once, when Enter was pressed.
bool set_field(Frame& f, std::string_view id, std::string_view label, std::string& typed,
               const DisplayUnit& unit, std::string_view disabled) {
  Ui& ui = f.ui;
  const ImVec2 at(ImGui::GetCursorScreenPos().x + ui.px(12), ImGui::GetCursorScreenPos().y + ui.px(4));
  draw_text_line(ui, at.x, at.x + ui.px(112), at.y + ui.px(16), Face::body,
                 ui[disabled.empty() ? Tone::ink : Tone::ink3], label);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(116), at.y));
  FieldOptions o;
  o.unit = unit.name;
  o.width = 132;
  o.right = true;
  o.disabled = disabled;
  const bool entered = text_field(ui, id, label, typed, o).entered;
  ImGui::SetCursorScreenPos(ImVec2(at.x - ui.px(12), at.y + ui.px(36)));
  return entered;
}

}  // namespace

void AxisMenu::draw(Frame& f, AxisId axis, const Touch& opener) {
  const AxisInfo& info = f.catalog.axes[axis.index];
  const std::optional<Clearing> clearing = clearing_of(f.catalog, f.now, axis);
  const float rows = 7.25f + (info.encoder ? 2.25f : 0) + (info.switchable ? 1 : 0) + (clearing ? 1.25f : 0);
  ImGui::PushID(axis.index);
  if (begin_popup(f.ui, "axis", opener, 288, rows)) {
    if (clearing) {
      const char* words = clearing->stops_all() ? "Stop, to clear its error"
                          : clearing->of_all    ? "Clear the flags of all axes"
                                                : "Clear its error";
      if (popup_row(f.ui, Path("dro/{}/menu/clear", info.name), words)) f.send(clearing->request);
      popup_line(f.ui);
    }
    draw_position_rows(f, axis);
    if (info.encoder) {
      popup_line(f.ui);
      draw_encoder_rows(f, axis);
    }
    popup_line(f.ui);
    draw_limit_rows(f, axis);
    draw_backlash_row(f, axis);
    if (info.switchable) {
      popup_line(f.ui);
      const bool on = f.now.axes[axis.index].enabled;
      if (popup_row(f.ui, Path("dro/{}/menu/power", info.name), on ? "Motor power off" : "Motor power on", {},
                    false, f.no_link()))
        f.send(intent::SetPower(axis.index, !on));
    }
    end_popup();
  }
  ImGui::PopID();
}

void AxisMenu::draw_position_rows(Frame& f, AxisId axis) {
  const std::string& name = f.catalog.axes[axis.index].name;
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const std::string_view why = f.tab.why_not_move();
  if (popup_row(f.ui, Path("dro/{}/copy", name), "Copy this number"))
    ImGui::SetClipboardText(
        std::string(format_position(f.now.axes[axis.index].position, unit).view()).c_str());
  if (popup_row(f.ui, Path("dro/{}/zero", name), "Set zero here", {}, false, why))
    f.send(intent::SetPosition(axis.index));
  if (!set_field(f, Path("dro/{}/set", name), "It stands at", position_, unit, why)) return;
  const auto value = parse_position(position_, unit);
  if (!value) return f.toast(Severity::fault, value.error().sentence());
  f.send(stands_at(f.now, axis, *value));
  position_.clear();
  ImGui::CloseCurrentPopup();
}

/// Draws "- limit [     ] Here  None", and the same for the other end.
void AxisMenu::draw_limit_rows(Frame& f, AxisId axis) {
  Ui& ui = f.ui;
  const std::string& name = f.catalog.axes[axis.index].name;
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const AxisState& state = f.now.axes[axis.index];
  Travel travel = f.tab.settings.profile.axes[axis.index].travel;
  const Travel before = travel;
  bool touched = false;
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    const ImVec2 at(ImGui::GetCursorScreenPos().x + ui.px(12), ImGui::GetCursorScreenPos().y + ui.px(4));
    draw_text_line(ui, at.x, at.x + ui.px(60), at.y + ui.px(16), Face::body, ui[Tone::ink],
                   sign == Sign::minus ? "\u2212 limit" : "+ limit");
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(60), at.y));
    bool& has = sign == Sign::minus ? travel.has_minus : travel.has_plus;
    Steps& end = sign == Sign::minus ? travel.minus : travel.plus;
    NumberOptions o;
    o.range.decimals = unit.real ? unit.decimals : 0;
    o.range.unit = unit.name;
    o.width = 108;
    o.sentence_below = false;
    o.tip =
        unit.per_step < 0
            ? sign == Sign::minus
                  ? "On the controller's \u2212 side, where these numbers grow. Jogs, moves and lists of the "
                    "console stay within it. Typed commands do not."
                  : "On the controller's + side, where these numbers fall. Jogs, moves and lists of the "
                    "console stay within it. Typed commands do not."
            : "Jogs, moves and lists of the console stay within it. Typed commands do not.";
    const std::optional<double> shown = has ? std::optional(from_steps(end, unit)) : std::nullopt;
    const NumberEvent typed = number_field(ui, Path("dro/{}/limit/{}", name, letter(sign)), "Limit", shown,
                                           limits_[sign == Sign::minus ? 0 : 1], o);
    if (typed.committed) touched = has = true, end = to_steps(typed.value, unit);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(172), at.y));
    ButtonOptions small{.style = ButtonStyle::quiet, .tip = "Sets the limit at the present position."};
    small.disabled = state.position_known && !state.trust.doubtful() ? "" : "Its position is not known.";
    small.width = 44;
    if (button(ui, Path("dro/{}/limit/{}/here", name, letter(sign)), "Here", small).clicked)
      touched = has = true, end = state.commanded();
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(216), at.y));
    small.tip = "No limit at this end.";
    small.disabled = has ? "" : "None is set.";
    if (button(ui, Path("dro/{}/limit/{}/none", name, letter(sign)), "None", small).clicked)
      touched = true, has = false;
    ImGui::SetCursorScreenPos(ImVec2(at.x - ui.px(12), at.y + ui.px(36)));
  }
  if (touched) f.withdraw(&limits_);
  if (travel == before) return;
  travel.in_counts = state.in_counts;
  const std::string why =
      describe_no_travel(f.catalog, intent::SetTravel(axis, travel), f.tab.settings.place_words());
  if (!why.empty()) return f.toast(Severity::fault, why, &limits_);
  for (NumberField& field : limits_) field.reset();
  f.tab.settings.profile.axes[axis.index].travel = travel;
  f.tab.settings.edited();
}

/// Draws "Backlash [     ] ends in +".
void AxisMenu::draw_backlash_row(Frame& f, AxisId axis) {
  Ui& ui = f.ui;
  const std::string& name = f.catalog.axes[axis.index].name;
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  Backlash backlash = f.tab.settings.profile.axes[axis.index].backlash;
  const Backlash before = backlash;
  const ImVec2 at(ImGui::GetCursorScreenPos().x + ui.px(12), ImGui::GetCursorScreenPos().y + ui.px(4));
  draw_text_line(ui, at.x, at.x + ui.px(60), at.y + ui.px(16), Face::body, ui[Tone::ink], "Backlash");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(68), at.y));
  NumberOptions o;
  o.range.decimals = unit.real ? unit.decimals : 0;
  o.range.unit = unit.name;
  o.width = 100;
  o.sentence_below = false;
  o.tip =
      "Moves of the console that would end in the other direction go this far past their target and come "
      "back. 0: off.";
  const double sense = unit.per_step < 0 ? -1 : 1;
  const NumberEvent typed = number_field(ui, Path("dro/{}/backlash", name), "Backlash",
                                         from_steps(backlash.by, unit) * sense, backlash_, o);
  if (typed.committed) backlash.by = to_steps(typed.value * sense, unit);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(172), at.y));
  ButtonOptions way{.style = ButtonStyle::quiet, .tip = "Direction in which every move ends, in steps."};
  way.disabled = backlash.by > Steps(0) ? "" : "Type the distance past the target first.";
  way.width = 88;
  const bool plus = backlash.last == Sign::plus;
  if (button(ui, Path("dro/{}/backlash/way", name), plus ? "Ends in +" : "Ends in \u2212", way).clicked)
    backlash.last = -backlash.last;
  ImGui::SetCursorScreenPos(ImVec2(at.x - ui.px(12), at.y + ui.px(36)));
  if (backlash == before) return;
  if (const std::string why =
          describe_no_backlash(intent::SetBacklash(axis, backlash), f.catalog.axes.size());
      !why.empty())
    return f.toast(Severity::fault, why);
  f.tab.settings.profile.axes[axis.index].backlash = backlash;
  f.tab.settings.edited();
}

void AxisMenu::draw_encoder_rows(Frame& f, AxisId axis) {
  const std::string& name = f.catalog.axes[axis.index].name;
  const DisplayUnit counts{"counts", 1, 0, false};
  if (popup_row(f.ui, Path("dro/{}/encoder/zero", name), "Encoder to zero", {}, false, f.no_link()))
    f.send(intent::SetEncoder(axis.index));
  if (!set_field(f, Path("dro/{}/encoder/set", name), "Encoder reads", encoder_, counts, f.no_link())) return;
  const auto value = parse_position(encoder_, counts);
  if (!value) return f.toast(Severity::fault, value.error().sentence());
  f.send(intent::SetEncoder(axis.index, *value));
  encoder_.clear();
  ImGui::CloseCurrentPopup();
}

}  // namespace hw::panels
