#pragma once
// A path kept as a picture. Ids: `path/save` and those of the dialog for a file.
#include <memory>
#include <string>
#include <string_view>

#include "core/drawing/tool_path.h"
#include "gui/shell/frame.h"
#include "gui/widgets/file_dialog.h"

namespace hw::panels {

class PathExport {
 public:
  struct What {
    std::shared_ptr<const drawing::ToolPath> path;  ///< null: there is none
    drawing::Projection projection;                 ///< as it is looked at
    bool equal = true;                              ///< its axes have one unit
    std::string unit;                               ///< that of lengths; empty: there is none
  };
  /// At ImGui's cursor.
  void draw_button(gui::Frame& frame, std::string_view label, bool can);
  void draw_dialog(gui::Frame& frame, const What& what);

 private:
  gui::FileDialog dialog_;
};

}  // namespace hw::panels
