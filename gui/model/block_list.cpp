#include "gui/model/block_list.h"

#include <algorithm>
#include <utility>

#include "core/sequence/sequence_file.h"

namespace hw::gui {

namespace {

/// Speeds apply to all axes, so one unit must hold for all.
sequence::Sequence empty_sequence(const Catalog& catalog, std::span<const DisplayUnit> units) {
  const std::size_t count = std::min<std::size_t>(catalog.axes.size(), max_axes);
  const bool real =
      units.size() >= count && count > 0 &&
      std::all_of(units.begin(), units.begin() + static_cast<std::ptrdiff_t>(count),
                  [&](const DisplayUnit& u) { return u.real && u.name == units[0].name && u.per_step > 0; });
  sequence::Sequence s;
  s.unit = real ? units[0].name : catalog.step_word;
  for (std::size_t a = 0; a < count; ++a)
    s.axes.push_back({catalog.axes[a].name, real ? 1 / units[a].per_step : 1});
  return s;
}

}  // namespace

BlockList::BlockList(const Catalog& catalog) {
  editor.load(empty_sequence(catalog, {}));
  in_file_ = editor.version();
}

void BlockList::begin_in(const Catalog& catalog, std::span<const DisplayUnit> units) {
  units = units.first(std::min(units.size(), begun_in_.size()));
  if (std::equal(units.begin(), units.end(), begun_in_.begin())) return;
  const bool begun =
      !editor.sequence().steps.empty() || editor.can_undo() || editor.can_redo() || !file_.empty();
  if (begun) return;
  std::copy(units.begin(), units.end(), begun_in_.begin());
  editor.load(empty_sequence(catalog, units));
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
    auto sequence = sequence::read_sequence(t.text, "Blocks of the last session");
    if (!sequence) return fail(sequence.error());
    editor.load(std::move(*sequence));
    file_ = t.path;  // the name only: the file's content is not known, so the blocks count as edited
  }
  return {};
}

}  // namespace hw::gui
