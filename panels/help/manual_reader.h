#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "gui/shell/frame.h"
#include "panels/help/manual_layout.h"
#include "panels/help/manual_pages.h"

namespace hw::panels {

/// Shows a page of the manual, or the table of contents. `help/page/scripts` opens a page,
/// `help/heading/connect` is a heading of the page shown, `help/link/0` its first link.
class ManualReader {
 public:
  /// `own`: the page of the controller in front, listed first; empty: none.
  void draw(gui::PageFrame& frame, std::string_view own);
  /// Opens "scripts", "scripts#read", "scripts.md#read", or "#read" on the page shown; empty: the contents.
  void open(std::string_view target);
  [[nodiscard]] bool can_go_back() const { return !before_.empty(); }
  void go_back();
  [[nodiscard]] bool shows_contents() const { return !now_.page; }
  /// The title of the page shown.
  [[nodiscard]] std::string_view title() const;

 private:
  struct Place {
    const ManualPage* page = nullptr;  ///< null: the contents
    float scroll = 0;                  ///< logical
  };
  void show(Place place);
  void draw_contents(gui::PageFrame& frame, std::string_view own);
  bool draw_row(gui::PageFrame& frame, const ManualPage& page);
  void draw_page(gui::PageFrame& frame);
  std::string_view draw_runs(gui::PageFrame& frame, ImVec2 at);
  void follow_request(float scale);

  Place now_;
  std::vector<Place> before_;
  ManualText text_;  ///< text of the page shown
  ManualLayout layout_;
  std::vector<std::string> titles_;  ///< titles of all pages
  std::string requested_anchor_;     ///< anchor to scroll to when the page is laid out
  bool scroll_requested_ = false;
};

}  // namespace hw::panels
