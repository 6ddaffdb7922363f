// A whole session of the console over USB: the unmodified libusb, our transport, link, driver, and the
// emulated PMX behind 64-byte transfers.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "tests/transports/ear.h"
#include "tests/usb/emulated_usb.h"
#include "transports/open.h"

namespace hw {
namespace {

using test::EmulatedUsb;
using test::poll_until;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

constexpr AxisId x{0};

class UsbSession : public ::testing::Test {
 protected:
  UsbSession() {
    if (!umockdev_in_mock_environment()) throw std::runtime_error("run this with umockdev-wrapper");
  }
  ~UsbSession() override {
    if (session) test::run_task(io, close(session));
    EXPECT_TRUE(until([this] { return std::none_of(plugs.begin(), plugs.end(), in_use); })) << "the good-bye";
    plugs.clear();
    g_object_unref(bus);
  }
  static Task<bool> close(std::shared_ptr<Session> session) {
    co_await session->close();
    co_return true;
  }

  static std::unique_ptr<Emulator> controller() {
    return find_device_type("pmx-4ex-sa")->make_emulator({{"framing", "usb"}}).value();
  }
  EmulatedUsb& plug_in(std::unique_ptr<Emulator> device) {
    plugs.push_back(std::make_unique<EmulatedUsb>(bus, std::move(device), "4ex00", ++number));
    return plug();
  }
  EmulatedUsb& plug() { return *plugs.back(); }
  static bool in_use(const std::unique_ptr<EmulatedUsb>& device) { return device->in_use(); }
  bool until(const std::function<bool()>& done, Millis patience = Millis(8000)) {
    return poll_until(io, done, patience);
  }
  void open() {
    session = Session::open(clock, *Address::parse("pmx-4ex-sa@usb"), make_wire_opener({}), [] {}).value();
    ASSERT_TRUE(until([&] { return known().link.state == LinkState::good; })) << sentence();
  }
  const Snapshot& known() { return session->known(); }
  const AxisState& axis() { return known().axes[0]; }
  std::string sentence() { return std::string(known().link.sentence.view()); }
  std::string perform(IntentBody body) {
    const auto done = test::run_task(io, session->perform(std::move(body)));
    return done ? "" : done.error().sentence();
  }
  std::string jog() { return perform(intent::JogStart(x, Sign::plus, {}, false)); }
  std::string reported() {
    session->notices().drain([&](Notice& n) { notices += n.text + "\n"; });
    return notices;
  }
  std::ptrdiff_t times_sent(std::string_view command) {
    const auto all = plug().commands();
    return std::count(all.begin(), all.end(), command);
  }

  UMockdevTestbed* bus = umockdev_testbed_new();
  std::vector<std::unique_ptr<EmulatedUsb>> plugs;  // the last one is in now, the others were pulled out
  int number = 3;
  IoContext io{1};
  RealScheduler clock{io};
  std::shared_ptr<Session> session;
  std::string notices;
};

TEST_F(UsbSession, IdentifiesPollsMovesAndStops) {
  EmulatedUsb& device = plug_in(controller());
  open();
  EXPECT_EQ(known().identity.firmware.view(), "V161BL");
  EXPECT_EQ(known().identity.serial.view(), "4EX00");
  EXPECT_EQ(axis().activity, Activity::idle);
  EXPECT_THAT(device.commands(), IsSupersetOf({"ID", "VER", "DN", "MST", "PP", "PE", "PS"}));
  EXPECT_THAT(device.commands(), Not(Contains(StartsWith("@")))) << "no address on USB (decision AMB-004)";

  AxisTarget far;
  far.axis = x, far.value = Steps(100'000);
  EXPECT_EQ(perform(intent::MoveTo({far})), "");
  ASSERT_TRUE(until([&] { return axis().activity == Activity::moving && axis().position > Steps(50); }));
  const Steps there = axis().position;
  ASSERT_TRUE(until([&] { return axis().position > there; })) << "the position stays live";
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(axis().activity, Activity::idle);
  EXPECT_EQ(axis().ended_by, EndedBy::stop);
  EXPECT_LT(axis().position, Steps(100'000));
  EXPECT_EQ(times_sent("X100000"), 1);
  EXPECT_GE(times_sent("STOP"), 1);
  EXPECT_EQ(known().link.timeouts, 0u);
}

TEST_F(UsbSession, PulledOutWhileMovingTheStateIsLostAndReadAfresh) {
  plug_in(controller());
  open();
  ASSERT_EQ(jog(), "");
  ASSERT_TRUE(until([&] { return axis().activity == Activity::jogging && axis().position > Steps(10); }));
  auto pulled = plug().pull_out();
  ASSERT_TRUE(until([&] { return known().link.state == LinkState::lost; }));
  EXPECT_THAT(sentence(), HasSubstr("is gone"));
  EXPECT_FALSE(axis().position_known);
  EXPECT_EQ(axis().activity, Activity::unknown);
  EXPECT_THAT(perform(intent::Stop()), HasSubstr("Stop cannot reach it"));

  EmulatedUsb& again = plug_in(std::move(pulled));  // it has gone on: it has a supply of its own
  ASSERT_TRUE(until([&] { return known().link.state == LinkState::good; })) << sentence();
  EXPECT_TRUE(axis().position_known);
  EXPECT_THAT(again.commands(), Contains("STOP")) << "the stop that is owed";
  EXPECT_THAT(again.commands(), Not(Contains("JX+"))) << "no motion is sent again";
  EXPECT_TRUE(until([&] { return axis().activity == Activity::idle; }));
  EXPECT_TRUE(until([&] { return reported().find("Nothing was sent again") != std::string::npos; }))
      << reported();
}

TEST_F(UsbSession, SwitchedOffMeanwhileItIsReportedAsSuch) {
  plug_in(controller());
  open();
  ASSERT_EQ(jog(), "");
  ASSERT_TRUE(until([&] { return axis().position > Steps(10); }));
  ASSERT_EQ(perform(intent::Stop()), "");
  plug().pull_out();
  ASSERT_TRUE(until([&] { return known().link.state == LinkState::lost; }));
  plug_in(controller());
  ASSERT_TRUE(until([&] { return known().link.state == LinkState::good; })) << sentence();
  EXPECT_THAT(reported(), HasSubstr("switched off and on"));
  EXPECT_TRUE(axis().trust.doubtful());
}

TEST_F(UsbSession, ACutReplyIsNeverTakenForAWholeOne) {
  plug_in(controller());
  open();
  ASSERT_EQ(perform(intent::SetPosition(0, Steps(-12'345))), "");
  ASSERT_TRUE(until([&] { return axis().position == Steps(-12'345); }));
  for (std::size_t bytes = 0; bytes < 8; ++bytes) {
    const auto before = known().link.timeouts;
    plug().cut_next_replies(bytes);
    ASSERT_TRUE(until([&] {
      EXPECT_EQ(axis().position, Steps(-12'345));
      return known().link.timeouts > before;
    }));
    ASSERT_TRUE(until([&] { return known().link.state == LinkState::good; })) << sentence();
  }
  EXPECT_EQ(axis().position, Steps(-12'345));
}

TEST_F(UsbSession, RepliesThatAreCutAreReportedInASentence) {
  plug_in(controller());
  open();
  plug().cut_next_replies(1, 2);  // the question is asked once more
  ASSERT_TRUE(until([&] { return !known().link.sentence.empty(); }));
  EXPECT_THAT(sentence(), HasSubstr("stopped in the middle"));
  ASSERT_TRUE(until([&] { return known().link.state == LinkState::good; })) << sentence();
}

}  // namespace
}  // namespace hw
