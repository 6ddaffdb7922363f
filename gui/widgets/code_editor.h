#pragma once
// The program editor shows line numbers, marks, coloured text, the cost of each line at the right, and the
// line that runs now. A problem is explained below its line, with a fix. Only visible lines are drawn.
// TextModel holds the text and its undo steps; colours, costs and problems come from the language's report.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "core/device/language.h"
#include "gui/surface/ui.h"
#include "gui/widgets/find_bar.h"
#include "gui/widgets/text_model.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

struct EditorLook {
  const ProgramReport* report = nullptr;          ///< made from this text; null: no colours
  std::string_view problems = "program/problem";  ///< id of the problem rows: `.../1`, `.../1/fix`
  std::string_view cost_title = {};               ///< "bytes"; empty: no costs
  std::string_view comment_mark = "; ";
  int live_line = -1;                      ///< from 0; -1: none
  std::span<const int> also_live = {};     ///< of other programs running at the same time
  bool live_reported = false;              ///< true: reported by the controller; false: estimated
  std::string_view live = "program/live";  ///< id of the live line
  std::string_view live_words = {};        ///< at the right of the live line: "pass 7 of 20"
  std::string_view read_only = {};         ///< why the text cannot be edited; empty: it can
  std::string_view placeholder = {};       ///< shown while the text is empty
  float height = fill;                     ///< logical
};

struct EditorEvent {
  bool edited = false;
  bool typing = false;  ///< has the caret
};

class CodeEditor {
 public:
  EditorEvent draw(Ui& ui, std::string_view id, const EditorLook& look);

  /// Shows another text; does nothing when it is the same.
  void load(std::string_view text);
  [[nodiscard]] const std::string& text() const { return text_; }
  TextModel& model() { return model_; }
  /// Moves the caret there and scrolls to the line.
  void go_to(TextPlace place);
  /// Do the same as Ctrl+F and Ctrl+/, for users who do not know the keys. They take effect in the next
  /// draw().
  void ask_find() { find_asked_ = true; }
  void toggle_comment() { comment_asked_ = true; }

 private:
  struct Metrics {
    float line, problem, advance, text_x;  // pixels
    Rect view;                             // of the lines, on the screen
    ImVec2 origin;                         // of line 0's row, column 0, with scrolling
  };
  Metrics measure(Ui& ui) const;
  void collect_problems(const EditorLook& look);
  [[nodiscard]] float top_of(const Metrics& m, int line) const;
  [[nodiscard]] int line_at(const Metrics& m, float y) const;
  [[nodiscard]] TextPlace place_at(const Metrics& m, ImVec2 at) const;
  [[nodiscard]] float x_of(const Metrics& m, TextPlace p) const;
  [[nodiscard]] const Problem* problem_in(const EditorLook& look, int line, bool error) const;

  void use_mouse(Ui& ui, const Metrics& m, const Touch& t);
  void use_keys(Ui& ui, const EditorLook& look, const Metrics& m);
  bool use_control_keys(Ui& ui, const EditorLook& look, bool shift);
  void use_caret_keys(const Metrics& m, bool ctrl, bool shift);
  void keep_caret_in_sight(const Metrics& m);
  void follow_live_line(const EditorLook& look, const Metrics& m);
  void remember();

  void draw_lines(Ui& ui, const EditorLook& look, const Metrics& m);
  void draw_ground(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row);
  void draw_selection(const Metrics& m, int line, const Rect& row);
  void draw_code(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row);
  void draw_gutter(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row);
  void draw_right(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row);
  void draw_problem_row(Ui& ui, const EditorLook& look, const Metrics& m, const Problem& problem, int number);
  void draw_caret(Ui& ui, const Metrics& m);

  TextModel model_;
  std::string text_;  // of model_, kept up to date
  std::uint64_t text_version_ = 1;
  std::vector<int> problem_lines_;  // lines with a row below, sorted
  FindBar find_;
  bool typing_ = false, reveal_ = false, dragging_ = false;
  bool find_asked_ = false, comment_asked_ = false;
  int followed_line_ = -1;
  float followed_height_ = 0;  ///< of the view, in pixels
  float widest_ = 0;
};

}  // namespace hw::gui
