#pragma once
// Where a tool goes and has been, in two axes or in three: to be looked at, moved about and pointed at. What
// is long is drawn by the worker; until it is done the picture of before is shown, moved along.
#include <memory>
#include <optional>
#include <string_view>

#include "gui/surface/ui.h"
#include "panels/path/path_backdrop.h"
#include "panels/path/path_limits.h"
#include "panels/path/path_measure.h"
#include "panels/path/path_overlays.h"
#include "panels/path/path_subject.h"
#include "panels/path/path_trace.h"

namespace hw::gui {
struct Touch;
}

namespace hw::panels {

/// Where the axes have really been.
struct TraceHit {
  drawing::Point3 at;
  Instant when{};  ///< to the second
};

class PathCanvas {
 public:
  /// At ImGui's cursor, logical size. Ids: `id` (the view: drag and wheel; with the focus + - 0 1, and arrows
  /// with Alt, for arrows alone jog), `id/here`. Of three axes a drag turns it, with Shift or another button
  /// it is moved; arrows with Alt and Shift turn it, the letters T F S I are `id/top`, `id/front`, `id/side`,
  /// `id/iso`.
  void draw(gui::Frame& frame, std::string_view id, const PathSubject& subject, float width, float height);
  /// All of it, with the next frame.
  void fit() { fitted_ = moved_ = with_limits_ = false; }
  /// And all limits that are known.
  void fit_limits() {
    fit();
    with_limits_ = true;
  }
  void zoom(double factor);
  /// As it is looked at.
  [[nodiscard]] const drawing::Projection& projection() const { return view_.projection(); }
  [[nodiscard]] const drawing::ToolPath& trace() const { return trace_.path(); }
  /// Of what is shown.
  [[nodiscard]] const drawing::Box3& box() const { return all_; }
  /// What was clicked in this frame.
  [[nodiscard]] const std::optional<drawing::PathHit>& clicked() const { return click_.hit; }
  [[nodiscard]] const std::optional<TraceHit>& passed() const { return click_.passed; }

  /// Wherever it was, in the units of the axes; the path or the end of a line where that is near. Of three
  /// axes only there.
  [[nodiscard]] const std::optional<drawing::Point3>& clicked_place() const { return click_.place; }

  /// Clicks set the two ends of a measured way, on the path where it is near.
  void measure(bool on) { measure_ = PathMeasure{on, {}, {}}; }
  [[nodiscard]] const PathMeasure& measured() const { return measure_; }

 private:
  struct Click {
    std::optional<drawing::PathHit> hit;
    std::optional<TraceHit> passed;
    std::optional<drawing::Point3> place;
  };
  /// A hand on the view.
  struct Grip {
    ImVec2 pressed_at{};
    drawing::Point3 pivot;  ///< it is turned about it
    int pans_with = 0;      ///< the button that was pressed on it, beside the left one; 0: none
    bool turned = false;    ///< in this frame
  };
  void place(gui::Frame& frame, const PathSubject& subject, const KnownLimits& limits, const gui::Rect& in);
  void touch(gui::Frame& frame, std::string_view id, const PathSubject& subject, const gui::Rect& in);
  void drag(const gui::Touch& touch, const PathSubject& subject);
  void take_click(const PathSubject& subject, drawing::Point mouse_px, float within_px);
  void use_keys(const PathSubject& subject);
  void pan(double right_px, double down_px);
  void turn(double turn, double tilt);
  void look(const drawing::Looking& from);
  void take_pivot(const PathSubject& subject, drawing::Point near_px, double within_px);
  float draw_standard_views(gui::Frame& frame, std::string_view id, float width);

  drawing::PathView view_;
  drawing::Looking looking_ = drawing::looking::iso;  ///< of three axes
  drawing::Box3 all_;                                 ///< of what is shown
  bool fitted_ = false, moved_ = false;  ///< moved: by hand, another path does not take its view away
  bool with_limits_ = false;             ///< they are in `all_`
  std::shared_ptr<const drawing::ToolPath> fitted_to_;
  Click click_;
  PathMeasure measure_;
  Grip grip_;
  PathTrace trace_;
  PathBackdrop backdrop_;
};

}  // namespace hw::panels
