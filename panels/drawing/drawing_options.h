#pragma once
// What is wanted of a drawing: its place, the tool, and its layers. Ids: `drawing/keep_order`,
// `drawing/layer/NAME`; see also DrawingPlace and DrawingTool.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "panels/drawing/drawing_place.h"
#include "panels/drawing/drawing_tool.h"

namespace hw::panels {

class DrawingOptions {
 public:
  /// At ImGui's cursor; `drawing` null: there is none yet, so no layers.
  void draw(gui::Frame& frame, const drawing::Drawing* drawing);
  /// Once a frame: what was chosen since becomes what is wanted.
  void settle(const gui::Frame& frame, const drawing::Drawing* drawing);
  /// As the controller and the units of its axes suggest, before anybody has chosen.
  void begin(const gui::Frame& frame);
  /// Of another file.
  void forget_file() { left_out_.clear(), without_.clear(), place_.forget_file(), changed_ = true; }
  /// Places in Drawing::paths.
  void leave_out(const std::vector<int>& paths) {
    without_.insert(without_.end(), paths.begin(), paths.end());
    changed_ = true;
  }
  void draw_all() { without_.clear(), changed_ = true; }
  [[nodiscard]] bool draws_all() const { return without_.empty(); }
  [[nodiscard]] bool wants_origin() const { return place_.wants_origin(); }
  /// A place of the drawing.
  void set_origin(drawing::Point of_drawing) { place_.set_origin(of_drawing), changed_ = true; }
  /// The axes that go along its X and Y, by their place in the catalog.
  [[nodiscard]] const std::array<int, 2>& axes() const { return place_.axes(); }
  [[nodiscard]] const ConversionOptions& wanted() const { return wanted_; }
  /// What of it is not understood, as a sentence; empty: all is.
  [[nodiscard]] const std::string& wrong() const { return tool_.wrong(); }
  /// Changes with wanted().
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  void draw_layers(gui::Frame& frame, const drawing::Drawing& drawing);

  bool begun_ = false, changed_ = true;
  DrawingPlace place_;
  DrawingTool tool_;
  bool keep_order_ = false;
  std::vector<std::string> left_out_;  ///< layers
  std::vector<int> without_;           ///< paths
  ConversionOptions wanted_;
  std::uint64_t version_ = 1;
};

}  // namespace hw::panels
