#pragma once
// A console without its window: pump, driver, link, and an emulated PMX or DMX at the other end.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/emulator.h"
#include "core/device/pump.h"
#include "core/device/registry.h"
#include "core/time/virtual_scheduler.h"
#include "tests/core/device/loopback.h"

namespace hw::arcus {

using Options = std::map<std::string, std::string>;

class DriverTest : public testing::Test {
 protected:
  void start(std::string_view model, const Options& options = {}, bool byte_times = false) {
    type = find_device_type(model);
    loop = std::make_unique<test::Loopback>(time, type->make_emulator(options).value(), byte_times);
    catalog = type->make_catalog({}).value();
    open();
  }
  void open() {
    Pump::Ways ways;
    ways.open_wire = [this]() -> Task<Result<std::shared_ptr<Link>>> { return open_wire(); };
    ways.publish = [this](const Snapshot& s) { latest = s; };
    ways.notify = [this](Notice n) { notices.push_back(std::move(n)); };
    ways.traffic = &traffic;
    pump = std::make_unique<Pump>(time, *type, catalog, std::move(ways));
    pump->start();
    run_until([&] { return latest.link.state != LinkState::connecting; }, 5);
    run(0.3);
  }
  void TearDown() override {
    if (!pump) return;
    if (HasFailure()) std::cerr << conversation();
    asio::co_spawn(io, pump->shut_down(), asio::detached);
    run(2);
    pump.reset();
    loop.reset();
  }
  Task<Result<std::shared_ptr<Link>>> open_wire() { co_return std::make_shared<Link>(time, loop->plug()); }

  void run(double s) { time.run_for(from_seconds(s)); }
  template <class Done>
  bool run_until(Done done, double at_most = 60) {
    return time.run_until(time.now() + from_seconds(at_most), done);
  }
  /// Sends and waits for its fate: empty when done, else the sentence.
  std::string perform(IntentBody body, double patience = 60) {
    const IntentId id = post(std::move(body));
    run_until([&] { return fate(id) != Fate::pending; }, patience);
    const IntentFate* f = pump->known().fate_of(id);
    if (!f) return "no fate";
    if (f->fate == Fate::pending) return "still pending";
    return f->fate == Fate::done ? "" : std::string(f->sentence.view());
  }
  IntentId post(IntentBody body) {
    const IntentId id = ++last_id;
    pump->post(Intent(id, std::move(body)));
    return id;
  }
  Fate fate(IntentId id) {
    const IntentFate* f = pump->known().fate_of(id);
    return f ? f->fate : Fate::pending;
  }
  /// As a hand on a jog does, each for a tenth of a second.
  void hold(int times) {
    for (; times > 0; --times) {
      run(0.1);
      pump->post(Intent(0, intent::JogKeepAlive()));
    }
  }
  std::string query(std::string text, double patience = 1) {
    std::string answer;
    bool came = false;
    asio::co_spawn(io, ask(*pump, std::move(text), from_seconds(patience), answer, came), asio::detached);
    run_until([&] { return came; }, patience + 5);
    return answer;
  }
  static Task<> ask(Pump& pump, std::string text, Duration patience, std::string& answer, bool& came) {
    auto reply = co_await pump.query(std::move(text), patience);
    answer = reply ? *reply : "fault: " + reply.error().sentence();
    came = true;
  }
  bool wait_idle(double at_most = 120) {
    run(0.05);
    const bool done = run_until(
        [&] { return !pump->busy() && !latest.any_axis_moving() && latest.program.run != RunState::running; },
        at_most);
    run(0.3);
    return done;
  }
  std::string act(std::string_view id, std::vector<std::int64_t> values) {
    return perform(intent::Act(catalog.find_action(id), std::move(values)));
  }
  std::int64_t position(int axis = 0) { return latest.axes[axis].position.value; }
  static std::vector<AxisTarget> targets(std::vector<std::int64_t> values) {
    std::vector<AxisTarget> all;
    for (std::size_t i = 0; i < values.size(); ++i) {
      AxisTarget t;
      t.axis = AxisId{static_cast<std::uint8_t>(i)};
      t.value = Steps{values[i]};
      all.push_back(t);
    }
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
  std::string conversation() {
    std::vector<std::string> lines;
    traffic.drain([&](const TrafficEntry& e) {
      std::string bytes;
      for (const char c : e.bytes)
        bytes +=
            c >= ' ' && c < 127 ? std::string(1, c) : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
      lines.push_back(fmt::format("{:10.4f} {} {} {}\n", seconds(e.at), static_cast<int>(e.kind),
                                  e.way == Way::sent ? "->" : "  <-", bytes));
    });
    std::string all;
    for (std::size_t i = lines.size() > 80 ? lines.size() - 80 : 0; i < lines.size(); ++i) all += lines[i];
    return all + all_notices() + std::string(latest.link.sentence.view()) + "\n";
  }
  bool told(std::string_view part) {
    for (const Notice& n : notices)
      if (n.text.find(part) != std::string::npos) return true;
    return false;
  }
  std::string all_notices() {
    std::string all;
    for (const Notice& n : notices) all += n.text + "\n";
    return all;
  }
  std::string program_text() {
    std::string text;
    for (const Notice& n : notices)
      if (n.kind == Notice::Kind::program) text = n.text;
    return text;
  }

  IoContext io;
  VirtualScheduler time{io};
  TrafficRing traffic{1 << 16};
  std::unique_ptr<test::Loopback> loop;
  const DeviceType* type = nullptr;
  Catalog catalog;
  std::vector<Notice> notices;
  Snapshot latest;
  std::unique_ptr<Pump> pump;
  IntentId last_id = 0;
};

}  // namespace hw::arcus
