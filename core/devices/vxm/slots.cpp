// Which program is selected, and what is known of each.
#include "core/devices/vxm/slots.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"

namespace hw::vxm {

// ---- which

void Slots::was_selected(int slot) {
  selected_ = chosen_ = slot;
  if (!talk_.listens().running) console_.draft.program.slot = static_cast<std::int8_t>(slot);
}

// A PM that has lost its P is another question.
Task<Result<std::int64_t>> Slots::ask_selected() {
  auto selected = co_await talk_.number("PM\r", Priority::poll);
  const auto is_one = [&] { return *selected >= 0 && *selected < program_count; };
  if (selected && !is_one()) selected = co_await talk_.number("PM\r", Priority::poll);
  if (!selected || is_one()) co_return selected;
  co_return fail(
      FaultKind::garbled,
      fmt::format("The controller says that program {} is selected, but it has 0 to 4.", *selected));
}

// M speaks of the selected program, so each must be selected in turn and the user's choice put back.
Task<Result<>> Slots::read_sizes() {
  auto given_back = co_await give_back_selection();
  if (!given_back) co_return given_back;
  auto selected = co_await ask_selected();
  if (!selected) co_return fail(selected.error());
  selected_ = chosen_ = static_cast<int>(*selected);
  if (!talk_.listens().running) console_.draft.program.slot = static_cast<std::int8_t>(selected_);
  for (int slot = 0; slot < program_count; ++slot) {
    std::int16_t& used = console_.draft.slot_bytes_used[static_cast<std::size_t>(slot)];
    if (used >= 0) continue;
    auto chosen = co_await choose(slot, Priority::poll);
    if (!chosen) co_return chosen;
    auto free = co_await talk_.number("M", Priority::poll);
    if (!free) co_return fail(free.error());
    used = static_cast<std::int16_t>(program_bytes - *free);
  }
  sizes_read_ = true;
  co_return co_await give_back_selection();
}

// Not one that starts by itself (4 after power-up or after Stop), nor one that a Slave's program runs with.
bool Slots::may_be_scratch(int slot) const {
  const auto mode = parameters_.value("DM").value_or(0), inputs = parameters_.value("I").value_or(0);
  if (slot == 4 && (mode & mode_program_4_first || inputs & inputs_program_4)) return false;
  const auto coupled = parameters_.value("PMA").value_or(pma_off);
  if (coupled == pma_off) return true;
  const auto excepted = coupled == -5 ? 0 : -coupled;
  return coupled >= 0 ? slot != coupled : slot == excepted;
}

Task<Result<int>> Slots::find_empty() {
  const auto& used = console_.draft.slot_bytes_used;
  if (confirmed_empty_ >= 0 && used[ix(confirmed_empty_)] == 0 && may_be_scratch(confirmed_empty_))
    co_return confirmed_empty_;
  for (const bool selected_too : {false, true})  // the selected one only when no other is left
    for (int slot = program_count - 1; slot >= 0; --slot) {
      if ((slot == selected_) != selected_too || used[ix(slot)] != 0 || !may_be_scratch(slot)) continue;
      auto chosen = co_await choose(slot, Priority::intent);
      if (!chosen) co_return fail(chosen.error());
      auto listing = co_await talk_.listing(Priority::intent);
      if (!listing) co_return fail(listing.error());
      auto back = co_await give_back_selection();
      if (!back) co_return fail(back.error());
      if (listing->slot == slot && listing->free_bytes == program_bytes && listing->commands.empty()) {
        confirmed_empty_ = slot;
        co_return slot;
      }
      holds(slot, *listing);
    }
  const Fault none(
      FaultKind::refused,
      "All five programs of the controller hold commands, and a move of the console needs an empty one for "
      "its time.",
      "Nothing was sent and nothing was erased.",
      "Which may be emptied? Choose it in the program editor, save its text if it is needed, take Empty in "
      "controller, and move again.");
  ask_for_room(none.sentence());
  co_return fail(none);
}

Task<Result<>> Slots::choose(int slot, Priority priority) {
  auto said = co_await talk_.say(select_program(slot), priority);
  if (said || said.error().kind != FaultKind::stopped) chosen_ = slot;
  co_return said;
}

Task<Result<>> Slots::give_back_selection() {
  if (chosen_ == selected_ || selected_ < 0) co_return Result<>();
  co_return co_await choose(selected_, Priority::poll);
}

void Slots::ask_for_room(std::string sentence) const {
  if (!console_.notify) return;
  Notice question(Notice::Kind::question, console_.scheduler.now(), std::move(sentence));
  for (int slot = 0; slot < program_count; ++slot)
    if (may_be_scratch(slot)) question.slots.push_back(slot);
  console_.notify(std::move(question));
}

// ---- what they hold

const std::optional<Slots::Lines>& Slots::listing(int slot) const {
  static const std::optional<Lines> none;
  return slot >= 0 && slot < program_count ? listings_[ix(slot)] : none;
}

void Slots::holds(int slot, const Listing& listing) {
  console_.draft.slot_bytes_used[ix(slot)] = static_cast<std::int16_t>(program_bytes - listing.free_bytes);
  listings_[ix(slot)] = listing.commands;
}

void Slots::doubt(int slot) {
  console_.draft.slot_bytes_used[ix(slot)] = -1;
  listings_[ix(slot)].reset();
  if (confirmed_empty_ == slot) confirmed_empty_ = -1;
  sizes_read_ = false;
}

void Slots::selected_was_changed() {
  if (selected_ < 0) return;
  doubt(selected_);
  console_.draft.unsaved_programs = true;
}

void Slots::doubt_all() {
  for (int slot = 0; slot < program_count; ++slot) doubt(slot);
}

void Slots::forget() {
  doubt_all();
  selected_ = chosen_ = 0;
  console_.draft.unsaved_programs = false;
  console_.draft.program.slot = 0;
}

}  // namespace hw::vxm
