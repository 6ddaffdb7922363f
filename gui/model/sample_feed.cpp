#include "gui/model/sample_feed.h"

#include "core/session/session.h"
#include "gui/model/tab.h"

namespace hw::gui {

StepRecorder::View steps_view(Tab& tab) {
  return {tab.now(), tab.clock(), [&tab](AxisId axis) { return tab.why_not_move(axis); },
          [&tab](IntentBody body) { return tab.send(std::move(body)); }};
}

void drop_samples(Tab& tab) {
  if (tab.session()) tab.session()->samples().drain([](const AxisSample&) {});
}

}  // namespace hw::gui
