#pragma once
// Shows a picture of path and trace that the worker draws somewhat larger than the view. Until a new picture
// is ready, the old picture is shown, shifted. While the user turns the view, which no picture can follow,
// some of the lines are drawn instead.
#include <memory>
#include <optional>

#include "gui/surface/path_picture.h"
#include "gui/surface/ui.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

class PathBackdrop {
 public:
  struct Wanted {
    const PathSubject& subject;
    const drawing::ToolPath& trace;
    const drawing::PathView& view;
    std::optional<std::size_t> done;  ///< PathProgress::done()
    bool turning = false;             ///< the view changes again in the next frame, so no picture is begun
  };
  /// Call once a frame.
  void follow(gui::Frame& frame, const Wanted& wanted);
  /// Draws inside `in`, the place of `view`. Allocates nothing.
  void draw(gui::Frame& frame, const gui::Rect& in, const PathSubject& subject,
            const drawing::PathView& view) const;
  /// The number of trace points in the picture that draw() shows.
  [[nodiscard]] std::size_t traced(const drawing::PathView& view) const {
    return fits(view) ? shown_.traced : 0;
  }

 private:
  using SharedPath = std::shared_ptr<const drawing::ToolPath>;
  struct Shown {
    std::shared_ptr<const gui::Picture> picture;
    SharedPath path, commanded;
    SharedPath coarse;           ///< coarse form of `path`
    drawing::PathView of, view;  ///< the view, and the picture's, which has a margin around it
    std::optional<std::size_t> done;
    gui::PathLook look;
    std::size_t traced = 0;
    int traced_until = 0;  ///< source of the latest run of the trace
  };
  [[nodiscard]] bool still_shows(const Wanted& wanted, const gui::PathLook& look) const;
  [[nodiscard]] bool fits(const drawing::PathView& view) const {
    return shown_.picture && shown_.view.projection() == view.projection();
  }

  Shown shown_;
  bool under_way_ = false;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

/// The screen position of a pixel of the view inside `in`. A point far outside is clamped, because ImGui uses
/// floats.
ImVec2 on_screen(const gui::Rect& in, drawing::Point px);

}  // namespace hw::panels
