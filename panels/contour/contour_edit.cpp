// Draws and edits the lists of the contour panel: pieces of a path, steps of a staircase.
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/contour/contour.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float head_width = 108;

float cell_width(float width, int cells) {
  return std::floor((width - head_width - remove_width - between * static_cast<float>(cells - 1)) /
                    static_cast<float>(cells));
}

void words_at(Ui& ui, ImVec2 at, float width, std::string_view words, Tone tone = Tone::ink2) {
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(16), Face::body, ui[tone], words);
}

bool remove_button(Ui& ui, std::string_view id, ImVec2 at) {
  ImGui::SetCursorScreenPos(at);
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.icon = Icon::cross;
  o.width = 32;
  o.tip = "Removes this row from the list.";
  return button(ui, id, "", o).clicked;
}

}  // namespace

void Contour::edited() {
  changed_ = true;
  (stairs_shown_ ? stairs_.unkept : contour_.unkept) = true;
}

void Contour::number(Frame& f, std::string_view id, std::string_view label, NumberField& field,
                     NumberRange range, ImVec2 at, float width) {
  NumberOptions o;
  o.range = range;
  o.width = width;
  o.sentence_below = false;
  if (!field.sentence.empty()) o.tip = field.sentence;
  ImGui::SetCursorScreenPos(at);
  if (number_field(f.ui, id, label, std::nullopt, field, o).field.edited) edited();
}

int Contour::axis_choice(Frame& f, std::string_view id, std::string_view label, int chosen, ImVec2 at,
                         std::string_view words) {
  const float word = std::ceil(text_width(f.ui, Face::body, words)) / f.ui.scale;
  words_at(f.ui, at, word + 1, words);
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(word + 8), at.y));
  const int picked = dropdown(f.ui, id, label, names_.axes, chosen, {.width = 52});
  if (picked < 0) return chosen;
  edited();
  return picked;
}

// ---- contour

void Contour::draw_contour_list(Frame& f, float width) {
  Ui& ui = f.ui;
  gap(ui, 8);
  draw_contour_head(f, width);
  std::size_t removed = contour_.pieces.size();
  for (std::size_t i = 0; i < contour_.pieces.size(); ++i)
    if (draw_piece(f, i, width)) removed = i;
  if (removed < contour_.pieces.size()) {
    contour_.pieces.erase(contour_.pieces.begin() + static_cast<std::ptrdiff_t>(removed));
    edited();
  }
  if (contour_.pieces.empty()) {
    gap(ui, 4);
    wrapped(ui, Face::body, Tone::ink2,
            "Add a line or an arc. An arc begins at the end of the path and goes round its centre.", width);
  }
  gap(ui, 8);
  draw_adders(f);
  gap(ui, 16);
}

void Contour::draw_contour_head(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // This row has no remove button; the cells take its width too, for units as long as "counts/s".
  const float cell = std::floor((width - head_width - between) / 2);
  const auto place = [&](int row, float x) {
    return ImVec2(at.x + ui.px(x), at.y + ui.px(static_cast<float>(row) * list_row_height));
  };
  contour_.first = axis_choice(f, "contour/first", "To the right", contour_.first, at, "Right");
  contour_.second = axis_choice(f, "contour/second", "Up", contour_.second, place(0, 108), "up");
  ImGui::SetCursorScreenPos(place(0, 200));
  static constexpr std::array<std::string_view, 2> ends = {"Ramp", "At once"};
  if (const int end = segment(ui, "contour/end", ends, contour_.ramp ? 0 : 1, {.cell_width = 52}); end >= 0)
    contour_.ramp = end == 0, edited();
  NumberRange places = contour_.unit.places(f.catalog);
  places.unit = contour_.unit.name;
  words_at(ui, place(1, 0), head_width, "Begin");
  number(f, "contour/x", "Begin, right", contour_.x, places, place(1, head_width), cell);
  number(f, "contour/y", "Begin, up", contour_.y, places, place(1, head_width + cell + between), cell);
  words_at(ui, place(2, 0), head_width, "Speed, lead-in");
  number(f, "contour/speed", "Speed", contour_.speed, contour_.unit.speeds(f.catalog), place(2, head_width),
         cell);
  number(f, "contour/lead_in", "Lead-in", contour_.lead_in, contour_.unit.lengths(f.catalog),
         place(2, head_width + cell + between), cell);
  ImGui::SetCursorScreenPos(place(3, 0));
}

/// Returns true when the row must be removed.
bool Contour::draw_piece(Frame& f, std::size_t row, float width) {
  Ui& ui = f.ui;
  Piece& p = contour_.pieces[row];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::size_t n = row + 1;
  const bool arc = p.kind == PieceKind::arc;
  const std::string_view word = arc ? "arc about" : p.kind == PieceKind::line ? "line to" : "output";
  draw_text_line(ui, at.x, at.x + ui.px(24), at.y + ui.px(16), Face::code_field, ui[Tone::ink3],
                 Path("{}", n));
  words_at(ui, ImVec2(at.x + ui.px(24), at.y), head_width - 24, word, Tone::ink);
  const float cell = cell_width(width, 3);
  const auto place = [&](int column) {
    return ImVec2(at.x + ui.px(head_width + static_cast<float>(column) * (cell + between)), at.y);
  };
  if (p.kind == PieceKind::output) {
    ImGui::SetCursorScreenPos(place(0));
    if (const int picked = dropdown(ui, Path("contour/{}/output", n), "Output", names_.outputs, p.output,
                                    {.width = 2 * cell + between - 40});
        picked >= 0)
      p.output = picked, edited();
    static constexpr std::array<std::string_view, 2> states = {"on", "off"};
    ImGui::SetCursorScreenPos(ImVec2(place(2).x - ui.px(32), at.y));
    if (const int state = segment(ui, Path("contour/{}/state", n), states, p.on ? 0 : 1, {.cell_width = 40});
        state >= 0)
      p.on = state == 0, edited();
  } else {
    number(f, Path("contour/{}/x", n), arc ? "Centre, right" : "End, right", p.x,
           contour_.unit.places(f.catalog), place(0), cell);
    number(f, Path("contour/{}/y", n), arc ? "Centre, up" : "End, up", p.y, contour_.unit.places(f.catalog),
           place(1), cell);
    if (arc)
      number(f, Path("contour/{}/angle", n), "Angle, counterclockwise", p.degrees, {-36000, 36000, 3, "°"},
             place(2), cell);
  }
  const bool gone = remove_button(ui, Path("contour/{}/remove", n), ImVec2(at.x + ui.px(width - 32), at.y));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(list_row_height)));
  return gone;
}

void Contour::draw_adders(Frame& f) {
  Ui& ui = f.ui;
  if (button(ui, "contour/add/line", "Add line", {.icon = Icon::plus}).clicked) add(PieceKind::line);
  ImGui::SameLine(0, ui.px(8));
  if (button(ui, "contour/add/arc", "Add arc", {.icon = Icon::plus}).clicked) add(PieceKind::arc);
  ImGui::SameLine(0, ui.px(8));
  ButtonOptions o;
  o.icon = Icon::plus;
  o.disabled = names_.output_numbers.empty() ? "A contour cannot switch outputs here." : "";
  if (button(ui, "contour/add/output", "Add output", o).clicked) add(PieceKind::output);
}

/// A new row continues from the previous one.
void Contour::add(PieceKind kind) {
  Piece p;
  p.kind = kind;
  contour_.unit.put(p.x, 0), contour_.unit.put(p.y, 0), p.degrees.set(90, 0);
  for (const Piece& old : contour_.pieces)
    if (old.kind == PieceKind::line && kind == old.kind)
      contour_.unit.put(p.x, contour_.unit.steps(old.x).value_or(0)),
          contour_.unit.put(p.y, contour_.unit.steps(old.y).value_or(0));
    else if (old.kind == PieceKind::output && kind == old.kind)
      p.output = old.output, p.on = !old.on;
  contour_.pieces.push_back(std::move(p));
  edited();
}

// ---- staircase

void Contour::draw_stairs_list(Frame& f, float width) {
  Ui& ui = f.ui;
  gap(ui, 8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  stairs_.axis = axis_choice(f, "stairs/axis", "Axis", stairs_.axis, at, "Axis");
  const AxisState& axis = f.now.axes[static_cast<std::size_t>(stairs_.axis)];
  const NumberText stands =
      format_number(stairs_.unit.shown(static_cast<double>(axis.position.value)), stairs_.unit.decimals);
  words_at(ui, ImVec2(at.x + ui.px(116), at.y), width - 116,
           axis.position_known ? Path("stands at {}", stands.view()).view() : "its position is not known");
  const float cell = cell_width(width, 2);
  const float y = at.y + ui.px(list_row_height);
  draw_text_line(ui, at.x + ui.px(head_width), at.x + ui.px(head_width + cell), y + ui.px(10), Face::small,
                 ui[Tone::ink2], Path("up to, {}", stairs_.unit.name));
  draw_text_line(ui, at.x + ui.px(head_width + cell + between), at.x + ui.px(width), y + ui.px(10),
                 Face::small, ui[Tone::ink2], Path("at, {}", stairs_.unit.of_speed));
  ImGui::SetCursorScreenPos(ImVec2(at.x, y + ui.px(20)));
  std::size_t removed = stairs_.rows.size();
  for (std::size_t i = 0; i < stairs_.rows.size(); ++i)
    if (draw_stair(f, i, width)) removed = i;
  if (removed < stairs_.rows.size()) {
    stairs_.rows.erase(stairs_.rows.begin() + static_cast<std::ptrdiff_t>(removed));
    edited();
  }
  const ImVec2 end = ImGui::GetCursorScreenPos();
  words_at(ui, end, head_width, "stop at");
  number(f, "stairs/stop", "Stop at", stairs_.stop_at, stairs_.unit.places(f.catalog),
         ImVec2(end.x + ui.px(head_width), end.y), cell);
  ImGui::SetCursorScreenPos(ImVec2(end.x, end.y + ui.px(list_row_height + 4)));
  if (button(ui, "stairs/add", "Add step", {.icon = Icon::plus}).clicked) {
    Stair s;
    const double last = stairs_.rows.empty() ? static_cast<double>(axis.position.value)
                                             : stairs_.unit.steps(stairs_.rows.back().until).value_or(0);
    stairs_.unit.put(s.until, last + 1000);
    stairs_.unit.put_long(s.speed, stairs_.rows.empty()
                                       ? 1000
                                       : stairs_.unit.steps_long(stairs_.rows.back().speed).value_or(1000));
    stairs_.rows.push_back(std::move(s));
    edited();
  }
  gap(ui, 16);
}

bool Contour::draw_stair(Frame& f, std::size_t row, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::size_t n = row + 1;
  const float cell = cell_width(width, 2);
  draw_text_line(ui, at.x, at.x + ui.px(24), at.y + ui.px(16), Face::code_field, ui[Tone::ink3],
                 Path("{}", n));
  words_at(ui, ImVec2(at.x + ui.px(24), at.y), head_width - 24, "run", Tone::ink);
  number(f, Path("stairs/{}/until", n), "Up to", stairs_.rows[row].until, stairs_.unit.places(f.catalog),
         ImVec2(at.x + ui.px(head_width), at.y), cell);
  NumberRange speeds = stairs_.unit.speeds(f.catalog);
  speeds.unit = {};  // shown over the column
  number(f, Path("stairs/{}/speed", n), "Speed", stairs_.rows[row].speed, speeds,
         ImVec2(at.x + ui.px(head_width + cell + between), at.y), cell);
  const bool gone = remove_button(ui, Path("stairs/{}/remove", n), ImVec2(at.x + ui.px(width - 32), at.y));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(list_row_height)));
  return gone;
}

}  // namespace hw::panels
