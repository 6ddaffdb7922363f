#pragma once
// The sheet of a saved picture. It is white, with rulers in the units of the axes, or in perspective with the
// three edges of its box and their lengths.
#include "gui/surface/pictures.h"
#include "gui/surface/ui.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

class PathSheet {
 public:
  static constexpr int width = 1600, height = 1200;
  /// GUI thread only, because it uses the fonts of the frame. `box`: around the whole content.
  PathSheet(const gui::Frame& frame, const PathSubject& subject, const drawing::Box3& box,
            const drawing::Projection& projection, bool equal);
  /// The part of the sheet where the path is drawn.
  [[nodiscard]] const drawing::PathView& view() const { return view_; }
  /// The sheet with a picture of that view on it. Any thread.
  [[nodiscard]] gui::Picture with(const gui::Picture& path) const;

 private:
  class Pen;
  void draw_rulers(Pen& pen) const;
  void draw_edges(Pen& pen) const;
  [[nodiscard]] ImVec2 at(drawing::Point3 p) const;

  std::array<std::string, 3> names_;  ///< "X mm", by direction
  drawing::Box3 box_;
  gui::Rect in_;  ///< the view
  drawing::PathView view_;
  gui::Picture ground_;
};

}  // namespace hw::panels
