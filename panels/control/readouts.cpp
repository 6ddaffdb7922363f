#include "panels/control/readouts.h"

#include <algorithm>

#include <fmt/format.h>

#include "gui/model/tab.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/control/shown_unit.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float readout_row_height = 28, head_height = 24, axis_width = 32, most_columns = 8;
constexpr float cells_height = 20;  ///< cells below "36 of 36 places free", in one row or in two

// Many groups are polled in turn, so a value of this age is still fresh.
constexpr Duration patience = Millis(3000);

/// Readouts with the same meaning for successive axes, which are adjacent in the catalog.
struct Run {
  std::size_t first = 0, size = 0;
};

bool drawn(const Catalog& c, std::size_t i, int group, const ReadoutSet& elsewhere) {
  return c.readouts[i].group == group && !c.readouts[i].for_scripts && !elsewhere[i];
}

bool per_axis(const Catalog& c, const ReadoutInfo& r) { return c.axes.size() > 1 && r.axis >= 0; }

/// "State of X" -> "State".
std::string_view without_axis(const Catalog& c, const ReadoutInfo& r) {
  const std::string_view label = r.label;
  const std::string& axis = c.axes[static_cast<std::size_t>(r.axis)].name;
  const std::size_t tail = axis.size() + 4;
  if (label.size() > tail && label.ends_with(axis) && label.substr(label.size() - tail, 4) == " of ")
    return label.substr(0, label.size() - tail);
  return label;
}

/// Finds the columns of a group's table. Returns their number.
std::size_t find_columns(const Catalog& c, int group, const ReadoutSet& elsewhere,
                         Run (&columns)[static_cast<std::size_t>(most_columns)]) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < c.readouts.size(); ++i) {
    const ReadoutInfo& r = c.readouts[i];
    if (!drawn(c, i, group, elsewhere) || !per_axis(c, r)) continue;
    const bool goes_on =
        n > 0 && columns[n - 1].first + columns[n - 1].size == i && c.readouts[i - 1].axis < r.axis;
    if (goes_on)
      ++columns[n - 1].size;
    else if (n < std::size(columns))
      columns[n++] = {i, 1};
  }
  return n;
}

std::size_t count_single(const Catalog& c, int group, const ReadoutSet& elsewhere) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < c.readouts.size(); ++i)
    n += drawn(c, i, group, elsewhere) && !per_axis(c, c.readouts[i]) ? 1 : 0;
  return n;
}

/// Draws the value, ending at `right` or beginning at `left`.
void draw_value(Frame& f, std::size_t i, const Rect& in, bool right_aligned) {
  Ui& ui = f.ui;
  const ReadoutInfo& info = f.catalog.readouts[i];
  const ReadoutText words(f, i);
  const Tone tone = words.bad() ? Tone::fault : words.old() || !words.known() ? Tone::ink3 : Tone::ink;
  const Face face = words.bad() ? Face::body_bold : Face::body;
  const float middle = std::floor(in.centre().y);
  const float width = std::ceil(text_width(ui, face, words.view()));
  float x = right_aligned ? std::max(in.min.x, in.max.x - width) : in.min.x;
  if (words.bad()) {
    const float icon = right_aligned ? x - ui.px(12) : x + ui.px(6);
    draw_icon(ImGui::GetWindowDrawList(), Icon::diamond_solid, ImVec2(icon, middle), ui.px(11), ui[tone]);
    if (!right_aligned) x += ui.px(18);
  }
  draw_text_line(ui, x, in.max.x + 1, middle, face, ui[tone], words.view());
  show(ui, {Path("readout/{}", info.id), Kind::text, info.label, words.view(), {}, false, info.help}, in);
}

/// Whether the readout counts the free places of the controller's buffer.
bool counts_places(const Catalog& c, std::size_t i) {
  return c.move_list.depth > 0 && c.readouts[i].group == c.move_list.readout_group &&
         c.readouts[i].words.empty() && !c.readouts[i].for_scripts;
}

/// Draws "36 of 36 places free", and below it a cell for each place, filled where a move waits.
void draw_places(Frame& f, std::size_t i, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const int depth = f.catalog.move_list.depth;
  const Rect all{at, ImVec2(at.x + ui.px(width), at.y + ui.px(readout_row_height + cells_height))};
  const ReadoutText words(f, i);
  const Path rest(" of {} places free", depth);
  const float middle = std::floor(at.y + ui.px(readout_row_height / 2));
  const Tone tone = words.known() && !words.old() ? Tone::ink : Tone::ink3;
  const float number = std::ceil(text_width(ui, Face::body_bold, words.view()));
  draw_text_line(ui, at.x, all.max.x, middle, Face::body_bold, ui[tone], words.view());
  draw_text_line(ui, at.x + number, all.max.x, middle, Face::body, ui[Tone::ink2], rest);
  constexpr float least_pitch = 8, row_pitch = 10;
  const bool one_row = width >= least_pitch * static_cast<float>(depth);
  const int in_row = one_row ? depth : (depth + 1) / 2;
  const float pitch = std::min(ui.px(12), std::floor((all.max.x - at.x) / static_cast<float>(in_row))),
              side = pitch - ui.px(3);
  const std::int64_t taken = words.known() ? depth - f.now.readouts[i] : 0;
  for (int n = 0; n < depth; ++n) {
    const float x = pitch * static_cast<float>(n % in_row), row = static_cast<float>(n / in_row);
    const ImVec2 from(at.x + x, at.y + ui.px(readout_row_height + 2 + row_pitch * row));
    const Rect cell{from, ImVec2(from.x + side, from.y + ui.px(8))};
    if (n < taken)
      draw_fill(ui, cell, ui[words.old() ? tone : Tone::ink2], 2);
    else
      draw_outline(ui, cell, ui[words.known() && !words.old() ? Tone::edge : Tone::line], 2);
  }
  const ReadoutInfo& info = f.catalog.readouts[i];
  show(ui, {Path("readout/{}", info.id), Kind::text, info.label, words.view(), {}, false, info.help}, all);
  ImGui::SetCursorScreenPos(ImVec2(at.x, all.max.y));
}

void draw_single(Frame& f, std::size_t i, float width) {
  if (counts_places(f.catalog, i)) return draw_places(f, i, width);
  Ui& ui = f.ui;
  const ReadoutInfo& info = f.catalog.readouts[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect row{at, ImVec2(at.x + ui.px(width), at.y + ui.px(readout_row_height))};
  draw_text_line(ui, at.x, row.max.x, std::floor(row.centre().y), Face::body, ui[Tone::ink2], info.label);
  const float label = std::ceil(text_width(ui, Face::body, info.label)) + ui.px(12);
  draw_value(f, i, {ImVec2(std::min(at.x + label, row.max.x), at.y), row.max}, true);
  ImGui::SetCursorScreenPos(ImVec2(at.x, row.max.y));
}

void draw_columns(Frame& f, std::span<const Run> columns, float width) {
  Ui& ui = f.ui;
  const Catalog& c = f.catalog;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float share = (width - axis_width) / static_cast<float>(columns.size());
  const auto cell = [&](std::size_t column, float y, float height) {
    const float x = at.x + ui.px(axis_width + share * static_cast<float>(column));
    const float end =
        column + 1 < columns.size() ? share - 8 : share;  // the last column ends where the lines end
    return Rect{ImVec2(x, y), ImVec2(x + ui.px(end), y + ui.px(height))};
  };
  float free_from =
      cell(0, at.y, head_height).min.x;  // a head may begin above the end of the previous column
  for (std::size_t n = 0; n < columns.size(); ++n) {
    const ReadoutInfo& info = c.readouts[columns[n].first];
    const Rect r = cell(n, at.y, head_height);
    const std::string_view name = without_axis(c, info);
    UnitsOfRows units;
    for (std::size_t i = 0; i < columns[n].size; ++i)
      units.add(shown_unit(f, c.readouts[columns[n].first + i]).name);
    const std::string_view unit = name.ends_with(units.view()) ? std::string_view() : units.view();
    const Path title("{}{}{}", name, unit.empty() ? "" : ", ", unit);
    const float w = std::ceil(text_width(ui, Face::small, title));
    const float x = info.words.empty() ? std::max(free_from, r.max.x - w) : r.min.x;
    draw_text_line(ui, x, r.max.x + 1, std::floor(r.centre().y), Face::small, ui[Tone::ink2], title);
    free_from = std::min(x + w, r.max.x) + ui.px(8);
  }
  float y = at.y + ui.px(head_height);
  for (std::size_t axis = 0; axis < c.axes.size(); ++axis) {
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, y), ImVec2(at.x + ui.px(width), y + ui.hair()),
                                              ui[Tone::line]);
    draw_text_line(ui, at.x, at.x + ui.px(axis_width), std::floor(y + ui.px(readout_row_height / 2)),
                   Face::body_bold, ui[Tone::ink], c.axes[axis].name);
    for (std::size_t n = 0; n < columns.size(); ++n)
      for (std::size_t i = columns[n].first; i < columns[n].first + columns[n].size; ++i)
        if (c.readouts[i].axis == static_cast<int>(axis))
          draw_value(f, i, cell(n, y, readout_row_height), c.readouts[i].words.empty());
    y += ui.px(readout_row_height);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
}

}  // namespace

ReadoutText::ReadoutText(const Frame& f, std::size_t i) {
  const ReadoutInfo& info = f.catalog.readouts[i];
  known_ = i < f.now.readouts_known.size() && f.now.readouts_known[i];
  if (!known_) {
    bytes_[0] = '?';
    size_ = 1;
    return;
  }
  const std::int64_t value = f.now.readouts[i];
  const Duration age = f.clock - f.now.readouts_seen_at[i];
  old_ = !f.connected() || age > std::max<Duration>(3 * f.now.poll_period, patience);
  bad_ = std::find(info.bad.begin(), info.bad.end(), value) != info.bad.end();
  const auto word = std::find_if(info.words.begin(), info.words.end(),
                                 [&](const ParamChoice& w) { return w.value == value; });
  const ShownUnit own = shown_unit(f, info);
  const NumberText number = format_number(own.shown(value), own.decimals);
  const bool has_word = word != info.words.end();
  const std::string_view unit = has_word || per_axis(f.catalog, info) ? std::string_view() : own.name;
  const auto end = fmt::format_to_n(bytes_, sizeof bytes_, "{}{}{}{}",
                                    has_word ? std::string_view(word->label) : number.view(),
                                    unit.empty() ? "" : " ", unit, old_ ? "?" : "");
  size_ = std::min<std::size_t>(end.size, sizeof bytes_);
}

int find_free_places(const Catalog& c) {
  for (std::size_t i = 0; i < c.readouts.size(); ++i)
    if (counts_places(c, i)) return static_cast<int>(i);
  return -1;
}

float readouts_height(const Catalog& c, int group, const ReadoutSet& elsewhere) {
  Run columns[static_cast<std::size_t>(most_columns)];
  float height = static_cast<float>(count_single(c, group, elsewhere)) * readout_row_height;
  for (std::size_t i = 0; i < c.readouts.size(); ++i)
    if (drawn(c, i, group, elsewhere) && !per_axis(c, c.readouts[i]) && counts_places(c, i))
      height += cells_height;
  if (find_columns(c, group, elsewhere, columns) > 0)
    height += head_height + static_cast<float>(c.axes.size()) * readout_row_height;
  return height;
}

void draw_readouts(Frame& f, int group, float width, const ReadoutSet& elsewhere) {
  Ui& ui = f.ui;
  const float height = ui.px(readouts_height(f.catalog, group, elsewhere));
  if (height <= 0) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::IsRectVisible(at, ImVec2(at.x + ui.px(width), at.y + height)))
    f.tab.watched.look_at_group(group);
  for (std::size_t i = 0; i < f.catalog.readouts.size(); ++i)
    if (drawn(f.catalog, i, group, elsewhere) && !per_axis(f.catalog, f.catalog.readouts[i]))
      draw_single(f, i, width);
  Run columns[static_cast<std::size_t>(most_columns)];
  const std::size_t n = find_columns(f.catalog, group, elsewhere, columns);
  if (n > 0) draw_columns(f, {columns, n}, width);
}

// Off, waiting and done have lamps too, because a word alone must not show a state.
void draw_readout(Frame& f, std::size_t i, const Rect& in) {
  Ui& ui = f.ui;
  const ReadoutInfo& info = f.catalog.readouts[i];
  if (ImGui::IsRectVisible(in.min, in.max)) f.tab.watched.look_at_group(info.group);
  Rect rest = in;
  const bool known = i < f.now.readouts_known.size() && f.now.readouts_known[i];
  if (!info.words.empty() && info.words.front().label == "off") {
    const std::int64_t value = f.now.readouts[i];
    draw_lamp(ui, ImVec2(in.min.x + ui.px(6), std::floor(in.centre().y)), 12, LampShape::round,
              !known                              ? LampState::unknown
              : value == info.words.front().value ? LampState::off
              : value == info.words.back().value  ? LampState::on
                                                  : LampState::armed);
    rest.min.x += ui.px(20);
  }
  draw_value(f, i, rest, info.words.empty());
}

}  // namespace hw::panels
