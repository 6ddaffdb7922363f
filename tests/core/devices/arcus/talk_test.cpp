// The transcripts in tests/talk/pmx-4ex-sa and tests/talk/dmx-k-sa, held against the emulators in virtual
// time.
#include "tests/talk/talk_test.h"

#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

class ArcusTalk : public ::testing::TestWithParam<std::string> {};

TEST_P(ArcusTalk, GoesAsWritten) {
  const Which which = GetParam().starts_with("pmx-4ex-sa/") ? Which::pmx : Which::dmx;
  talk::goes_as_written(
      GetParam(), [which](const Options& options) { return talk::RigPartner<Rig>(Rig(which, options)); });
}

INSTANTIATE_TEST_SUITE_P(Pmx, ArcusTalk, ::testing::ValuesIn(talk::transcripts("pmx-4ex-sa")),
                         talk::test_name);
INSTANTIATE_TEST_SUITE_P(Dmx, ArcusTalk, ::testing::ValuesIn(talk::transcripts("dmx-k-sa")), talk::test_name);

}  // namespace
}  // namespace hw::arcus::proof
