#include "panels/drawing/drawing_chains.h"

#include <array>
#include <utility>

#include "core/base/index.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/row.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float chain_row = 32;
constexpr std::array<Column, 6> chain_columns{{{"", 44, true},
                                               {"layer"},
                                               {"made of"},
                                               {"length, mm", 92, true},
                                               {"way to it", 84, true},
                                               {"time, s", 72, true}}};

double length_of(const drawing::Chain& chain) {
  double length = 0;
  for (const drawing::Curve& curve : chain.curves) length += curve.length();
  return length;
}

/// "2 lines, 1 arc"
Path made_of(const drawing::Chain& chain) {
  std::size_t arcs = 0, dots = 0;
  for (const drawing::Curve& curve : chain.curves) {
    if (curve.kind == drawing::Curve::Kind::arc) ++arcs;
    if (curve.length() == 0) ++dots;
  }
  const std::size_t lines = chain.curves.size() - arcs - dots;
  if (lines + arcs == 0) return Path("a dot");
  if (lines == 0) return Path("{} arc{}", arcs, arcs == 1 ? "" : "s");
  if (arcs == 0) return Path("{} line{}", lines, lines == 1 ? "" : "s");
  return Path("{} line{}, {} arc{}", lines, lines == 1 ? "" : "s", arcs, arcs == 1 ? "" : "s");
}

}  // namespace

int DrawingChains::may_be_left_out(const Conversion& made) const {
  return ix(chosen_) < made.chains.size() ? chosen_ : made.box_around;
}

DrawingChains::Request DrawingChains::draw_bar(Frame& f, const Shown& s, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const int out = may_be_left_out(s.made);
  const Path sentence = out < 0          ? Path("Choose a chain with a click.")
                        : out == chosen_ ? Path("Chain {} is chosen.", out + 1)
                                         : Path("Chain {} surrounds all: a margin?", out + 1);
  Request request = Request::nothing;
  ButtonOptions leave{.height = 28};
  if (s.busy) leave.disabled = "Calculating.";
  if (out < 0) leave.disabled = "No chain is chosen.";
  ButtonOptions all{.style = ButtonStyle::quiet, .height = 28};
  if (s.busy) all.disabled = "Calculating.";
  if (s.all) all.disabled = "Nothing was left out.";
  const float right = ui.px(width) - ui.px(8);
  const float draw_all = ui.px(button_width(ui, "Draw all", all)),
              leave_out = ui.px(button_width(ui, "Leave out", leave));
  ImGui::SetCursorScreenPos(ImVec2(at.x + right - draw_all, at.y + ui.px(6)));
  if (button(ui, "drawing/draw_all", "Draw all", all).clicked) request = Request::draw_all;
  ImGui::SetCursorScreenPos(ImVec2(at.x + right - draw_all - ui.px(8) - leave_out, at.y + ui.px(6)));
  if (button(ui, "drawing/leave_out", "Leave out", leave).clicked) request = Request::leave_out;
  draw_text_line(ui, at.x + ui.px(16), at.x + right - draw_all - leave_out - ui.px(16), at.y + ui.px(21),
                 Face::small, ui[Tone::ink2], sentence);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(bar_height)));
  return request;
}

DrawingChains::Request DrawingChains::draw(Frame& f, const Shown& shown, float width, float height) {
  const drawing::Drawing& drawing = shown.drawing;
  const Conversion& made = shown.made;
  const std::vector<double>& seconds = shown.seconds;
  Ui& ui = f.ui;
  const Request request = draw_bar(f, shown, width);
  height -= bar_height;
  if (height <= 0) return request;
  begin_part(ui, "drawing/chains_table", ui.px(width), ui.px(height), Tone::panel, 16);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Columns columns(ui, chain_columns, at.x, at.x + ImGui::GetContentRegionAvail().x);
  table_head(ui, columns);
  if (std::exchange(into_view_, false) && chosen_ >= 0)
    ImGui::SetScrollY(ui.px(chain_row) * static_cast<float>(chosen_) - ui.px(height / 2));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(made.chains.size()), ui.px(chain_row));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const drawing::Chain& chain = made.chains[ix(i)];
      const drawing::Point before = i > 0 ? made.chains[ix(i - 1)].end() : drawing::Point();
      const NumberText length = format_number(length_of(chain), 1);
      const NumberText way =
          format_number(std::hypot(chain.begin().x - before.x, chain.begin().y - before.y), 1);
      const Path time = ix(i) < seconds.size() ? Path("{:.1f}", seconds[ix(i)]) : Path("?");
      const Path words("{} mm, {} mm to it, {} s", length.view(), way.view(), time.view());
      const Touch touch = row(ui, Path("drawing/chain/{}", i + 1), Path("Chain {}", i + 1),
                              {.height = chain_row, .chosen = i == chosen_, .value = words});
      if (touch.clicked) chosen_ = i == chosen_ ? -1 : i;
      const auto cell = [&](std::size_t column, Tone tone, std::string_view text) {
        columns.text(ui, column, touch.rect, Face::body, ui[tone], text);
      };
      cell(0, Tone::ink2, Path("{}", i + 1));
      cell(1, Tone::ink, drawing.layers[ix(chain.layer)].name);
      cell(2, Tone::ink2, made_of(chain));
      cell(3, Tone::ink, length), cell(4, Tone::ink2, way), cell(5, Tone::ink, time);
    }
  clipper.End();
  end_part();
  return request;
}

}  // namespace hw::panels
