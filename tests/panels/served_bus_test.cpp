// A bus of emulators that is open in the console and served to another program on the same wire: what the
// other asks is answered to both, and the console must not take it for an answer of its own.
#include <fmt/core.h>
#include <gmock/gmock.h>

#include "core/session/session.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"
#include "transports/open.h"

namespace hw::panels {
namespace {

using namespace gui;

/// Another program on the wire: it asks again as soon as it has heard the end of an answer, or 50 ms after a
/// question that nobody answered.
struct OtherProgram final : Stream::Listener {
  OtherProgram(VirtualScheduler& clock, std::unique_ptr<Stream> end, std::string question)
      : clock(clock), wire(std::move(end)), question(std::move(question)) {
    wire->listen(this);
  }
  ~OtherProgram() override { wire->listen(nullptr); }
  void look() {
    if (clock.now() < next) return;
    received.clear();
    wire->send(question);
    next = clock.now() + Millis(50);
    ++asked;
  }
  void bytes_arrived(std::string_view bytes) override {
    received += bytes;
    if (received.ends_with('\0')) last = received, next = std::min(next, clock.now() + Millis(7));
  }
  void stream_closed(const Fault&) override {}
  VirtualScheduler& clock;
  std::unique_ptr<Stream> wire;
  std::string question, received, last;
  Instant next{};
  int asked = 0;
};

struct Rig {
  IoContext io;
  VirtualScheduler clock{io};
  Console console{panel_list(), Outside{clock, make_wire_opener(), [] {}}};
  std::function<void()> each_frame;
  Stage stage{[this](Ui& ui) {
    const Instant until(from_seconds(stage.now_s));
    while (clock.now() < until) {
      clock.run_until(std::min(until, clock.now() + Millis(1)));
      if (each_frame) each_frame();
    }
    console.draw(ui);
  }};
  explicit Rig(const std::string& address) {
    EXPECT_TRUE(console.open(address));
    run(4);
  }
  ~Rig() {
    console.close_all();
    clock.run_until(clock.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  void run(double seconds) {
    for (int n = static_cast<int>(seconds * 60 + 0.5); n > 0; --n) stage.frame();
  }
  Tab& tab(std::size_t i) { return *console.tabs().at(i); }
};

TEST(ServedBus, TheAnswerToAnotherProgramIsNotTakenForOnesOwn) {
  Rig rig("dmx-k-sa@emulator,id=01-02");
  ASSERT_EQ(rig.console.tabs().size(), 2u);
  rig.tab(1).send(intent::SetPower(0, true));
  rig.run(1);
  rig.tab(1).send(intent::MoveBy({{AxisId{0}, Steps(5000)}}, Pps(5000)));
  rig.run(4);
  ASSERT_EQ(rig.tab(1).now().axes[0].position, Steps(5000));
  const auto host = EmulatorHost::of(rig.tab(0).session()->bench());
  ASSERT_TRUE(host);
  EXPECT_EQ(host->device_count(), 2u) << "of any device on it the wire has all";
  OtherProgram other(rig.clock, *host->plug_in(), "@02PX\r");
  rig.each_frame = [&other] { other.look(); };
  int wrong = 0, lost = 0;
  for (int n = 0; n < 60 * 30; ++n) {
    rig.stage.frame();
    wrong +=
        rig.tab(0).now().axes[0].position != Steps(0) || rig.tab(1).now().axes[0].position != Steps(5000);
    for (std::size_t i : {0u, 1u}) lost += !rig.tab(i).now().link.connected();
  }
  EXPECT_GT(other.asked, 500);
  EXPECT_EQ(other.last, std::string("5000\0", 5));
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace hw::panels
