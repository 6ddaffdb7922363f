#include "gui/model/traffic_log.h"

#include <map>

#include <gmock/gmock.h>

namespace hw::gui {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::map<std::string, int> explained;

std::string explain(std::string_view bytes, Way way, TrafficKind, std::string_view asked) {
  ++explained[std::string(bytes)];
  if (way == Way::sent) return "ask " + std::string(bytes);
  return "answer to " + std::string(asked);
}

TrafficEntry entry(double at_s, Way way, TrafficKind kind, std::string bytes) {
  TrafficEntry e;
  e.at = Instant(from_seconds(at_s));
  e.way = way, e.kind = kind, e.bytes = std::move(bytes);
  return e;
}
TrafficEntry sent(TrafficKind kind, std::string bytes) { return entry(1, Way::sent, kind, std::move(bytes)); }
TrafficEntry came(TrafficKind kind, std::string bytes) {
  return entry(1, Way::received, kind, std::move(bytes));
}

std::vector<std::string> shown(TrafficLog& log) {
  while (log.update_rows()) {
  }
  std::vector<std::string> out;
  for (std::size_t i = 0; i < log.row_count(); ++i) out.push_back(log.line(log.row(i)).raw);
  return out;
}

struct TrafficLogTest : ::testing::Test {
  TrafficLogTest() { explained.clear(); }
  void poll(const std::string& name) {
    log.append(sent(TrafficKind::poll, name));
    log.append(came(TrafficKind::poll, "+0000400\r"));
  }
  void filter(std::string text) {
    TrafficLog::View view = log.view();
    view.filter = std::move(text);
    log.set_view(view);
  }
  TrafficLog log{explain, DayClock{std::chrono::hours(14) + std::chrono::minutes(2)}};
};

TEST_F(TrafficLogTest, ShowsTimeBytesAndMeaning) {
  log.append(entry(4.951, Way::sent, TrafficKind::intent, "M\r"));
  log.append(entry(4.963, Way::received, TrafficKind::intent, "229\r"));
  log.append(entry(5.0, Way::received, TrafficKind::unparsed, "\x01\xFE"));
  ASSERT_THAT(shown(log),
              ElementsAre("M\u2039cr\u203A", "229\u2039cr\u203A", "\u203901\u203A\u2039FE\u203A"));
  EXPECT_EQ(log.line(log.row(0)).time, "14:02:04.951");
  EXPECT_EQ(log.line(log.row(1)).time, "14:02:04.963");
  EXPECT_EQ(log.line(log.row(1)).meaning, "answer to M\r");
  EXPECT_EQ(log.line(log.row(2)).kind, TrafficKind::unparsed);
}

TEST_F(TrafficLogTest, ExplainsOnlyWhatIsLookedAtAndOnce) {
  for (int i = 0; i < 1000; ++i) log.append(sent(TrafficKind::intent, "A" + std::to_string(i)));
  log.update_rows();
  EXPECT_TRUE(explained.empty());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(log.line(log.row(999)).meaning, "ask A999");
  EXPECT_EQ(explained.size(), 1u);
  EXPECT_EQ(explained["A999"], 1);
}

TEST_F(TrafficLogTest, FoldsPollsIntoOneLineThatCounts) {
  for (const char* name : {"X", "Y", "V", "X", "Y"}) poll(name);
  EXPECT_THAT(shown(log), ElementsAre("5 polls of X, Y, V folded."));
  poll("V");
  log.append(sent(TrafficKind::intent, "R\r"));
  for (int i = 0; i < 12345; ++i) poll("X");
  EXPECT_THAT(shown(log),
              ElementsAre("6 polls of X, Y, V folded.", "R\u2039cr\u203A", "12\u2009345 polls of X folded."));
}

TEST_F(TrafficLogTest, FoldOpensAndClosesAndGoesOnCounting) {
  poll("X");
  log.append(sent(TrafficKind::intent, "R\r"));
  ASSERT_THAT(shown(log), ElementsAre("1 poll of X folded.", "R\u2039cr\u203A"));
  log.toggle(log.row(0));
  EXPECT_THAT(shown(log),
              ElementsAre("1 poll of X folded.", "X", "+0000400\u2039cr\u203A", "R\u2039cr\u203A"));
  EXPECT_TRUE(log.row(0).open);
  log.toggle(log.row(0));
  EXPECT_THAT(shown(log), ElementsAre("1 poll of X folded.", "R\u2039cr\u203A"));
}

TEST_F(TrafficLogTest, UnfoldedShowsEachPoll) {
  poll("X");
  TrafficLog::View view;
  view.fold_polls = false;
  log.set_view(view);
  EXPECT_THAT(shown(log), ElementsAre("X", "+0000400\u2039cr\u203A"));
}

TEST_F(TrafficLogTest, FoldsTheMiddleOfAProgramTransfer) {
  for (const char* line : {"PM-0", "S1M2000", "I1M1", "I1M2", "I1M3", "L0"})
    log.append(sent(TrafficKind::transfer, line));
  EXPECT_THAT(shown(log), ElementsAre("PM-0", "S1M2000", "3 more lines of the transfer folded.", "L0"));
  log.toggle(log.row(2));
  EXPECT_THAT(shown(log), ElementsAre("PM-0", "S1M2000", "3 more lines of the transfer folded.", "I1M1",
                                      "I1M2", "I1M3", "L0"));
}

TEST_F(TrafficLogTest, HexShowsTheBytes) {
  log.append(came(TrafficKind::intent, "4\r"));
  TrafficLog::View view;
  view.hex = true;
  view.decoded = false;
  log.set_view(view);
  EXPECT_THAT(shown(log), ElementsAre("34 0D"));
  EXPECT_EQ(log.line(log.row(0)).meaning, "");
}

TEST_F(TrafficLogTest, FilterFindsBytesAndMeaningWhateverTheCase) {
  log.append(sent(TrafficKind::intent, "I1M400\r"));
  log.append(came(TrafficKind::intent, "^"));
  filter("i1m");
  EXPECT_THAT(shown(log), ElementsAre("I1M400\u2039cr\u203A", "^")) << "the answer's meaning names it";
  filter("ASK");
  EXPECT_THAT(shown(log), ElementsAre("I1M400\u2039cr\u203A"));
  log.append(sent(TrafficKind::intent, "K"));
  EXPECT_THAT(shown(log), ElementsAre("I1M400\u2039cr\u203A", "K")) << "new lines are filtered too";
  filter("");
  EXPECT_EQ(shown(log).size(), 3u);
}

TEST_F(TrafficLogTest, FilterLooksThroughOldLinesInSlices) {
  for (int i = 0; i < 10000; ++i) log.append(sent(TrafficKind::intent, "A"));
  filter("ask a");
  EXPECT_TRUE(log.update_rows());
  EXPECT_EQ(log.row_count(), 4096u);
  while (log.update_rows()) {
  }
  EXPECT_EQ(log.row_count(), 10000u);
}

TEST_F(TrafficLogTest, LongListingIsReadLineByLine) {
  std::string listing;
  for (int i = 0; i < 20; ++i) listing += "I1M400\r";
  log.append(came(TrafficKind::intent, listing));
  EXPECT_EQ(shown(log).size(), 20u);
}

TEST_F(TrafficLogTest, MemoryIsBoundedAndTheOldestGoes) {
  TrafficLog::Limits small;
  small.bytes = 1024, small.records = 64;
  TrafficLog bounded(explain, {}, small);
  for (int i = 0; i < 1000; ++i) {
    bounded.append(sent(TrafficKind::intent, "line " + std::to_string(i)));
    bounded.update_rows();
  }
  EXPECT_LE(bounded.records(), 64u);
  const auto lines = shown(bounded);
  EXPECT_EQ(lines.size(), bounded.records());
  EXPECT_EQ(lines.back(), "line 999");
  bounded.append(came(TrafficKind::unsolicited, std::string(5000, 'x')));
  const auto after = shown(bounded);
  EXPECT_EQ(after.back(), std::string(5000 % 128, 'x'));
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_FALSE(after[i].empty());
}

TEST_F(TrafficLogTest, ReportsHowManyWereLost) {
  TrafficRing ring(4);
  for (int i = 0; i < 10; ++i) ring.push(sent(TrafficKind::intent, "A"));
  log.drain(ring);
  EXPECT_EQ(log.records(), 4u);
  EXPECT_EQ(log.lost(), 6u);
  EXPECT_THAT(log.text_of_all(), HasSubstr("6 entries are missing: they came too fast."));
  log.clear();
  log.drain(ring);
  EXPECT_EQ(log.lost(), 0u);
}

TEST_F(TrafficLogTest, TextForFilesAndClipboardIsPlain) {
  log.append(entry(4.951, Way::sent, TrafficKind::intent, "M\r"));
  poll("X");
  shown(log);
  std::string rows;
  log.append_rows(rows, 0, 2);
  EXPECT_EQ(rows, "14:02:04.951 > M<cr>    ask M\r\n1 poll of X folded.\n");
  EXPECT_THAT(log.text_of_all(), HasSubstr("14:02:01.000 < +0000400<cr>"));
  log.clear();
  EXPECT_EQ(log.text_of_all(), "");
  EXPECT_TRUE(shown(log).empty());
}

TEST(DayClock, GoesRoundMidnight) {
  const DayClock clock{std::chrono::hours(23) + std::chrono::minutes(59)};
  char out[16];
  EXPECT_EQ(format_time_of_day(clock.of(Instant(std::chrono::seconds(61))), false, out), "00:00:01");
}

}  // namespace
}  // namespace hw::gui
