// What a raw text does, read before it is sent and without a driver.
#include "core/devices/vxm/text_meaning.h"

#include <gtest/gtest.h>

#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm {
namespace {

using Stops = TextMeaning::Stops;
using Answered = TextMeaning::Answered;

enum State { at_rest, own_move, program_runs, local, halted };

TextMeaning meaning(std::string_view text, State state = at_rest) {
  Listening now;
  now.running = state == own_move || state == program_runs;
  now.local = state == local;
  now.halted = state == halted;
  return meaning_of(text, now, state == own_move);
}

TEST(VxmTextMeaning, OfAllFormsOnlyKAndResStopAndDOnLine) {
  ASSERT_GT(proof::form_table().size(), 150u);
  for (const proof::Form& form : proof::form_table())
    for (const State state : {at_rest, own_move, program_runs, local, halted}) {
      const bool always = form.example == "K" || form.example == "res";
      const bool ramps = form.example == "D" && state != local && state != halted;
      EXPECT_EQ(meaning(form.example, state).is_stop(), always || ramps) << form.id << " in state " << state;
    }
}

TEST(VxmTextMeaning, KAndResStopEverythingDOnlyAMoveOfTheConsole) {
  for (const State state : {at_rest, own_move, program_runs, local, halted}) {
    EXPECT_EQ(meaning("K", state).stops, Stops::all);
    EXPECT_EQ(meaning("res", state).stops, Stops::all);
  }
  EXPECT_EQ(meaning("D", own_move).stops, Stops::all);
  EXPECT_EQ(meaning("D", program_runs).stops, Stops::some) << "the program goes on";
}

TEST(VxmTextMeaning, CommandsBehindAStopCountOnlyIfTheyStartSomething) {
  for (const char* text : {"K,PM1,", " K", "K;done\r", "KV", "res,F"})
    EXPECT_EQ(meaning(text, own_move).stops, Stops::all) << text;
  for (const char* text : {"K,R", "KPM1,R", "D,R", "V,K", "FK", "", "k", ";K"})
    EXPECT_FALSE(meaning(text, own_move).is_stop()) << text;
}

TEST(VxmTextMeaning, PredictsWhenTheAnswerComes) {
  for (const char* text : {"V", "X", "lst", "getM1M", "rsm", "K", "PM1,M", "K,V"}) {
    EXPECT_EQ(meaning(text).answered, Answered::at_once) << text;
    EXPECT_FALSE(meaning(text).end_is_reported) << text;
  }
  for (const char* text : {"R", "PM1,R", "X,R", "I1M400,", "bogus"}) {
    EXPECT_EQ(meaning(text).answered, Answered::later) << text;
    EXPECT_TRUE(meaning(text).end_is_reported) << text;
  }
  EXPECT_EQ(meaning("D", own_move).answered, Answered::later) << "by the prompt of the move";
  EXPECT_EQ(meaning("D", local).answered, Answered::at_once) << "it asks for places";
  EXPECT_EQ(meaning("res").answered, Answered::never);
}

TEST(VxmTextMeaning, NothingAnswersWhatTheStateDrops) {
  EXPECT_EQ(meaning("X", local).answered, Answered::never);
  EXPECT_EQ(meaning("V,X", local).answered, Answered::never);
  EXPECT_EQ(meaning("X,V", local).answered, Answered::at_once);
  EXPECT_EQ(meaning("lst", program_runs).answered, Answered::never);
  EXPECT_EQ(meaning("R", halted).answered, Answered::never);
  EXPECT_EQ(meaning("K", halted).answered, Answered::at_once);
}

TEST(VxmTextMeaning, KnowsWhatOnlyAsks) {
  for (const char* text : {"V", "X", "x", "getM1M", "lst", "V,X", "@"})
    EXPECT_TRUE(meaning(text).only_asks) << text;
  for (const char* text :
       {"", "R", "N", "PM1,", "setM1M4,", "V,R", "rsm", "K", "D", "C", "B5,", "bogus", "H"})
    EXPECT_FALSE(meaning(text).only_asks) << text;
}

TEST(VxmTextMeaning, KnowsWhatRunsPrograms) {
  for (const char* text : {"R", "PM-0,I1M400,R", "G", "H"}) EXPECT_TRUE(meaning(text).runs_program) << text;
  for (const char* text : {"X", "I1M400,", "setM1M4,", "K"}) EXPECT_FALSE(meaning(text).runs_program) << text;
  EXPECT_FALSE(meaning("R", halted).runs_program);
}

TEST(VxmTextMeaning, KnowsWhatChangesPrograms) {
  for (const char* text : {"PM-0,", "I1M400,", "C", "del", "res", "V,L0,"})
    EXPECT_TRUE(meaning(text).changes_programs) << text;
  for (const char* text : {"X", "PM1,", "PM", "lst", "R", "setM1M4,", "K"})
    EXPECT_FALSE(meaning(text).changes_programs) << text;
}

TEST(VxmTextMeaning, IsForThisControllerAlone) {
  for (const proof::Form& form : proof::form_table())
    EXPECT_EQ(meaning(form.example).addressee, TextMeaning::For::this_one) << form.id;
}

}  // namespace
}  // namespace hw::vxm
