#include "core/devices/vxm/knowledge.h"

namespace hw::vxm {

Task<Result<>> Knowledge::catch_up() {
  if (!identification_.is_read()) {
    auto read = co_await identification_.read();
    if (!read) co_return read;
  }
  if (!parameters_.knows_essentials()) {
    auto read = co_await parameters_.read_essentials();
    if (!read) co_return read;
  }
  if (!slots_.knows_sizes()) {
    auto read = co_await slots_.read_sizes();
    if (!read) co_return read;
  }
  co_return co_await parameters_.read_some();
}

void Knowledge::doubt() {
  identification_.forget();
  parameters_.doubt_essentials();
  slots_.doubt_all();
}

void Knowledge::may_be_of_before() {
  identification_.forget();
  parameters_.forget();
  slots_.doubt_all();
}

void Knowledge::forget() {
  identification_.forget();
  parameters_.forget();
  slots_.forget();
}

}  // namespace hw::vxm
