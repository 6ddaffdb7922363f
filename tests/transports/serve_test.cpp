#include "transports/serve.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/transports/ear.h"
#include "tests/transports/toy_emulator.h"
#include "transports/memory.h"

namespace hw {
namespace {

using test::Ear;
using test::ToyEmulator;

class Serve : public ::testing::Test {
 protected:
  std::shared_ptr<EmulatorHost> make(HostOptions options = {}) {
    auto made = EmulatorHost::make(clock, std::make_unique<ToyEmulator>(), std::move(options),
                                   [this](const Fault& fault) { troubles.push_back(fault); });
    if (!made) throw std::runtime_error(made.error().sentence());
    return *made;
  }
  std::shared_ptr<EmulatorHost> make_paced(double speed = 1) {
    HostOptions options;
    options.byte_times = true;
    options.speed = speed;
    return make(options);
  }
  // Asks as a link does: the next question follows the end of the reply. Returns the time they take.
  Duration ask_in_turn(Stream& stream, std::vector<std::pair<std::string, std::size_t>> questions) {
    Ear ear(stream);
    const Instant began = clock.now();
    for (const auto& [question, reply_size] : questions) {
      const std::size_t enough = ear.received.size() + reply_size;
      stream.send(question);
      EXPECT_TRUE(clock.run_until(clock.now() + Millis(500), [&] { return ear.received.size() >= enough; }))
          << question;
    }
    stream.listen(nullptr);
    return clock.now() - began;
  }
  static const ToyEmulator& toy(EmulatorHost& host) {
    return static_cast<const ToyEmulator&>(host.bench()->emulator());
  }

  IoContext io{1};
  VirtualScheduler clock{io};
  std::vector<Fault> troubles;
};

TEST_F(Serve, AnswersAtOnceWithoutByteTimes) {
  auto host = make();
  auto stream = *host->plug_in();
  EXPECT_EQ(ask_in_turn(*stream, {{"X", 9}, {"Y", 9}, {"V", 1}}), Duration{});
  EXPECT_EQ(stream->rate(), 0);
}

TEST_F(Serve, SpendsTheByteTimesAt9600) {
  auto host = make_paced();
  auto stream = *host->plug_in();
  EXPECT_EQ(stream->rate(), 9600);
  EXPECT_NEAR(seconds(ask_in_turn(*stream, {{"X", 9}, {"Y", 9}, {"V", 1}})), 22.9e-3, 22.9e-3 * 0.02);
}

TEST_F(Serve, SpendsTheByteTimesAt38400) {
  auto host = make_paced();
  auto stream = *host->plug_in();
  ask_in_turn(*stream, {{"4V", 0}});
  clock.run_for(Millis(10));
  ASSERT_TRUE(stream->set_rate(38400));
  EXPECT_NEAR(seconds(ask_in_turn(*stream, {{"X", 9}, {"Y", 9}, {"V", 1}})), 5.7e-3, 5.7e-3 * 0.02);
}

TEST_F(Serve, BytesLeaveOnePerByteTime) {
  auto host = make_paced();
  auto stream = *host->plug_in();
  Ear ear(*stream, &clock);
  stream->send("X");
  clock.run_for(Millis(20));
  ASSERT_EQ(ear.received, "+0000400\r");
  for (std::size_t i = 0; i < ear.times.size(); ++i)
    EXPECT_NEAR(seconds(ear.times[i]), static_cast<double>(i + 2) * 10 / 9600, 1e-7);
}

TEST_F(Serve, AReceivedByteActsWhenItsLastBitIsIn) {
  auto host = make_paced();
  auto stream = *host->plug_in();
  stream->send("XX");
  clock.run_for(std::chrono::microseconds(1041));
  EXPECT_EQ(toy(*host).received(), "");
  clock.run_for(std::chrono::microseconds(1));
  EXPECT_EQ(toy(*host).received(), "X");
}

TEST_F(Serve, UnsolicitedBytesComeAtTheirTime) {
  auto host = make();
  auto stream = *host->plug_in();
  Ear ear(*stream, &clock);
  stream->send("M");
  clock.run_for(Millis(200));
  ASSERT_EQ(ear.received, "^");
  EXPECT_EQ(ear.times[0], Instant(Millis(100)));
}

TEST_F(Serve, SpeedScalesTheControllersTime) {
  HostOptions options;
  options.speed = 3;
  auto host = make(options);
  auto stream = *host->plug_in();
  Ear ear(*stream, &clock);
  stream->send("M");
  clock.run_for(Millis(200));
  ASSERT_EQ(ear.received, "^");
  EXPECT_NEAR(seconds(ear.times[0]), 0.1 / 3, 1e-8);
}

TEST_F(Serve, AWrongRateGarblesBothWays) {
  auto host = make_paced();
  auto stream = *host->plug_in(38400);
  Ear ear(*stream);
  stream->send("X");
  clock.run_for(Millis(50));
  EXPECT_FALSE(toy(*host).received().empty());
  EXPECT_EQ(toy(*host).received().find('X'), std::string::npos);
  EXPECT_EQ(ear.received, "");  // it did not understand

  ASSERT_TRUE(stream->set_rate(9600));
  stream->send("M");
  clock.run_for(Millis(50));
  ASSERT_TRUE(stream->set_rate(38400));
  clock.run_for(Millis(100));
  EXPECT_FALSE(ear.received.empty());
  EXPECT_EQ(ear.received.find('^'), std::string::npos);
}

TEST_F(Serve, WithoutByteTimesRatesDoNotMatter) {
  auto host = make();
  auto stream = *host->plug_in(38400);
  Ear ear(*stream);
  stream->send("V");
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "R");
}

TEST_F(Serve, EachClientSeesEachReply) {
  auto host = make();
  auto [near_a, far_a] = make_memory_pair(clock);
  auto [near_b, far_b] = make_memory_pair(clock);
  host->attach(std::move(far_a));
  host->attach(std::move(far_b));
  Ear a(*near_a), b(*near_b);
  near_a->send("V");
  clock.run_for(Millis(1));
  EXPECT_EQ(a.received, "R");
  EXPECT_EQ(b.received, "R");
  near_a.reset();
  clock.run_for(Millis(1));
  near_b->send("X");
  clock.run_for(Millis(1));
  EXPECT_EQ(b.received, "R+0000400\r");
}

TEST_F(Serve, GarbleFlipsAsManyBytesAsAsked) {
  auto host = make();
  auto stream = *host->plug_in();
  Ear ear(*stream);
  ASSERT_TRUE(host->bench()->operate(bench::Garble(2)));
  stream->send("X");
  clock.run_for(Millis(1));
  ASSERT_EQ(ear.received.size(), 9u);
  EXPECT_NE(ear.received[0], '+');
  EXPECT_NE(ear.received[1], '0');
  EXPECT_EQ(ear.received.substr(2), "000400\r");
}

TEST_F(Serve, DropLosesAsManyBytesAsAsked) {
  auto host = make();
  auto stream = *host->plug_in();
  Ear ear(*stream);
  ASSERT_TRUE(host->bench()->operate(bench::Drop(3)));
  stream->send("V");
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "");
  stream->send("X");
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "000400\r") << "one byte of V, two of X";
}

TEST_F(Serve, APulledCableClosesAndTheSameControllerComesBack) {
  auto host = make();
  auto stream = *host->plug_in();
  Ear ear(*stream);
  stream->send("4");
  clock.run_for(Millis(1));
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(true)));
  clock.run_for(Millis(1));
  ASSERT_TRUE(ear.closed);
  EXPECT_EQ(ear.closed->kind, FaultKind::lost);
  EXPECT_NE(ear.closed->what.find("pulled"), std::string::npos);
  stream->send("X");
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "");

  const auto refused = host->plug_in();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("Plug it in again"), std::string::npos);

  ASSERT_TRUE(host->bench()->operate(bench::Unplug(false)));
  auto second = host->plug_in();
  ASSERT_TRUE(second);
  EXPECT_EQ(toy(*host).rate(), 38400) << "it is the same one";
}

TEST_F(Serve, AMoveGoesOnWhileTheCableIsOff) {
  auto host = make();
  auto stream = *host->plug_in();
  stream->send("M");
  clock.run_for(Millis(1));
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(true)));
  clock.run_for(Millis(200));
  BenchView view;
  host->bench()->look(view);
  EXPECT_TRUE(view.present);
  EXPECT_TRUE(view.unplugged);
  EXPECT_EQ(view.lamps, 0u);
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(false)));
  auto second = *host->plug_in();
  Ear ear(*second);
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "") << "the prompt was lost on the way";
}

TEST_F(Serve, ServedClientsStayConnectedWhileTheCableIsOff) {
  auto host = make();
  auto [near, far] = make_memory_pair(clock);
  host->attach(std::move(far));
  Ear ear(*near);
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(true)));
  near->send("V");
  clock.run_for(Millis(1));
  EXPECT_FALSE(ear.closed);
  EXPECT_EQ(ear.received, "");
  ASSERT_TRUE(host->bench()->operate(bench::Unplug(false)));
  near->send("V");
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "R");
}

TEST_F(Serve, NotifiesOnlyWhenTheBenchLooksDifferent) {
  auto host = make();
  auto stream = *host->plug_in();
  int reported = 0;
  host->bench()->changed = [&] { ++reported; };
  stream->send("V");
  clock.run_for(Millis(1));
  const int at_rest = reported;
  stream->send("VVV");
  clock.run_for(Millis(1));
  EXPECT_EQ(reported, at_rest);
  stream->send("M");
  clock.run_for(Millis(1));
  EXPECT_EQ(reported, at_rest + 1);
  clock.run_for(Millis(200));
  EXPECT_EQ(reported, at_rest + 2);
}

TEST_F(Serve, DeviceFaultsGoToTheDevice) {
  auto host = make();
  EXPECT_TRUE(host->bench()->operate(bench::Power(false)));
  EXPECT_FALSE(host->bench()->operate(bench::Input(1, true)));
  BenchView view;
  host->bench()->look(view);
  EXPECT_FALSE(view.powered);
}

TEST_F(Serve, MayBeDestroyedFromInsideItsOwnNews) {
  auto host = make();
  auto stream = *host->plug_in();
  host->bench()->changed = [&] { host.reset(); };
  stream->send("M");
  Ear ear(*stream);
  clock.run_for(Millis(200));
  EXPECT_FALSE(host);
  EXPECT_TRUE(ear.closed);
}

TEST_F(Serve, ABenchFileActsAtTheStartAndLater) {
  auto host = make();
  BenchFile file;
  file.at_start.emplace_back(bench::Drop(1));
  file.later.push_back({Millis(50), bench::Unplug(true)});
  file.later.push_back({Millis(80), bench::Unplug(false)});
  ASSERT_TRUE(host->set_up(file));
  auto stream = *host->plug_in();
  Ear ear(*stream);
  stream->send("X");
  clock.run_for(Millis(49));
  EXPECT_EQ(ear.received, "0000400\r");
  EXPECT_FALSE(ear.closed);
  clock.run_for(Millis(1));
  EXPECT_TRUE(ear.closed);
  EXPECT_FALSE(host->plug_in());
  clock.run_for(Millis(30));
  EXPECT_TRUE(host->plug_in());
}

TEST_F(Serve, ABenchFileThatAsksForWhatIsNotThereIsRefused) {
  auto host = make();
  BenchFile file;
  file.at_start.emplace_back(bench::Input(1, true));
  EXPECT_FALSE(host->set_up(file));
}

// ---- state file ----

class ServeState : public Serve {
 protected:
  ServeState() {
    folder = std::filesystem::temp_directory_path() / ("hw-state-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    options.state_file = folder / "memory";
  }
  ~ServeState() override {
    ::chmod(folder.c_str(), 0755);
    std::filesystem::remove_all(folder);
  }
  std::string text() {
    std::ifstream in(options.state_file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }
  void store() {
    auto host = make(options);
    auto stream = *host->plug_in();
    stream->send("S");
    clock.run_for(Millis(1));
  }

  std::filesystem::path folder;
  HostOptions options;
};

TEST_F(ServeState, IsWrittenAtEachStoreAndReadAtTheNextStart) {
  store();
  EXPECT_EQ(text(), "stored 1\n");
  store();
  EXPECT_EQ(text(), "stored 2\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "nothing is left beside it";
}

TEST_F(ServeState, IsNotWrittenWithoutAStore) {
  {
    auto host = make(options);
    auto stream = *host->plug_in();
    stream->send("X");
    clock.run_for(Millis(1));
  }
  EXPECT_FALSE(std::filesystem::exists(options.state_file));
}

TEST_F(ServeState, AForeignFileIsRefusedAndKept) {
  std::ofstream(options.state_file) << "holiday pictures";
  const auto made = EmulatorHost::make(clock, std::make_unique<ToyEmulator>(), options);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().what.find(options.state_file), std::string::npos);
  EXPECT_EQ(text(), "holiday pictures");
}

TEST_F(ServeState, AFullDiskIsReportedAndNothingElseStops) {
  store();
  auto host = make(options);
  auto stream = *host->plug_in();
  Ear ear(*stream);
  std::filesystem::remove_all(folder);  // no folder to write into: fails for root too
  stream->send("SV");
  const bool reported = test::poll_until(io, [&] { return !troubles.empty(); });
  ASSERT_TRUE(reported);
  EXPECT_NE(troubles[0].done.find(options.state_file), std::string::npos);
  EXPECT_NE(troubles[0].done.find("not saved"), std::string::npos);
  clock.run_for(Millis(1));
  EXPECT_EQ(ear.received, "R");
}

// A file that is always full, and by that name nothing to be replaced.
TEST_F(ServeState, NoSpaceLeft) {
  options.state_file = folder / "full";
  std::filesystem::create_symlink("/dev/full", options.state_file);
  auto host = EmulatorHost::make(clock, std::make_unique<ToyEmulator>(), options);
  ASSERT_FALSE(host) << "it cannot be read either";
  std::filesystem::remove(options.state_file);
  host = make(options);
  auto stream = *(*host)->plug_in();
  std::filesystem::create_symlink("/dev/full", options.state_file);
  stream->send("S");
  ASSERT_TRUE(test::poll_until(io, [&] { return !troubles.empty(); }));
  EXPECT_NE(troubles[0].sentence().find("full"), std::string::npos);
  EXPECT_NE(troubles[0].advice.find("space"), std::string::npos);
}

}  // namespace
}  // namespace hw
