#pragma once
// What is said of a drawing: how long it takes, in how many moves, how much of it is drawn, and what was left
// out. Ids: `drawing/problem`, `drawing/progress`, `drawing/off`, `drawing/time`, `drawing/moves`,
// `drawing/drawn`, `drawing/travel`, `drawing/saved`, `drawing/size`, `drawing/chains`,
// `drawing/remarks`, `drawing/left_out`, `drawing/understood`.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gui/shell/frame.h"
#include "panels/drawing/drawing_job.h"

namespace hw::panels {

class DrawingFacts {
 public:
  /// Once a frame.
  void follow(const DrawingJob& job, const ConversionOptions& wanted);
  /// At ImGui's cursor.
  void draw(gui::Frame& frame, const DrawingJob& job);
  void draw_left_out(gui::Frame& frame);
  /// May be empty, as it is not known.
  [[nodiscard]] std::string_view time() const { return time_; }
  /// In all of it.
  [[nodiscard]] std::size_t moves() const { return count_; }

 private:
  static void draw_remarks(gui::Frame& frame, const std::vector<std::string>& remarks);

  std::uint64_t said_ = ~std::uint64_t{0};  ///< DrawingJob::version() that the words are of
  std::size_t count_ = 0;
  std::string time_, moves_, drawn_, travel_, saved_, beside_, size_, chains_, off_, left_out_title_,
      problem_;
  bool can_be_cut_ = false;  ///< all the same, where problem_ says that no program holds it
  std::vector<std::string> left_out_, understood_;
};

}  // namespace hw::panels
