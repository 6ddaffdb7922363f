#pragma once
// Draws the routines that lower and lift the tool below an open Tool block. All Tool blocks of a sequence
// share them. Ids: `PATH/pen_down`, `PATH/pen_up`, `PATH/routine` (why they are refused).
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
  /// Draws at ImGui's cursor. Returns the changed frame of the sequence; nullopt: unchanged.
  std::optional<sequence::Sequence> draw(gui::Frame& frame, std::string_view path, float width);
  /// Why typed routines were refused: "Tool: \"DO9 on\" is not understood."; empty: both were accepted.
  [[nodiscard]] std::string_view problem() const { return problem_; }

 private:
  [[nodiscard]] std::array<std::string, 2> written() const;
  std::optional<sequence::Sequence> read();

  std::shared_ptr<const sequence::Sequence> of_;
  const Catalog* catalog_ = nullptr;
  sequence::Look look_;
  std::array<std::string, 2> texts_, kept_;  ///< down, up: as typed, and as in the sequence
  std::string why_not_;                      ///< why the routines cannot be shown in words
  std::uint64_t loads_ = 0;                  ///< Editor::loads() at the last follow()
  std::string problem_;
};

}  // namespace hw::panels
