#pragma once
// A console without its window, and an emulated PMX or DMX at the other end.
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "core/emulation/emulator.h"
#include "tests/core/device/driver_stage.h"

namespace hw::arcus {

using Options = std::map<std::string, std::string>;

class DriverTest : public test::DriverStage {
 protected:
  void start(std::string_view model, const Options& options = {}, bool byte_times = false) {
    close();
    type = find_device_type(model);
    loop = std::make_unique<test::Loopback>(time, type->make_emulator(options).value(), byte_times);
    catalog = type->make_catalog({}).value();
    open();
  }
  void open() { DriverStage::open(*type); }
  bool idle() override { return DriverStage::idle() && latest.program.run != RunState::running; }
  std::string act(std::string_view id, std::vector<std::int64_t> values) {
    return perform(intent::Act(catalog.find_action(id), std::move(values)));
  }
  static std::vector<AxisTarget> targets(const std::vector<std::int64_t>& values) {
    std::vector<AxisTarget> all;
    for (const std::int64_t value : values) all.push_back(target_of(static_cast<int>(all.size()), value));
    return all;
  }
  std::int64_t param(std::string_view name) {
    return latest.params[static_cast<std::size_t>(catalog.find_param(name))].value;
  }
  std::int64_t readout(std::string_view id) {
    return latest.readouts[static_cast<std::size_t>(catalog.find_readout(id))];
  }
  /// What was sent since the last call, polls left out, without addresses: "ABS X400".
  std::string sent() {
    std::string all;
    traffic.drain([&](const TrafficEntry& e) {
      if (e.way != Way::sent || e.kind == TrafficKind::poll) return;
      std::string text = e.bytes.substr(e.bytes.starts_with('@') ? 3 : 0);
      while (!text.empty() && text.back() == '\r') text.pop_back();
      all += (all.empty() ? "" : " ") + text;
    });
    return all;
  }
  std::string program_text() {
    std::string text;
    for (const Notice& n : notices)
      if (n.kind == Notice::Kind::program) text = n.text;
    return text;
  }

  const DeviceType* type = nullptr;
};

}  // namespace hw::arcus
