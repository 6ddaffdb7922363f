#pragma once
// The routines that lower and lift the tool, below an open Tool block: the routines are those of all its Tool
// blocks. Ids: `PATH/pen_down`, `PATH/pen_up`, `PATH/routine` (why they are not taken).
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "core/sequence/editor.h"
#include "core/sequence/words.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class ToolRoutines {
 public:
  /// Call once a frame.
  void follow(const sequence::Editor& editor, const Catalog& catalog, const sequence::Look& look);
  /// Draws at ImGui's cursor. Returns the changed frame of the sequence; none: unchanged.
  std::optional<sequence::Sequence> draw(gui::Frame& frame, std::string_view path, float width);
  /// Typed and not taken: "Tool: \"DO9 on\" is not understood."; empty: both were taken.
  [[nodiscard]] std::string_view problem() const { return problem_; }

 private:
  [[nodiscard]] std::array<std::string, 2> written() const;
  std::optional<sequence::Sequence> read();

  std::shared_ptr<const sequence::Sequence> of_;
  const Catalog* catalog_ = nullptr;
  sequence::Look look_;
  std::array<std::string, 2> texts_, kept_;  ///< down, up: as typed, and as the sequence has them
  std::string why_not_;                      ///< routines that these words cannot describe
  std::uint64_t loads_ = 0;                  ///< Editor::loads() at the last follow()
  std::string problem_;
};

}  // namespace hw::panels
