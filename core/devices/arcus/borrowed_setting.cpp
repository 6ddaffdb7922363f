#include "core/devices/arcus/borrowed_setting.h"

#include <algorithm>

#include <fmt/core.h>

namespace hw::arcus {

Task<Result<>> BorrowedSetting::borrow(std::string name, std::int64_t value,
                                       std::optional<std::int64_t> shown) {
  const auto is_it = [&name](const Borrowed& one) { return one.name == name; };
  Conversation::Decode decode = decode_number;
  auto before = co_await conversation_.ask_confirmed(name, std::move(decode), shown, Priority::intent);
  if (!before) co_return fail(before.error());
  if (*before == value) co_return Result<>();
  if (const auto out = std::find_if(borrowed_.begin(), borrowed_.end(), is_it); out != borrowed_.end())
    out->for_now = value;
  else
    borrowed_.push_back({name, *before, value});
  co_return co_await conversation_.command(set_command(name, value), Priority::intent);
}

Task<Result<>> BorrowedSetting::give_back() {
  while (!borrowed_.empty()) {
    const std::size_t out = borrowed_.size();
    auto returned = co_await give_back_last();
    if (!returned || borrowed_.size() == out) co_return returned;
  }
  co_return Result<>();
}

Task<Result<>> BorrowedSetting::give_back_last() {
  const Borrowed last = borrowed_.back();
  if (last.left_alone) {
    Conversation::Decode decode = decode_number;
    auto present =
        co_await conversation_.ask_confirmed(last.name, std::move(decode), last.for_now, Priority::intent);
    if (!present) co_return fail(present.error());
    const bool anothers = *present != last.for_now;
    if (anothers && is_out()) borrowed_.pop_back();
    if (anothers || !is_out()) co_return Result<>();
  }
  auto set = co_await put_back(last);
  if (set && is_out()) {
    given_back_(last.name);
    borrowed_.pop_back();
  }
  if (!set && set.error().kind == FaultKind::stopped) co_return Result<>();  // the next round does it
  co_return set;
}

// A digit doubled on the line still leaves a valid number, and this setting is not read again before the next
// motion.
Task<Result<>> BorrowedSetting::put_back(Borrowed setting) {
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    auto set = co_await conversation_.command(set_command(setting.name, setting.before), Priority::intent);
    if (!set) co_return set;
    Conversation::Decode decode = decode_number;
    auto present = co_await conversation_.ask_confirmed(setting.name, std::move(decode), setting.before,
                                                        Priority::intent);
    if (!present) co_return fail(present.error());
    if (*present == setting.before) co_return Result<>();
  }
  co_return fail(FaultKind::garbled,
                 fmt::format("{} could not be set back to {}.", setting.name, setting.before),
                 fmt::format("It was set {} times.", attempts), "Check the cable.");
}

Task<Result<>> BorrowedSetting::give_back_first() {
  auto returned = co_await give_back();
  if (returned || !worth_another_try(returned.error())) co_return returned;
  Fault why = std::move(returned.error());
  why.kind = FaultKind::refused;
  why.done = "The setting for the last motion has not been restored yet, so nothing else was sent.";
  co_return fail(std::move(why));
}

std::string BorrowedSetting::leaves_behind() const {
  std::string all;
  for (const Borrowed& one : borrowed_)
    all +=
        fmt::format("{0}Set {1}={3} before the next motion: {1} is still {2}, which was for one motion only.",
                    all.empty() ? "" : " ", one.name, one.for_now, one.before);
  return all;
}

}  // namespace hw::arcus
