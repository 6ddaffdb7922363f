#pragma once
// Paths at constant speed and staircases of speeds: edited as a list, drawn, checked, and run in the
// controller's own language. Ids: `contour/kind`, `contour/first`, `contour/speed`, `contour/ROW/x` (rows
// from 1), `contour/add/line`, `contour/run`, `contour/to_program`, `contour/open`, `contour/save`,
// `contour/text`, `contour/problem`, `contour/view`; `stairs/...` alike.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/drawing/contour_path.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/plot.h"
#include "panels/contour/contour_file.h"
#include "panels/contour/contour_unit.h"
#include "panels/doubt_ways.h"
#include "panels/path/path_canvas.h"

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
    int output = 0;  ///< index into `outputs_`
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
  /// The fault: why the step cannot be drawn. Else sets `path_` or the plot.
  Result<> draw_step(const sequence::Step& step);
  Result<SequenceText> write(const sequence::Sequence& plan, const Catalog& catalog) const;
  void add_places(const sequence::Sequence& plan, const Catalog& catalog);
  /// The list shown, in its unit, for a file.
  Result<sequence::Sequence> shown_list() const;
  void opened(gui::Frame& frame, const sequence::Sequence& sequence);
  bool take_contour(const sequence::Sequence& sequence);
  bool take_staircase(const sequence::Sequence& sequence);
  void follow(gui::Frame& frame);
  void run(gui::Frame& frame);
  void put_into_program(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not_run(const gui::Frame& frame) const;

  void draw_toolbar(gui::Frame& frame);
  void draw_work(gui::Frame& frame, float width, float height);
  void draw_preview(gui::Frame& frame, float width, float height);
  void draw_text(gui::Frame& frame, float width);
  void draw_dialogs(gui::Frame& frame);

  // ---- contour_edit.cpp
  void edited();  ///< the list that is shown, by hand
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

  const Language* language_ = nullptr;  ///< of the tab, or null
  bool made_ = false, changed_ = true;
  bool stairs_shown_ = false;
  bool contour_unkept_ = false, stairs_unkept_ = false;  ///< edited since last put into the program
  std::vector<std::string_view> axis_names_, output_names_;
  std::vector<int> outputs_;  ///< the maker's numbers

  int first_ = 0, second_ = 1, stair_axis_ = 0;
  ContourUnit unit_, stairs_unit_;  ///< of the numbers in the fields
  bool ramp_ = true;
  gui::NumberField speed_, x_, y_, lead_in_, stop_at_;
  std::vector<Piece> pieces_;
  std::vector<Stair> stairs_;

  // The results, recomputed when something has changed.
  std::shared_ptr<const drawing::ToolPath> path_;
  drawing::Point scale_;  ///< units of the view per step
  PathCanvas canvas_;
  std::vector<AxisTarget> places_;  ///< targets of its text
  std::string text_, problem_, facts_;
  std::vector<float> stair_x_, stair_y_;
  Steps worked_out_from_{};  ///< position of the staircase's axis at that time
  gui::PlotCursor cursor_;

  ContourFile file_;
  IntentId loading_ = 0, starting_ = 0;
  DoubtWays doubt_;
  std::weak_ptr<void> go_ahead_;  ///< of the latest Run; expires on a stop
  int drawn_frame_ = 0;
  bool asking_ = false;
};

}  // namespace hw::panels
