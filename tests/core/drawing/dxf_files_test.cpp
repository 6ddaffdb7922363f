// Drawings that other software has written: what is read agrees with what that software itself reads in them
// (files/expected.txt, made by make_files.py).
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "core/drawing/dxf_reader.h"

namespace hw::drawing {
namespace {

const std::string folder = HW_TEST_DIR "/core/drawing/files/";

struct Expected {
  std::string name;
  std::size_t paths = 0;
  double length = 0, left = 0, bottom = 0, right = 0, top = 0;
  bool exact = false;
};
std::ostream& operator<<(std::ostream& out, const Expected& e) { return out << e.name; }

std::vector<Expected> expected() {
  std::vector<Expected> all;
  std::ifstream in(folder + "expected.txt");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    Expected e;
    std::string exact;
    words >> e.name >> e.paths >> e.length >> e.left >> e.bottom >> e.right >> e.top >> exact;
    e.exact = exact == "exact";
    all.push_back(e);
  }
  return all;
}

class DxfFiles : public testing::TestWithParam<Expected> {};

TEST_P(DxfFiles, AreReadAsTheirOwnProgramReadsThem) {
  const Expected& e = GetParam();
  std::ifstream in(folder + e.name, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  const Tolerance tolerance{1e-5};
  const auto drawing = read_dxf(text.str(), e.name, tolerance);
  ASSERT_TRUE(drawing) << drawing.error().sentence();
  for (const LeftOut& l : drawing->left_out)
    ADD_FAILURE() << l.what << " of line " << l.line << ": " << l.why;
  EXPECT_EQ(drawing->paths.size(), e.paths);
  const double within = e.exact ? 1e-6 : 10 * tolerance.chord;
  EXPECT_NEAR(length_of(*drawing), e.length, e.exact ? within : 1e-5 * e.length);
  const Box box = box_of(*drawing);
  EXPECT_NEAR(box.low.x, e.left, within);
  EXPECT_NEAR(box.low.y, e.bottom, within);
  EXPECT_NEAR(box.high.x, e.right, within);
  EXPECT_NEAR(box.high.y, e.top, within);
}

INSTANTIATE_TEST_SUITE_P(Each, DxfFiles, testing::ValuesIn(expected()), [](const auto& info) {
  return info.param.name.substr(0, info.param.name.find('.'));
});

}  // namespace
}  // namespace hw::drawing
