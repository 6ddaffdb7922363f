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
  auto set = co_await talk_.command(set_command(borrowed_->name, borrowed_->before), Priority::intent);
  if (set && borrowed_) given_back_(borrowed_->name);
  if (set) borrowed_.reset();
  if (!set && set.error().kind == FaultKind::stopped) co_return Result<>();  // the next round does it
  co_return set;
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
