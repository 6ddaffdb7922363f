#pragma once
// Draws the row of a parameter of the set-up: mnemonic, name, previous value, and the control for its values.
#include <optional>
#include <string>
#include <vector>

#include "gui/model/setup_edits.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "gui/widgets/number_field.h"
#include "panels/control/shown_unit.h"
#include "panels/widget_path.h"

namespace hw::panels {

/// The view state of a row.
struct SetupRowState {
  gui::NumberField number;
  ShownUnit unit;                       ///< of the content of `number`
  bool typing_name = false;             ///< a name is being typed into number.text
  std::vector<std::string> names;       ///< names of the choices
  std::vector<std::string_view> views;  ///< into `names`
};

/// The place of a row: its ends in pixels, and the width of its field, which is right-aligned.
struct SetupRowPlace {
  float left, right;
  float field;  ///< logical
};

class SetupRow {
 public:
  SetupRow(gui::Frame& frame, gui::SetupEdits& edits, std::size_t i, SetupRowState& state,
           const SetupRowPlace& place);
  /// Draws at ImGui's cursor. Returns true when the caret or focus ring is on the row, or (if `hover_counts`)
  /// the mouse.
  bool draw(bool hover_counts);

 private:
  void draw_words(float right, float y);
  Path note(gui::Tone& tone) const;
  void draw_note(std::string_view words, gui::Tone tone, ImVec2 left_middle);
  void draw_control(float left, float y);
  void draw_number(float y);
  void draw_name(float y);
  void draw_choice(float y);
  void draw_bits(float y);
  [[nodiscard]] std::string_view why_not() const;
  void part_id(std::string_view part, char (&out)[96], std::size_t& size) const;

  gui::Frame& f_;
  gui::Ui& ui_;
  gui::SetupEdits& edits_;
  const std::size_t i_;
  const ParamInfo& p_;
  const ParamState& has_;
  SetupRowState& state_;
  const float left_, right_;  // pixels
  const float field_;         ///< width, logical
  const ShownUnit unit_;
  char id_[96];
  std::size_t id_size_ = 0;
  [[nodiscard]] std::string_view id() const { return {id_, id_size_}; }
};

}  // namespace hw::panels
