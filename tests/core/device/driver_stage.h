#pragma once
// A console without its window, in virtual time: pump, driver, link, and an emulated controller at the other
// end. What is sent and told since is kept to be looked at.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/device/pump.h"
#include "core/time/virtual_scheduler.h"
#include "tests/core/device/loopback.h"

namespace hw::test {

class DriverStage : public testing::Test {
 protected:
  /// With `catalog` and `loop` in place; `type` outlives the stage.
  void open(const DeviceType& type) {
    Pump::Callbacks callbacks;
    callbacks.open_wire = [this]() -> Task<Result<std::shared_ptr<Link>>> { return open_wire(); };
    callbacks.publish = [this](const Snapshot& s) { latest = s; };
    callbacks.notify = [this](Notice n) { notices.push_back(std::move(n)); };
    callbacks.traffic = &traffic;
    pump = std::make_unique<Pump>(time, type, catalog, std::move(callbacks));
    pump->start();
    run_until([&] { return latest.link.state != LinkState::connecting; }, 5);
    run(0.3);
  }
  void TearDown() override {
    if (pump && HasFailure()) std::cerr << conversation();
    close();
  }
  /// What is left of the pump's procedures must not outlive it.
  void close() {
    if (!pump) return;
    asio::co_spawn(io, pump->shut_down(), asio::detached);
    run(9);  // a stop that is owed
    pump.reset();
    loop.reset();
  }
  Task<Result<std::shared_ptr<Link>>> open_wire() {
    if (port_missing) co_return fail(FaultKind::port, "There is no port /dev/ttyUSB0.");
    co_return std::make_shared<Link>(time, loop->plug());
  }

  void run(double s) { time.run_for(from_seconds(s)); }
  template <class Done>
  bool run_until(Done done, double at_most = 60) {
    return time.run_until(time.now() + from_seconds(at_most), done);
  }
  bool wait_idle(double at_most = 120) {
    run(0.05);
    const bool done = run_until([&] { return idle(); }, at_most);
    run(0.3);
    return done;
  }
  virtual bool idle() { return !pump->busy() && !latest.any_axis_moving(); }

  IntentId post(IntentBody body) {
    const IntentId id = ++last_id;
    pump->post(Intent(id, std::move(body)));
    return id;
  }
  IntentState outcome(IntentId id) {
    const IntentOutcome* f = pump->known().outcome_of(id);
    return f ? f->state : IntentState::pending;
  }
  /// Sends and waits for its outcome: empty when done, else the sentence.
  std::string perform(IntentBody body, double patience = 60) {
    const IntentId id = post(std::move(body));
    run_until([&] { return outcome(id) != IntentState::pending; }, patience);
    const IntentOutcome* f = pump->known().outcome_of(id);
    if (!f) return "no outcome";
    if (f->state == IntentState::pending) return "still pending";
    return f->state == IntentState::done ? "" : std::string(f->sentence.view());
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

  std::int64_t position(int axis = 0) { return latest.axes[axis].position.value; }
  static AxisTarget target_of(int axis, std::int64_t value) {
    AxisTarget t;
    t.axis = AxisId{static_cast<std::uint8_t>(axis)};
    t.value = Steps{value};
    return t;
  }
  bool reported(std::string_view part) {
    for (const Notice& n : notices)
      if (n.text.find(part) != std::string::npos) return true;
    return false;
  }
  std::string all_notices() {
    std::string all;
    for (const Notice& n : notices) all += n.text + "\n";
    return all;
  }
  /// The end of what went over the wire, for a failed test.
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

  IoContext io;
  VirtualScheduler time{io};
  TrafficRing traffic{1 << 16};
  std::unique_ptr<Loopback> loop;
  Catalog catalog;
  std::vector<Notice> notices;
  Snapshot latest;
  std::unique_ptr<Pump> pump;
  IntentId last_id = 0;
  bool port_missing = false;
};

}  // namespace hw::test
