#include "gui/model/block_list.h"

#include <utility>

#include "core/sequence/sequence_file.h"

namespace hw::gui {

BlockList::BlockList(const Catalog& catalog) {
  sequence::Sequence s;
  s.unit = catalog.step_word;
  for (const AxisInfo& axis : catalog.axes)
    if (s.axes.size() < max_axes) s.axes.push_back({axis.name});
  editor.load(std::move(s));
  in_file_ = editor.version();
}

bool BlockList::edited() const {
  return in_file_ != editor.version() && !(file_.empty() && editor.sequence().steps.empty());
}

void BlockList::opened(std::filesystem::path path, sequence::Sequence sequence) {
  editor.load(std::move(sequence));
  saved(std::move(path), editor.version());
}

void BlockList::became(sequence::Sequence sequence) {
  editor.exchange(std::move(sequence));
  file_.clear();
  ++files_;
}

void BlockList::saved(std::filesystem::path path, std::uint64_t version) {
  file_ = std::move(path);
  in_file_ = version;
  ++files_;
}

std::optional<BlockList::Unsaved> BlockList::unsaved() const {
  if (!edited()) return std::nullopt;
  return Unsaved{editor.shared(), file_.string()};
}

UnsavedText BlockList::Unsaved::text() const {
  return {UnsavedText::of_blocks, sequence::write_sequence(*sequence), path};
}

Result<> BlockList::restore(const std::vector<UnsavedText>& texts) {
  for (const UnsavedText& t : texts) {
    if (t.slot != UnsavedText::of_blocks) continue;
    auto sequence = sequence::read_sequence(t.text, "The blocks of last time");
    if (!sequence) return fail(sequence.error());
    editor.load(std::move(*sequence));
    file_ = t.path;  // the name only: what the file holds is not known, so they count as edited
  }
  return {};
}

}  // namespace hw::gui
