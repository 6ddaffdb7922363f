#include "gui/rehearsals.h"

#include "gui/text_diff.h"

namespace hw::gui {

void Rehearsals::start(const Language& language, std::string text, RehearseOptions options, Worker& worker) {
  const int slot = options.slot;
  if (under_way(slot)) return;
  running_[slot] = true;
  worker.run(
      [&language, text = std::move(text), options = std::move(options)]() mutable {
        auto result = language.rehearse(text, options);
        return Outcome{std::move(text), std::move(result)};
      },
      [this, slot](Outcome outcome) {
        running_.erase(slot);
        outcomes_.insert_or_assign(slot, std::move(outcome));
        ++version_;
      },
      alive_);
}

const Rehearsals::Outcome* Rehearsals::of(int slot) const {
  const auto found = outcomes_.find(slot);
  return found == outcomes_.end() ? nullptr : &found->second;
}

int Rehearsals::older_than_line(int slot, std::string_view text) const {
  const Outcome* outcome = of(slot);
  return outcome ? TextDiff(outcome->text, text).first_changed() : -1;
}

}  // namespace hw::gui
