#pragma once
// The path and the trace as a picture that the worker draws. Until that is done the picture of before is
// shown, moved along; while the view is turned, which no picture can follow, a few of the lines.
#include <memory>

#include "gui/surface/path_picture.h"
#include "gui/surface/ui.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

class PathBackdrop {
 public:
  /// Once a frame. `turning`: it will be looked at from elsewhere in the next frame, nothing is begun.
  void follow(gui::Frame& frame, const PathSubject& subject, const drawing::ToolPath& trace,
              const drawing::PathView& view, bool turning);
  /// Within `in`, of which `view` is. Allocates nothing.
  void draw(gui::Frame& frame, const gui::Rect& in, const PathSubject& subject,
            const drawing::PathView& view) const;
  /// Points of the trace that are in what draw() shows.
  [[nodiscard]] std::size_t traced(const drawing::PathView& view) const {
    return fits(view) ? shown_.traced : 0;
  }

 private:
  using SharedPath = std::shared_ptr<const drawing::ToolPath>;
  struct Shown {
    std::shared_ptr<const gui::Picture> picture;
    SharedPath path, commanded;
    SharedPath coarse;  ///< of `path`
    drawing::PathView view;
    gui::PathLook look;
    std::size_t traced = 0;
    int traced_until = 0;  ///< source of the latest run of the trace
  };
  [[nodiscard]] bool fits(const drawing::PathView& view) const {
    return shown_.picture && shown_.view.projection() == view.projection();
  }

  Shown shown_;
  bool under_way_ = false;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

/// A pixel of the view within `in`. Far outside is far outside: ImGui counts in floats.
ImVec2 on_screen(const gui::Rect& in, drawing::Point px);

}  // namespace hw::panels
