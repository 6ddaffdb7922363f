#include "core/devices/vxm/scratch.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr int attempts = 3;

bool same(const std::vector<TextCommand>& held, const std::vector<TextCommand>& wanted) {
  return std::equal(held.begin(), held.end(), wanted.begin(), wanted.end(),
                    [](const TextCommand& a, const TextCommand& b) { return canonical(a) == canonical(b); });
}

}  // namespace

Task<Result<>> Scratch::take() {
  auto slot = co_await slots_.find_empty();
  if (!slot) co_return fail(slot.error());
  slot_ = *slot;
  co_return Result<>();
}

Task<Result<>> Scratch::fill(std::string commands) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    auto chosen = co_await slots_.choose(slot_, Priority::intent);
    if (!chosen) co_return chosen;
    auto sent = co_await conversation_.transmit("C" + commands, Priority::intent);
    if (!sent) co_return sent;
    auto held = co_await holds(commands);
    if (held && *held) co_return Result<>();
    if (!held && !worth_another_try(held.error())) co_return fail(held.error());
    auto quiet = co_await conversation_.wait_for_quiet();  // more bytes may come than expected
    if (!quiet) co_return quiet;
  }
  co_return fail(FaultKind::garbled,
                 fmt::format("Program {} in the controller differs from the text that was sent.", slot_),
                 "Nothing was run.", check_line);
}

// A pair of indexes may be listed in more than one line.
Task<Result<bool>> Scratch::holds(const std::string& commands) {
  const auto wanted = read_text(commands);
  const bool lines_are_known = commands.find('(') == std::string::npos;
  Result<Listing> listing;
  if (lines_are_known)
    listing = co_await conversation_.listing_of(wanted.size(), Priority::intent);
  else
    listing = co_await conversation_.listing(Priority::intent);
  if (!listing) co_return fail(listing.error());
  int cost = 0;
  for (const TextCommand& c : wanted) cost += program_cost(c);
  const bool as_long = listing->free_bytes == program_bytes - cost;
  co_return listing->slot == slot_&& as_long&& same(commands_of(listing->commands), wanted);
}

Task<Result<>> Scratch::clear(Priority priority) {
  if (!in_use()) co_return Result<>();
  auto chosen = co_await slots_.choose(slot_, priority);
  if (!chosen) co_return chosen;
  auto cleared = co_await conversation_.confirm("CM", program_bytes, priority);
  if (!cleared) co_return cleared;
  slot_ = -1;
  co_return Result<>();
}

}  // namespace hw::vxm
