// Drawings that other software has written, and one of our own for each corner of the format: what is read
// agrees with what ezdxf reads in them, and nothing that is left out goes unsaid.
#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/drawing/dxf_reader.h"
#include "dxf_table.h"

namespace hw::drawing {

static void PrintTo(const ExpectedDrawing& e, std::ostream* out) { *out << name_of(e); }

namespace {

constexpr Tolerance fine{1e-5};

class DxfFiles : public testing::TestWithParam<ExpectedDrawing> {
 protected:
  /// Without what frozen and switched off layers hide.
  static Drawing shown(Drawing drawing) {
    std::erase_if(drawing.paths, [&](const Path& path) {
      return !drawing.layers[static_cast<std::size_t>(path.layer)].shown;
    });
    return drawing;
  }
  static void expect_left_out(const Drawing& drawing, const std::vector<std::string>& expected) {
    std::map<int, std::string> reported;  // in the order of the file
    for (const LeftOut& l : drawing.left_out)
      reported[l.entity] += fmt::format("{} {} {}: {}", l.entity, l.what, l.line, l.why);
    std::vector<std::string> rows;
    for (const auto& [entity, row] : reported) rows.push_back(row);
    ASSERT_EQ(rows.size(), expected.size()) << testing::PrintToString(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool with_reason = expected[i].find(':') != std::string::npos;
      EXPECT_EQ(with_reason ? rows[i] : rows[i].substr(0, rows[i].find(':')), expected[i]);
    }
  }
};

TEST_P(DxfFiles, AreReadAsOthersReadThem) {
  const ExpectedDrawing& e = GetParam();
  const std::string text = text_of(e.file);
  const auto read = read_dxf(text, e.file.filename().string(), fine);
  if (!e.refused.empty()) {
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().sentence(), testing::HasSubstr(e.refused));
    return;
  }
  ASSERT_TRUE(read) << read.error().sentence();
  expect_left_out(*read, e.left_out);
  const Drawing drawing = shown(*read);
  EXPECT_EQ(drawing.paths.size(), e.paths);
  EXPECT_EQ(drawing.unit, e.unit == "none" ? "" : e.unit);
  const double within = e.exact ? 1e-6 : 10 * fine.chord;
  EXPECT_NEAR(length_of(drawing), e.length, e.exact ? within : 1e-5 * e.length);
  const Box box = box_of(drawing);
  EXPECT_EQ(box.empty, e.paths == 0);
  EXPECT_NEAR(box.low.x, e.left, within);
  EXPECT_NEAR(box.low.y, e.bottom, within);
  EXPECT_NEAR(box.high.x, e.right, within);
  EXPECT_NEAR(box.high.y, e.top, within);
}

INSTANTIATE_TEST_SUITE_P(Each, DxfFiles, testing::ValuesIn(expected_drawings()),
                         [](const auto& info) { return name_of(info.param); });

TEST(DxfTable, HoldsEveryFile) {
  const std::vector<ExpectedDrawing> all = expected_drawings();
  std::size_t files = 0, own = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(HW_TEST_DIR) /
                                                                         "core/drawing/files"))
    if (entry.path().extension() == ".dxf") {
      ++files;
      own += entry.path().parent_path().filename() == "own" ? 1 : 0;
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const ExpectedDrawing& e) {
        return std::filesystem::equivalent(e.file, entry.path());
      })) << entry.path();
    }
  EXPECT_EQ(files, all.size());
  EXPECT_GE(own, 40u);
}

}  // namespace
}  // namespace hw::drawing
