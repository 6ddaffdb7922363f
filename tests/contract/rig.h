#pragma once
// One registered controller as an in-process emulator, opened through the real wire, link, driver and session
// in virtual time. A fifth controller is tested by being listed.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/profile.h"  // says hw::seconds: before any file of the batch uses std::chrono's
#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "tests/contract/lies.h"
#include "transports/open.h"

namespace hw {

inline std::string name_of_type(const testing::TestParamInfo<const DeviceType*>& info) {
  std::string name(info.param->model);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// One that the controller does not use itself, as the factory has set it; -1: there is none.
inline int free_output(const Catalog& catalog) {
  for (std::size_t place = 0; place < catalog.outputs.size(); ++place) {
    const auto& unless = catalog.outputs[place].duty.while_not_zero;
    const bool free = std::none_of(unless.begin(), unless.end(), [&catalog](const std::string& name) {
      const int param = catalog.find_param(name);
      return param >= 0 && catalog.params[static_cast<std::size_t>(param)].fallback != 0;
    });
    if (free) return catalog.output_number(place);
  }
  return -1;
}

class ContractTest : public testing::TestWithParam<const DeviceType*> {
 protected:
  void SetUp() override { open(); }
  void TearDown() override {
    if (session) close();
  }

  /// A session of its own with what stands behind `opener`.
  std::shared_ptr<Session> open_by(const WireOpener& opener, const std::string& keys = {}) {
    auto address = Address::parse(std::string(GetParam()->model) + "@emulator" + keys);
    EXPECT_TRUE(address) << address.error().sentence();
    auto wire = std::make_shared<SharedWire>(time, *address, opener);
    auto opened = Session::open_as(*GetParam(), time, *address, std::move(wire), 0, [this] {
      if (on_wake) on_wake();
    });
    EXPECT_TRUE(opened) << opened.error().sentence();
    return *opened;
  }
  void open(const WireOpener& opener = make_wire_opener(), const std::string& keys = {}) {
    session = open_by(opener, keys);
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, std::chrono::seconds(10)))
        << now().link.sentence.view();
    run(std::chrono::seconds(2));
  }
  void close() {
    asio::co_spawn(io, session->close(), asio::detached);
    run(std::chrono::seconds(2));
    EXPECT_EQ(now().link.state, LinkState::closed);
  }
  /// Another session with the same emulated controller: what it knows it has read.
  void open_afresh() {
    const auto same = session->bench();
    close();
    session.reset();
    open([usual = make_wire_opener(), same](Scheduler& s, Address a, std::shared_ptr<BenchAccess> again) {
      return usual(s, std::move(a), again ? std::move(again) : same);
    });
  }

  void run(Duration d) { time.run_for(d); }
  bool run_until(const std::function<bool()>& done, Duration patience) {
    return time.run_until(time.now() + patience, done);
  }
  [[nodiscard]] const Snapshot& now() const { return session->known(); }
  [[nodiscard]] const AxisState& axis() const { return now().axes[0]; }
  [[nodiscard]] Steps load() const {
    BenchView view;
    session->bench()->look(view);
    return view.load_position[0];
  }
  void operate(BenchCommand command) {
    auto done = session->bench()->operate(command);
    EXPECT_TRUE(done) << done.error().sentence();
  }
  /// What became of it, once that is known.
  IntentOutcome perform(IntentBody body, Duration patience = std::chrono::seconds(10)) {
    const IntentId id = session->send(std::move(body));
    run_until([&] { return now().outcome_of(id) && now().outcome_of(id)->state != IntentState::pending; },
              patience);
    const IntentOutcome* outcome = now().outcome_of(id);
    return outcome ? *outcome : IntentOutcome{};
  }
  [[nodiscard]] bool axes_jog_at_once() const {
    return now().axis_count > 1 && !session->catalog().can.one_axis_at_a_time;
  }
  /// Where the error of a limit keeps moves back until it is cleared.
  void clear_errors() {
    const int action = session->catalog().find_action("clear");
    if (axis().activity != Activity::error || action < 0) return;
    std::vector<std::int64_t> values;
    for (const ActionField& f : session->catalog().actions[static_cast<std::size_t>(action)].fields)
      values.push_back(f.fallback);
    EXPECT_EQ(perform(intent::Act(action, std::move(values))).state, IntentState::done);
    run(std::chrono::seconds(1));
  }
  bool becomes_idle(Duration patience) {
    run(Millis(300));
    return run_until([this] { return !now().any_axis_moving() && now().program.run == RunState::idle; },
                     patience);
  }

  std::function<void()> on_wake;  ///< what the window would do now: draw
  IoContext io;
  VirtualScheduler time{io};
  std::shared_ptr<Session> session;
};

}  // namespace hw
