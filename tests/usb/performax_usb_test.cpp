#include "transports/performax_usb.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/transports/ear.h"
#include "tests/usb/emulated_usb.h"

namespace hw {
namespace {

using test::Ear;
using test::EmulatedUsb;
using test::poll_until;
using testing::ElementsAre;
using testing::HasSubstr;

/// Answers each command with itself, "E" with an empty reply, "Q" with nothing.
class Parrot final : public Emulator {
 public:
  void receive(std::string_view bytes) override {
    std::string text(bytes.substr(0, bytes.find('\0')));
    if (text == "Q") return;
    if (text == "E") text.clear();
    text.resize(64, '\0');
    output_ += text;
  }
  void take_output(std::string& sink) override { sink += std::exchange(output_, {}); }
  std::optional<Instant> next_event() const override { return std::nullopt; }
  void advance_to(Instant) override {}
  Result<> operate(const BenchCommand&) override { return {}; }
  void look(BenchView&) const override {}
  const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  int rate() const override { return 0; }
  std::string save_memory() const override { return {}; }
  Result<> load_memory(std::string_view) override { return {}; }
  std::uint64_t memory_version() const override { return 0; }
  std::unique_ptr<Emulator> clone() const override { return std::make_unique<Parrot>(*this); }

 private:
  std::string output_;
  std::vector<TriggerPulse> pulses_;
};

class PerformaxUsb : public ::testing::Test {
 protected:
  PerformaxUsb() {
    if (!umockdev_in_mock_environment()) throw std::runtime_error("run this with umockdev-wrapper");
  }
  ~PerformaxUsb() override {
    stream.reset();
    EXPECT_TRUE(poll_until(
        io, [this] { return std::none_of(devices.begin(), devices.end(), in_use); }, Millis(10'000)))
        << "the good-bye";
    devices.clear();
    g_object_unref(bus);
  }
  EmulatedUsb& plug_in(const std::string& serial) {
    devices.push_back(std::make_unique<EmulatedUsb>(bus, std::make_unique<Parrot>(), serial, ++number));
    return *devices.back();
  }
  static bool in_use(const std::unique_ptr<EmulatedUsb>& device) { return device->in_use(); }
  Result<std::unique_ptr<Stream>> open(const std::string& serial = {}) {
    return test::run_task(io, open_performax_usb(clock, serial));
  }
  void open_good() {
    auto opened = open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    stream = std::move(*opened);
    stream->listen(&ear);
  }
  /// What came, with a bar for each closing zero.
  std::string reported() {
    std::string text = ear.received;
    std::replace(text.begin(), text.end(), '\0', '|');
    return text;
  }
  bool received(const std::string& text) {
    return poll_until(io, [&] { return reported() == text; });
  }

  UMockdevTestbed* bus = umockdev_testbed_new();
  std::vector<std::unique_ptr<EmulatedUsb>> devices;
  int number = 3;
  IoContext io{1};
  RealScheduler clock{io};
  Ear ear;
  std::unique_ptr<Stream> stream;
};

TEST_F(PerformaxUsb, OpensFlushesTalksAndCloses) {
  EmulatedUsb& device = plug_in("4ex00");
  open_good();
  EXPECT_THAT(device.controls(), ElementsAre(2, 1));
  EXPECT_TRUE(stream->carries_messages());
  EXPECT_EQ(stream->describe(), "USB 4ex00");
  stream->send("PP");
  ASSERT_TRUE(received("PP|"));
  stream->send("MST");
  stream->send("ID");
  ASSERT_TRUE(received("PP|MST|ID|")) << reported();
  EXPECT_THAT(device.commands(), ElementsAre("PP", "MST", "ID"));
  stream.reset();
  ASSERT_TRUE(poll_until(io, [&] { return device.controls().size() == 3; }));
  EXPECT_EQ(device.controls().back(), 4);
  open_good();
  stream->send("again");
  EXPECT_TRUE(received("PP|MST|ID|again|"));
}

TEST_F(PerformaxUsb, ALeftoverReplyIsNoAnswer) {
  EmulatedUsb& device = plug_in("4ex00");
  device.leave_reply("old");
  open_good();
  stream->send("new");
  EXPECT_TRUE(received("new|")) << reported();
}

TEST_F(PerformaxUsb, HalfAReplyHasNoClosingZero) {
  EmulatedUsb& device = plug_in("4ex00");
  open_good();
  device.cut_next_replies(3);
  stream->send("-12345");
  ASSERT_TRUE(received("-12")) << reported();
  stream->send("ok");
  EXPECT_TRUE(received("-12ok|")) << reported();
}

TEST_F(PerformaxUsb, AnEmptyReplyIsOne) {
  plug_in("4ex00");
  open_good();
  stream->send("E");
  EXPECT_TRUE(received("|"));
}

TEST_F(PerformaxUsb, ReportsWhenItIsPulledOut) {
  EmulatedUsb& device = plug_in("4ex00");
  open_good();
  device.unplug();
  ASSERT_TRUE(poll_until(io, [&] { return ear.closed.has_value(); }));
  EXPECT_THAT(ear.closed->sentence(), HasSubstr("USB 4ex00 is gone"));
  stream.reset();
  EXPECT_THAT(open().error().sentence(), HasSubstr("No Performax controller is connected"));
  plug_in("4ex00");
  open_good();
  stream->send("PP");
  EXPECT_TRUE(received("PP|"));
}

TEST_F(PerformaxUsb, OneOfSeveralIsNamed) {
  plug_in("4ex00");
  EmulatedUsb& second = plug_in("4ex01");
  EXPECT_THAT(open().error().sentence(), HasSubstr("4ex00, 4ex01"));
  EXPECT_THAT(open("4ex07").error().sentence(), HasSubstr("named 4ex07"));
  auto opened = open("4EX01");
  ASSERT_TRUE(opened) << opened.error().sentence();
  stream = std::move(*opened);
  stream->listen(&ear);
  stream->send("here");
  EXPECT_TRUE(received("here|"));
  EXPECT_THAT(second.commands(), ElementsAre("here"));
}

TEST_F(PerformaxUsb, ThePortListShowsNewOnes) {
  int changed = 0;
  auto watch = PerformaxWatch::start(clock, [&] { ++changed; });
  ASSERT_TRUE(watch) << watch.error().sentence();
  ASSERT_TRUE(poll_until(io, [&] { return changed == 1; })) << "what was plugged in before is looked at too";
  EXPECT_TRUE(list_performax().empty());
  changed = 0;
  EmulatedUsb& device = plug_in("4ex00");
  ASSERT_TRUE(poll_until(
      io, [&] { return changed > 0 && !list_performax().empty(); }, Millis(10'000)));
  const auto there = list_performax();
  ASSERT_EQ(there.size(), 1u);
  EXPECT_EQ(there.front().serial, "4ex00");
  EXPECT_EQ(there.front().product, "Performax USB");
  changed = 0;
  device.unplug();
  ASSERT_TRUE(poll_until(
      io, [&] { return changed > 0 && list_performax().empty(); }, Millis(10'000)));
  EXPECT_TRUE(list_performax().empty());
}

}  // namespace
}  // namespace hw
