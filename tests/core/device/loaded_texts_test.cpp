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
    texts.loaded(intent::LoadProgram(0, text), now.restarts);
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
  EXPECT_TRUE(places_of("I1M-0,P5,IA1M-0,IA1M4000,").empty()) << "no block says that here is zero";
  EXPECT_TRUE(places_of("IA1M-0,IA1M4000,").empty());
  EXPECT_FALSE(places_of("IA1M4000,I1M-0,P5,IA1M-0,").empty()) << "it goes there first";
}

TEST_F(LoadedTextsTest, NothingIsKnownBehindARestart) {
  EXPECT_FALSE(places_of("IA1M4000,").empty());
  ++now.restarts;
  EXPECT_TRUE(places().empty());
  EXPECT_FALSE(places_of("IA1M4000,").empty()) << "loaded again";
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
  unread.loaded(intent::LoadProgram(0, "IA1M4000,"), now.restarts);
  EXPECT_TRUE(unread.places_in_doubt(0, now).empty());
  EXPECT_TRUE(unread.places_in_doubt(0, now).empty());
  EXPECT_EQ(language.reads, 1);
}

}  // namespace
}  // namespace hw
