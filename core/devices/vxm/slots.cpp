// The selected program, and the known contents of each.
#include "core/devices/vxm/slots.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"

namespace hw::vxm {
namespace {

/// A PM4 that has lost its M.
bool may_be_select_without_m(const TextCommand& c) {
  return c.verb == Verb::pause && !c.minus && c.value < program_count;
}

}  // namespace

// ---- selection

void Slots::was_selected(int slot) {
  selected_ = chosen_ = slot;
  may_be_selected_ = only(slot);
  if (!conversation_.listens().running) console_.snapshot.program.slot = static_cast<std::int8_t>(slot);
}

// A PM that has lost its P is another question, M.
Task<Result<std::int64_t>> Slots::ask_selected() {
  auto selected = co_await conversation_.number("PM\r", Priority::poll);
  const auto is_one = [&] { return *selected >= 0 && *selected < program_count; };
  if (selected && !is_one()) selected = co_await conversation_.number("PM\r", Priority::poll);
  if (!selected || is_one()) co_return selected;
  co_return fail(
      FaultKind::garbled,
      fmt::format("The controller reports program {} as selected, but it has only 0 to 4.", *selected));
}

// M reports on the selected program, so each is selected in turn and the user's choice restored. The user's
// program is read first: a PM that lost a byte may change it, which must be noticed.
Task<Result<>> Slots::read_sizes() {
  auto given_back = co_await give_back_selection();
  if (!given_back) co_return given_back;
  auto selected = co_await ask_selected();
  if (!selected) co_return fail(selected.error());
  was_selected(static_cast<int>(*selected));
  auto read = co_await read_size();
  if (!read) co_return read;
  for (int slot = 0; slot < program_count; ++slot) {
    if (console_.snapshot.slot_bytes_used[ix(slot)] >= 0) continue;
    auto chosen = co_await choose(slot, Priority::poll);
    if (!chosen) co_return chosen;
    read = co_await read_size();
    if (!read) co_return read;
  }
  sizes_read_ = true;
  co_return co_await give_back_selection();
}

Task<Result<>> Slots::read_size() {
  std::int16_t& used = console_.snapshot.slot_bytes_used[ix(chosen_)];
  if (used >= 0) co_return Result<>();
  auto free = co_await conversation_.number("M", Priority::poll);
  if (!free) co_return fail(free.error());
  used = static_cast<std::int16_t>(program_bytes - *free);
  co_return Result<>();
}

// Not a program that starts by itself (4 after power-up or after Stop) or with a Slave's program.
bool Slots::may_be_scratch(int slot) const {
  const auto mode = parameters_.value("DM").value_or(0), inputs = parameters_.value("I").value_or(0);
  if (slot == 4 && (mode & mode_program_4_first || inputs & inputs_program_4)) return false;
  const auto coupled = parameters_.value("PMA").value_or(pma_off);
  if (coupled == pma_off) return true;
  const auto excepted = coupled == -5 ? 0 : -coupled;
  return coupled >= 0 ? slot != coupled : slot == excepted;
}

Task<Result<int>> Slots::find_empty() {
  const auto& used = console_.snapshot.slot_bytes_used;
  if (confirmed_empty_ >= 0 && used[ix(confirmed_empty_)] == 0 && may_be_scratch(confirmed_empty_))
    co_return confirmed_empty_;
  for (const bool selected_too : {false, true})  // the selected program only if no other is left
    for (int slot = program_count - 1; slot >= 0; --slot) {
      if ((slot == selected_) != selected_too || used[ix(slot)] != 0 || !may_be_scratch(slot)) continue;
      auto chosen = co_await choose(slot, Priority::intent);
      if (!chosen) co_return fail(chosen.error());
      auto free = co_await conversation_.number("M", Priority::intent);
      if (!free) co_return fail(free.error());
      if (*free == program_bytes) {
        confirmed_empty_ = slot;
        co_return slot;
      }
      doubt(slot);
      console_.snapshot.slot_bytes_used[ix(slot)] = static_cast<std::int16_t>(program_bytes - *free);
    }
  const Fault none(FaultKind::refused,
                   "All five programs of the controller contain commands, and a move from the console needs "
                   "an empty program while it lasts.",
                   "Nothing was sent and nothing was erased.",
                   "In the program editor, choose a program that may be emptied, save its text if you need "
                   "it, press Empty in controller, and move again.");
  ask_for_room(none.sentence());
  co_return fail(none);
}

// A lost or doubled byte may have selected another program, or none. A PM4 that has lost its M is a pause,
// and is stored.
Task<Result<>> Slots::choose(int slot, Priority priority) {
  const std::uint32_t repeats = conversation_.repeats();
  chosen_ = -1;
  const Set before = may_be_selected_;
  may_be_selected_ = static_cast<Set>(before | only(slot));
  auto chosen = co_await conversation_.confirm(select_program(slot) + "PM\r", slot, priority);
  const bool at_once = chosen && conversation_.repeats() == repeats;
  const bool not_sent =
      !chosen && chosen.error().kind == FaultKind::stopped && conversation_.repeats() == repeats;
  if (!at_once && !not_sent) may_have_grown_ = static_cast<Set>(may_have_grown_ | before | only(slot));
  if (!chosen) co_return chosen;
  chosen_ = slot;
  may_be_selected_ = only(slot);
  co_return chosen;
}

Task<Result<>> Slots::give_back_selection() {
  if (selection_is_given_back() || selected_ < 0) co_return Result<>();
  auto taken_back = co_await take_back_pauses(Priority::poll);
  if (!taken_back) co_return taken_back;
  co_return co_await choose(selected_, Priority::poll);
}

Task<Result<>> Slots::take_back_pauses(Priority priority) {
  for (int slot = 0; slot < program_count; ++slot) {
    if ((may_have_grown_ & only(slot)) == 0) continue;
    auto taken_back = co_await take_back_pauses_of(slot, priority);
    if (!taken_back) co_return taken_back;
    may_have_grown_ = static_cast<Set>(may_have_grown_ & ~only(slot));
  }
  co_return Result<>();
}

// While the program holds more than it did and ends with a pause, that pause is the console's.
Task<Result<>> Slots::take_back_pauses_of(int slot, Priority priority) {
  const std::int16_t used = console_.snapshot.slot_bytes_used[ix(slot)];
  for (int attempt = 0; attempt <= program_count; ++attempt) {
    auto chosen = co_await choose(slot, priority);
    if (!chosen) co_return chosen;
    auto listing = co_await conversation_.listing(priority);
    if (!listing) co_return fail(listing.error());
    const auto commands = commands_of(listing->commands);
    if (used < 0) {  // after a restart: former contents unknown
      if (!commands.empty() && may_be_select_without_m(commands.back()))
        warn_of_pause_at_end(slot, commands.back());
      co_return Result<>();
    }
    if (listing->free_bytes >= program_bytes - used) co_return Result<>();
    if (listing->slot != slot || commands.empty() || commands.back().verb != Verb::pause) break;
    auto sent = co_await conversation_.transmit("del", priority);
    if (!sent) co_return sent;
  }
  doubt(slot);
  console_.report(Notice::Kind::warning,
                  fmt::format("Check program {} of the controller before you run it: it has grown, so a byte "
                              "that was sent was lost or arrived twice.",
                              slot));
  co_return Result<>();
}

void Slots::warn_of_pause_at_end(int slot, const TextCommand& pause) const {
  console_.report(Notice::Kind::warning,
                  fmt::format("Check program {} of the controller before you run it: it ends with P{}. This "
                              "may be a selection by the console that lost a byte.",
                              slot, pause.value));
}

void Slots::ask_for_room(std::string sentence) const {
  if (!console_.notify) return;
  Notice question(Notice::Kind::question, console_.scheduler.now(), std::move(sentence));
  for (int slot = 0; slot < program_count; ++slot)
    if (may_be_scratch(slot)) question.slots.push_back(slot);
  console_.notify(std::move(question));
}

// ---- contents

const std::optional<Slots::Lines>& Slots::listing(int slot) const {
  static const std::optional<Lines> none;
  return slot >= 0 && slot < program_count ? listings_[ix(slot)] : none;
}

void Slots::holds(int slot, const Listing& listing) {
  console_.snapshot.slot_bytes_used[ix(slot)] = static_cast<std::int16_t>(program_bytes - listing.free_bytes);
  listings_[ix(slot)] = listing.commands;
}

void Slots::doubt(int slot) {
  console_.snapshot.slot_bytes_used[ix(slot)] = -1;
  listings_[ix(slot)].reset();
  typed_[ix(slot)].reset();
  if (confirmed_empty_ == slot) confirmed_empty_ = -1;
  sizes_read_ = false;
}

ProgramContents Slots::contents(int slot) const {
  if (const auto& read = listing(slot)) return commands_of(*read);
  if (slot < 0 || slot >= program_count) return {};
  if (console_.snapshot.slot_bytes_used[ix(slot)] == 0) return ProgramContents(std::in_place);
  return typed_[ix(slot)];
}

void Slots::selected_was_changed(const TextCommand& by) {
  if (selected_ < 0) return;
  ProgramContents now = contents(selected_);
  change(now, by);
  doubt(selected_);
  typed_[ix(selected_)] = std::move(now);
  console_.snapshot.unsaved_programs = true;
}

void Slots::doubt_all() {
  for (int slot = 0; slot < program_count; ++slot) doubt(slot);
}

void Slots::forget() {
  doubt_all();
  selected_ = chosen_ = 0;
  may_be_selected_ = only(0);
  may_have_grown_ = 0;
  console_.snapshot.unsaved_programs = false;
  console_.snapshot.program.slot = 0;
}

}  // namespace hw::vxm
