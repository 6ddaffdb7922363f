#pragma once
// Saves the content of a path canvas as a picture. Ids: `path/save` and those of the file dialog.
#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/drawing/tool_path.h"
#include "gui/shell/frame.h"
#include "gui/widgets/file_dialog.h"
#include "panels/path/path_canvas.h"

namespace hw::panels {

class PathExport {
 public:
  /// Draws the button at ImGui's cursor. `wordless`: as an icon.
  void draw_button(gui::Frame& frame, std::string_view label, bool wordless, bool can);
  /// Draws the file dialog. The file gets the whole content of the canvas.
  void draw_dialog(gui::Frame& frame, const PathSubject& subject, const PathCanvas& canvas);

 private:
  gui::FileDialog dialog_;
};

}  // namespace hw::panels
