#include "panels/control/axis_tables.h"

#include <algorithm>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float band_title = 32, band_heads = 20, band_row = 32, name_column = 30;
constexpr float shared_name_width = 120;  ///< aligns its field with those of the other settings
constexpr float does_width = 108, least_between = 16, most_between = 96;

/// The id of a column for an axis: '*' becomes the name of the axis, or is removed if there is only one axis.
std::string id_of_axis(const Catalog& c, std::string id, std::size_t axis) {
  if (const auto star = id.find('*'); star != id.npos)
    id.replace(star, 1, c.axes.size() > 1 ? c.axes[axis].name : std::string());
  return id;
}

bool has_value(const ActionField& field, std::int64_t value) {
  return std::any_of(field.choices.begin(), field.choices.end(),
                     [&](const ParamChoice& c) { return c.value == value; });
}

/// Whether the action can be sent to this axis.
bool takes_axis(const ActionInfo& action, std::size_t axis) {
  for (const ActionField& field : action.fields)
    if (field.id == "axis") return has_value(field, static_cast<std::int64_t>(axis));
  return true;
}

bool is_of_axis(const ActionInfo& action) {
  return std::any_of(action.fields.begin(), action.fields.end(),
                     [](const ActionField& field) { return field.id == "axis"; });
}

/// An action with a state, but no word for switching off, only clears that state.
bool only_while_on(const AxisColumn& column) {
  return column.shows == AxisColumn::Shows::action && !column.state.empty() && column.verb_off.empty();
}

void row_hairline(Ui& ui, float x, float y, float width) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, y), ImVec2(x + ui.px(width), y + ui.hair()),
                                            ui[Tone::line]);
}

}  // namespace

AxisTables::AxisTables(const Catalog& catalog) {
  for (const AxisTable& info : catalog.axis_tables) {
    Table& table = tables_.emplace_back();
    table.info = &info;
    for (const AxisColumn& column : info.columns) {
      Column made;
      made.info = &column;
      fill(catalog, made);
      const bool any =
          std::any_of(made.cells.begin(), made.cells.end(), [](const Cell& cell) { return cell.index >= 0; });
      if (any || column.shows == AxisColumn::Shows::motion) table.columns.push_back(std::move(made));
    }
  }
  std::erase_if(tables_, [](const Table& table) { return table.columns.empty(); });
}

void AxisTables::fill(const Catalog& catalog, Column& column) {
  using Shows = AxisColumn::Shows;
  for (std::size_t axis = 0; axis < catalog.axes.size(); ++axis) {
    Cell& cell = column.cells.emplace_back();
    const std::string id = id_of_axis(catalog, column.info->id, axis);
    fill_state(catalog, column.info->state, axis, cell);
    if (column.info->shows == Shows::toggle && cell.state >= 0 && !cell.state_is_param)
      readouts_.set(static_cast<std::size_t>(cell.state));
    if (column.info->shows == Shows::readout) {
      cell.index = catalog.find_readout(id);
      if (cell.index >= 0) readouts_.set(static_cast<std::size_t>(cell.index));
      continue;
    }
    const int param = catalog.find_param(id);
    if (column.info->shows == Shows::param || (column.info->shows == Shows::toggle && param >= 0)) {
      cell.index = param;
      if (param >= 0 && column.choices.empty()) {
        const ParamInfo& p = catalog.params[static_cast<std::size_t>(param)];
        column.choices.assign(p.short_choices.begin(), p.short_choices.end());
        if (column.choices.empty())
          for (const ParamChoice& choice : p.choices) column.choices.push_back(choice.label);
      }
      continue;
    }
    const int action = catalog.find_action(id);
    if (action < 0 || !takes_axis(catalog.actions[static_cast<std::size_t>(action)], axis)) continue;
    if (only_while_on(*column.info) && cell.state < 0) continue;
    cell.index = action;
    if (!column.shared) column.shared = std::make_unique<ActionForm>(catalog, action);
    cell.form = std::make_unique<ActionForm>(catalog, action, static_cast<int>(axis), *column.shared);
  }
}

void AxisTables::fill_state(const Catalog& catalog, const std::string& form, std::size_t axis,
                            Cell& cell) const {
  if (form.empty()) return;
  const std::string id = id_of_axis(catalog, form, axis);
  cell.state = catalog.find_readout(id);
  if (cell.state >= 0) return;
  cell.state = catalog.find_param(id);
  cell.state_is_param = true;
  if (cell.state >= 0 && !catalog.params[static_cast<std::size_t>(cell.state)].bits.empty())
    cell.state_bits = std::int64_t{1} << axis;
}

bool AxisTables::has_title(std::string_view title) const {
  return std::any_of(tables_.begin(), tables_.end(),
                     [&](const Table& table) { return table.info->title == title; });
}

// An action of the whole controller has its place elsewhere, because its row may not be drawn.
bool AxisTables::has_action(const Catalog& catalog, int action) const {
  if (catalog.axes.size() > 1 && !is_of_axis(catalog.actions[static_cast<std::size_t>(action)])) return false;
  for (const Table& table : tables_)
    for (const Column& column : table.columns)
      for (const Cell& cell : column.cells)
        if (cell.form && cell.index == action) return true;
  return false;
}

bool AxisTables::lacks_settings(const Frame& f) const {
  const auto lacks = [&f](int param) {
    return param >= 0 && f.catalog.params[static_cast<std::size_t>(param)].readable &&
           !f.now.params[static_cast<std::size_t>(param)].known;
  };
  for (const Table& table : tables_)
    for (const Column& column : table.columns)
      for (const Cell& cell : column.cells)
        if ((cell.state_is_param && lacks(cell.state)) ||
            (!cell.form && column.info->shows != AxisColumn::Shows::readout && lacks(cell.index)))
          return true;
  return false;
}

/// Measures each column by its longest possible content, so that new values do not move other columns.
void AxisTables::measure(const Frame& f, Table& table) {
  using Shows = AxisColumn::Shows;
  const Ui& ui = f.ui;
  const Catalog& c = f.catalog;
  bool after_numbers = true;
  const auto words = [&](Face face, std::string_view s) { return text_width(ui, face, s) / ui.scale; };
  table.width = -between;
  for (Column& column : table.columns) {
    float width = 0;
    const auto cell = std::find_if(column.cells.begin(), column.cells.end(),
                                   [](const Cell& one) { return one.index >= 0; });
    const auto index = cell == column.cells.end() ? 0 : static_cast<std::size_t>(cell->index);
    switch (column.info->shows) {
      case Shows::motion: width = does_width + speed_width; break;
      case Shows::readout: {
        width = 60;
        for (const ParamChoice& word : c.readouts[index].words)
          width = std::max(width, std::min(84.0f, words(Face::body_bold, word.label) + 24));
        break;
      }
      case Shows::param: {
        width = c.params[index].choices.empty()
                    ? std::max(56.0f, c.params[index].maximum > 9999 ? 88.0f : 0.0f)
                    : 0;
        for (const std::string_view choice : column.choices)
          width = std::max(width, std::min(140.0f, words(Face::body_bold, choice) + 42));
        break;
      }
      case Shows::toggle: width = 60; break;
      case Shows::action: {
        const ActionInfo& action = c.actions[index];
        float button = std::max(words(Face::body_medium, column.info->verb_on),
                                words(Face::body_medium, column.info->verb_off));
        if (column.info->verb_on.empty()) button = words(Face::body_medium, action.label);
        width = ActionForm::row_fields_width(action) + button + 24;
        break;
      }
    }
    // The head of a column of numbers is right-aligned, and may begin above the words of the previous column.
    const bool numbers = has_numbers(c, column);
    const bool may_reach_over = numbers && !after_numbers;
    column.width =
        std::ceil(may_reach_over ? width : std::max(width, words(Face::small, head_of(f, column))));
    table.width += column.width + between;
    after_numbers = numbers;
  }
}

void AxisTables::draw(Frame& f, float width) {
  UnitsOfRows units;
  for (std::size_t axis = 0; axis < f.catalog.axes.size(); ++axis)
    units.add(f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(axis)}).name);
  if (scale_ != f.ui.scale || units_ != units.view()) {
    for (Table& table : tables_) measure(f, table);
    scale_ = f.ui.scale;
    units_ = units.view();
  }
  second_column_ = 0;
  for (std::size_t first = 0; first < tables_.size();) {
    float used = name_column + tables_[first].width;
    std::size_t end = first + 1;
    while (end < tables_.size() && used + least_between + tables_[end].width <= width)
      used += least_between + tables_[end++].width;
    draw_band(f, first, end, width);
    first = end;
  }
}

void AxisTables::draw_shared(Frame& f, float width) {
  Ui& ui = f.ui;
  for (Table& table : tables_)
    for (Column& column : table.columns) {
      if (!column.shared || !column.shared->has_shared()) continue;
      const ImVec2 at = ImGui::GetCursorScreenPos();
      draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(title_height / 2), Face::body_bold,
                     ui[Tone::ink],
                     Path("{}{}", table.info->title, f.catalog.axes.size() > 1 ? ", every axis" : ""));
      ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(title_height)));
      column.shared->draw_shared(f, shared_name_width);
      const float end = ImGui::GetCursorScreenPos().y + ui.px(close_between);
      row_hairline(ui, at.x, end, width);
      ImGui::SetCursorScreenPos(ImVec2(at.x, end + ui.px(close_between)));
    }
}

/// Two tables share the width evenly if both fit into a half; more tables are spread over it.
float AxisTables::apart_in_band(std::size_t first, std::size_t end, float width) {
  float used = name_column;
  for (std::size_t i = first; i < end; ++i) used += tables_[i].width;
  const auto gaps = static_cast<float>(end - first - 1);
  if (gaps == 0) return 0;
  if (gaps > 1) return std::clamp(std::floor((width - used) / gaps), least_between, most_between);
  const float before = name_column + tables_[first].width;
  const float half = std::floor((width - between_columns) / 2) + between_columns;
  const float least = before + least_between;
  second_column_ = std::clamp(half, least, std::max(least, width - tables_[end - 1].width));
  return second_column_ - before;
}

void AxisTables::draw_band(Frame& f, std::size_t first, std::size_t end, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float apart = apart_in_band(first, end, width);
  const float rows_top = at.y + ui.px(band_title + band_heads);
  for (std::size_t axis = 0; axis < f.catalog.axes.size(); ++axis) {
    const float y = rows_top + ui.px(band_row) * static_cast<float>(axis);
    row_hairline(ui, at.x, y, width);
    draw_text_line(ui, at.x, at.x + ui.px(name_column), std::floor(y + ui.px(band_row / 2)), Face::body_bold,
                   ui[Tone::ink], f.catalog.axes[axis].name);
  }
  float x = name_column;
  for (std::size_t i = first; i < end; ++i) {
    Table& table = tables_[i];
    // The first title is at the left edge, above the names of the axes.
    const float title_x = at.x + (i == first ? 0 : ui.px(x));
    const float right = at.x + ui.px(i + 1 == end ? width : x + table.width);
    const float middle = std::floor(at.y + ui.px(band_title / 2));
    draw_text_line(ui, title_x, right, middle, Face::body_bold, ui[Tone::ink], table.info->title);
    const float note = std::ceil(text_width(ui, Face::small, table.info->note));
    if (title_x + text_width(ui, Face::body_bold, table.info->title) + ui.px(16) + note <= right)
      draw_text_line(ui, right - note, right + 1, middle, Face::small, ui[Tone::ink2], table.info->note);
    draw_heads(f, table, ImVec2(at.x + ui.px(x), at.y + ui.px(band_title)));
    for (std::size_t axis = 0; axis < f.catalog.axes.size(); ++axis)
      draw_row(f, table, axis,
               ImVec2(at.x + ui.px(x), rows_top + ui.px(band_row) * static_cast<float>(axis)));
    x += table.width + apart;
  }
  const float bottom = rows_top + ui.px(band_row) * static_cast<float>(f.catalog.axes.size());
  row_hairline(ui, at.x, bottom, width);
  ImGui::SetCursorScreenPos(ImVec2(at.x, bottom + ui.px(between)));
}

/// The head of a column, with the unit of its content.
Path AxisTables::head_of(const Frame& f, const Column& column) {
  using Shows = AxisColumn::Shows;
  UnitsOfRows units;
  const bool several = f.catalog.axes.size() > 1;
  for (const Cell& cell : column.cells) {
    if (cell.index < 0) continue;
    const auto i = static_cast<std::size_t>(cell.index);
    if (cell.form)
      cell.form->add_units(f, units);
    else if (column.info->shows == Shows::param)
      units.add(shown_unit(f, f.catalog.params[i]).name);
    else if (column.info->shows == Shows::readout &&
             several)  // for a single axis the unit is beside the value
      units.add(shown_unit(f, f.catalog.readouts[i]).name);
  }
  const std::string_view title = column.info->title;
  const bool has_unit = units.view().empty() || title.ends_with(units.view());
  return Path("{}{}{}", title, has_unit || title.empty() ? "" : ", ",
              has_unit ? std::string_view() : units.view());
}

bool AxisTables::has_numbers(const Catalog& c, const Column& column) {
  return column.info->shows == AxisColumn::Shows::readout &&
         std::any_of(column.cells.begin(), column.cells.end(), [&](const Cell& cell) {
           return cell.index >= 0 && c.readouts[static_cast<std::size_t>(cell.index)].words.empty();
         });
}

void AxisTables::draw_heads(Frame& f, const Table& table, ImVec2 at) {
  Ui& ui = f.ui;
  float x = at.x;
  const float middle = std::floor(at.y + ui.px(band_heads / 2));
  for (const Column& column : table.columns) {
    const float right = x + ui.px(column.width);
    const Path head = head_of(f, column);
    const float wide = std::ceil(text_width(ui, Face::small, head));
    draw_text_line(ui, has_numbers(f.catalog, column) ? right - wide : x, right + 1, middle, Face::small,
                   ui[Tone::ink2], head);
    if (column.info->shows == AxisColumn::Shows::motion) {
      UnitsOfRows units;
      for (std::size_t axis = 0; axis < f.catalog.axes.size(); ++axis)
        units.add(Path("{}/s", f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(axis)}).name));
      draw_text_right(ui, ImVec2(right, middle - ui.line(Face::small) / 2), Face::small, ui[Tone::ink2],
                      units.view());
    }
    x = right + ui.px(between);
  }
}

void AxisTables::draw_row(Frame& f, Table& table, std::size_t axis, ImVec2 at) {
  Ui& ui = f.ui;
  const bool moves = f.now.axis_moves(static_cast<int>(axis)) && !only_goes_along(f.now.axes[axis]);
  const float end = at.x + ui.px(table.width);
  float x = at.x;
  bool reported = false;
  for (Column& column : table.columns) {
    const Rect in{ImVec2(x, at.y), ImVec2(x + ui.px(column.width), at.y + ui.px(band_row))};
    x = in.max.x + ui.px(between);
    if (column.cells[axis].index < 0 && column.info->shows != AxisColumn::Shows::motion) continue;
    if (only_while_on(*column.info) && !is_on(f, column.cells[axis]).value_or(false)) continue;
    if (column.info->while_moving && !moves) {
      if (!reported)
        draw_text_line(ui, in.min.x, end, std::floor(in.centre().y), Face::body, ui[Tone::ink3],
                       "only while it moves");
      reported = true;
      continue;
    }
    draw_cell(f, column, axis, in);
  }
}

}  // namespace hw::panels
