#pragma once
// Where a tool goes and has been, in two axes: to be looked at, moved about and pointed at. What is long is
// drawn by the worker; until it is done the picture of before is shown, moved along.
#include <memory>
#include <optional>
#include <string_view>

#include "core/drawing/tool_path.h"
#include "gui/frame.h"
#include "gui/path_picture.h"
#include "gui/position_trace.h"
#include "gui/ui.h"

namespace hw::panels {

/// What is shown, all of it in the units of the two axes.
struct PathSubject {
  std::shared_ptr<const drawing::ToolPath> path;  ///< null: none
  std::string_view none;                          ///< said then
  AxisId right{0}, up{1};
  int lit = -1;                 ///< runs of this source stand out
  drawing::Box table = {};      ///< where the tool gets; empty: not known
  std::string_view words = {};  ///< what it comes to, for scripts; empty: how much of a unit a pixel is
};

/// Where the axes have really been.
struct TraceHit {
  drawing::Point at;
  Instant when{};  ///< to the second
};

class PathCanvas {
 public:
  /// At ImGui's cursor, logical size. Ids: `id` (the view, drag and wheel; with the focus + - 0, and arrows
  /// with Alt, for arrows alone jog), `id/here`.
  void draw(gui::Frame& frame, std::string_view id, const PathSubject& subject, float width, float height);
  /// All of it, with the next frame.
  void fit() { fitted_ = moved_ = false; }
  void zoom(double factor);
  /// What was clicked in this frame.
  [[nodiscard]] const std::optional<drawing::PathHit>& clicked() const { return clicked_; }
  [[nodiscard]] const std::optional<TraceHit>& passed() const { return passed_; }

  /// Wherever it was, in the units of the axes; the path or the end of a line where that is near.
  [[nodiscard]] const std::optional<drawing::Point>& clicked_place() const { return clicked_place_; }

  /// Clicks set the two ends of a measured way, on the path where it is near.
  void measure(bool on) { measure_ = Measure{on, {}, {}}; }
  [[nodiscard]] bool measures() const { return measure_.on; }
  /// From its first end to the second, or to the pointer until that is set; none: it has no first end.
  [[nodiscard]] std::optional<drawing::Point> measured() const;

 private:
  struct Shown {
    std::shared_ptr<const gui::Picture> picture;
    std::shared_ptr<const drawing::ToolPath> path;
    drawing::PathView view;
    gui::PathLook look;
    std::size_t traced = 0;  ///< points of the trace that it shows
  };
  /// The trace in the two axes, as far as it has been followed.
  struct Trace {
    std::uint64_t begun = 0, count = 0;  ///< of gui::PositionTrace
    AxisId right, up;
    drawing::Point scale;
    Instant first{};  ///< each run of the path is of one second since then
    drawing::ToolPath path;
  };
  struct Measure {
    bool on = false;
    std::optional<drawing::Point> from, to;
  };
  void take_click(const PathSubject& subject, drawing::Point mouse_px, float within_px);
  void set_end(drawing::Point end);
  void use_keys();
  void draw_measure(gui::Frame& frame, const gui::Rect& in);
  void follow_trace(gui::Frame& frame, const PathSubject& subject);
  void place(gui::Frame& frame, const PathSubject& subject, const gui::Rect& in);
  void touch(gui::Frame& frame, std::string_view id, const PathSubject& subject, const gui::Rect& in);
  void draw_again(gui::Frame& frame, const PathSubject& subject);
  void draw_grid(gui::Frame& frame, const gui::Rect& whole, const gui::Rect& in, const PathSubject& subject);
  void draw_table(gui::Frame& frame, const gui::Rect& in, const drawing::Box& table);
  void draw_picture(gui::Frame& frame, const gui::Rect& in);
  void draw_lit(gui::Frame& frame, const gui::Rect& in, const PathSubject& subject);
  void draw_trace(gui::Frame& frame, const gui::Rect& in);
  void draw_switches(gui::Frame& frame, const gui::Rect& in, const PathSubject& subject);
  void draw_here(gui::Frame& frame, std::string_view id, const gui::Rect& in, const PathSubject& subject);
  [[nodiscard]] ImVec2 at(const gui::Rect& in, drawing::Point p) const;

  drawing::PathView view_;
  bool fitted_ = false, moved_ = false;  ///< moved: by hand, another path does not take its view away
  std::shared_ptr<const drawing::ToolPath> fitted_to_;
  std::optional<drawing::PathHit> clicked_;
  std::optional<TraceHit> passed_;
  std::optional<drawing::Point> clicked_place_;
  Measure measure_;
  drawing::Point pointer_;  ///< in the units of the axes
  ImVec2 pressed_at_{};
  Trace trace_;
  Shown shown_;
  bool under_way_ = false;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
