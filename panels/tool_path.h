#pragma once
// The path: where the rehearsed program goes in two axes, and where they have really been. Ids:
// `path/simulate`, `path/right`, `path/up`, `path/tool`, `path/fit`, `path/nearer`, `path/further`,
// `path/forget`, `path/save`, `path/view`, `path/hit`, `path/measure`, `path/show_line`.
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/track_path.h"
#include "gui/desk.h"
#include "gui/panel.h"
#include "gui/units_format.h"
#include "gui/widgets/file_dialog.h"
#include "panels/path_canvas.h"

namespace hw::panels {

class ToolPath final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  /// What the path was made of: made anew when it differs.
  struct Made {
    int rehearsal = 0, slot = -1;
    TrackAxes axes;
    bool operator==(const Made&) const = default;
  };
  void make(const gui::Frame& frame);
  void work_out(gui::Frame& frame);
  void take(std::shared_ptr<const drawing::ToolPath> path, const gui::DisplayUnit& right,
            const gui::DisplayUnit& up);
  [[nodiscard]] std::string place_text(const gui::Frame& frame, drawing::Point place) const;
  void say_hit(gui::Frame& frame);
  void say_measure(const gui::Frame& frame);
  void follow_caret(const gui::Frame& frame);
  [[nodiscard]] int lit_line(const gui::Frame& frame) const;
  void draw_toolbar(gui::Frame& frame);
  void draw_choices(gui::Frame& frame, float top);
  void draw_legend(gui::Frame& frame, float height);
  void draw_hit(gui::Frame& frame, float width);
  void save(gui::Frame& frame, const std::filesystem::path& file);

  std::vector<std::string_view> axis_names_, tool_names_;
  int right_ = 0, up_ = 1, tool_ = 0;  ///< tool: 0 none, else output tool_ - 1
  Made made_;
  std::shared_ptr<const drawing::ToolPath> path_;
  std::vector<int> line_of_command_;
  std::string size_, way_on_, way_off_, time_, hit_;
  int hit_line_ = -1, caret_line_ = -1;
  PathCanvas canvas_;
  gui::FileDialog save_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
