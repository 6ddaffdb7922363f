#pragma once
// The rows of a list of blocks, including blocks inside loops. The words of a row are made when the row is
// first visible, so that thousands of rows cost little.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/sequence/editor.h"
#include "core/sequence/words.h"

namespace hw::panels {

class BlockRows {
 public:
  struct Words {
    std::string number, title, summary;
  };
  /// Call once a frame, first. Returns true when the blocks have changed.
  bool follow(const sequence::Editor& editor);
  /// Call when the units have changed.
  void forget_words();

  /// Changes with the blocks.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const sequence::Step& step(std::size_t row) const { return *rows_[row].step; }
  [[nodiscard]] int depth(std::size_t row) const { return rows_[row].depth; }
  [[nodiscard]] sequence::StepPath path(std::size_t row) const;
  [[nodiscard]] const Words& words(std::size_t row, const sequence::Look& look);
  /// The next row after `row` and all blocks inside it.
  [[nodiscard]] std::size_t behind(std::size_t row) const;
  /// The row of a block; -1: no block has this path. Slow: call it on changes only.
  [[nodiscard]] int row_of(const std::optional<sequence::StepPath>& path) const;

 private:
  struct Row {
    const sequence::Step* step = nullptr;
    std::size_t place = 0;  ///< index in its list
    int parent = -1;        ///< row of the enclosing block
    int depth = 0;
    std::unique_ptr<Words> words{};
  };
  void add(const sequence::StepList& steps, int parent, int depth);

  std::shared_ptr<const sequence::Sequence> of_;
  std::vector<Row> rows_;
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace hw::panels
