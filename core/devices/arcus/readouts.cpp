#include "core/devices/arcus/readouts.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/catalog.h"

namespace hw::arcus {
namespace {

constexpr int variables_per_round = 10;

}  // namespace

// Readouts contained in the status need no questions.
Readouts::Readouts(const Console& console, Conversation& conversation,
                   std::function<void(int axis, std::int64_t state)> loop_is)
    : console_(console), conversation_(conversation), loop_is_(std::move(loop_is)) {
  by_status_.assign(console_.catalog.readouts.size(), false);
  for (std::size_t i = 0; i < by_status_.size(); ++i) {
    const std::string& id = console_.catalog.readouts[i].id;
    by_status_[i] = id.starts_with("MST") || id == "LATCHIN" || id == "INDEX";
    for (const std::string_view behind : console_.forms.behind_status)
      by_status_[i] = by_status_[i] || id == behind;
  }
}

void Readouts::put(std::string_view id, std::int64_t value) {
  const int index = console_.catalog.find_readout(id);
  if (index < 0) return;
  console_.snapshot.readouts[ix(index)] = value;
  console_.snapshot.readouts_known.set(ix(index));
  console_.snapshot.readouts_seen_at[ix(index)] = console_.scheduler.now();
  if (id == "MM") incremental_ = value != 0;
}

Task<Result<>> Readouts::read(int index, Priority priority) {
  const ReadoutInfo& info = console_.catalog.readouts[ix(index)];
  auto value = co_await conversation_.ask_number(info.id, priority);
  if (!value) co_return fail(value.error());
  put(info.id, *value);
  if (info.group == loop && info.axis >= 0 &&
      info.id == fill(console_.forms, console_.forms.loop_state, info.axis))
    loop_is_(info.axis, *value);
  co_return Result<>();
}

/// A program may change it at any time.
std::optional<bool> Readouts::known_incremental() const {
  const auto& threads = console_.snapshot.threads;
  if (std::any_of(threads.begin(), threads.end(),
                  [](const ThreadState& thread) { return thread.run == RunState::running; }))
    return std::nullopt;
  const int index = console_.catalog.find_readout("MM");
  if (index < 0 || !console_.snapshot.readouts_known.test(ix(index))) return std::nullopt;
  return incremental_;
}

Task<Result<>> Readouts::read_mode(Priority priority) {
  const int index = console_.catalog.find_readout(console_.forms.mode);
  if (index < 0) co_return Result<>();
  co_return co_await read(index, priority);
}

Task<Result<>> Readouts::read_analog(int number, Priority priority) {
  auto value = co_await conversation_.ask_number(fmt::format("AI{}", number), priority);
  if (!value) co_return fail(value.error());
  console_.snapshot.analog[ix(number - 1)] = static_cast<std::int32_t>(*value);
  console_.snapshot.analog_known |= 1u << (number - 1);
  console_.snapshot.analog_seen_at[ix(number - 1)] = console_.scheduler.now();
  co_return Result<>();
}

Task<Result<>> Readouts::read_variable(int number, Priority priority) {
  auto value = co_await conversation_.ask_number(fmt::format("V{}", number), priority);
  if (!value) co_return fail(value.error());
  console_.snapshot.variables[ix(number)] = static_cast<std::int32_t>(*value);
  console_.snapshot.variables_known.set(ix(number));
  co_return Result<>();
}

Task<Result<>> Readouts::read_watched() {
  const auto& threads = console_.snapshot.threads;
  const bool runs = std::any_of(threads.begin(), threads.end(),
                                [](const ThreadState& thread) { return thread.run == RunState::running; });
  // The program may change them, and without a reader the change would go unnoticed.
  if (runs && !(watched_ >> variable_values & 1)) console_.snapshot.variables_known.reset();
  for (int i = 0; i < static_cast<int>(console_.catalog.readouts.size()); ++i) {
    if (by_status_[ix(i)] || !(watched_ >> console_.catalog.readouts[ix(i)].group & 1)) continue;
    auto done = co_await read(i, Priority::poll);
    if (!done) co_return done;
  }
  if (watched_ >> variable_values & 1)
    for (int i = 0; i < variables_per_round; ++i) {
      const int count = console_.catalog.variables.count;
      auto read = co_await read_variable(variables_.peek(count), Priority::poll);
      if (!read) co_return read;
      variables_.next(count);
    }
  const bool all_analog = (watched_ >> analog_inputs & 1) != 0;
  for (int n = 1; all_analog && n <= console_.model().analog_inputs; ++n) {
    auto read = co_await read_analog(n, Priority::poll);
    if (!read) co_return read;
  }
  co_return Result<>();
}

Task<Result<>> Readouts::read_in_turn() {
  const int index = readouts_.next(static_cast<int>(console_.catalog.readouts.size()),
                                   [this](int i) { return !by_status_[ix(i)]; });
  if (index >= 0) {
    auto done = co_await read(index, Priority::poll);
    if (!done) co_return done;
  }
  if (const int inputs = console_.model().analog_inputs; inputs > 0) {
    auto done = co_await read_analog(analog_.peek(inputs) + 1, Priority::poll);
    if (!done) co_return done;
    analog_.next(inputs);
  }
  co_return Result<>();
}

}  // namespace hw::arcus
