#pragma once
// The blocks of a list one below the other, loops entered. What a row says is put into words when it is seen
// for the first time, so that thousands cost little.
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
  /// Once a frame, before anything else. True: the blocks have changed.
  bool follow(const sequence::Editor& editor);
  /// They are shown in other units than before.
  void forget_words();

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const sequence::Step& step(std::size_t row) const { return *rows_[row].step; }
  [[nodiscard]] int depth(std::size_t row) const { return rows_[row].depth; }
  [[nodiscard]] sequence::StepPath path(std::size_t row) const;
  [[nodiscard]] const Words& words(std::size_t row, const sequence::Look& look);
  /// Row behind those that stand in it.
  [[nodiscard]] std::size_t behind(std::size_t row) const;
  /// -1: none stands there. Long; for changes.
  [[nodiscard]] int row_of(const std::optional<sequence::StepPath>& path) const;

 private:
  struct Row {
    const sequence::Step* step = nullptr;
    std::size_t place = 0;  ///< in its list
    int parent = -1;        ///< row of what it stands in
    int depth = 0;
    std::unique_ptr<Words> words{};
  };
  void add(const sequence::StepList& steps, int parent, int depth);

  std::shared_ptr<const sequence::Sequence> of_;
  std::vector<Row> rows_;
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace hw::panels
