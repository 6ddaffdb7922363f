#include "gui/model/setup_edits.h"

#include <gmock/gmock.h>

#include "tests/gui/model/toy_language.h"

namespace hw::gui {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct SetupEditsTest : ::testing::Test {
  SetupEditsTest() {
    for (std::size_t i = 0; i < catalog.params.size(); ++i) {
      now.params[i].known = true;
      now.params[i].value = catalog.params[i].fallback;
    }
  }
  SetupWrite::Send send = [this](IntentBody body) {
    sent.push_back(std::get<intent::SetParam>(std::move(body)));
    return static_cast<IntentId>(sent.size());
  };
  void settle(IntentState outcome, const char* sentence = "") {
    IntentOutcome f;
    f.id = sent.size(), f.state = outcome, f.sentence = sentence;
    now.outcomes[0] = f;
    write.update(now, catalog, send);
  }
  Catalog catalog = test::toy_catalog();
  SetupEdits edits{catalog};
  SetupWrite write;
  Snapshot now;
  std::vector<intent::SetParam> sent;
};

TEST_F(SetupEditsTest, OutOfRangeIsRefusedInWordsAndChangesNothing) {
  ASSERT_TRUE(edits.set(1, 100));
  std::string why;
  EXPECT_FALSE(edits.set(1, 9000, &why));
  EXPECT_EQ(why, "j1M takes 1 to 6000. 9000 was not accepted.");
  EXPECT_EQ(edits.edited(1), 100);
  EXPECT_FALSE(edits.set(0, 5, &why));
  EXPECT_EQ(why, "M1M takes 0, 1, 2. 5 was not accepted.");
}

TEST_F(SetupEditsTest, ChangedAgainstTheControllerOffAgainstTheFactory) {
  EXPECT_TRUE(edits.to_send(now).empty());
  edits.set(1, 100);
  edits.set(2, 7);
  EXPECT_THAT(edits.to_send(now), ElementsAre(1u)) << "7 is what it has";
  EXPECT_TRUE(edits.off_factory(1, now));
  now.params[1].value = 100;
  EXPECT_FALSE(edits.changed(1, now));
  edits.settle(now);
  EXPECT_EQ(edits.edited(1), std::nullopt);
  EXPECT_TRUE(edits.off_factory(1, now));
  EXPECT_EQ(edits.shown(1, now), 100);
}

TEST_F(SetupEditsTest, UnknownIsShownAsUnknown) {
  now.params[1].known = false;
  EXPECT_EQ(edits.shown(1, now), std::nullopt);
  EXPECT_FALSE(edits.off_factory(1, now));
  edits.set(1, 2000);
  EXPECT_TRUE(edits.changed(1, now)) << "it may differ";
}

TEST_F(SetupEditsTest, FileBecomesEditsAndBack) {
  edits.set(1, 55);
  const Backup file = edits.to_file(now);
  EXPECT_EQ(file.parameters.size(), 4u);
  SetupEdits other(catalog);
  int differing = 0;
  const auto checked = check_backup(file, catalog, "a.toml");
  ASSERT_TRUE(checked);
  EXPECT_TRUE(other.take(*checked, now, &differing).empty());
  EXPECT_EQ(differing, 1);
  EXPECT_THAT(other.to_send(now), ElementsAre(1u));
}

TEST_F(SetupEditsTest, FilterFindsAllItsWords) {
  EXPECT_TRUE(edits.matches(1, ""));
  EXPECT_TRUE(edits.matches(1, "JOG speed"));
  EXPECT_TRUE(edits.matches(1, "j1M"));
  EXPECT_TRUE(edits.matches(1, "stranger"));
  EXPECT_FALSE(edits.matches(1, "jog baud"));
}

TEST_F(SetupEditsTest, WritesOneAfterAnother) {
  edits.set(1, 100);
  edits.set(2, 3);
  write.begin(edits, now, catalog, true, send);
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].mnemonic, "j1M");
  EXPECT_TRUE(sent[0].confirmed);
  settle(IntentState::pending);
  EXPECT_EQ(sent.size(), 1u);
  settle(IntentState::done);
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[1].value, 3);
  settle(IntentState::done);
  EXPECT_FALSE(write.busy());
  EXPECT_THAT(write.take_report().sentence, HasSubstr("2 values written and read back."));
}

TEST_F(SetupEditsTest, TheReportCountsTheValuesThatStoreKeeps) {
  catalog.params[2].stored = false;
  edits.set(2, 5);
  write.begin(edits, now, catalog, false, send);
  settle(IntentState::done);
  EXPECT_THAT(write.take_report().sentence, HasSubstr("It is lost at power-off."));
  edits.set(1, 55);
  write.begin(edits, now, catalog, false, send);
  settle(IntentState::done);
  settle(IntentState::done);
  EXPECT_THAT(write.take_report().sentence, HasSubstr("Store keeps 1 of them at power-off."));
}

TEST_F(SetupEditsTest, ARefusalStopsTheRest) {
  edits.set(1, 100);
  edits.set(2, 3);
  write.begin(edits, now, catalog, false, send);
  settle(IntentState::refused, "A program runs.");
  EXPECT_EQ(sent.size(), 1u);
  const auto reported = write.take_report();
  EXPECT_FALSE(reported.good);
  EXPECT_EQ(reported.sentence, "j1M: A program runs. 0 of 2 values were written.");
  EXPECT_EQ(edits.edited(2), 3) << "what was typed stays";
}

TEST_F(SetupEditsTest, ValuesInWords) {
  EXPECT_EQ(value_in_words(catalog.params[0], 2), "2: big");
  EXPECT_EQ(value_in_words(catalog.params[1], 100), "100 steps/s");
  EXPECT_EQ(value_in_words(catalog.params[2], 3), "3 (Run starts, Stop stops)");
  EXPECT_EQ(value_in_words(catalog.params[2], 0), "0 (nothing)");
}

}  // namespace
}  // namespace hw::gui
