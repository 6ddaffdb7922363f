#pragma once
// A VME58 session in virtual time: real driver, link and window onto the emulated board.
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/emulation/bus_target.h"
#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "transports/serve.h"

namespace hw::test {

using Seconds = std::chrono::seconds;  // hw::seconds() is the other way round

/// A bus that takes its time for each burst.
class SlowBus final : public Window {
 public:
  SlowBus(Scheduler& time, std::unique_ptr<Window> window) : time_(time), window_(std::move(window)) {}
  void listen(Listener* listener) override { window_->listen(listener); }
  [[nodiscard]] std::string describe() const override { return window_->describe(); }
  Task<Result<>> run(std::span<BusCycle> cycles) override {
    co_await time_.sleep_for(std::chrono::microseconds(130));
    auto done = co_await window_->run(cycles);
    co_await time_.sleep_for(std::chrono::microseconds(120));
    co_return done;
  }

 private:
  Scheduler& time_;
  std::unique_ptr<Window> window_;
};

class Vme58Rig : public testing::Test {
 protected:
  Vme58Rig() : Vme58Rig(DeviceOptions{}) {}
  explicit Vme58Rig(DeviceOptions o) : options(std::move(o)) {}
  void SetUp() override {
    open();
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, std::chrono::seconds(10)))
        << now().link.sentence.view();
    run(Millis(500));
  }
  void open() {
    std::string text = "vme58@emulator";
    for (const auto& [key, value] : options) text += "," + key + "=" + value;
    const auto address = Address::parse(text);
    ASSERT_TRUE(address) << address.error().sentence();
    auto emulator = find_device_type("vme58")->make_emulator(board_is.value_or(options));
    ASSERT_TRUE(emulator) << emulator.error().sentence();
    HostOptions host_options;
    host_options.name = "VME58";
    host = *EmulatorHost::make(time, std::move(*emulator), std::move(host_options));
    auto opened = Session::open(
        time, *address, [this](Scheduler&, Address, std::shared_ptr<BenchAccess>) { return plug_in(); },
        [] {});
    ASSERT_TRUE(opened) << opened.error().sentence();
    session = *opened;
  }
  void TearDown() override {
    if (!session) return;
    asio::co_spawn(io, session->close(), asio::detached);
    run(std::chrono::seconds(2));
  }
  /// A bus between driver and board that is not as quick as a test.
  virtual std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) { return window; }
  Task<Result<Wire>> plug_in() {
    co_await time.sleep_for(opening_takes);
    auto window = host->plug_in_window();
    if (!window) co_return fail(window.error());
    Wire wire;
    wire.window = dressed(std::move(*window));
    wire.benches.push_back(host->bench());
    co_return wire;
  }

  void run(Duration d) { time.run_for(d); }
  bool run_until(const std::function<bool()>& done, Duration patience) {
    return time.run_until(time.now() + patience, done);
  }
  [[nodiscard]] const Snapshot& now() const { return session->known(); }
  [[nodiscard]] const AxisState& axis(int i = 0) const { return now().axes[static_cast<std::size_t>(i)]; }
  /// The board itself, past the console.
  std::uint32_t peek(std::uint8_t bytes, std::uint16_t offset) {
    auto& emulator = const_cast<Emulator&>(host->bench()->emulator());
    return bus_cycle(*emulator.bus(), false, bytes, offset);
  }
  void poke(std::uint8_t bytes, std::uint16_t offset, std::uint32_t value) {
    auto& emulator = const_cast<Emulator&>(host->bench()->emulator());
    bus_cycle(*emulator.bus(), true, bytes, offset, value);
  }
  void operate(BenchCommand command) {
    auto done = host->bench()->operate(command);
    EXPECT_TRUE(done) << done.error().sentence();
  }
  IntentOutcome perform(IntentBody body, Duration patience = std::chrono::seconds(10)) {
    const IntentId id = session->send(std::move(body));
    run_until([&] { return now().outcome_of(id) && now().outcome_of(id)->state != IntentState::pending; },
              patience);
    const IntentOutcome* outcome = now().outcome_of(id);
    return outcome ? *outcome : IntentOutcome{};
  }
  static Task<> ask_and_keep(std::shared_ptr<Session> s, std::string text, Result<std::string>& reply,
                             bool& came) {
    reply = co_await s->pump().query(std::move(text), Millis(500));
    came = true;
  }
  Result<std::string> query(std::string text) {
    Result<std::string> reply{std::string()};
    bool came = false;
    asio::co_spawn(io, ask_and_keep(session, std::move(text), reply, came), asio::detached);
    run_until([&] { return came; }, std::chrono::seconds(5));
    EXPECT_TRUE(came);
    return reply;
  }
  bool becomes_idle(Duration patience = std::chrono::seconds(60)) {
    run(Millis(300));
    return run_until([this] { return !now().any_axis_moving() && now().program.run != RunState::running; },
                     patience);
  }
  std::string reported() {
    std::string all;
    session->notices().drain([&](const Notice& n) { all += n.text + "\n"; });
    return all;
  }
  /// The text lines of the wire, polls left out.
  std::vector<std::string> lines() {
    std::vector<std::string> all;
    session->traffic().drain([&](const TrafficEntry& e) {
      if (e.kind != TrafficKind::poll) all.push_back((e.way == Way::sent ? "> " : "< ") + e.bytes);
    });
    return all;
  }

  Duration opening_takes{};
  DeviceOptions options;
  std::optional<DeviceOptions> board_is;  ///< of the board, where it is another than the address says
  IoContext io;
  VirtualScheduler time{io};
  std::shared_ptr<EmulatorHost> host;
  std::shared_ptr<Session> session;
};

}  // namespace hw::test
