#include "panels/position/own_unit_form.h"

#include <cmath>
#include <utility>

#include <imgui.h>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float form_line = 36;

/// Places the parts of a line.
class FormLine {
 public:
  FormLine(Frame& f, AxisId axis)
      : f_(f), name_(f.catalog.axes[axis.index].name), at_(ImGui::GetCursorScreenPos()) {}
  ~FormLine() { ImGui::SetCursorScreenPos(ImVec2(at_.x, at_.y + f_.ui.px(form_line))); }
  FormLine(const FormLine&) = delete;
  FormLine& operator=(const FormLine&) = delete;

  void words(float x, std::string_view sentence) const {
    draw_text_line(f_.ui, at_.x + f_.ui.px(x), at_.x + f_.ui.px(x + 120), at_.y + f_.ui.px(16), Face::small,
                   f_.ui[Tone::ink2], sentence);
  }
  void go_to(float x) const { ImGui::SetCursorScreenPos(ImVec2(at_.x + f_.ui.px(x), at_.y)); }
  NumberEvent number(float x, float width, std::string_view id, std::string_view label, NumberField& field,
                     std::optional<double> shown, int decimals) const {
    go_to(x);
    NumberOptions o;
    o.range.decimals = decimals;
    o.width = width;
    o.sentence_below = false;
    return number_field(f_.ui, Path("dro/unit/own/{}/{}", name_, id), label, shown, field, o);
  }
  bool use(float x, std::string_view id, std::string_view why_not) const {
    go_to(x);
    ButtonOptions o{.disabled = why_not, .width = 52};
    return button(f_.ui, Path("dro/unit/own/{}/{}", name_, id), "Use", o).clicked;
  }

 private:
  Frame& f_;
  const std::string& name_;
  const ImVec2 at_;
};

/// Whether the controller counts the encoder, as with a closed loop; an encoder has no micro steps.
bool counts_encoder(const Frame& f, AxisId axis) {
  return f.catalog.axes[axis.index].servo || f.now.axes[axis.index].in_counts;
}

}  // namespace

bool OwnUnitForm::draw(Frame& f, AxisId axis, AxisProfile& profile) {
  forget_other_counts(counts_encoder(f, axis));
  const bool reported = draw_step(f, axis, profile.own_unit);
  const bool by_drive = draw_drive(f, axis, profile.own_unit);
  const bool measured = draw_points(f, axis, profile);
  if (by_drive || measured) step_.reset();
  return reported || by_drive || measured;
}

/// Clears the numbers when counts change, because steps per turn are not counts per turn.
void OwnUnitForm::forget_other_counts(bool counts) {
  if (std::exchange(counts_, counts) == counts) return;
  full_.reset(), micro_.reset();
  for (Point& point : points_) point.steps.reset();
}

/// Draws "One step is [0.0025] [mm]".
bool OwnUnitForm::draw_step(Frame& f, AxisId axis, OwnUnit& own) {
  const FormLine line(f, axis);
  line.words(0, counts_encoder(f, axis) ? "One count is" : "One step is");
  const auto shown = own.per_step != 0 ? std::optional(own.per_step) : std::nullopt;
  const NumberEvent typed = line.number(76, 132, "step", "One step is", step_, shown, 9);
  line.go_to(216);
  FieldOptions o;
  o.width = 84;
  o.tip = "mm, inch, \u00b0 or any other word.";
  const Field unit =
      text_field(f.ui, Path("dro/unit/own/{}/name", f.catalog.axes[axis.index].name), "Unit", own.name, o);
  const bool renamed = unit.entered || unit.left;
  if (!typed.committed || typed.value == 0) return renamed;
  own.per_step = std::abs(typed.value);
  return true;
}

bool OwnUnitForm::draw_drive(Frame& f, AxisId axis, OwnUnit& own) {
  const FormLine line(f, axis);
  const bool counts = counts_encoder(f, axis);
  line.words(0, counts ? "counts/turn" : "steps/turn");
  line.number(76, 60, "full", counts ? "Encoder counts per turn" : "Full steps per turn", full_, std::nullopt,
              0);
  if (!counts) {
    line.words(142, "micro");
    line.number(178, 52, "micro", "Microsteps per full step", micro_, std::nullopt, 0);
  }
  line.words(236, "gear");
  line.number(264, 52, "gear", "Motor turns per turn of the screw", gear_, std::nullopt, 6);
  line.words(322, "goes");
  line.number(354, 54, "travel", "Distance per turn", travel_, std::nullopt, 6);
  const double of_motor =
      counts ? full_.value().value_or(0) : full_.value().value_or(200) * micro_.value().value_or(1);
  const double steps = of_motor * gear_.value().value_or(1);
  const auto travel = travel_.value();
  const bool known = travel && *travel != 0 && steps > 0;
  const std::string_view why_not = counts
                                       ? "Type the encoder counts of one turn, and its distance."
                                       : "Type the distance of one turn. Steps per turn: 200 if left empty.";
  if (!line.use(412, "drive", known ? "" : why_not)) return false;
  own.per_step = std::abs(*travel) / steps;
  return true;
}

/// Draws two positions measured at the machine, each with the count at that moment.
bool OwnUnitForm::draw_points(Frame& f, AxisId axis, AxisProfile& profile) {
  const FormLine line(f, axis);
  line.words(0, "measured at");
  draw_point(f, axis, points_[0], "first", 76);
  line.words(228, "and at");
  draw_point(f, axis, points_[1], "second", 268);
  const auto from = points_[0].place.value(), to = points_[1].place.value();
  const bool taken = from && to && points_[0].steps && points_[1].steps;
  const Steps steps = taken ? *points_[1].steps - *points_[0].steps : Steps();
  const bool known = taken && steps != Steps(0) && *to != *from;
  if (!line.use(412, "measured",
                known ? "" : "Type the measured position and press Here. Then move the axis and repeat."))
    return false;
  const double per_step = (*to - *from) / static_cast<double>(steps.value);
  profile.own_unit.per_step = std::abs(per_step);
  profile.reversed = per_step < 0;
  return true;
}

void OwnUnitForm::draw_point(Frame& f, AxisId axis, Point& point, std::string_view id, float x) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string& name = f.catalog.axes[axis.index].name;
  const AxisState& state = f.now.axes[axis.index];
  NumberOptions o;
  o.range.decimals = 6;
  o.width = 84;
  o.sentence_below = false;
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(x), at.y));
  number_field(f.ui, Path("dro/unit/own/{}/{}", name, id), "Measured place", std::nullopt, point.place, o);
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(x + 88), at.y));
  ButtonOptions here{.tip = "The axis is there now.", .width = 50, .on = point.steps.has_value()};
  here.disabled = !state.position_known          ? "Its count is not known."
                  : f.now.axis_moves(axis.index) ? "It moves."
                                                 : "";
  if (button(f.ui, Path("dro/unit/own/{}/{}/here", name, id), "Here", here).clicked)
    point.steps = state.commanded();
  ImGui::SetCursorScreenPos(at);
}

}  // namespace hw::panels
