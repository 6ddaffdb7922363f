// A list of moves, fed into the controller's buffer as its places become free.
#include <fmt/core.h>

#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr int most_per_round = 8;  // so that the round of status is not kept waiting

}  // namespace

Task<Result<>> ArcusDriver::start_feed(intent::FeedMoves wish) {
  const auto& columns = catalog_.move_list.columns;
  if (columns.empty())
    co_return fail(FaultKind::refused, fmt::format("A {} has no buffer for moves.", model().title),
                   "Nothing was sent.");
  for (std::size_t row = 0; row < wish.rows.size(); ++row)
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (wish.rows[row].size() != columns.size() || wish.rows[row][c] < columns[c].minimum ||
          wish.rows[row][c] > columns[c].maximum)
        co_return fail(FaultKind::refused,
                       fmt::format("Move {} of the list cannot be sent: {} goes from {} to {}.", row + 1,
                                   columns[c].label, columns[c].minimum, columns[c].maximum),
                       "Nothing was sent.");
  auto read = co_await read_motion(Priority::intent);
  if (!read) co_return read;
  if (!buffer_on_) {
    auto on = co_await talk_.command("BO", Priority::intent);
    if (!on && on.error().kind == FaultKind::refused)
      on.error().advice = "Buffered moves need StepNLoop of X, Y and Z switched off.";
    if (!on) co_return on;
    tell(Notice::Kind::info,
         "Buffered mode was switched on for the list. It stays on until you switch it off.");
    auto again = co_await read_motion(Priority::intent);
    if (!again) co_return again;
  }
  to_feed_.assign(std::make_move_iterator(wish.rows.begin()), std::make_move_iterator(wish.rows.end()));
  draft_.feed.running = !to_feed_.empty();
  draft_.feed.sent = 0;
  draft_.feed.total = static_cast<std::int32_t>(to_feed_.size());
  co_return co_await feed();
}

// A move is taken from the list before it is sent: whatever comes back, it is not sent twice. Only a buffer
// that was full has not taken it.
Task<Result<>> ArcusDriver::feed() {
  for (int n = 0; n < most_per_round && !to_feed_.empty() && buffer_free_ > 0; ++n) {
    if (!buffer_on_) {
      end_feed();
      tell(Notice::Kind::warning, "Buffered mode was switched off, so the rest of the list was not sent.");
      co_return Result<>();
    }
    const std::vector<std::int64_t> row = std::move(to_feed_.front());
    to_feed_.pop_front();
    const std::string text = fmt::format("I{}:{}:{}:{}", row[0], row[1], row[2], row[3]);
    auto reply = co_await talk_.exchange(text, Priority::intent, Millis(200));
    if (reply && reply->text == model().refusal(Refusal::buffer_full)) {
      to_feed_.push_front(row);
      buffer_free_ = 0;
      break;
    }
    if (!reply || reply->text != "OK") {
      const int sent = draft_.feed.sent;
      end_feed();
      Fault fault = reply ? talk_.refusal(text, reply->text).value() : reply.error();
      if (fault.kind == FaultKind::stopped) co_return Result<>();
      fault.done = fmt::format("{} moves of the list were sent; the rest was not.", sent);
      tell(Notice::Kind::error, fault.sentence());
      co_return Result<>();
    }
    --buffer_free_;
    ++draft_.feed.sent;
    for (int axis = 0; axis < 3 && axis < axis_count(); ++axis) begun(axis, Activity::moving, round_began_);
  }
  if (to_feed_.empty()) draft_.feed.running = false;
  co_return Result<>();
}

void ArcusDriver::end_feed() {
  to_feed_.clear();
  draft_.feed.running = false;
}

}  // namespace hw::arcus
