#pragma once
// Draws the form of a step: a line for each field, from its description in core/sequence/fields.h.
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "core/base/fixed_text.h"
#include "gui/widgets/number_field.h"
#include "panels/blocks/step_form.h"

namespace hw::panels {

/// A line for each field: its label, and the control for its value.
class FieldLines {
 public:
  using Numbers = std::map<std::string, gui::NumberField, std::less<>>;
  FieldLines(gui::Frame& frame, const EditedStep& step, const sequence::Step::Body& typed, Numbers& numbers,
             float width)
      : f_(frame),
        path_(step.path),
        of_(step.of),
        step_(step),
        typed_(typed),
        numbers_(numbers),
        width_(width) {}

  [[nodiscard]] bool changed() const { return changed_; }
  /// Whether the refusal was not shown beside a field.
  [[nodiscard]] bool refusal_left() const { return step_.refused && !refusal_shown_; }
  [[nodiscard]] std::string& problem() { return problem_; }
  /// Allows texts of several lines.
  void with_several_lines() { several_lines_ = true; }

  void number(std::string_view key, double& value);
  void needed(std::string_view key, double& value) { number(key, value); }
  void positive(std::string_view key, double& value) { put_number(key, value, 0); }
  void count(std::string_view key, int& value) { whole(key, value, 0, 1'000'000); }
  void line(std::string_view key, int& value) { whole(key, value, 0, 64); }
  void line_or_all(std::string_view key, int& value);
  void word(std::string_view key, std::uint32_t& value);
  void flag(std::string_view key, bool& value);
  void text(std::string_view key, std::string& value);
  void axis(std::string_view key, int& value) { choose_axis(key, value, false); }
  void axis_or_all(std::string_view key, int& value) { choose_axis(key, value, true); }
  void sign(std::string_view key, Sign& value);
  void choice(std::string_view key, sequence::MoveOnInput::Kind& value,
              std::span<const std::string_view> names);
  /// An empty field means that the axis does not move. More than two axes share lines.
  void places(std::string_view key, sequence::Places& value);
  /// A controller with two axes needs no choice of plane.
  void plane(std::string_view key, sequence::Plane& value);
  /// Draws a line for each stair, or two lines if it does not fit.
  void stairs(std::string_view key, std::vector<sequence::SpeedStairs::Stair>& value);
  void own(sequence::OwnSpeeds& value);
  void steps(std::string_view, sequence::StepList&) {}  // steps have rows of their own

 private:
  /// Whether the step is a move on an input: to a place (`to_place`), else without end or to its home.
  [[nodiscard]] bool goes_some_way(bool to_place) const {
    const auto* some = std::get_if<sequence::MoveOnInput>(&typed_);
    return some && (some->kind == sequence::MoveOnInput::Kind::move) == to_place;
  }
  [[nodiscard]] FixedText<64> label(std::string_view key) const;
  /// The axis that is "x" or "y" in the plane.
  [[nodiscard]] int axis_of(std::string_view key) const;
  /// The scale of this field's number.
  [[nodiscard]] const sequence::Scale& scale_of(std::string_view key) const;
  ImVec2 begin(std::string_view key, const std::string* of_axis = nullptr);
  ImVec2 begin_at(ImVec2 at, std::string_view words, float width);
  ImVec2 begin_without_label();
  void end(ImVec2 field);
  /// Draws the refusal beside the field, in the rest of the line.
  void show_refusal(ImVec2 field, float width, const FixedText<64>& name, std::string_view why);
  [[nodiscard]] std::size_t places_in_line() const;
  void place(std::string_view key, std::size_t a, std::optional<double>& value, float width, bool alone);
  [[nodiscard]] static gui::NumberRange place_range(const sequence::Scale& scale);
  [[nodiscard]] static std::string why_no_place(const gui::NumberField& state, const sequence::Scale& scale);
  /// Draws below the line a typing error, if several fields share the line, and the controller's refusal.
  void show_place_refused(std::string_view key, std::size_t a, std::optional<double>& value);
  [[nodiscard]] bool is_refused(std::string_view key) const;
  /// Draws the controller's refusal below the field, because the number itself is valid.
  void show_refused(std::string_view key);
  /// Draws a button below the field that offers the nearest allowed number. Returns true when it was pressed.
  bool offers_nearest(std::string_view key, const sequence::Scale& scale, double& nearest);
  /// Draws a field for each line of the text. Enter adds a field; an empty field disappears when it loses the
  /// focus.
  void lines(std::string_view key, std::string& value);
  gui::NumberField& kept(std::string_view id, std::optional<double> value, const sequence::Scale& scale = {});
  template <class Value>
  bool field(std::string_view id, std::string_view key, Value& value, gui::NumberRange range, float width);
  /// Speeds have no direction, so their unit has no sign either.
  void put_number(std::string_view key, double& value, double low);
  void stair_number(std::string_view below, std::string_view key, double& value, double low, float width);
  /// Draws the angle, and the direction as seen.
  void turn(std::string_view key, double& value);
  void whole(std::string_view key, int& value, double low, double high);
  void choose_axis(std::string_view key, int& value, bool or_all);

  gui::Frame& f_;
  std::string_view path_;
  const sequence::Sequence& of_;
  const EditedStep& step_;
  const sequence::Step::Body& typed_;
  Numbers& numbers_;
  float width_;
  bool changed_ = false, all_lines_ = false, several_lines_ = false, refusal_shown_ = false;
  std::string problem_;
};

/// Draws below the fields why the controller refuses the step.
void draw_step_refusal(gui::Frame& frame, const EditedStep& step, float width);

}  // namespace hw::panels
