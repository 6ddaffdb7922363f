#pragma once
// Blocks as the text that the controller's language makes of them, worked out beside the frame whenever they
// have changed.
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/refused_steps.h"
#include "core/device/sequence_text.h"
#include "core/sequence/editor.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Of one version of the blocks.
struct WrittenBlocks {
  std::uint64_t version = ~std::uint64_t{0};
  SequenceText text;                     ///< of those that can be written
  std::vector<std::size_t> line_begins;  ///< of the text, and its end
  std::vector<int> step_of_command;      ///< of its first program
  std::vector<int> lines_of_step;        ///< how many each block has itself
  std::string problem;                   ///< why it is not to be run; empty: it is
  std::vector<RefusedStep> refused{};    ///< in the order of the blocks, one for each
  std::string remark;
  int cost = 0;  ///< of the text, in the unit of ProgramFacts::capacity

  /// Null: the block is written.
  [[nodiscard]] const RefusedStep* refusal_of(int row) const;
  /// How many before `row`.
  [[nodiscard]] int refused_before(int row) const;
};

class BlockWork {
 public:
  /// Once a frame.
  void follow(gui::Frame& frame, const sequence::Editor& editor);
  /// What came last: of the present blocks when it is up_to_date(). Another object for each version.
  [[nodiscard]] const std::shared_ptr<const WrittenBlocks>& written() const { return written_; }
  [[nodiscard]] bool up_to_date() const { return written_->version == wanted_; }
  /// Why there is no text that could be run; empty: there is one.
  [[nodiscard]] std::string_view why_none(const sequence::Editor& editor) const;

 private:
  std::shared_ptr<const WrittenBlocks> written_ = std::make_shared<const WrittenBlocks>();
  std::shared_ptr<const Catalog> catalog_;  ///< for the worker, who may outlive the tab
  std::uint64_t wanted_ = ~std::uint64_t{0};
  std::shared_ptr<int> under_way_ = std::make_shared<int>(0);  ///< jobs; theirs are dropped with this object
};

}  // namespace hw::panels
