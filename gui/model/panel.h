#pragma once
// A part of the screen that belongs to one controller. Its tab owns it; the shell lays it out and draws it.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hw::gui {

struct Frame;

/// One object per open controller: its members are the view state of that controller.
class Panel {
 public:
  virtual ~Panel() = default;
  virtual void draw(Frame& frame) = 0;
  /// The data that only this object holds and closing it would lose, as a sentence; empty: none.
  [[nodiscard]] virtual std::string_view unkept() const { return {}; }
};

/// The panels of one controller.
struct OpenPanels {
  /// Parallel to the console's list; null until first drawn.
  std::vector<std::unique_ptr<Panel>> all;
  std::string in_front;  ///< id of the one in the centre
  /// The data that closing them would lose, see Panel::unkept(); empty: none.
  [[nodiscard]] std::string unkept() const;
};

}  // namespace hw::gui
