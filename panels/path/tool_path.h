#pragma once
// Shows the path of the rehearsed program in two or three axes, or in one axis over time, and the real path
// of the axes. A bus has one such panel. Ids: `path/simulate`, `path/fit`, `path/fit_table`, `path/nearer`,
// `path/further`, `path/forget`, `path/save`, `path/view`, `path/hit`, `path/measure`, `path/show_line`,
// `path/run_here`; the axes: see PathChoice; the legend: see draw_path_legend().
#include <optional>
#include <string>

#include "gui/shell/panel_entry.h"
#include "panels/path/path_canvas.h"
#include "panels/path/path_choice.h"
#include "panels/path/path_export.h"
#include "panels/path/program_path.h"
#include "panels/path/run_drawn_from.h"
#include "panels/program/run_from.h"

namespace hw::panels {

class ToolPath final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  /// A place in the rehearsed text, and the words about it or about the clicked part.
  struct Hit {
    int source = -1, count = 1;  ///< sources of the line; 1: a single source
    std::string words;
    std::optional<int> pass = {};  ///< pass at that place; nullopt: unknown
  };
  void draw_all(gui::Frame& frame);
  [[nodiscard]] PathSubject subject_of(const gui::Frame& frame) const;
  [[nodiscard]] std::string place_text(const gui::Frame& frame, drawing::Point3 place) const;
  void describe_hit(gui::Frame& frame);
  void describe_measure(const gui::Frame& frame);
  void follow_caret(const gui::Frame& frame);
  void follow_block(const gui::Frame& frame);
  [[nodiscard]] const gui::WrittenSequence* blocks_of_text(const gui::Frame& frame) const;
  void light(const gui::Frame& frame, int line);
  void draw_toolbar(gui::Frame& frame);
  void draw_view_tools(gui::Frame& frame);
  void draw_hit(gui::Frame& frame, float width);
  void draw_hit_links(gui::Frame& frame, float& right_px, float y_px);
  void ask_to_run_from_hit(gui::Frame& frame);
  [[nodiscard]] int first_to_move(const gui::WrittenSequence& written, int step) const;

  std::optional<Catalog>
      together_;  ///< catalog of all controllers of the bus; nullopt: that of this controller
  PathChoice choice_;
  ProgramPath program_;
  PathCanvas canvas_;
  PathExport export_;
  RunFrom run_from_;
  RunDrawnFrom run_drawn_;
  Hit hit_;
  int caret_line_ = -1, chosen_step_ = -1;
};

}  // namespace hw::panels
