// Of a loaded program only those places are asked about that rely on a doubtful count.
#include "core/device/loaded_texts.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "core/device/registry.h"

namespace hw {
namespace {

struct LoadedTextsTest : testing::Test {
  LoadedTextsTest() {
    now.axis_count = static_cast<int>(catalog.axes.size());
    now.axes[0].position_known = true;
    now.axes[0].trust.doubt(Doubt::another, Instant{});
  }
  std::vector<AxisTarget> places_of(const std::string& text) {
    texts.loaded(intent::LoadProgram(0, text));
    return places();
  }
  std::vector<AxisTarget> places() { return texts.places_in_doubt(0, now); }

  const DeviceType& type = *find_device_type("vxm");
  const Catalog catalog = *type.make_catalog({});
  Snapshot now;
  LoadedTexts texts{catalog, &type.language()};
};

TEST_F(LoadedTextsTest, APlaceByADoubtfulCountIsOne) {
  EXPECT_FALSE(places_of("IA1M4000,").empty());
  EXPECT_FALSE(places().empty()) << "also the second time";
  now.axes[0].trust.settle(Trust::set, Instant{});
  EXPECT_TRUE(places().empty());
}

TEST_F(LoadedTextsTest, BehindWhatMayZeroTheCountIsNone) {
  EXPECT_TRUE(places_of("I1M-0,IA1M-0,IA1M4000,").empty());
  EXPECT_TRUE(places_of("I1M-0,P5,IA1M-0,IA1M4000,").empty()) << "no block sets zero here";
  EXPECT_TRUE(places_of("IA1M-0,IA1M4000,").empty());
  EXPECT_FALSE(places_of("IA1M4000,I1M-0,P5,IA1M-0,").empty()) << "it goes there first";
}

TEST_F(LoadedTextsTest, ItsPlacesCountBehindARestartThatMayHaveLeftItThere) {
  EXPECT_FALSE(places_of("IA1M4000,").empty());
  ++now.restarts;
  EXPECT_FALSE(places().empty());
}

TEST_F(LoadedTextsTest, TheQueueOfOneAxisIsReadToo) {
  const DeviceType& board = *find_device_type("vme58");
  const Catalog eight = *board.make_catalog({});
  LoadedTexts loaded(eight, &board.language());
  now.axis_count = static_cast<int>(eight.axes.size());
  now.axes[1].trust.doubt(Doubt::another, Instant{});
  const auto axes_of = [&](const std::string& text) {
    std::string axes;
    loaded.loaded(intent::LoadProgram(0, text));
    for (const AxisTarget& place : loaded.places_in_doubt(0, now))  // the least and the greatest
      if (const std::string& name = eight.axes[place.axis.index].name; !axes.ends_with(name)) axes += name;
    return axes;
  };
  EXPECT_EQ(axes_of("AX MA400 GO ID"), "X");
  EXPECT_EQ(axes_of("AY VL2000; MA400; GO; AX MR20 GO"), "Y");
  EXPECT_EQ(axes_of("AX MR400 GO ID"), "");
  EXPECT_EQ(axes_of("AX MR50 GO ID MA400 GO ID"), "X") << "MA goes by the count, wherever MR has moved it";
  EXPECT_EQ(axes_of("AX LP0 MA400 GO ID"), "") << "it says where it stands";
  EXPECT_EQ(axes_of("AX MA400 GO LP0"), "X") << "it goes there first";
  EXPECT_EQ(axes_of("AZ MA400 GO ID"), "") << "nothing is doubtful there";
}

TEST_F(LoadedTextsTest, AProgramWithVariablesIsReadToo) {
  const DeviceType& four = *find_device_type("pmx-4ex-sa");
  const Catalog axes = *four.make_catalog({});
  LoadedTexts loaded(axes, &four.language());
  const auto places_of = [&](const std::string& text) {
    loaded.loaded(intent::LoadProgram(0, text));
    return loaded.places_in_doubt(0, now);
  };
  const auto goes_there = places_of("V1=700\nWHILE V1>0\nXV1\nWAITX\nV1=V1-100\nENDWHILE\nEND\n");
  ASSERT_FALSE(goes_there.empty());
  EXPECT_EQ(goes_there[0].axis, AxisId{0});
  EXPECT_TRUE(places_of("V1=7\nINC\nX400\nWAITX\nABS\nEND\n").empty()) << "a distance";
  EXPECT_TRUE(places_of("V1=7\nHOMEX-\nWAITX\nX400\nWAITX\nEND\n").empty()) << "it homes first";
  EXPECT_TRUE(places_of("V1=7\nPX=0\nX400\nWAITX\nEND\n").empty()) << "it says where it stands";
  EXPECT_TRUE(places_of("V1=7\nY400\nWAITY\nEND\n").empty()) << "only X is doubtful";
  EXPECT_TRUE(places_of("V1=7\nGOSUB 1\nX400\nWAITX\nEND\nSUB 1\nHOMEX-\nWAITX\nENDSUB\n").empty())
      << "a subroutine homes it";
  EXPECT_FALSE(places_of("V1=7\nGOSUB 1\nX400\nWAITX\nEND\nSUB 1\nDO1=1\nENDSUB\n").empty());
}

TEST_F(LoadedTextsTest, AnErrorSubroutineCountsOnWhatHeldWhereverTheErrorCame) {
  const DeviceType& four = *find_device_type("pmx-4ex-sa");
  const Catalog axes = *four.make_catalog({});
  LoadedTexts loaded(axes, &four.language());
  const auto goes_away = [&](const std::string& text) {
    loaded.loaded(intent::LoadProgram(0, text));
    return !loaded.places_in_doubt(0, now).empty();
  };
  const std::string back = "END\nSUB 31\nECLEARX\nX0\nWAITX\nENDSUB\n";
  EXPECT_TRUE(goes_away("V1=7\nHOMEX-\nWAITX\nX400\nWAITX\n" + back)) << "the search itself may fail";
  EXPECT_TRUE(goes_away("V1=7\nPX=0\nX400\nWAITX\n" + back)) << "what sets its place may be refused";
  EXPECT_TRUE(goes_away("V1=7\nINC\nX400\nWAITX\n" + back)) << "it may not come to INC";
  EXPECT_TRUE(goes_away("V1=7\nINC\nX400\nWAITX\nABS\nY5\nWAITY\n" + back)) << "either";
  EXPECT_TRUE(goes_away("V1=1/V2\n" + back)) << "a division by 0, without any motion";
  EXPECT_TRUE(goes_away("V1=7\nINC\nX1000\nABS\nWAITX\n" + back)) << "it may come when ABS holds";
  EXPECT_TRUE(goes_away("PRG 0\nV1=1/V2\nEND\nSUB 31\nX0\nENDSUB\n")) << "a division by 0, without a motion";
  EXPECT_TRUE(goes_away("PRG 0\nINC\nX1000\nABS\nWAITX\nEND\nSUB 31\nX0\nENDSUB\n")) << "under ABS";
  EXPECT_FALSE(goes_away("V1=7\nHOMEX-\nWAITX\nEND\nSUB 31\nECLEARX\nHOMEX-\nWAITX\nX0\nENDSUB\n"));
}

TEST_F(LoadedTextsTest, OnlyTheProgramThatIsStartedAndWhatItStartsAreRead) {
  const DeviceType& four = *find_device_type("pmx-4ex-sa");
  const Catalog axes = *four.make_catalog({});
  LoadedTexts loaded(axes, &four.language());
  const auto is_sent_away = [&](int start, const std::string& text) {
    loaded.loaded(intent::LoadProgram(0, text));
    (void)loaded.places_in_doubt(1 - start, now);  // another was started before
    return !loaded.places_in_doubt(start, now).empty();
  };
  const std::string far = "X4000\nWAITX\nEND\n", homes = "HOMEX-\nWAITX\nX400\nWAITX\nEND\n";
  EXPECT_FALSE(is_sent_away(1, "PRG 0\n" + far + "PRG 1\n" + homes)) << "it homes, and program 0 rests";
  EXPECT_TRUE(is_sent_away(0, "PRG 0\n" + far + "PRG 1\n" + homes));
  EXPECT_TRUE(is_sent_away(1, "PRG 0\n" + homes + "PRG 1\n" + far));
  EXPECT_TRUE(is_sent_away(1, "PRG 0\n" + far + "PRG 1\nSR0=1\nEND\n")) << "it starts the other";
  EXPECT_FALSE(is_sent_away(1, "PRG 0\n" + far + "PRG 1\nHOMEX-\nWAITX\nSR0=1\nEND\n")) << "and has homed";
  EXPECT_FALSE(is_sent_away(1, "PRG 0\n" + far + "PRG 1\nSR0=0\nEND\n")) << "it stops the other";
  EXPECT_TRUE(is_sent_away(1, "PRG 1\nGOSUB 1\nEND\nPRG 0\nEND\nSUB 1\nX4000\nWAITX\nENDSUB\n"));
  EXPECT_FALSE(is_sent_away(1, "PRG 1\nEND\nPRG 0\nGOSUB 1\nEND\nSUB 1\nX4000\nWAITX\nENDSUB\n"));
  EXPECT_FALSE(is_sent_away(1, far)) << "there is no such program";
}

TEST_F(LoadedTextsTest, SubroutinesThatCallEachOtherEnd) {
  const DeviceType& four = *find_device_type("pmx-4ex-sa");
  const Catalog axes = *four.make_catalog({});
  LoadedTexts loaded(axes, &four.language());
  std::string text = "PRG 0\nV1=1\nGOSUB 1\nEND\nSUB 1\n";
  for (int n = 0; n < 60; ++n) text += "GOSUB 1\n";
  loaded.loaded(intent::LoadProgram(0, text + "X400\nWAITX\nENDSUB\n"));
  EXPECT_FALSE(loaded.places_in_doubt(0, now).empty());
}

TEST_F(LoadedTextsTest, NorOfALongOne) {
  std::string text;
  for (int line = 0; line < 250; ++line) text += "IA1M4000,\n";
  EXPECT_TRUE(places_of(text).empty());
}

class Thrower final : public Language {
 public:
  mutable int reads = 0;
  ProgramReport analyse(std::string_view, int) const override { return {}; }
  Result<Rehearsal> rehearse(std::string_view, const RehearseOptions&) const override {
    return fail(FaultKind::refused, "No.");
  }
  Result<SequenceText> write(const sequence::Sequence&, const Catalog&) const override {
    return fail(FaultKind::refused, "No.");
  }
  Result<SequenceRead> read(std::string_view, const sequence::Sequence&, const Catalog&) const override {
    ++reads;
    throw std::runtime_error("bad");
  }
};

TEST_F(LoadedTextsTest, NorOfOneThatCannotBeReadWhichIsTriedOnce) {
  const Thrower language;
  LoadedTexts unread(catalog, &language);
  unread.loaded(intent::LoadProgram(0, "IA1M4000,"));
  EXPECT_TRUE(unread.places_in_doubt(0, now).empty());
  EXPECT_TRUE(unread.places_in_doubt(0, now).empty());
  EXPECT_EQ(language.reads, 1);
}

}  // namespace
}  // namespace hw
