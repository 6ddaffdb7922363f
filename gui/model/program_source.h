#pragma once
// The sequence from which a program's text was written: the blocks, a drawing, or the remainder of one. GUI
// thread.
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "gui/model/block_list.h"

namespace hw::gui {

struct WrittenSequence {
  std::shared_ptr<const sequence::Sequence> sequence;
  SequenceText written;
};

class ProgramSource {
 public:
  /// Records a text that was put into the program; the latest few are kept.
  void put(WrittenSequence sequence);
  /// Null: the text comes from no known sequence. The blocks are written anew when they have changed.
  const WrittenSequence* of(const std::string& text, const BlockList& blocks, const Language* language,
                            const Catalog& catalog);

 private:
  std::deque<WrittenSequence> put_;
  WrittenSequence blocks_;
  std::uint64_t blocks_version_ = ~std::uint64_t{0};  ///< of their editor when `blocks_` was written
};

}  // namespace hw::gui
