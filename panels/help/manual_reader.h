#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "gui/shell/frame.h"
#include "panels/help/manual_layout.h"
#include "panels/help/manual_pages.h"

namespace hw::panels {

/// The manual, a page at a time, and what it holds. `help/page/scripts` opens a page, `help/heading/connect`
/// is a heading of the one that is shown, `help/link/0` the first link of it.
class ManualReader {
 public:
  /// `own`: the page of the controller in front, which stands first; empty: none.
  void draw(gui::PageFrame& frame, std::string_view own);
  /// "scripts", "scripts#read", "scripts.md#read", "#read" on the page that is shown; empty: what it holds.
  void open(std::string_view target);
  [[nodiscard]] bool can_go_back() const { return !before_.empty(); }
  void go_back();
  [[nodiscard]] bool shows_contents() const { return !now_.page; }
  /// Of what is shown.
  [[nodiscard]] std::string_view title() const;

 private:
  struct Place {
    const ManualPage* page = nullptr;  ///< null: what it holds
    float scroll = 0;                  ///< logical
  };
  void show(Place place);
  void draw_contents(gui::PageFrame& frame, std::string_view own);
  bool draw_row(gui::PageFrame& frame, const ManualPage& page);
  void draw_page(gui::PageFrame& frame);
  std::string_view draw_runs(gui::PageFrame& frame, ImVec2 at);
  void follow_wish(float scale);

  Place now_;
  std::vector<Place> before_;
  ManualText text_;  ///< of the page that is shown
  ManualLayout layout_;
  std::vector<std::string> titles_;  ///< of all pages
  std::string wished_anchor_;        ///< to be scrolled to when the page has been laid out
  bool wishes_scroll_ = false;
};

}  // namespace hw::panels
