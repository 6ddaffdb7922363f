#include "gui/model/program_job.h"

#include <gmock/gmock.h>

#include "tests/gui/model/toy_language.h"

namespace hw::gui {
namespace {

using ::testing::HasSubstr;

struct ProgramJobTest : ::testing::Test {
  ProgramJob::Send send = [this](IntentBody body) {
    sent.push_back(std::move(body));
    return static_cast<IntentId>(sent.size());
  };
  bool begin(ProgramJob::Goal goal) { return job.begin(goal, 0, texts, now, catalog, send); }
  void settle(IntentState outcome, const char* sentence = "") {
    IntentOutcome f;
    f.id = sent.size(), f.state = outcome, f.sentence = sentence;
    now.outcomes[0] = f;
    job.update(texts, now, catalog, Instant(), send);
  }
  void find_another_program() {
    now.slot_bytes_used[0] = 12;
    texts.set_text(0, "I1M400");
    ASSERT_TRUE(begin(ProgramJob::Goal::run));
    texts.listed(0, "L9\n", Instant());
    settle(IntentState::done);
  }
  template <class T>
  const T* last() const {
    return sent.empty() ? nullptr : std::get_if<T>(&sent.back());
  }
  Catalog catalog = test::toy_catalog();
  test::ToyLanguage language;
  ProgramTexts texts{catalog.program, &language};
  ProgramJob job;
  Snapshot now;
  std::vector<IntentBody> sent;
};

TEST_F(ProgramJobTest, RunLoadsWhatAnEmptySlotDoesNotHold) {
  texts.set_text(0, "I1M400");
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  ASSERT_TRUE(last<intent::LoadProgram>());
  EXPECT_EQ(last<intent::LoadProgram>()->text, "I1M400");
  settle(IntentState::done);
  ASSERT_TRUE(last<intent::RunProgram>());
  settle(IntentState::done);
  EXPECT_FALSE(job.busy());
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  EXPECT_EQ(sent.size(), 3u) << "the second time it is there already";
  EXPECT_TRUE(last<intent::RunProgram>());
}

TEST_F(ProgramJobTest, NothingIsStartedBehindAStop) {
  texts.set_text(0, "I1M400");
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  job.give_up();
  settle(IntentState::done);
  EXPECT_FALSE(last<intent::RunProgram>());
  EXPECT_FALSE(job.busy());
  EXPECT_THAT(job.take_report().sentence, HasSubstr("A stop came"));
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  EXPECT_TRUE(last<intent::RunProgram>()) << "asked for again, and loaded already";
}

TEST_F(ProgramJobTest, AProgramThatMustNotBeginOnceLoadedIsNotStarted) {
  for (const auto goal : {ProgramJob::Goal::run, ProgramJob::Goal::run_stepping}) {
    texts.set_text(0, goal == ProgramJob::Goal::run ? "I1M400" : "I1M500");
    std::string why;
    const RunTerms terms{true, [&why] { return why; }};
    ASSERT_TRUE(job.begin(goal, 0, texts, now, catalog, send, terms));
    ASSERT_TRUE(last<intent::LoadProgram>());
    why = "It was loaded and not started.";
    settle(IntentState::done);
    EXPECT_TRUE(last<intent::LoadProgram>()) << "nothing came behind it";
    EXPECT_FALSE(job.busy());
    EXPECT_EQ(job.take_report().sentence, why);
    EXPECT_TRUE(texts.controller_has(0));
  }
}

TEST_F(ProgramJobTest, AControllerThatKeepsNoProgramsIsSentTheTextWithoutAsking) {
  catalog.program.capacity = 0;
  now.slot_bytes_used[0] = 4;
  texts.set_text(0, "I1M400");
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  ASSERT_TRUE(last<intent::LoadProgram>());
  settle(IntentState::done);
  EXPECT_TRUE(last<intent::RunProgram>());
}

TEST_F(ProgramJobTest, RunComparesFirstWhenTheSlotIsInUse) {
  now.slot_bytes_used[0] = 4;
  texts.set_text(0, "I1M400,L0");
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  ASSERT_TRUE(last<intent::UploadProgram>());
  texts.listed(0, "I1M400\nL0\n", Instant());
  settle(IntentState::done);
  EXPECT_TRUE(last<intent::RunProgram>()) << "the same program: nothing is loaded";
}

TEST_F(ProgramJobTest, RunAsksBeforeItOverwritesWhatMeansNothingHere) {
  now.slot_bytes_used[0] = 1;
  texts.set_text(0, "I1M400");
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  texts.listed(0, "", Instant(), false);
  settle(IntentState::done);
  EXPECT_EQ(job.stage(), ProgramJob::Stage::asking);
  EXPECT_THAT(job.question(), HasSubstr("another program of 1 byte,"));
}

TEST_F(ProgramJobTest, RunAsksBeforeItOverwritesAnotherProgram) {
  find_another_program();
  EXPECT_EQ(job.stage(), ProgramJob::Stage::asking);
  EXPECT_THAT(job.question(), HasSubstr("Program 0 in the controller holds another program of 12 bytes"));
  EXPECT_EQ(sent.size(), 1u);
  job.answer(ProgramJob::Answer::leave, texts, send);
  EXPECT_EQ(sent.size(), 1u);
  EXPECT_THAT(job.take_report().sentence, HasSubstr("Nothing was sent."));

  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  settle(IntentState::done);
  job.answer(ProgramJob::Answer::overwrite, texts, send);
  EXPECT_TRUE(last<intent::LoadProgram>());
}

TEST_F(ProgramJobTest, AnAnswerDoesNotCoverTextTypedDuringTheQuestion) {
  find_another_program();
  ASSERT_EQ(job.stage(), ProgramJob::Stage::asking);
  texts.set_text(0, "I1M-77");
  const std::size_t before = sent.size();
  job.answer(ProgramJob::Answer::overwrite, texts, send);
  EXPECT_EQ(sent.size(), before);
  EXPECT_FALSE(job.busy());
  EXPECT_THAT(job.take_report().sentence, HasSubstr("The text has changed since. Nothing was sent"));
}

TEST_F(ProgramJobTest, RoomIsMadeAfterTheTextWasBroughtIntoTheEditor) {
  ASSERT_TRUE(begin(ProgramJob::Goal::make_room));
  ASSERT_TRUE(last<intent::UploadProgram>());
  texts.listed(0, "L9\n", Instant());
  settle(IntentState::done);
  EXPECT_THAT(texts.text(0), HasSubstr("L9"));
  ASSERT_TRUE(last<intent::ClearProgram>());
  settle(IntentState::done);
  EXPECT_THAT(job.take_report().sentence, HasSubstr("Its text is kept in the editor. Move again."));
}

TEST_F(ProgramJobTest, AQuestionStaysUntilItIsAnswered) {
  find_another_program();
  ASSERT_EQ(job.stage(), ProgramJob::Stage::asking);
  EXPECT_FALSE(begin(ProgramJob::Goal::make_room));
  EXPECT_EQ(job.stage(), ProgramJob::Stage::asking);
  EXPECT_THAT(job.take_report().sentence, HasSubstr("Answer the question about the program first."));
}

TEST_F(ProgramJobTest, NoRoomIsMadeWhereATextWouldBeLost) {
  texts.set_text(0, "I1M400");
  ASSERT_TRUE(begin(ProgramJob::Goal::make_room));
  texts.listed(0, "L9\n", Instant());
  settle(IntentState::done);
  EXPECT_FALSE(last<intent::ClearProgram>());
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(texts.text(0), "I1M400");
  EXPECT_THAT(job.take_report().sentence, HasSubstr("Nothing was emptied."));
}

TEST_F(ProgramJobTest, FetchingInsteadKeepsTheControllersProgram) {
  now.slot_bytes_used[0] = 12;
  texts.set_text(0, "I1M400");
  begin(ProgramJob::Goal::run);
  texts.listed(0, "L9\n", Instant());
  settle(IntentState::done);
  job.answer(ProgramJob::Answer::fetch_instead, texts, send);
  EXPECT_EQ(texts.text(0), "L9\n");
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(sent.size(), 1u);
}

TEST_F(ProgramJobTest, ErrorsInTheTextAreReportedAndNothingIsSent) {
  texts.set_text(0, "I1\nBAD");
  EXPECT_FALSE(begin(ProgramJob::Goal::run));
  EXPECT_EQ(job.take_report().sentence, "Nothing was sent. Line 2: BAD is no command.");
  EXPECT_TRUE(sent.empty());
  EXPECT_EQ(texts.text(0), "I1\nBAD");
}

TEST_F(ProgramJobTest, ProgramTooLongIsReportedAndNothingIsSent) {
  texts.set_text(0, "A,B,C,D,E,F,G,H,J,K,M");
  EXPECT_FALSE(begin(ProgramJob::Goal::run));
  EXPECT_EQ(job.take_report().sentence,
            "Nothing was sent. The program needs 22 bytes and 20 fit: 2 too many. Shorten it.");
  EXPECT_TRUE(sent.empty());
}

TEST_F(ProgramJobTest, RefusedLoadEndsTheJobWithItsSentence) {
  texts.set_text(0, "I1");
  begin(ProgramJob::Goal::run);
  settle(IntentState::refused, "A program runs. Nothing was sent.");
  EXPECT_FALSE(job.busy());
  const auto reported = job.take_report();
  EXPECT_EQ(reported.severity, Severity::fault);
  EXPECT_EQ(reported.sentence, "A program runs. Nothing was sent.");
  EXPECT_EQ(sent.size(), 1u);
  EXPECT_EQ(job.take_report().sentence, "") << "told once";
}

TEST_F(ProgramJobTest, LostLinkEndsTheJob) {
  texts.set_text(0, "I1");
  begin(ProgramJob::Goal::store);
  now.link.state = LinkState::lost;
  job.update(texts, now, catalog, Instant(), send);
  EXPECT_FALSE(job.busy());
  EXPECT_THAT(job.take_report().sentence, HasSubstr("The link was lost"));
}

TEST_F(ProgramJobTest, StoreShowsHowManyWritesWereUsed) {
  texts.set_text(0, "I1");
  begin(ProgramJob::Goal::store);
  settle(IntentState::done);
  ASSERT_TRUE(last<intent::Store>());
  now.store_count = 13;
  settle(IntentState::done);
  EXPECT_EQ(job.take_report().sentence, "Stored in the controller. 13 of 100000 writes used.");
}

TEST_F(ProgramJobTest, AProgramKeptOnLoadingNeedsNoStore) {
  catalog.program.compiled = true;
  texts.set_text(0, "I1");
  begin(ProgramJob::Goal::store);
  settle(IntentState::done);
  EXPECT_TRUE(last<intent::LoadProgram>());
  EXPECT_FALSE(last<intent::Store>());
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(job.take_report().sentence, "The controller holds this program now.");
}

TEST_F(ProgramJobTest, SteppingHoldsBeforeTheFirstCommand) {
  texts.set_text(0, "I1");
  begin(ProgramJob::Goal::run_stepping);
  settle(IntentState::done);
  ASSERT_EQ(sent.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<intent::SelectProgram>(sent[1]));
  EXPECT_TRUE(std::holds_alternative<intent::SingleStep>(sent[2]));
}

TEST_F(ProgramJobTest, FetchBringsTheListingAndClearLeavesTheText) {
  begin(ProgramJob::Goal::fetch);
  texts.listed(0, "L9\n", Instant());
  settle(IntentState::done);
  EXPECT_EQ(texts.text(0), "L9\n");
  begin(ProgramJob::Goal::clear);
  ASSERT_TRUE(last<intent::ClearProgram>());
  settle(IntentState::done);
  EXPECT_EQ(texts.text(0), "L9\n");
  EXPECT_TRUE(texts.held(0).known);
  EXPECT_TRUE(texts.held(0).listing.empty());
}

TEST_F(ProgramJobTest, FetchReportsHowToGetBackWhatItReplaces) {
  begin(ProgramJob::Goal::fetch);
  texts.listed(0, "L9\n", Instant());
  settle(IntentState::done);
  EXPECT_THAT(job.take_report().sentence, testing::Not(HasSubstr("Ctrl+Z")));
  texts.set_text(0, "L9\n; a note\n");
  begin(ProgramJob::Goal::fetch);
  settle(IntentState::done);
  EXPECT_THAT(job.take_report().sentence, HasSubstr("Ctrl+Z restores the earlier text."));
}

TEST_F(ProgramJobTest, TextTypedDuringTheTransferIsNotTakenForLoaded) {
  texts.set_text(0, "I1");
  begin(ProgramJob::Goal::run);
  texts.set_text(0, "I2");
  settle(IntentState::done);
  EXPECT_EQ(texts.held(0).text, "I1");
  EXPECT_FALSE(texts.controller_has(0));
}

TEST_F(ProgramJobTest, LinesAndTheTimeThatIsLeftAreReportedAsFarAsTheyAreKnown) {
  texts.set_text(0, "I1M400");
  begin(ProgramJob::Goal::load);
  const auto words = [&] { return job.words(catalog.program, now.transfer); };
  EXPECT_EQ(words(), "Loading Program 0");
  now.transfer.running = true;
  now.transfer.phase = TransferState::Phase::writing;
  now.transfer.done = 41, now.transfer.total = 302;
  EXPECT_EQ(words(), "Loading Program 0: 41 of 302 lines");
  now.transfer.left = from_seconds(13.2);
  EXPECT_EQ(words(), "Loading Program 0: 41 of 302 lines, 14 s left");
  now.transfer.phase = TransferState::Phase::comparing;
  EXPECT_EQ(words(), "Loading Program 0: comparing, 41 of 302 lines, 14 s left");
  now.transfer = TransferState();
  now.transfer.running = true, now.transfer.done = 7;
  EXPECT_EQ(words(), "Loading Program 0: 7 lines");
}

TEST_F(ProgramJobTest, ALinkThatIsLostInTheMiddleLeavesWhatIsReported) {
  texts.set_text(0, "I1M400");
  begin(ProgramJob::Goal::load);
  now.transfer.phase = TransferState::Phase::writing;
  now.transfer.done = 41, now.transfer.total = 302;
  now.slots_torn = 1;
  now.link.state = LinkState::lost;
  settle(IntentState::pending);
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(job.take_report().sentence,
            "The link was lost while the program was transferred: the first 41 of its 302 lines are written. "
            "Load it again when the link is back.");
}

TEST_F(ProgramJobTest, HalfOfATransferIsLoadedOverWithoutAQuestion) {
  now.slot_bytes_used[0] = -1;
  now.slots_torn = 1;
  texts.set_text(0, "I1M400");
  ASSERT_TRUE(begin(ProgramJob::Goal::run));
  EXPECT_TRUE(last<intent::LoadProgram>());
}

}  // namespace
}  // namespace hw::gui
