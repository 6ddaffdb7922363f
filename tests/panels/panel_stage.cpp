#include "tests/panels/panel_stage.h"

#include "core/time/virtual_scheduler.h"
#include "gui/shell/outside.h"

namespace hw::test {

static Task<Result<Wire>> nowhere(Scheduler&, Address, std::shared_ptr<BenchAccess>) {
  co_return fail(FaultKind::port, "There is nothing.");
}

struct EmptyConsole::World {
  IoContext io;
  VirtualScheduler scheduler{io};
  gui::Console console{gui::PanelList{}, gui::Outside(scheduler, nowhere, [] {})};
};

EmptyConsole::EmptyConsole() : world_(std::make_unique<World>()) {}
EmptyConsole::~EmptyConsole() = default;
gui::Console& EmptyConsole::operator*() { return world_->console; }

}  // namespace hw::test
