#pragma once
// One of Catalog::actions: its fields and the button that sends it. Ids: `action/ID/FIELD`, `action/ID/go`;
// in the row of an axis, where several have one, `action/ID/AXIS/FIELD`, `action/ID/AXIS/go`.
#include <optional>
#include <string>
#include <vector>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "gui/widgets/number_field.h"
#include "panels/control/shown_unit.h"
#include "panels/doubt_ways.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class ActionForm {
 public:
  ActionForm(const Catalog& catalog, int action);
  /// In the row of `axis`. `shared`: has the fields that are the same for all rows; it outlives this.
  ActionForm(const Catalog& catalog, int action, int axis, ActionForm& shared);
  /// At ImGui's cursor; leaves it below. `width` logical.
  void draw(gui::Frame& frame, float width);
  /// What it takes of so much width, without a refusal. Logical.
  [[nodiscard]] float height(float width) const;
  /// Only a button: several of them may share a line.
  [[nodiscard]] bool only_a_button() const { return fields_.empty(); }
  /// The button alone, at the cursor: one of a choice, or a lamp that switches to what it is not.
  void draw_choice(gui::Frame& frame, std::string_view label, bool lamp, bool chosen);
  /// The button alone, at the cursor.
  void draw_button(gui::Frame& frame, float width);
  [[nodiscard]] float button_width(const gui::Ui& ui) const;
  /// What became of it, if it was refused: on a card under the form that ends at the cursor.
  void draw_refusal(gui::Frame& frame, float width);
  [[nodiscard]] int action() const { return action_; }

  /// In a row at the cursor: the fields of that axis and the button, which says `verb`; `on` is what it
  /// switches to. With `lamp` the button is a lamp that is lit while it would switch off.
  void draw_in_row(gui::Frame& frame, std::string_view verb, bool on, bool lamp, float width);
  /// The field that is one for all rows, with its label before it. False: there is none.
  bool draw_shared(gui::Frame& frame, float label_width);
  [[nodiscard]] bool has_shared() const;
  static constexpr float row_height = 28;
  /// Of the fields of a row with a gap behind each, logical.
  [[nodiscard]] static float row_fields_width(const ActionInfo& action);
  /// The units of the fields of a row.
  void add_units(const gui::Frame& frame, UnitsOfRows& units) const;

  /// What stands in a field, in the action's own numbers; nothing while it does not do.
  [[nodiscard]] std::optional<std::int64_t> entered(std::size_t field) const;
  void put(std::size_t field, std::int64_t value);
  /// Without its label.
  void draw_bare_field(gui::Frame& frame, std::size_t field, float width, float height = 32);

 private:
  struct Field {
    gui::NumberField number;
    ShownUnit unit;  ///< of what stands in `number`
    int chosen = 0;
    std::vector<std::string_view> names;  ///< of the choices, in the catalog's memory
  };
  void fill_in();
  void draw_field(gui::Frame& frame, std::size_t field, float width);
  void send(gui::Frame& frame);
  [[nodiscard]] std::optional<std::int64_t> value(const ActionField& info, Field& field);
  void follow_unit(const gui::Frame& frame, std::size_t field);
  [[nodiscard]] int axis_of(const ActionField& info) const;
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame) const;

  const int action_;
  const ActionInfo& info_;
  const std::string path_;   ///< of its widgets
  const int row_axis_ = -1;  ///< in whose row it stands
  ActionForm* const shared_ = nullptr;
  bool switches_on_ = true;  ///< in a row: what is sent for the field "on"
  std::vector<Field> fields_;
  float least_ = 104;  ///< of a cell, so that no value of its lists is cut
  IntentId asked_ = 0;
  std::string refused_;
  RefusalCard card_;
  DoubtWays doubt_;
};

}  // namespace hw::panels
