// The transcripts in tests/talk/vme58, said through the rings of the window in virtual time.
#include "tests/talk/talk_test.h"

#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {
namespace {

class Vme58Talk : public ::testing::TestWithParam<std::string> {};

TEST_P(Vme58Talk, GoesAsWritten) {
  talk::goes_as_written(GetParam(),
                        [](const DeviceOptions& options) { return talk::RigPartner<Rig>(Rig(options)); });
}

INSTANTIATE_TEST_SUITE_P(Transcripts, Vme58Talk, ::testing::ValuesIn(talk::transcripts("vme58")),
                         talk::test_name);

}  // namespace
}  // namespace hw::vme58::proof
