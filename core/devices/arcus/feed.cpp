#include "core/devices/arcus/feed.h"

namespace hw::arcus {

Task<Result<>> Feed::start(intent::FeedMoves request) {
  if (auto may = list_.accepts(request); !may) co_return may;
  auto read = co_await status_.read(Priority::intent);
  if (!read) co_return read;
  if (!list_.buffer_is_on()) {
    auto on = co_await list_.switch_buffer_on();
    if (!on) co_return on;
    auto again = co_await status_.read(Priority::intent);
    if (!again) co_return again;
  }
  list_.begin(std::move(request.rows));
  co_return co_await go_on();
}

Task<Result<>> Feed::go_on() {
  std::function<void()> moves = [this] {
    const bool begins = !console_.snapshot.any_axis_moving();
    for (int axis = 0; axis < 3 && axis < console_.axes(); ++axis)
      motions_.begun(axis, Activity::moving, status_.round_began());
    if (begins) console_.changed();  // the next status round comes only after a few moves
  };
  co_return co_await list_.feed(std::move(moves));
}

}  // namespace hw::arcus
