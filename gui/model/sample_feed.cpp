#include "gui/model/sample_feed.h"

#include "core/session/session.h"
#include "gui/model/tab.h"

namespace hw::gui {

void take_samples(Tab& tab, const std::function<void(const AxisSample&)>& take) {
  if (tab.session()) tab.session()->samples().drain(take);
}

}  // namespace hw::gui
