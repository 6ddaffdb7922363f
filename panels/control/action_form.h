#pragma once
// The form of an action of Catalog::actions: its fields and the button that sends it. Ids: `action/ID/FIELD`,
// `action/ID/go`; in the row of an axis `action/ID/AXIS/FIELD`, `action/ID/AXIS/go`.
#include <optional>
#include <string>
#include <vector>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "gui/widgets/number_field.h"
#include "panels/control/shown_unit.h"
#include "panels/doubt_remedies.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class ActionForm {
 public:
  ActionForm(const Catalog& catalog, int action);
  /// A form in the row of `axis`. `shared` has the fields common to all rows; it must outlive this form.
  ActionForm(const Catalog& catalog, int action, int axis, ActionForm& shared);
  /// Draws at ImGui's cursor and leaves it below. `width` is logical.
  void draw(gui::Frame& frame, float width);
  /// The height at this width, without a refusal. Logical.
  [[nodiscard]] float height(float width) const;
  /// Whether the form has only a button, so that several forms may share a line.
  [[nodiscard]] bool only_a_button() const { return fields_.empty(); }
  /// Draws only the button at the cursor, as a part of a choice, or as a lamp that switches to the opposite.
  void draw_choice(gui::Frame& frame, std::string_view label, bool lamp, bool chosen);
  /// Draws only the button, at the cursor.
  void draw_button(gui::Frame& frame, float width);
  [[nodiscard]] float button_width(const gui::Ui& ui) const;
  /// Draws a refusal as a card below the form that ends at the cursor.
  void draw_refusal(gui::Frame& frame, float width);
  [[nodiscard]] int action() const { return action_; }

  /// Draws in a row at the cursor: the fields of the axis, and the button labelled `verb`. `on`: the state to
  /// which it switches. `lamp`: the button is a lamp, lit while a press would switch off.
  void draw_in_row(gui::Frame& frame, std::string_view verb, bool on, bool lamp, float width);
  /// Whether the form has a field common to all rows.
  [[nodiscard]] bool has_shared() const;
  /// Draws that field after its label.
  void draw_shared(gui::Frame& frame, float label_width);
  static constexpr float row_height = 28;
  /// Width of the fields of a row, each with a gap after it, logical.
  [[nodiscard]] static float row_fields_width(const ActionInfo& action);
  /// Adds the units of the fields of a row.
  void add_units(const gui::Frame& frame, UnitsOfRows& units) const;

  /// The content of a field, in the action's own numbers; nullopt while it is invalid.
  [[nodiscard]] std::optional<std::int64_t> entered(std::size_t field) const;
  void put(std::size_t field, std::int64_t value);
  /// Draws a field without its label.
  void draw_bare_field(gui::Frame& frame, std::size_t field, float width, float height = 32);

 private:
  struct Field {
    gui::NumberField number;
    ShownUnit unit;  ///< unit of the content of `number`
    int chosen = 0;
    std::vector<std::string_view> names;  ///< names of the choices, in the catalog's memory
  };
  void fill_in();
  void draw_field(gui::Frame& frame, std::size_t field, float width);
  void send(gui::Frame& frame);
  [[nodiscard]] std::optional<std::int64_t> value(const ActionField& info, Field& field);
  void follow_unit(const gui::Frame& frame, std::size_t field);
  [[nodiscard]] int axis_of(const ActionField& info) const;
  /// The field that names the position past a limit; nullopt: the position follows from several fields.
  [[nodiscard]] std::optional<std::size_t> field_past_limit() const;
  void draw_refusal_card(gui::Frame& frame, const gui::Rect& form);
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame) const;

  const int action_;
  const ActionInfo& info_;
  const std::string path_;   ///< start of the ids of its widgets
  const int row_axis_ = -1;  ///< axis of its row
  ActionForm* const shared_ = nullptr;
  bool switches_on_ = true;  ///< in a row: value sent for the field "on"
  std::vector<Field> fields_;
  float least_ = 104;  ///< least width of a cell, so that no list value is cut
  IntentId asked_ = 0;
  std::string refused_;
  std::optional<PastTravel> past_;  ///< why
  RefusalCard card_;
  DoubtRemedies doubt_;
};

}  // namespace hw::panels
