#include "core/devices/arcus/borrowed_setting.h"

#include <fmt/core.h>

namespace hw::arcus {

Task<Result<>> BorrowedSetting::borrow(std::string name, std::int64_t value,
                                       std::optional<std::int64_t> shown) {
  Conversation::Decode decode = decode_number;
  auto before = co_await talk_.ask_surely(name, std::move(decode), shown, Priority::intent);
  if (!before) co_return fail(before.error());
  if (*before == value) co_return Result<>();
  borrowed_ = Borrowed{name, *before, value};
  co_return co_await talk_.command(set_command(name, value), Priority::intent);
}

Task<Result<>> BorrowedSetting::give_back() {
  if (!borrowed_) co_return Result<>();
  if (borrowed_->left_alone) {
    Conversation::Decode decode = decode_number;
    auto present =
        co_await talk_.ask_surely(borrowed_->name, std::move(decode), borrowed_->for_now, Priority::intent);
    if (!present) co_return fail(present.error());
    if (borrowed_ && *present != borrowed_->for_now) borrowed_.reset();
    if (!borrowed_) co_return Result<>();
  }
  auto set = co_await put_back(*borrowed_);
  if (set && borrowed_) given_back_(borrowed_->name);
  if (set) borrowed_.reset();
  if (!set && set.error().kind == FaultKind::stopped) co_return Result<>();  // the next round does it
  co_return set;
}

// A digit that is doubled on its way is no less a number, and nobody looks at this one before the next
// motion.
Task<Result<>> BorrowedSetting::put_back(Borrowed setting) {
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    auto set = co_await talk_.command(set_command(setting.name, setting.before), Priority::intent);
    if (!set) co_return set;
    Conversation::Decode decode = decode_number;
    auto present =
        co_await talk_.ask_surely(setting.name, std::move(decode), setting.before, Priority::intent);
    if (!present) co_return fail(present.error());
    if (*present == setting.before) co_return Result<>();
  }
  co_return fail(FaultKind::garbled,
                 fmt::format("{} does not become {} again.", setting.name, setting.before),
                 fmt::format("It was set {} times.", attempts), "Look at the cable.");
}

Task<Result<>> BorrowedSetting::give_back_first() {
  auto returned = co_await give_back();
  if (returned || !worth_another_try(returned.error())) co_return returned;
  Fault why = std::move(returned.error());
  why.kind = FaultKind::refused;
  why.done = "The setting of the last motion is not put back yet; nothing else was sent.";
  co_return fail(std::move(why));
}

std::string BorrowedSetting::leaves_behind() const {
  if (!borrowed_) return {};
  return fmt::format("{0} is {1} for one motion; it was {2}. Set {0}={2} before the next one.",
                     borrowed_->name, borrowed_->for_now, borrowed_->before);
}

}  // namespace hw::arcus
