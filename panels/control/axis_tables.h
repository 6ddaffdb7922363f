#pragma once
// Draws Catalog::axis_tables: a row for each axis. As many tables as fit are beside each other. Ids:
// `readout/ID`, `control/PARAM`, `action/ID/AXIS/go`, `control/X/does`.
#include <memory>
#include <string>
#include <vector>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"
#include "panels/control/action_form.h"
#include "panels/control/readouts.h"
#include "panels/control/shown_unit.h"
#include "panels/widget_path.h"

namespace hw::panels {

class AxisTables {
 public:
  explicit AxisTables(const Catalog& catalog);
  /// Draws at ImGui's cursor and leaves it below.
  void draw(gui::Frame& frame, float width);
  /// Draws the fields that apply to all rows of a table, below its title, which is repeated. Logical width.
  void draw_shared(gui::Frame& frame, float width);
  /// Left of the second table where two tables share a band, logical; 0: no band has two tables.
  [[nodiscard]] float second_column() const { return second_column_; }
  /// The readouts that the tables show, also as the state of a switch. Other places leave them out.
  [[nodiscard]] const ReadoutSet& readouts() const { return readouts_; }
  [[nodiscard]] bool has_title(std::string_view title) const;
  [[nodiscard]] bool has_action(const Catalog& catalog, int action) const;
  /// Whether a setting in the tables was not read yet.
  [[nodiscard]] bool lacks_settings(const gui::Frame& frame) const;

 private:
  static constexpr float speed_width = 84;
  /// The cell of an axis in a column.
  struct Cell {
    int index = -1;  ///< index of the readout, param or action; -1: empty cell
    int state = -1;  ///< index of the readout or param that shows whether it is on
    bool state_is_param = false;
    std::int64_t state_bits = -1;      ///< bits of that param
    std::unique_ptr<ActionForm> form;  ///< form of an action
    gui::NumberField number;           ///< number of a param
    ShownUnit unit;                    ///< of the content of `number`
  };
  struct Column {
    const AxisColumn* info = nullptr;
    std::unique_ptr<ActionForm> shared;
    std::vector<Cell> cells;
    std::vector<std::string_view> choices;  ///< choices of a param
    float width = 0;
  };
  struct Table {
    const AxisTable* info = nullptr;
    std::vector<Column> columns;
    float width = 0;
  };
  void fill(const Catalog& catalog, Column& column);
  void fill_state(const Catalog& catalog, const std::string& id, std::size_t axis, Cell& cell) const;
  static void measure(const gui::Frame& frame, Table& table);
  static Path head_of(const gui::Frame& frame, const Column& column);
  static bool has_numbers(const Catalog& catalog, const Column& column);
  float apart_in_band(std::size_t first, std::size_t end, float width);
  void draw_band(gui::Frame& frame, std::size_t first, std::size_t end, float width);
  static void draw_heads(gui::Frame& frame, const Table& table, ImVec2 at);
  void draw_row(gui::Frame& frame, Table& table, std::size_t axis, ImVec2 at);
  void draw_cell(gui::Frame& frame, Column& column, std::size_t axis, const gui::Rect& in);
  static void draw_motion(gui::Frame& frame, Cell& cell, std::size_t axis, const gui::Rect& in);
  static void draw_param(gui::Frame& frame, Column& column, Cell& cell, const gui::Rect& in);
  static void draw_toggle(gui::Frame& frame, const Cell& cell, const gui::Rect& in);
  static void draw_action(gui::Frame& frame, const Column& column, Cell& cell, const gui::Rect& in);
  static std::optional<bool> is_on(const gui::Frame& frame, const Cell& cell);

  std::vector<Table> tables_;
  ReadoutSet readouts_;
  float second_column_ = 0;
  float scale_ = 0;    ///< scale at which the columns were measured
  std::string units_;  ///< units shown when the columns were measured
};

}  // namespace hw::panels
