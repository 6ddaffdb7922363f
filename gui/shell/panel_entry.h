#pragma once
// A part of the screen. The list of all panels stands in panels/panel_list.cpp; the console lays them out by
// their place and never names one.
#include <memory>
#include <span>
#include <string_view>

#include "gui/model/panel.h"
#include "gui/model/status_sentence.h"
#include "gui/shell/frame.h"

namespace hw::gui {

/// Without a controller; one object.
class Page {
 public:
  virtual ~Page() = default;
  virtual void draw(PageFrame& frame) = 0;
  /// For the status line while it is in front.
  virtual StatusSentence status(Console& console) = 0;
};

enum class Place : std::uint8_t {
  top_left,     ///< positions: the top of the left column, in a narrow window the strip; never scrolls
  left,         ///< the rest of the left column; in a narrow window the first panel tab
  centre,       ///< a panel tab
  below,        ///< under the panel tabs (the terminal); without room one more panel tab
  right,        ///< the right column, from the top; a rail in a medium, the last panel tab in a narrow window
  lower_right,  ///< under those, in what they leave; moves with a scroll bar of its own, and can be folded
};

/// Of a panel at `lower_right`, logical: its title, with the button that folds it. In no more it shows only
/// that.
inline constexpr float lower_right_title = 44;

struct PanelEntry {
  std::string_view id;  ///< `tab/ID`
  std::string_view title;
  Place place;
  std::unique_ptr<Panel> (*make)();
  /// Whether this controller has something to show there; null: always.
  bool (*wanted)(const Tab&) = nullptr;
  /// Logical. In less (a narrow window) it scrolls as a whole; 0: it manages with any.
  float least_height = 0;
  /// Files let fall on the window whose names end so are this panel's: see Desk::take_dropped. Empty: none.
  std::string_view opens = {};
  /// Logical, of a panel tab. While it is in front the part below gives way, down to its least, unless
  /// somebody has given that a height of his own; 0: it does not.
  float good_height = 0;
  /// Controllers that share a bus have one for all of them: it is the first one's, whichever is chosen.
  bool of_bus = false;
};

struct PageEntry {
  std::string_view id;  ///< "connect"
  std::string_view title;
  std::unique_ptr<Page> (*make)();
};

/// Lies beside the desk, over neither a position nor a control that moves metal, until it is put away.
class Sheet {
 public:
  virtual ~Sheet() = default;
  virtual void draw(PageFrame& frame) = 0;
};

/// What the console shows, in this order.
struct PanelList {
  std::span<const PanelEntry> panels;
  std::span<const PageEntry> pages;                 ///< the first is shown when no controller is open
  std::unique_ptr<Sheet> (*make_help)() = nullptr;  ///< null: there is none
};

}  // namespace hw::gui
