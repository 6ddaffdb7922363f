#include "core/devices/arcus/live_status.h"

namespace hw::arcus {

Task<> LiveStatus::read() {
  if (!conversation_.is_open() || console_.scheduler.now() - status_.round_began() < period_at_rest)
    co_return;
  auto read = co_await status_.read(Priority::poll);
  if (read) read = co_await threads_.read(false, Priority::poll);
  console_.changed();
}

}  // namespace hw::arcus
