#pragma once
// Describes a panel and a page of the console. panels/panel_list.cpp lists all of them. The console lays them
// out by their place and never names a panel.
#include <memory>
#include <span>
#include <string_view>

#include "gui/model/panel.h"
#include "gui/model/status_sentence.h"
#include "gui/shell/frame.h"

namespace hw::gui {

/// A page without a controller. There is one object for each page.
class Page {
 public:
  virtual ~Page() = default;
  virtual void draw(PageFrame& frame) = 0;
  /// The text of the status line while the page is in front.
  virtual StatusSentence status(Console& console) = 0;
};

enum class Place : std::uint8_t {
  top_left,     ///< positions: the top of the left column, in a narrow window the strip; never scrolls
  left,         ///< the rest of the left column; in a narrow window the first panel tab
  centre,       ///< a panel tab
  below,        ///< below the panel tabs (the terminal); where it does not fit, a panel tab
  right,        ///< the right column, from the top; a rail in a medium, the last panel tab in a narrow window
  lower_right,  ///< below those, in the remaining height; scrolls separately, and can be folded
};

/// Height of the title and fold button of a panel at `lower_right`, logical. With no more than this height,
/// only the title is shown.
inline constexpr float lower_right_title = 44;

struct PanelEntry {
  std::string_view id;  ///< `tab/ID`
  std::string_view title;
  Place place;
  std::unique_ptr<Panel> (*make)();
  /// Whether the panel is shown for this controller; null: always.
  bool (*wanted)(const Tab&) = nullptr;
  /// Least height, logical. In a lower window the whole panel scrolls; 0: any height is enough.
  float least_height = 0;
  /// File name ending of the dropped files that this panel opens: see Desk::take_dropped. Empty: it opens
  /// none.
  std::string_view opens = {};
  /// Good height of a panel tab, logical. While the tab is in front, the part below shrinks to its least
  /// height to give it, unless the user has set a height; 0: the part below does not shrink.
  float good_height = 0;
  /// All controllers of a bus share the panel of the first controller.
  bool of_bus = false;
};

struct PageEntry {
  std::string_view id;  ///< "connect"
  std::string_view title;
  std::unique_ptr<Page> (*make)();
};

/// A sheet lies beside the panels until the user closes it. It covers no position and no control that can
/// start motion.
class Sheet {
 public:
  virtual ~Sheet() = default;
  virtual void draw(PageFrame& frame) = 0;
};

/// The contents of the console, in this order.
struct PanelList {
  std::span<const PanelEntry> panels;
  std::span<const PageEntry> pages;                 ///< the first is shown when no controller is open
  std::unique_ptr<Sheet> (*make_help)() = nullptr;  ///< null: there is no help
};

}  // namespace hw::gui
