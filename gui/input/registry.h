#pragma once
// Every widget of the frame, by its path: what scripts, tests, the focus order and later screen readers know
// of the screen. Filled while drawing, read after the frame. Allocates nothing once it has grown.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace hw::gui {

enum class Kind : std::uint8_t {
  button,
  hold,  ///< acts while held
  toggle,
  lamp,    ///< shows only
  text,    ///< shows only
  field,   ///< a line of text
  editor,  ///< many lines of text
  choice,  ///< one of several
  list,    ///< opens a list of choices
  slider,
  tab,
  row,
  meter,
  link,
};
std::string_view name_of(Kind kind);

struct Rect {
  ImVec2 min, max;
  [[nodiscard]] ImVec2 centre() const { return ImVec2((min.x + max.x) * 0.5f, (min.y + max.y) * 0.5f); }
  [[nodiscard]] float width() const { return max.x - min.x; }
  [[nodiscard]] float height() const { return max.y - min.y; }
  [[nodiscard]] bool contains(ImVec2 p) const {
    return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y;
  }
};

struct Widget {
  std::string_view id;      ///< stable path: `jog/1/+`
  std::string_view label;   ///< what a person reads on it
  std::string_view value;   ///< what it shows or holds, plain ASCII
  std::string_view reason;  ///< disabled: why
  Kind kind = Kind::button;
  Rect rect{}, clip{};  ///< pixels; what of the window may be seen there
  int layer = 0;        ///< depth of popups and dialogs; only the deepest can be used
  bool enabled = true;
  bool moving = false;        ///< can start motion
  bool stops = false;         ///< a Stop: nothing may lie over it
  bool card = false;          ///< the ground of a card that lies over other parts: no toast may lie on it
  double stands_since_s = 0;  ///< `moving`: it stands still and ready since then, see standing.h
  bool not_taken = false;     ///< `moving`: a press has just come too early, and it says so
  bool hovered = false;       ///< the mouse is over it and nothing covers it
  [[nodiscard]] bool usable() const {
    return kind != Kind::lamp && kind != Kind::text && kind != Kind::meter;
  }
  [[nodiscard]] bool in_view() const { return clip.contains(rect.centre()); }
};

class Registry {
 public:
  void begin_frame();
  /// Copies the texts. Values lose what is not ASCII: the minus becomes '-', a thin space goes.
  void add(const Widget& widget);
  void end_frame();

  /// The last complete frame, in drawing order.
  [[nodiscard]] std::span<const Widget> widgets() const { return shown_.widgets; }
  [[nodiscard]] const Widget* find(std::string_view id) const;
  [[nodiscard]] int top_layer() const { return shown_.top_layer; }

  /// Asks the widget to bring itself into view in the next frame in which it is drawn.
  void scroll_to(std::string_view id) { scroll_to_ = id; }
  /// For widgets: whether it was asked; answers once.
  bool wants_scroll(std::string_view id);

 private:
  struct Page {
    std::string texts;
    std::vector<Widget> widgets;  // while drawing, views hold offsets into `texts`
    int top_layer = 0;
  };
  std::string_view keep(std::string_view text, bool ascii_only);
  Page drawn_, shown_;
  std::string scroll_to_;
};

}  // namespace hw::gui
