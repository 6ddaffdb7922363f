#pragma once
// Shows the options of a drawing: its place, the tool, and its layers. Options of the machine are kept for
// the next drawing and the next session. Ids: `drawing/keep_order`, `drawing/layer/NAME`; see also
// DrawingPlace and DrawingTool.
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "panels/drawing/drawing_place.h"
#include "panels/drawing/drawing_tool.h"

namespace hw::panels {

class DrawingOptions {
 public:
  /// Draws at ImGui's cursor. `drawing` is null while no drawing is open; there are no layers then.
  void draw(gui::Frame& frame, const drawing::Drawing* drawing);
  /// Call once a frame. Applies and keeps the changes since the previous call.
  void settle(const gui::Frame& frame, const drawing::Drawing* drawing);
  /// Takes defaults from the controller and the units of its axes.
  void begin(const gui::Frame& frame);
  /// Call when another file is opened.
  void forget_file() {
    other_layers_.clear(), without_.clear(), place_.forget_file();
    counted_of_ = nullptr, changed_ = true;
  }
  /// Leaves out `paths`, indexes into Drawing::paths.
  void leave_out(const std::vector<int>& paths) {
    without_.insert(without_.end(), paths.begin(), paths.end());
    changed_ = true;
  }
  void draw_all() { without_.clear(), changed_ = true; }
  [[nodiscard]] bool draws_all() const { return without_.empty(); }
  [[nodiscard]] bool wants_origin() const { return place_.wants_origin(); }
  /// `of_drawing`: a point of the drawing.
  void set_origin(drawing::Point of_drawing) { place_.set_origin(of_drawing), changed_ = true; }
  /// The axes along its X and Y, as indexes into the catalog.
  [[nodiscard]] const std::array<int, 2>& axes() const { return place_.axes(); }
  [[nodiscard]] const ConversionOptions& wanted() const { return wanted_; }
  /// The sentence about an option that is not understood; empty: none.
  [[nodiscard]] const std::string& wrong() const { return wrong_; }
  /// Changes with wanted().
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  void draw_layers(gui::Frame& frame, const drawing::Drawing& drawing);
  void keep(const gui::Frame& frame);
  void choose_layers(const drawing::Drawing& drawing, ConversionOptions& options) const;
  [[nodiscard]] bool is_drawn(const drawing::Layer& layer) const;

  bool begun_ = false, changed_ = true;
  DrawingPlace place_;
  DrawingTool tool_;
  bool keep_order_ = false;
  std::vector<std::string> other_layers_;  ///< drawn although the file hides them, or the reverse
  std::vector<int> without_;               ///< paths
  const drawing::Drawing* counted_of_ = nullptr;
  std::vector<int> on_layer_;  ///< entities per layer of that drawing
  ConversionOptions wanted_;
  std::string wrong_;
  KeptOptions kept_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
  std::uint64_t version_ = 1;
};

}  // namespace hw::panels
