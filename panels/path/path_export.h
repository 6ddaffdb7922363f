#pragma once
// What a path canvas shows, kept as a picture. Ids: `path/save` and those of the dialog for a file.
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
  /// At ImGui's cursor.
  void draw_button(gui::Frame& frame, std::string_view label, bool can);
  /// All that is shown then goes into the file.
  void draw_dialog(gui::Frame& frame, const PathSubject& subject, const PathCanvas& canvas);

 private:
  gui::FileDialog dialog_;
};

}  // namespace hw::panels
