#pragma once
// A console without its window, and an emulated VXM at the other end.
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/device_type.h"
#include "core/devices/vxm/emulator.h"
#include "tests/core/device/driver_stage.h"

namespace hw::vxm {

using Options = std::map<std::string, std::string>;

class DriverTest : public test::DriverStage {
 protected:
  void start(const Options& options = {}, bool byte_times = false) {
    catalog_options = options;
    loop = std::make_unique<test::Loopback>(time, make_emulator(options).value(), byte_times);
    open();
  }
  void open() {
    Options known;
    if (catalog_options.contains("motors")) known["motors"] = catalog_options["motors"];
    catalog = make_catalog(known).value();
    type = device_type();
    DriverStage::open(type);
  }
  bool idle() override { return DriverStage::idle() && latest.program.run == RunState::idle; }
  std::string unsolicited() {
    std::string all, text;
    while (pump->take_unsolicited(text)) all += (all.empty() ? "" : " ") + text;
    return all;
  }
  static std::vector<AxisTarget> target(int axis, std::int64_t value) { return {target_of(axis, value)}; }
  std::string move_to(int axis, std::int64_t value, double speed = 0) {
    return perform(intent::MoveTo(target(axis, value), Pps{speed}));
  }
  std::string move_by(int axis, std::int64_t value, double speed = 0) {
    return perform(intent::MoveBy(target(axis, value), Pps{speed}));
  }
  std::string send(std::string text) { return perform(intent::SendText(std::move(text))); }
  /// What was sent since the last call, polls left out.
  std::string sent() {
    std::string all;
    traffic.drain([&](const TrafficEntry& e) {
      if (e.way == Way::sent && e.kind != TrafficKind::poll) all += e.bytes;
    });
    return all;
  }

  Options catalog_options;
  DeviceType type{};
};

}  // namespace hw::vxm
