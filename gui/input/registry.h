#pragma once
// All widgets of a frame, by their ids, for scripts, tests, the focus order and, later, screen readers.
// Filled while drawing, read after the frame. Allocates nothing once it has grown.
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
  std::string_view label;   ///< visible label
  std::string_view value;   ///< shown or held value, plain ASCII
  std::string_view reason;  ///< why it is disabled
  Kind kind = Kind::button;
  Rect rect{}, clip{};  ///< pixels; its visible part of the window
  int layer = 0;        ///< depth of popups and dialogs; only widgets of the deepest layer can be used
  bool enabled = true;
  bool moving = false;         ///< can start motion
  bool stops = false;          ///< a Stop: nothing may cover it
  bool card = false;           ///< the background of a card that covers other parts: no toast may cover it
  double settled_since_s = 0;  ///< `moving`: at rest and ready since then, see press_guard.h
  bool press_ignored = false;  ///< `moving`: a press came too early just now
  bool hovered = false;        ///< the mouse is over it, and nothing covers it
  [[nodiscard]] bool usable() const {
    return kind != Kind::lamp && kind != Kind::text && kind != Kind::meter;
  }
  [[nodiscard]] bool in_view() const { return clip.contains(rect.centre()); }
  [[nodiscard]] bool wholly_in_view() const { return clip.contains(rect.min) && clip.contains(rect.max); }
};

class Registry {
 public:
  void begin_frame();
  /// Copies the texts. Values lose non-ASCII characters: the minus becomes '-', a thin space is dropped.
  void add(const Widget& widget);
  void end_frame();

  /// The last complete frame, in drawing order.
  [[nodiscard]] std::span<const Widget> widgets() const { return shown_.widgets; }
  [[nodiscard]] const Widget* find(std::string_view id) const;
  [[nodiscard]] int top_layer() const { return shown_.top_layer; }

  /// Keeps tooltips off an area (a refusal, limit lamps). Call in each frame.
  void keep_clear(const Rect& rect) { drawn_.clear.push_back(rect); }
  /// The areas of the last complete frame.
  [[nodiscard]] std::span<const Rect> kept_clear() const { return shown_.clear; }

  /// Asks the widget to scroll itself into view in the next frame that draws it.
  void scroll_to(std::string_view id) { scroll_to_ = id; }
  /// Called by a widget: returns true, once, when it was asked to scroll.
  bool wants_scroll(std::string_view id);

 private:
  struct Page {
    std::string texts;
    std::vector<Widget> widgets;  // while drawing, views hold offsets into `texts`
    std::vector<Rect> clear;
    int top_layer = 0;
  };
  std::string_view keep(std::string_view text, bool ascii_only);
  Page drawn_, shown_;
  std::string scroll_to_;
};

}  // namespace hw::gui
