#include "core/devices/arcus/move_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace hw::arcus {
namespace {

constexpr int most_per_round = 8;  // so that status rounds are not delayed
constexpr double status_takes_part = 1.3;

}  // namespace

Result<> MoveList::accepts(const intent::FeedMoves& request) const {
  const auto& columns = console_.catalog.move_list.columns;
  if (columns.empty())
    return fail(FaultKind::refused, fmt::format("A {} has no buffer for moves.", console_.model().title),
                "Nothing was sent.");
  for (std::size_t row = 0; row < request.rows.size(); ++row)
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (request.rows[row].size() != columns.size() ||
          (request.rows[row][c] != intent::FeedMoves::as_it_is &&
           (request.rows[row][c] < columns[c].minimum || request.rows[row][c] > columns[c].maximum)))
        return fail(FaultKind::refused,
                    fmt::format("Move {} of the list cannot be sent: {} goes from {} to {}.", row + 1,
                                columns[c].label, columns[c].minimum, columns[c].maximum),
                    "Nothing was sent.");
  return {};
}

Task<Result<>> MoveList::switch_buffer_on() {
  auto on = co_await conversation_.command("BO", Priority::intent);
  if (!on && on.error().kind == FaultKind::refused)
    on.error().advice = "Buffered moves need StepNLoop of X, Y and Z switched off.";
  if (!on) co_return on;
  console_.report(
      Notice::Kind::info,
      console_.snapshot.pieces.running
          ? "Buffered mode is on while this is drawn. After a stop it stays on until you switch it off."
          : "Buffered mode was switched on for the list. It stays on until you switch it off.");
  co_return Result<>();
}

void MoveList::begin(std::vector<std::vector<std::int64_t>> rows) {
  const auto& columns = console_.catalog.move_list.columns;
  const auto own_speed = std::llround(console_.snapshot.axes[0].own_speed.value);
  for (std::vector<std::int64_t>& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      const int axis = columns[c].of_axis;
      const std::int64_t now = axis >= 0 ? console_.snapshot.axes[axis].position.value : own_speed;
      if (row[c] == intent::FeedMoves::as_it_is) row[c] = std::max(now, columns[c].minimum);
    }
  to_feed_.assign(std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
  for (std::size_t a = 0; a < behind_.size(); ++a) behind_[a] = console_.snapshot.axes[a].position.value;
  if (row_takes_ == Duration::zero() && conversation_.is_open())
    row_takes_ = conversation_.station()->wire_time(40);
  if (console_.snapshot.pieces.step < 0) slow_reported_ = false;  // the first of all
  console_.snapshot.feed.running = !to_feed_.empty();
  console_.snapshot.feed.sent = 0;
  console_.snapshot.feed.total = static_cast<std::int32_t>(to_feed_.size());
}

// A move is taken from the list before it is sent, so it is never sent twice, whatever the reply. Only the
// reply that the buffer is full proves that the controller did not take it.
Task<Result<>> MoveList::feed(std::function<void()> moves) {
  if (console_.snapshot.pieces.held) co_return Result<>();
  // A status round takes as long as a few moves: more are sent before the buffer runs dry.
  const bool runs_dry = 2 * buffer_free_ > console_.catalog.move_list.depth;
  const int most = runs_dry ? 2 * most_per_round : most_per_round;
  for (int n = 0; n < most && !to_feed_.empty() && buffer_free_ > 0; ++n) {
    if (!buffer_on_) {
      end();
      console_.report(Notice::Kind::warning,
                      "Buffered mode was switched off, so the rest of the list was not sent.");
      co_return Result<>();
    }
    const std::vector<std::int64_t> row = std::move(to_feed_.front());
    to_feed_.pop_front();
    const std::string text = fmt::format("I{}:{}:{}:{}", row[0], row[1], row[2], speed_of(row));
    const Instant asked_at = console_.scheduler.now();
    auto reply = co_await conversation_.exchange(text, Priority::intent, Millis(200));
    if (reply && reply->text == console_.model().refusal(Refusal::buffer_full)) {
      to_feed_.push_front(row);
      buffer_free_ = 0;
      break;
    }
    if (!reply || reply->text != "OK") {
      Fault why = reply ? conversation_.refusal(text, reply->text).value() : reply.error();
      broken_off(std::move(why));
      co_return Result<>();
    }
    row_took(console_.scheduler.now() - asked_at);
    std::copy_n(row.begin(), behind_.size(), behind_.begin());
    --buffer_free_;
    ++console_.snapshot.feed.sent;
    moves();
  }
  if (!to_feed_.empty()) co_return Result<>();
  console_.snapshot.feed.running = false;
  co_return Result<>();
}

std::int64_t MoveList::speed_of(const std::vector<std::int64_t>& row) {
  if (!console_.snapshot.pieces.running) return row[3];
  const ActionField& column = console_.catalog.move_list.columns[3];
  const std::int64_t speed =
      std::clamp(row[3] * console_.snapshot.pieces.percent / 100, column.minimum, column.maximum);
  if (to_feed_.empty()) return speed;
  double way = 0;
  for (std::size_t a = 0; a < behind_.size(); ++a)
    way = std::hypot(way, static_cast<double>(row[a] - behind_[a]));
  const double at_least_s = status_takes_part * seconds(row_takes_);
  if (way >= at_least_s * static_cast<double>(speed)) return speed;
  if (!std::exchange(slow_reported_, true))
    console_.report(Notice::Kind::info,
                    fmt::format("Short lines are drawn more slowly than set: sending a line takes {} ms on "
                                "this wire, and no line may end sooner.",
                                row_takes_ / Millis(1)));
  return std::max(static_cast<std::int64_t>(way / at_least_s), std::int64_t{1});
}

void MoveList::row_took(Duration time) { row_takes_ = std::max(time, row_takes_ - row_takes_ / 16); }

void MoveList::broken_off(Fault why) {
  const int sent = console_.snapshot.feed.sent;
  end();
  if (why.kind == FaultKind::stopped) return;
  why.done = fmt::format("Only {} moves of the list were sent.", sent);
  console_.report(Notice::Kind::error, why.sentence());
}

void MoveList::end() {
  to_feed_.clear();
  console_.snapshot.feed.running = false;
}

}  // namespace hw::arcus
