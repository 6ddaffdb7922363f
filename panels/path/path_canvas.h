#pragma once
// Draws the past and future path of a tool, in two axes or three, with pan, zoom and picking. The worker
// draws long paths; until a new picture is ready, the old picture is shown, shifted.
#include <memory>
#include <optional>
#include <string_view>

#include "gui/surface/ui.h"
#include "panels/path/path_backdrop.h"
#include "panels/path/path_limits.h"
#include "panels/path/path_measure.h"
#include "panels/path/path_overlays.h"
#include "panels/path/path_progress.h"
#include "panels/path/path_subject.h"
#include "panels/path/path_trace.h"

namespace hw::gui {
struct Touch;
}

namespace hw::panels {

/// A point of the real path of the axes.
struct TraceHit {
  drawing::Point3 at;
  Instant when{};  ///< to the second
};

class PathCanvas {
 public:
  /// Draws at ImGui's cursor, logical size. Ids: `id` (the view: drag and wheel; with the focus + - 0 1, and
  /// arrows with Alt, for arrows alone jog), `id/here`. With three axes a drag turns the view; a drag with
  /// Shift or another button pans it. Arrows with Alt and Shift turn it; the letters T F S I are `id/top`,
  /// `id/front`, `id/side`, `id/iso`.
  void draw(gui::Frame& frame, std::string_view id, const PathSubject& subject, float width, float height);
  /// Fits the whole content into the next frame.
  void fit() {
    fitted_ = moved_ = with_limits_ = false;
    numbers_ = 0;
  }
  /// Fits the whole content and all known limits.
  void fit_limits() {
    fit();
    with_limits_ = true;
  }
  void zoom(double factor);
  /// The present projection.
  [[nodiscard]] const drawing::Projection& projection() const { return view_.projection(); }
  [[nodiscard]] const drawing::ToolPath& trace() const { return trace_.path(); }
  /// The box around the whole content.
  [[nodiscard]] const drawing::Box3& box() const { return all_; }
  /// The part of the path clicked in this frame.
  [[nodiscard]] const std::optional<drawing::PathHit>& clicked() const { return click_.hit; }
  [[nodiscard]] const std::optional<TraceHit>& passed() const { return click_.passed; }

  /// The clicked place in the units of the axes. It snaps to the path or the end of a line nearby; with three
  /// axes only such places can be clicked.
  [[nodiscard]] const std::optional<drawing::Point3>& clicked_place() const { return click_.place; }

  /// While on, clicks set the two ends of a measured line, on the path if it is near.
  void measure(bool on) { measure_ = PathMeasure{on, {}, {}}; }
  [[nodiscard]] const PathMeasure& measured() const { return measure_; }

 private:
  struct Click {
    std::optional<drawing::PathHit> hit;
    std::optional<TraceHit> passed;
    std::optional<drawing::Point3> place;
  };
  /// A drag of the view.
  struct Grip {
    ImVec2 pressed_at{};
    drawing::Point3 pivot;  ///< centre of rotation
    int pans_with = 0;      ///< button pressed on the view, other than the left; 0: none
    bool turned = false;    ///< the view was turned in this frame
  };
  [[nodiscard]] gui::Rect view_in(const gui::Ui& ui, const gui::Rect& whole, bool flat, float row) const;
  void place(gui::Frame& frame, const PathSubject& subject, const KnownLimits& limits, const gui::Rect& in);
  void touch(gui::Frame& frame, std::string_view id, const PathSubject& subject, const gui::Rect& in);
  void drag(const gui::Touch& touch, const PathSubject& subject);
  void take_click(const PathSubject& subject, drawing::Point mouse_px, float within_px);
  void use_keys(const PathSubject& subject);
  void pan(double right_px, double down_px);
  void turn(double turn, double tilt);
  void look(const drawing::ViewDirection& from);
  void take_pivot(const PathSubject& subject, drawing::Point near_px, double within_px);
  float draw_standard_views(gui::Frame& frame, std::string_view id, float width);

  drawing::PathView view_;
  drawing::ViewDirection direction_ = drawing::views::iso;  ///< with three axes
  drawing::Box3 all_;                                       ///< box around the whole content
  bool fitted_ = false, moved_ = false;  ///< moved_: by the user, so a new path keeps the view
  bool with_limits_ = false;             ///< `all_` includes them
  float numbers_ = 0;                    ///< width of the widest number left of the view since fit(), logical
  std::shared_ptr<const drawing::ToolPath> fitted_to_;
  Click click_;
  PathMeasure measure_;
  Grip grip_;
  PathTrace trace_;
  PathBackdrop backdrop_;
  PathProgress progress_;
};

}  // namespace hw::panels
