#pragma once
// A part of the screen. panels/panel_list.cpp lists all panels; the console lays them out by their place and
// never names one.
#include <memory>
#include <span>
#include <string_view>

#include "gui/model/panel.h"
#include "gui/model/status_sentence.h"
#include "gui/shell/frame.h"

namespace hw::gui {

/// A page without a controller; one object.
class Page {
 public:
  virtual ~Page() = default;
  virtual void draw(PageFrame& frame) = 0;
  /// The status line's text while the page is in front.
  virtual StatusSentence status(Console& console) = 0;
};

enum class Place : std::uint8_t {
  top_left,     ///< positions: the top of the left column, in a narrow window the strip; never scrolls
  left,         ///< the rest of the left column; in a narrow window the first panel tab
  centre,       ///< a panel tab
  below,        ///< below the panel tabs (the terminal); without room one more panel tab
  right,        ///< the right column, from the top; a rail in a medium, the last panel tab in a narrow window
  lower_right,  ///< under those, in the remaining height; scrolls by itself, and can be folded
};

/// Height of the title of a panel at `lower_right` with its fold button, logical. With no more than this,
/// only the title is shown.
inline constexpr float lower_right_title = 44;

struct PanelEntry {
  std::string_view id;  ///< `tab/ID`
  std::string_view title;
  Place place;
  std::unique_ptr<Panel> (*make)();
  /// Whether the panel is shown for this controller; null: always.
  bool (*wanted)(const Tab&) = nullptr;
  /// Logical. With less (a narrow window) it scrolls as a whole; 0: any height will do.
  float least_height = 0;
  /// Name ending of the dropped files that this panel opens: see Desk::take_dropped. Empty: none.
  std::string_view opens = {};
  /// Logical, of a panel tab. While it is in front, the part below shrinks to its least height, unless the
  /// user has set one; 0: does not shrink it.
  float good_height = 0;
  /// One panel for all controllers of a bus: the first one's, whichever is chosen.
  bool of_bus = false;
};

struct PageEntry {
  std::string_view id;  ///< "connect"
  std::string_view title;
  std::unique_ptr<Page> (*make)();
};

/// Lies beside the desk until it is put away, and covers neither a position nor a control that moves metal.
class Sheet {
 public:
  virtual ~Sheet() = default;
  virtual void draw(PageFrame& frame) = 0;
};

/// The contents of the console, in this order.
struct PanelList {
  std::span<const PanelEntry> panels;
  std::span<const PageEntry> pages;                 ///< the first is shown when no controller is open
  std::unique_ptr<Sheet> (*make_help)() = nullptr;  ///< null: there is none
};

}  // namespace hw::gui
