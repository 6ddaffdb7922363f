#include "core/devices/arcus/move_list.h"

#include <fmt/core.h>

namespace hw::arcus {
namespace {

constexpr int most_per_round = 8;  // so that the round of status is not kept waiting

}  // namespace

Result<> MoveList::accepts(const intent::FeedMoves& wish) const {
  const auto& columns = console_.catalog.move_list.columns;
  if (columns.empty())
    return fail(FaultKind::refused, fmt::format("A {} has no buffer for moves.", console_.model().title),
                "Nothing was sent.");
  for (std::size_t row = 0; row < wish.rows.size(); ++row)
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (wish.rows[row].size() != columns.size() || wish.rows[row][c] < columns[c].minimum ||
          wish.rows[row][c] > columns[c].maximum)
        return fail(FaultKind::refused,
                    fmt::format("Move {} of the list cannot be sent: {} goes from {} to {}.", row + 1,
                                columns[c].label, columns[c].minimum, columns[c].maximum),
                    "Nothing was sent.");
  return {};
}

Task<Result<>> MoveList::switch_buffer_on() {
  auto on = co_await talk_.command("BO", Priority::intent);
  if (!on && on.error().kind == FaultKind::refused)
    on.error().advice = "Buffered moves need StepNLoop of X, Y and Z switched off.";
  if (!on) co_return on;
  console_.tell(Notice::Kind::info,
                "Buffered mode was switched on for the list. It stays on until you switch it off.");
  co_return Result<>();
}

void MoveList::begin(std::vector<std::vector<std::int64_t>> rows) {
  to_feed_.assign(std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
  console_.draft.feed.running = !to_feed_.empty();
  console_.draft.feed.sent = 0;
  console_.draft.feed.total = static_cast<std::int32_t>(to_feed_.size());
}

// A move is taken from the list before it is sent: whatever comes back, it is not sent twice. Only a buffer
// that was full has not taken it.
Task<Result<>> MoveList::feed(std::function<void()> moves) {
  for (int n = 0; n < most_per_round && !to_feed_.empty() && buffer_free_ > 0; ++n) {
    if (!buffer_on_) {
      end();
      console_.tell(Notice::Kind::warning,
                    "Buffered mode was switched off, so the rest of the list was not sent.");
      co_return Result<>();
    }
    const std::vector<std::int64_t> row = std::move(to_feed_.front());
    to_feed_.pop_front();
    const std::string text = fmt::format("I{}:{}:{}:{}", row[0], row[1], row[2], row[3]);
    auto reply = co_await talk_.exchange(text, Priority::intent, Millis(200));
    if (reply && reply->text == console_.model().refusal(Refusal::buffer_full)) {
      to_feed_.push_front(row);
      buffer_free_ = 0;
      break;
    }
    if (!reply || reply->text != "OK") {
      Fault why = reply ? talk_.refusal(text, reply->text).value() : reply.error();
      broken_off(std::move(why));
      co_return Result<>();
    }
    --buffer_free_;
    ++console_.draft.feed.sent;
    moves();
  }
  if (to_feed_.empty()) console_.draft.feed.running = false;
  co_return Result<>();
}

void MoveList::broken_off(Fault why) {
  const int sent = console_.draft.feed.sent;
  end();
  if (why.kind == FaultKind::stopped) return;
  why.done = fmt::format("{} moves of the list were sent; the rest was not.", sent);
  console_.tell(Notice::Kind::error, why.sentence());
}

void MoveList::end() {
  to_feed_.clear();
  console_.draft.feed.running = false;
}

}  // namespace hw::arcus
