#pragma once
// Shows a refusal beside the row of the left column that caused it: the words, the remedies, a cross. The
// card lies over the centre at the column's border. It moves nothing and covers no control that may be
// needed. If there is no such place, in a narrow window, and for controls in the centre, it is a bar over the
// status line.
//
// Usage: the panel keeps a RefusalCard for each row and draws it in each frame until the refusal is closed.
//
//     const Path home("goto/{}/home", name), once("goto/{}/once", name);   // they must outlive the calls
//     const gui::Action actions[] = {{.id = home, .label = "Home", .disabled = why, .moving = true},
//                                    {.id = once, .label = "Go on this once", .moving = true}};
//     Refusal refusal{.id = id, .about = "Go, X", .words = row.refused, .actions = actions};
//     refusal.slot_width = 200, refusal.slot_in_bar = 120;  // only with a field of the panel's own
//     card.begin(f, refusal, row_rect);  // row_rect: pixels, of the row that it is about
//     number_field(...);                 // only with a slot: at the cursor, 32 high, 28 if is_bar()
//     const RefusalTouch done = card.end();
//     if (done.action == 0) ...                 // an index into `actions`
//     if (done.closed) row.refused.clear();     // its cross
//
// The words have the id, the cross has `<id>/close`. An action that can start motion ignores an early press,
// because a card appears suddenly.
#include <optional>
#include <span>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/widgets/message.h"
#include "panels/free_place.h"

namespace hw::panels {

struct Refusal {
  std::string_view id;     ///< id of the words: "goto/1/refused"
  std::string_view about;  ///< title in bold: "Go, X"
  std::string_view
      words;  ///< what was asked for, by how much it exceeds the range, and whether anything was done
  std::span<const gui::Action> actions;
  /// Logical width of the panel's own widget before the actions: in the card's row of 32, and in the bar's
  /// row of 28.
  float slot_width = 0, slot_in_bar = 0;
};

struct RefusalTouch {
  int action = -1;  ///< index of the action pressed in this frame
  bool closed = false;
};

class RefusalCard {
 public:
  void begin(gui::Frame& frame, const Refusal& what, const gui::Rect& row);
  RefusalTouch end();
  [[nodiscard]] bool is_bar() const { return bar_; }  ///< valid after begin()

 private:
  void find_place(const gui::Frame& frame, const gui::Rect& row);
  [[nodiscard]] std::optional<gui::Rect> free_place(const gui::Ui& ui, const gui::Rect& row,
                                                    ImVec2 size) const;
  void draw_card_words();
  void draw_bar_words();

  gui::Ui* ui_ = nullptr;  ///< valid, as `what_`, only from begin() to end()
  Refusal what_;
  FreePlace free_;
  gui::Rect place_{}, row_{};  ///< place of the card and of its row, in pixels; empty: no place yet
  bool bar_ = false;
  ImVec2 rows_{};    ///< where slot and actions begin
  float width_ = 0;  ///< width of these rows, logical
};

}  // namespace hw::panels
