// What the pump is told of a text before it is sent: is it a stop, of what, for whom, and does it answer.
#include "core/devices/arcus/text_meaning.h"

#include <gtest/gtest.h>

#include "core/devices/dmx_k_sa/forms.h"
#include "core/devices/pmx_4ex_sa/forms.h"

namespace hw::arcus {
namespace {

using Stops = TextMeaning::Stops;
using For = TextMeaning::For;

TextMeaning typed_to_dmx(const char* text, bool to_all = false) {
  return meaning_of(dmx_k_sa::forms(), intent::SendText(text, to_all), Addressing{1, false});
}
TextMeaning typed_to_pmx(const char* text) {
  return meaning_of(pmx_4ex_sa::forms(), intent::SendText(text), Addressing{0, false});
}

TEST(ArcusTextMeaning, StopsOfAllAreKnownInEverySpellingThatTheControllerTakes) {
  for (const char* text :
       {"STOP", "ABORT", "@01STOP", "@00ABORT", " STOP", "STOP ", "@01 STOP", "@00  ABORT"})
    EXPECT_EQ(typed_to_dmx(text).stops, Stops::all) << text;
  EXPECT_EQ(typed_to_pmx("STOP").stops, Stops::all);
}

TEST(ArcusTextMeaning, AProgramThatIsEndedAndAnAxisThatIsStoppedAreNotAll) {
  for (const char* text : {"SR0=0", "SR1=0", "@01SR1=0", "SR0= 0", "SR0 =0", " SR0=0", "SR0=00", "SR00=0",
                           "SR0=+0", "SR0=-0", "SR0=0 ", "@01 SR1 = 0"})
    EXPECT_EQ(typed_to_dmx(text).stops, Stops::some) << text;
  for (const char* text : {"STOPX", "ABORTU", "SR3=0", "@00STOPY"})
    EXPECT_EQ(typed_to_pmx(text).stops, Stops::some) << text;
  EXPECT_EQ(typed_to_pmx("STOPX").axis, 0);
  EXPECT_EQ(typed_to_pmx("ABORTU").axis, 3);
  EXPECT_EQ(typed_to_pmx("SR3=0").axis, -1);
}

TEST(ArcusTextMeaning, KnowsWhatOnlyAsks) {
  for (const char* text : {"PX", "EX", "MST", "V5", "DI", "SASTAT0", "HSPD", "ID", "@01PX", "TOC"})
    EXPECT_TRUE(typed_to_dmx(text).only_asks) << text;
  for (const char* text : {"PP", "PE", "PX", "MST", "HSX", "ACC", "V99", "DO1", "EO", "SLSX", "SPC0"})
    EXPECT_TRUE(typed_to_pmx(text).only_asks) << text;
  for (const char* text :
       {"", "X100", "J+", "PX=0", "V5=1", "STORE", "CLR", "CLRX", "ABS", "SYNXF", "HX+", "STOP", "SR0=1"})
    EXPECT_FALSE(typed_to_pmx(text).only_asks) << text;
}

TEST(ArcusTextMeaning, NothingElseIsAStop) {
  for (const char* text :
       {"", "@", "PX", "SR0=1", "SR0", "SR", "SR0=01", "X100", "@02X100", "STORE", "SLOAD=0", "SR0= 1",
        "SR0=+1", "SR0=0x", "SR=0", "SRX=0", "SR0=", " X100", "SR0= "})
    EXPECT_FALSE(typed_to_dmx(text).is_stop()) << text;
}

TEST(ArcusTextMeaning, ATextIsForTheDeviceThatItNames) {
  EXPECT_EQ(typed_to_dmx("PX").addressee, For::this_one);
  EXPECT_EQ(typed_to_dmx("@01PX").addressee, For::this_one);
  EXPECT_EQ(typed_to_dmx("@02STOP").addressee, For::another);
  EXPECT_EQ(typed_to_dmx("@02STOP").address, 2);
  EXPECT_FALSE(typed_to_dmx("@02STOP").stops_here());
  EXPECT_EQ(typed_to_dmx("@00STOP").addressee, For::all);
  EXPECT_EQ(typed_to_dmx("STOP", true).addressee, For::all);
  EXPECT_TRUE(typed_to_dmx("@00STOP").stops_here());
}

TEST(ArcusTextMeaning, OnlyWhatGoesToAllIsNotAnswered) {
  EXPECT_EQ(typed_to_dmx("@01J+").answered, TextMeaning::Answered::at_once);
  EXPECT_EQ(typed_to_dmx("@00J+").answered, TextMeaning::Answered::never);
  EXPECT_FALSE(typed_to_dmx("X1000").end_is_reported);
  EXPECT_TRUE(meaning_of(dmx_k_sa::forms(), intent::SendText("X1000"), Addressing{1, true}).end_is_reported);
}

TEST(ArcusTextMeaning, ALineOfTheProgramMemoryChangesPrograms) {
  EXPECT_TRUE(typed_to_dmx("SA12=PX").changes_programs);
  EXPECT_FALSE(typed_to_dmx("SA12").changes_programs);
  EXPECT_FALSE(typed_to_dmx("SR0=1").changes_programs);
  for (const char* text : {"SR0=1", "SR1=3", "GS0"}) EXPECT_TRUE(typed_to_dmx(text).runs_program) << text;
  for (const char* text : {"SR0=0", "SA12=PX", "X100", "DO2=1"})
    EXPECT_FALSE(typed_to_dmx(text).runs_program) << text;
}

}  // namespace
}  // namespace hw::arcus
