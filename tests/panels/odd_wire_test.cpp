// The link doctor on wires that are odd: real drivers and emulators, and between them an echo, a second
// device with the same address, a wrong rate. Each is named by its own cause.
#include <fmt/core.h>
#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"
#include "transports/serve.h"

namespace hw::panels {
namespace {

using testing::HasSubstr;
using testing::Not;

enum class Oddity : std::uint8_t { echo, two_answers, none };

/// A wire that returns what is sent, or on which a second device gives the same answer a little later.
class OddStream final : public Stream, private Stream::Listener {
 public:
  OddStream(Scheduler& scheduler, std::unique_ptr<Stream> inner, Oddity oddity)
      : inner_(std::move(inner)),
        oddity_(oddity),
        clock_(scheduler),
        timer_(scheduler, [this] { arrive(); }) {}
  void listen(Stream::Listener* listener) override {
    listener_ = listener;
    inner_->listen(listener ? this : nullptr);
  }
  void send(std::string_view bytes) override {
    if (oddity_ == Oddity::echo) late(bytes);
    inner_->send(bytes);
  }
  void discard_unsent() override { inner_->discard_unsent(); }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void late(std::string_view bytes) {
    waiting_ += bytes;
    timer_.arm(clock_.now() + Millis(1));
  }
  void arrive() {
    const std::string bytes = std::exchange(waiting_, {});
    if (listener_) listener_->bytes_arrived(bytes);
  }
  void bytes_arrived(std::string_view bytes) override {
    if (oddity_ == Oddity::two_answers) late(bytes);
    if (listener_) listener_->bytes_arrived(bytes);
  }
  void stream_closed(const Fault& why) override {
    if (listener_) listener_->stream_closed(why);
  }
  std::unique_ptr<Stream> inner_;
  Oddity oddity_;
  Stream::Listener* listener_ = nullptr;
  std::string waiting_;
  Scheduler& clock_;
  Timer timer_;
};

Task<Result<Wire>> plug_into(Scheduler& scheduler, std::shared_ptr<EmulatorHost> host, Address address,
                             Oddity oddity) {
  auto stream = host->plug_in(address.number("baud", 0).value_or(0));
  if (!stream) co_return fail(stream.error());
  Wire wire;
  wire.stream = std::make_unique<OddStream>(scheduler, std::move(*stream), oddity);
  co_return wire;
}

struct OddDesk {
  OddDesk(const char* model, Oddity oddity, const std::string& rest = "baud=9600")
      : host(make_host(model)),
        console(panel_list(), {clock,
                               [host = host, oddity](Scheduler& scheduler, Address address,
                                                     const std::shared_ptr<BenchAccess>&) {
                                 return plug_into(scheduler, host, std::move(address), oddity);
                               },
                               [] {}}) {
    EXPECT_TRUE(console.open(fmt::format("{}@serial:/dev/ttyS9,{}", model, rest)));
    run(20);
    console.show_page("connect");
    run(0.5);
    EXPECT_TRUE(stage.hand.click("connect/here/0/doctor"));
    run(2);
  }
  ~OddDesk() {
    console.close_all();
    clock.run_until(clock.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  std::shared_ptr<EmulatorHost> make_host(const char* model) {
    HostOptions options;
    options.byte_times = true;
    return *EmulatorHost::make(clock, *find_device_type(model)->make_emulator({}), options);
  }
  void run(double seconds) {
    for (double t = 0; t < seconds; t += 0.05) {
      stage.now_s += 0.05 - 1.0 / 60;
      stage.frame();
    }
  }
  std::string findings() {
    std::string all;
    for (int i = 1; stage.find(fmt::format("connect/doctor/finding/{}", i)); ++i)
      all += stage.hand.value(fmt::format("connect/doctor/finding/{}", i)).value_or("") + "\n";
    return all;
  }

  IoContext io;
  VirtualScheduler clock{io};
  std::shared_ptr<EmulatorHost> host;
  gui::Console console;
  gui::Stage stage{[this](gui::Ui& ui) {
    clock.run_until(Instant(from_seconds(stage.now_s)));
    console.draw(ui);
  }};
};

class OddWire : public testing::TestWithParam<const char*> {};

TEST_P(OddWire, AnEchoIsCalledAnEcho) {
  OddDesk d(GetParam(), Oddity::echo);
  EXPECT_THAT(d.findings(), HasSubstr("The console receives its own bytes"));
  EXPECT_THAT(d.findings(), Not(HasSubstr("Two replies came to one query")));
  EXPECT_THAT(d.findings(), Not(HasSubstr("another rate")));
}

class SharedOddWire : public OddWire {};

TEST_P(SharedOddWire, ASecondDeviceIsCalledASecondDevice) {
  OddDesk d(GetParam(), Oddity::two_answers);
  // Byte between byte, two answers of a VXM make no sense: then it is the second of two reasons.
  EXPECT_THAT(d.findings(), testing::AnyOf(HasSubstr("Two replies came to one query"),
                                           HasSubstr("two controllers may answer at once")));
  EXPECT_THAT(d.findings(), Not(HasSubstr("receives its own bytes")));
}

TEST_P(OddWire, AWrongRateIsCalledAWrongRateAndItsAddressCanBeChangedThere) {
  OddDesk d(GetParam(), Oddity::none, "baud=38400");
  // One that listens to its address says nothing at all to what it cannot read.
  EXPECT_THAT(d.findings(), testing::AnyOf(HasSubstr("Enter the rate that the controller is set to"),
                                           HasSubstr("here, which must match its setting")));
  MUST(d.stage.hand.type("connect/doctor/address",
                         fmt::format("{}@serial:/dev/ttyS9,baud=9600\n", GetParam())));
  d.run(8);
  ASSERT_EQ(d.console.tabs().size(), 1u);
  EXPECT_TRUE(d.console.tabs().front()->now().link.connected());
}

TEST_P(OddWire, AGoodOneIsCalledGood) {
  OddDesk d(GetParam(), Oddity::none);
  EXPECT_THAT(d.findings(), HasSubstr("No echo, no second reply, no wrong bytes"));
}

INSTANTIATE_TEST_SUITE_P(Lines, SharedOddWire, testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa"));
INSTANTIATE_TEST_SUITE_P(Lines, OddWire, testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa"));

}  // namespace
}  // namespace hw::panels
