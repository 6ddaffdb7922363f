#include "gui/app/device_search.h"

#include <fmt/core.h>

namespace hw::app {

static Task<> search_and_report(Scheduler& scheduler, DeviceSearch what,
                                std::shared_ptr<DeviceSearcher::Wire> wire, std::function<void()> wake) {
  std::function<bool(const SearchProgress&)> go_on = [wire, wake](const SearchProgress& at) {
    wire->progress.push(at);
    if (wake) wake();
    return wire->go_on.load();
  };
  std::function<void(const PortReport&)> found = [wire](const PortReport& report) {
    wire->found.push(report);
  };
  co_await search_devices(scheduler, std::move(what), std::move(go_on), std::move(found));
  wire->over = true;
  if (wake) wake();
}

void DeviceSearcher::start(const std::string& path, int baud, int first_id, int last_id) {
  cancel();
  DeviceSearch what;
  for (SerialPort& port : list_serial_ports())
    if (path.empty() || port.path == path) what.ports.push_back(std::move(port));
  if (!path.empty() && what.ports.empty()) {
    SerialPort typed;
    typed.path = path;
    what.ports.push_back(std::move(typed));
  }
  if (baud > 0) what.bauds = {baud};
  what.first_id = first_id;
  what.last_id = last_id;
  state_ = {};
  state_.running = true;
  wire_ = std::make_shared<Wire>();
  asio::co_spawn(scheduler_.executor(), search_and_report(scheduler_, std::move(what), wire_, wake_),
                 asio::detached);
}

void DeviceSearcher::cancel() {
  if (!wire_ || !state_.running) return;
  wire_->go_on = false;
  state_.cancelled = true;
}

const gui::DeviceSearchState& DeviceSearcher::state() {
  if (!wire_) return state_;
  const bool over = wire_->over;  // read before the rings, so that everything pushed before the end is taken
  wire_->progress.drain([this](SearchProgress& at) {
    state_.asked = at.asked;
    state_.of = at.of;
    state_.now = fmt::format("{} at {} baud, id {}", at.port, at.baud, at.id);
  });
  wire_->found.drain([this](PortReport& report) {
    state_.found.push_back(
        {report.name.empty() ? report.port.path : report.name, report.address(), report.sentence()});
  });
  if (over) {
    state_.running = false;
    if (!state_.cancelled) state_.asked = state_.of;  // progress was reported before each question
  }
  return state_;
}

}  // namespace hw::app
