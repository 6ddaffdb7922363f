#pragma once
// What is wanted of a drawing: its place, the tool, and its layers. What belongs to the machine is kept for
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
  /// At ImGui's cursor; `drawing` null: there is none yet, so no layers.
  void draw(gui::Frame& frame, const drawing::Drawing* drawing);
  /// Once a frame: what was chosen since becomes what is wanted, and is kept.
  void settle(const gui::Frame& frame, const drawing::Drawing* drawing);
  /// As the controller and the units of its axes suggest, before anybody has chosen.
  void begin(const gui::Frame& frame);
  /// Of another file.
  void forget_file() {
    other_layers_.clear(), without_.clear(), place_.forget_file();
    counted_of_ = nullptr, changed_ = true;
  }
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
  std::vector<std::string> other_layers_;  ///< drawn where the file hides them, and the other way round
  std::vector<int> without_;               ///< paths
  const drawing::Drawing* counted_of_ = nullptr;
  std::vector<int> on_layer_;  ///< entities, by layer of that one
  ConversionOptions wanted_;
  std::string wrong_;
  KeptOptions kept_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
  std::uint64_t version_ = 1;
};

}  // namespace hw::panels
