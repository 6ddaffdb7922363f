#pragma once
// A part of the screen that belongs to one controller. Its tab owns it; the shell lays it out and draws it.
#include <string_view>

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

}  // namespace hw::gui
