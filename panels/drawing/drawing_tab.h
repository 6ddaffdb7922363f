#pragma once
// The drawing tab: the picture of a drawing file, its placement, the tool, and the resulting program. Ids:
// `drawing/open`, `drawing/to_blocks`, `drawing/to_program`, `drawing/frame`, `drawing/fit`,
// `drawing/settings`, `drawing/view`, `drawing/pointer`, `drawing/outline`; facts: see DrawingFacts;
// settings: see DrawingOptions; cutting: see DrawingRun.
#include <cstdint>
#include <filesystem>
#include <string>

#include "gui/shell/panel_entry.h"
#include "gui/widgets/button.h"
#include "gui/widgets/file_dialog.h"
#include "panels/drawing/drawing_chains.h"
#include "panels/drawing/drawing_facts.h"
#include "panels/drawing/drawing_job.h"
#include "panels/drawing/drawing_options.h"
#include "panels/drawing/drawing_run.h"
#include "panels/path/path_canvas.h"

namespace hw::panels {

class DrawingTab final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_all(gui::Frame& frame);
  [[nodiscard]] PathSubject subject_of(const gui::Frame& frame);
  [[nodiscard]] drawing::Point scale_of(const gui::Frame& frame) const;
  void open(gui::Frame& frame, const std::filesystem::path& path);
  void take_dropped(gui::Frame& frame);
  void draw_toolbar(gui::Frame& frame);
  void draw_picture(gui::Frame& frame, float width, float height);
  void draw_why_outline(gui::Frame& frame, float width);
  void draw_pointer(gui::Frame& frame, const gui::Rect& view) const;
  void draw_side(gui::Frame& frame, float height);
  void draw_run(gui::Frame& frame);
  void draw_dialogs(gui::Frame& frame);
  /// The use that a click asks for. The click waits while the drawing is worked out, which may have begun
  /// because that click left a field.
  enum class Use : std::uint8_t { nothing, blocks, program, frame };
  void draw_use(gui::Frame& frame, Use use, std::string_view id, std::string_view label, float gap,
                gui::ButtonOptions look);
  [[nodiscard]] std::string_view why_no_use(const gui::Frame& frame, Use use) const;
  void use(gui::Frame& frame, Use use);
  void to_blocks(gui::Frame& frame);
  void ask_or_put(gui::Frame& frame, std::string text);
  void put(gui::Frame& frame);
  void take_click();
  [[nodiscard]] std::string_view why_not() const;

  std::optional<Catalog>
      together_;  ///< catalog of all controllers of the bus; nullopt: this controller draws by itself
  float run_height_ = 72;  ///< in the previous frame
  DrawingJob job_;
  DrawingOptions options_;
  DrawingRun run_;
  DrawingFacts facts_;
  PathCanvas canvas_;
  DrawingChains chains_table_;
  gui::FileDialog open_;
  std::string to_put_, here_;
  int opened_ = 0;  ///< DrawingJob::opened() of the options
  Use wanted_ = Use::nothing;
  bool asking_blocks_ = false, asking_program_ = false;
  bool settings_ = false;  ///< settings replace the picture if both do not fit
};

}  // namespace hw::panels
