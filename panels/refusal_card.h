#pragma once
// What was refused, beside the row of the left column that asked for it: the words, what may be done instead,
// a cross. It lies over the centre at the column's border and pushes nothing; it lies over nothing that a
// hand reaches for. Where no such place is free, in a narrow window, and for what stands in the centre
// itself, it is a bar over the status line.
//
// How a panel uses it: a RefusalCard for each row, kept by the panel, drawn in each frame in which it stands.
//
//     const Path home("goto/{}/home", name), once("goto/{}/once", name);   // they must outlive the calls
//     const gui::Action actions[] = {{.id = home, .label = "Home", .disabled = why, .moving = true},
//                                    {.id = once, .label = "Go on for this once", .moving = true}};
//     Refusal refusal{.id = id, .about = "Go, X", .words = row.refused, .actions = actions};
//     refusal.slot_width = 200, refusal.slot_in_bar = 120;  // only with a field or the like of the panel's
//     own card.begin(f, refusal, row_rect);            // row_rect: pixels, of the row that it is about
//     number_field(...);                           // only with a slot: at the cursor, 32 high, 28 if
//     is_bar() const RefusalTouch done = card.end(); if (done.action == 0) ...                    // the
//     index in `actions` if (done.closed) row.refused.clear();        // its cross
//
// The words have the id, the cross `<id>/close`. An action that moves waits as every moving button does: a
// card has only just come where it opens.
#include <span>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/widgets/message.h"

namespace hw::panels {

struct Refusal {
  std::string_view id;     ///< of its words: "goto/1/refused"
  std::string_view about;  ///< in bold over them: "Go, X"
  std::string_view words;  ///< what was asked for, by how much it does not go, what was done or not
  std::span<const gui::Action> actions;
  /// Logical: of what the panel draws itself before the actions, in a row of 32, and in the bar, in one
  /// of 28.
  float slot_width = 0, slot_in_bar = 0;
};

struct RefusalTouch {
  int action = -1;  ///< the one just pressed
  bool closed = false;
};

class RefusalCard {
 public:
  void begin(gui::Frame& frame, const Refusal& what, const gui::Rect& row);
  RefusalTouch end();
  [[nodiscard]] bool is_bar() const { return bar_; }  ///< from begin() on

 private:
  void find_place(const gui::Frame& frame, const gui::Rect& row);
  void draw_card_words();
  void draw_bar_words();

  gui::Ui* ui_ = nullptr;  ///< like `what_` from begin() to end() only
  Refusal what_;
  gui::Rect place_{}, row_{};  ///< where it lies, and for which row; empty: nowhere yet
  bool bar_ = false;
  ImVec2 rows_{};    ///< where slot and actions begin
  float width_ = 0;  ///< logical, of their rows
};

}  // namespace hw::panels
