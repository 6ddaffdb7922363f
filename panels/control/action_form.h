#pragma once
// One of Catalog::actions: its fields and the button that sends it. Ids: `action/ID/FIELD`, `action/ID/go`.
#include <optional>
#include <string>
#include <vector>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "gui/widgets/number_field.h"
#include "panels/doubt_ways.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class ActionForm {
 public:
  ActionForm(const Catalog& catalog, int action);
  /// At ImGui's cursor; leaves it below. `width` logical.
  void draw(gui::Frame& frame, float width);
  /// What it takes of so much width, without a refusal. Logical.
  [[nodiscard]] float height(float width) const;
  /// Only a button: several of them may share a line.
  [[nodiscard]] bool only_a_button() const { return fields_.empty(); }
  /// The button alone, at the cursor.
  void draw_button(gui::Frame& frame, float width);
  [[nodiscard]] float button_width(const gui::Ui& ui) const;
  /// What became of it, if it was refused: on a card under the form that ends at the cursor.
  void draw_refusal(gui::Frame& frame, float width);
  [[nodiscard]] int action() const { return action_; }

 private:
  struct Field {
    gui::NumberField number;
    int chosen = 0;
    std::vector<std::string_view> names;  ///< of the choices, in the catalog's memory
  };
  void draw_field(gui::Frame& frame, std::size_t field, float width);
  void send(gui::Frame& frame);
  [[nodiscard]] std::optional<std::int64_t> value(const gui::Frame& frame, const ActionField& info,
                                                  Field& field);
  [[nodiscard]] std::string unit_of(const gui::Frame& frame, const ActionField& info) const;
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame) const;

  const int action_;
  const ActionInfo& info_;
  std::vector<Field> fields_;
  float least_ = 104;  ///< of a cell, so that no value of its lists is cut
  IntentId asked_ = 0;
  std::string refused_;
  RefusalCard card_;
  DoubtWays doubt_;
};

}  // namespace hw::panels
