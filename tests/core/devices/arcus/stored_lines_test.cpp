// What goes over the wire when a program is downloaded: only lines that are not known to be there are written
// (flash wears), and every line is read before it is said to stand. How far it has come, and what an end
// before the end leaves.
#include <fmt/core.h>

#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

constexpr std::string_view both_models[] = {"pmx-4ex-sa", "dmx-k-sa"};
constexpr int count = 302;    // lines of the program
constexpr int behind_it = 4;  // empty lines that end it
constexpr int all = count + behind_it;

std::string program(int other = -1) {
  std::string text;
  for (int n = 0; n < count - 1; ++n) text += fmt::format("V1={}\n", n == other ? 9999 : n);
  return text + "END\n";
}

class ProgramDownload : public DriverTest {
 protected:
  struct Wire {
    int reads = 0, writes = 0;
    bool operator==(const Wire&) const = default;
    friend std::ostream& operator<<(std::ostream& out, const Wire& wire) {
      return out << wire.reads << " read, " << wire.writes << " written";
    }
  };
  /// Stored lines that were asked for and sent since the last call, by transfers.
  Wire wire() {
    Wire seen;
    traffic.drain([&](const TrafficEntry& e) {
      const auto at = e.bytes.find("SA");
      const bool line =
          at != e.bytes.npos && at + 2 < e.bytes.size() && e.bytes[at + 2] >= '0' && e.bytes[at + 2] <= '9';
      if (e.way != Way::sent || e.kind != TrafficKind::transfer || !line) return;
      ++(e.bytes.find('=') == e.bytes.npos ? seen.reads : seen.writes);
    });
    return seen;
  }
  Wire download(std::string text) {
    wire();
    EXPECT_EQ(perform(intent::LoadProgram(0, std::move(text)), 600), "");
    return wire();
  }
  /// On its way, with so many lines done.
  IntentId begin_download(int lines) {
    const IntentId loading = post(intent::LoadProgram(0, program()));
    EXPECT_TRUE(run_until([&] { return latest.transfer.running && latest.transfer.done >= lines; }, 60));
    return loading;
  }
  std::string end_of(IntentId loading) {
    EXPECT_TRUE(run_until([&] { return outcome(loading) != IntentState::pending; }, 120));
    return std::string(pump->known().outcome_of(loading)->sentence.view());
  }
  void next_model() {
    TearDown();
    latest = Snapshot();
    notices.clear();
  }
};

// Four lines show that another program, or none, is stored; behind the last line four show that nothing is.
TEST_F(ProgramDownload, ADownloadWritesOnlyWhatIsNotKnownToBeThere) {
  for (const std::string_view model : both_models) {
    start(model);
    EXPECT_EQ(download(program()), (Wire{4 + all, count})) << model << ", the first time";
    EXPECT_TRUE(reported("302 of 1275 lines are stored: 302 were written and compared.")) << all_notices();
    EXPECT_EQ(download(program()), (Wire{all, 0})) << model << ", once more";
    EXPECT_TRUE(reported("302 of 1275 lines are stored: nothing had to be written.")) << all_notices();
    EXPECT_EQ(download(program(150)), (Wire{all, 1})) << model << ", one line changed";
    next_model();
  }
}

// Behind the console's back: by another host, on the controller's other port.
TEST_F(ProgramDownload, LinesWrittenByAnotherHostAreFoundAndRewritten) {
  for (const std::string_view model : both_models) {
    start(model);
    download(program());
    std::string after_silence;
    for (const int line : {150, count + 1}) {
      loop->emulator().receive(fmt::format("@{}SA{}=END\r", model == "dmx-k-sa" ? "01" : "00", line));
      loop->emulator().take_output(after_silence);
    }
    ASSERT_THAT(after_silence, HasSubstr("OK"));
    EXPECT_EQ(download(program()), (Wire{all + 2 + 2, 2})) << model << ", two behind the new end, two mended";
    EXPECT_EQ(query(fmt::format("SA{}", count + 1)), "");
    ASSERT_EQ(perform(intent::UploadProgram(0), 600), "");
    EXPECT_EQ(program_text(), program());
    next_model();
  }
}

TEST_F(ProgramDownload, LinesReadByAnUploadAreKnownToo) {
  start("dmx-k-sa");
  download(program());
  loop->operate(bench::PowerCycle());
  run(5);
  ASSERT_EQ(perform(intent::UploadProgram(0), 600), "");
  EXPECT_EQ(download(program()), (Wire{all, 0}));
}

TEST_F(ProgramDownload, AfterALostLinkEveryLineIsReadAndNoneThatIsThereIsWritten) {
  for (const std::string_view model : both_models) {
    start(model);
    download(program());
    loop->pull();
    ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::lost; }, 10));
    ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 30));
    EXPECT_EQ(download(program(150)), (Wire{all + 1, 1})) << model;
    next_model();
  }
}

TEST_F(ProgramDownload, ALineThatTheTerminalHasWrittenIsNotTakenForTheOldOne) {
  for (const std::string_view model : both_models) {
    start(model);
    download(program());
    ASSERT_EQ(query("SA7=END"), "OK");
    EXPECT_EQ(download(program()), (Wire{all + 1, 1})) << model;
    next_model();
  }
}

TEST_F(ProgramDownload, AProgramThatGrowsAtItsEndCostsItsNewLines) {
  start("dmx-k-sa");
  ASSERT_EQ(download("V1=1\nV2=2\nEND\n"), (Wire{3 + 4 + 3, 3}));
  EXPECT_EQ(download("V1=1\nV2=2\nV3=3\nEND\n").writes, 2);
  EXPECT_EQ(download("V1=1\nEND\n").writes, 3) << "one changed, two emptied";
  EXPECT_EQ(query("SA2"), "");
  EXPECT_EQ(query("SA3"), "");
}

// A digit of its number may have been lost: then it stands in another place, where it is looked for as well.
TEST_F(ProgramDownload, ALineThatWasGarbledOnItsWayIsFoundWhereverItWent) {
  start("dmx-k-sa", {}, true);
  download(program());
  int torn = 0;
  for (int after_ms = 0; after_ms < 60; after_ms += 4) {
    const IntentId loading = post(intent::LoadProgram(0, program(after_ms % 8 == 0 ? 150 : -1)));
    run(0.03 + after_ms / 1000.0);
    loop->lose(1);
    end_of(loading);
    if (outcome(loading) != IntentState::done) {
      ++torn;
      continue;
    }
    ASSERT_EQ(perform(intent::UploadProgram(0), 600), "");
    EXPECT_EQ(program_text(), program(after_ms % 8 == 0 ? 150 : -1)) << after_ms;
  }
  EXPECT_LT(torn, 10);
}

TEST_F(ProgramDownload, HowFarItIsAndHowLongItTakesIsReported) {
  start("pmx-4ex-sa", {}, true);
  const Instant began = time.now();
  const IntentId loading = begin_download(60);
  EXPECT_EQ(latest.transfer.phase, TransferState::Phase::writing);
  EXPECT_EQ(latest.transfer.total, count);
  const double left = seconds(latest.transfer.left), until_now = seconds(time.now() - began);
  EXPECT_GT(left, until_now);
  const Instant asked = time.now();
  ASSERT_TRUE(run_until([&] { return latest.transfer.phase == TransferState::Phase::comparing; }, 60));
  EXPECT_TRUE(latest.transfer.running);
  ASSERT_TRUE(run_until([&] { return outcome(loading) != IntentState::pending; }, 60));
  EXPECT_NEAR(seconds(time.now() - asked), left, left / 4);
  EXPECT_FALSE(latest.transfer.running);
  EXPECT_EQ(latest.transfer.left, Duration{});

  const IntentId reading = post(intent::UploadProgram(0));
  ASSERT_TRUE(run_until([&] { return latest.transfer.running && latest.transfer.done > 60; }, 60));
  EXPECT_EQ(latest.transfer.phase, TransferState::Phase::reading);
  EXPECT_EQ(latest.transfer.total, count);
  EXPECT_GT(latest.transfer.left, Duration{});
  ASSERT_TRUE(run_until([&] { return outcome(reading) != IntentState::pending; }, 60));
}

TEST_F(ProgramDownload, ItIsQuickerThanThreeTransactionsALine) {
  start("pmx-4ex-sa", {}, true);
  const auto took = [&](std::string text) {
    const Instant began = time.now();
    download(std::move(text));
    return seconds(time.now() - began);
  };
  const double first = took(program());
  EXPECT_LT(took(program()), first * 0.6) << "each line is asked for once";
  EXPECT_LT(took(program(150)), first * 0.6);
}

// And what is there already is not written a second time.
TEST_F(ProgramDownload, AbortedInTheMiddleItReportsWhatIsWrittenAndGoesOnFromThere) {
  for (const std::string_view model : both_models) {
    start(model, {}, true);
    download("V9=1\nEND\n");
    const IntentId loading = begin_download(100);
    ASSERT_EQ(perform(intent::HaltProgram()), "");
    const std::string sentence = end_of(loading);
    EXPECT_THAT(sentence,
                MatchesRegex("A stop came first. The stored code is now neither the old program nor the new "
                             "one: the first 1[0-9][0-9] of its 302 lines are written, and the other lines "
                             "are those of the old program. Download the program again before it is run."));
    const int done = latest.transfer.done;
    EXPECT_FALSE(latest.transfer.running);
    EXPECT_EQ(latest.slots_torn, 1);
    EXPECT_THAT(sentence, HasSubstr(fmt::format("the first {} of", done)));
    EXPECT_NE(query(fmt::format("SA{}", done - 1)), "");
    EXPECT_EQ(query(fmt::format("SA{}", done + 1)), "");
    EXPECT_LE(download(program()).writes, count - done);
    EXPECT_EQ(latest.slots_torn, 0);
    next_model();
  }
}

TEST_F(ProgramDownload, AbortedWhileItIsComparedAllIsWritten) {
  start("dmx-k-sa", {}, true);
  const IntentId loading = post(intent::LoadProgram(0, program()));
  ASSERT_TRUE(run_until(
      [&] { return latest.transfer.phase == TransferState::Phase::comparing && latest.transfer.done > 50; },
      60));
  ASSERT_EQ(perform(intent::Stop()), "");
  EXPECT_THAT(end_of(loading),
              MatchesRegex("A stop came first. The stored code may not be the new program: all of its "
                           "lines are written, and [0-9]+ of 302 were compared. Download the program again "
                           "before it is run."));
  EXPECT_EQ(download(program()).writes, 0);
}

TEST_F(ProgramDownload, ALinkThatIsLostInTheMiddleLeavesWhatIsReported) {
  for (const std::string_view model : both_models) {
    start(model, {}, true);
    download("V9=1\nEND\n");
    const IntentId loading = begin_download(100);
    loop->pull();
    EXPECT_THAT(end_of(loading), MatchesRegex(".*neither the old program nor the new one: the first "
                                              "1[0-9][0-9] of its 302 lines are written, and the other lines "
                                              "are those of the old program. Download the program again.*"));
    EXPECT_FALSE(latest.transfer.running);
    EXPECT_GE(latest.transfer.done, 100) << "the panel says it as long as it is so";
    EXPECT_EQ(latest.slots_torn, 1);
    ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 30));
    EXPECT_LT(download(program()).writes, count - 90);
    next_model();
  }
}

}  // namespace
}  // namespace hw::arcus
