#pragma once
// Paths at constant speed and staircases of speeds: edited as a list, drawn, checked, and run in the
// controller's own language. Ids: `contour/kind`, `contour/first`, `contour/speed`, `contour/ROW/x` (rows
// from 1), `contour/add/line`, `contour/run`, `contour/to_program`, `contour/open`, `contour/save`,
// `contour/text`, `contour/problem`, `contour/view`, `contour/refused`, `contour/nearest`; `stairs/...`
// alike.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/drawing/contour_path.h"
#include "gui/model/list_run.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/plot.h"
#include "panels/contour/contour_file.h"
#include "panels/contour/contour_unit.h"
#include "panels/doubt_remedies.h"
#include "panels/path/path_canvas.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class Contour final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;
  [[nodiscard]] std::string_view unkept() const override;

 private:
  enum class PieceKind : std::uint8_t { line, arc, output };
  struct Piece {
    PieceKind kind = PieceKind::line;
    gui::NumberField x, y, degrees;
    int output = 0;  ///< index into Names::outputs
    bool on = true;
  };
  struct Stair {
    gui::NumberField until, speed;
  };
  void make(const gui::Frame& frame);
  void follow_units(const gui::Frame& frame);
  void work_out(gui::Frame& frame);
  /// A sequence of one contour, in steps of its two axes.
  Result<sequence::Sequence> contour() const;
  /// A sequence of one staircase of speeds, in steps.
  Result<sequence::Sequence> staircase() const;
  void draw_staircase_line(const sequence::SpeedStairs& stairs, double from);
  /// Sets the path or the plot. The fault says why the step cannot be drawn.
  Result<> draw_step(const sequence::Step& step);
  Result<SequenceText> write(const sequence::Sequence& plan, const Catalog& catalog) const;
  void add_places(const sequence::Sequence& plan, const Catalog& catalog);
  /// The list that is shown, in the unit in which it is typed.
  Result<sequence::Sequence> shown_list() const;
  Result<sequence::Sequence> list_for_file() const;
  void opened(gui::Frame& frame, const sequence::Sequence& sequence);
  bool take_contour(const sequence::Sequence& sequence);
  bool take_staircase(const sequence::Sequence& sequence);
  void follow(gui::Frame& frame);
  void run(gui::Frame& frame);
  void put_into_program(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not_run(const gui::Frame& frame) const;

  // ---- contour_refused.cpp
  [[nodiscard]] std::optional<Steps> shift_inside(const gui::Frame& frame) const;
  void shift(const gui::Frame& frame, Steps by);
  void draw_refused(gui::Frame& frame, const gui::Rect& beside);

  void draw_toolbar(gui::Frame& frame);
  void draw_work(gui::Frame& frame, float width, float height);
  void draw_preview(gui::Frame& frame, float width, float height);
  void draw_text(gui::Frame& frame, float width);
  void draw_dialogs(gui::Frame& frame);

  // ---- contour_edit.cpp
  void edited();  ///< call when the user has edited the list that is shown
  void draw_contour_list(gui::Frame& frame, float width);
  void draw_contour_head(gui::Frame& frame, float width);
  bool draw_piece(gui::Frame& frame, std::size_t row, float width);
  void draw_adders(gui::Frame& frame);
  void add(PieceKind kind);
  void draw_stairs_list(gui::Frame& frame, float width);
  bool draw_stair(gui::Frame& frame, std::size_t row, float width);
  void number(gui::Frame& frame, std::string_view id, std::string_view label, gui::NumberField& field,
              gui::NumberRange range, ImVec2 at, float width);
  int axis_choice(gui::Frame& frame, std::string_view id, std::string_view label, int chosen, ImVec2 at,
                  std::string_view words);

  const Language* language_ = nullptr;  ///< the tab's language; may be null
  gui::ListRun* run_ = nullptr;         ///< the desk's
  bool changed_ = true;
  bool stairs_shown_ = false;
  struct Names {
    std::vector<std::string_view> axes, outputs;
    std::vector<int> output_numbers;  ///< the maker's numbers of the outputs
  };
  Names names_;
  struct ContourList {
    int first = 0, second = 1;
    ContourUnit unit;  ///< unit of the numbers in the fields
    bool ramp = true;
    gui::NumberField speed, x, y, lead_in;
    std::vector<Piece> pieces;
    bool unkept = false;  ///< edited since it was last put into the program
  };
  ContourList contour_;
  struct StairsList {
    int axis = 0;
    ContourUnit unit;
    gui::NumberField stop_at;
    std::vector<Stair> rows;
    bool unkept = false;
  };
  StairsList stairs_;
  /// The results, worked out again after each change.
  struct WorkedOut {
    std::shared_ptr<const drawing::ToolPath> path;
    std::vector<AxisTarget> places;  ///< targets of the text
    std::string text, problem, facts;
    std::vector<float> stair_x, stair_y;
    Steps from{};  ///< position of the staircase's axis at that time
  };
  WorkedOut worked_;
  drawing::Point scale_;  ///< units of the view per step of the axes
  PathCanvas canvas_;
  gui::PlotCursor cursor_;
  ContourFile file_;
  DoubtRemedies doubt_;
  std::optional<PastTravel> past_;  ///< why the list was refused
  std::string refused_;
  std::vector<AxisTarget> refused_places_;
  RefusalCard card_;
  bool asking_ = false;
};

}  // namespace hw::panels
