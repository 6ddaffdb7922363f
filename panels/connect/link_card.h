#pragma once
// The link doctor's card below a controller of the connection page. It shows the time spent on a question,
// the findings about the link with their remedies, and, if the controller does not answer, an editor for its
// address. Ids: `connect/doctor/...`.
#include <string>
#include <vector>

#include "core/link/doctor.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "panels/connect/rate_raise.h"

namespace hw::panels {

class LinkCard {
 public:
  /// Unfolds or folds the card of this controller. `address`: shows its address editor.
  void toggle(gui::PageFrame& frame, const gui::Tab& tab, bool address = false);
  /// Unfolds the card, unless it is unfolded already.
  void unfold(gui::PageFrame& frame, const gui::Tab& tab) {
    if (!is_of(tab)) toggle(frame, tab);
  }
  void fold() { *this = LinkCard(); }
  [[nodiscard]] bool is_of(const gui::Tab& tab) const;
  /// Whether the card of an open controller is unfolded. Work that the card has begun continues while it is
  /// folded.
  [[nodiscard]] bool is_open(gui::PageFrame& frame);
  /// `address_offered`: the row above has a button to change the address.
  void draw(gui::PageFrame& frame, gui::Tab& tab, float width, bool address_offered);

 private:
  void look(gui::PageFrame& frame, gui::Tab& tab);
  void draw_summary(gui::Ui& ui, const gui::Tab& tab, float width);
  void draw_budget(gui::Ui& ui, float width);
  void draw_finding(gui::PageFrame& frame, gui::Tab& tab, std::size_t index, float width);
  void mend(gui::PageFrame& frame, gui::Tab& tab, const LinkFinding& finding);
  void draw_steps(gui::PageFrame& frame, float width);
  void draw_address(gui::PageFrame& frame, gui::Tab& tab, float width);
  void follow_raise(gui::PageFrame& frame);

  std::string of_;  ///< address of the controller; empty: folded
  LinkFacts facts_;
  LinkBudget now_, then_;
  std::string summary_;
  std::vector<LinkFinding> findings_;
  double looked_at_s_ = -1, examined_at_s_ = 0;
  float height_ = 0;              ///< pixels taken in the last frame
  bool changes_address_ = false;  ///< the field for the address is shown
  bool address_offered_ = false;  ///< the row or that field offers it, so a finding does not
  std::string address_, refused_;
  RateRaise raise_;
  bool wants_back_ = false;  ///< going back was requested while drawing a controller that it closes
};

}  // namespace hw::panels
