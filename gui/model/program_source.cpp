#include "gui/model/program_source.h"

#include <utility>

namespace hw::gui {

void ProgramSource::put(WrittenSequence sequence) {
  constexpr std::size_t most = 4;
  put_.push_back(std::move(sequence));
  if (put_.size() > most) put_.pop_front();
}

const WrittenSequence* ProgramSource::of(const std::string& text, const BlockList& blocks,
                                         const Language* language, const Catalog& catalog) {
  if (text.empty() || !language) return nullptr;
  for (const WrittenSequence& put : put_)
    if (put.written.text == text) return &put;
  const sequence::Editor& editor = blocks.editor;
  if (std::exchange(blocks_version_, editor.version()) != editor.version()) {
    auto written = language->write(editor.sequence(), catalog);
    blocks_ = written ? WrittenSequence{editor.shared(), std::move(*written)} : WrittenSequence();
  }
  return blocks_.sequence && blocks_.written.text == text ? &blocks_ : nullptr;
}

}  // namespace hw::gui
