// From a drawing to a controller that draws it: the emulator goes through every vertex, and nowhere else with
// its tool down.
#include "core/session/conversion.h"

#include <fstream>

#include <gmock/gmock.h>

#include "core/drawing/dxf_reader.h"
#include "emulator_drawing.h"

namespace hw {
namespace {

using testing::HasSubstr;

std::string pairs(std::initializer_list<std::pair<int, std::string_view>> all) {
  std::string text;
  for (const auto& [code, value] : all) text += std::to_string(code) + "\n" + std::string(value) + "\n";
  return text;
}
/// An open corner of lines and a bulge, a circle, half an ellipse, a dot, and a word.
std::string drawing_text() {
  return pairs({{0, "SECTION"},   {2, "HEADER"},
                {9, "$INSUNITS"}, {70, "4"},
                {0, "ENDSEC"},    {0, "SECTION"},
                {2, "ENTITIES"},  {0, "LINE"},
                {8, "cut"},       {10, "1"},
                {20, "1"},        {11, "4"},
                {21, "2"},        {0, "LWPOLYLINE"},
                {8, "cut"},       {90, "3"},
                {70, "0"},        {10, "4"},
                {20, "2"},        {42, "0.5"},
                {10, "6"},        {20, "3"},
                {10, "6"},        {20, "5.5"},
                {0, "CIRCLE"},    {8, "round"},
                {10, "3"},        {20, "6"},
                {40, "1.25"},     {0, "ELLIPSE"},
                {8, "round"},     {10, "8"},
                {20, "2"},        {11, "1.5"},
                {21, "0.5"},      {40, "0.4"},
                {41, "0"},        {42, "3.141592653589793"},
                {0, "POINT"},     {8, "cut"},
                {10, "8"},        {20, "6"},
                {0, "TEXT"},      {8, "margin"},
                {10, "0"},        {20, "0"},
                {40, "1"},        {1, "a word"},
                {0, "LINE"},      {8, "margin"},
                {10, "-5"},       {20, "-5"},
                {11, "20"},       {21, "-5"},
                {0, "ENDSEC"},    {0, "EOF"}});
}
drawing::Drawing read() {
  auto read = drawing::read_dxf(drawing_text(), "a.dxf", drawing::Tolerance{0.002});
  EXPECT_TRUE(read) << read.error().sentence();
  return read ? *read : drawing::Drawing();
}

struct ConversionTest : testing::TestWithParam<const char*>, EmulatorDrawing {
  ConversionTest() : EmulatorDrawing(GetParam()) {
    o.layers = {"cut"};
    if (!catalog.can.one_axis_at_a_time) o.layers.push_back("round");  // of a VXM they would not fit
  }
};
INSTANTIATE_TEST_SUITE_P(Every, ConversionTest, testing::Values("vxm", "pmx-4ex-sa", "vme58"),
                         [](const auto& info) { return std::string(info.param).substr(0, 3); });

TEST_P(ConversionTest, TheToolGoesThroughEveryVertexAndNowhereElse) {
  ASSERT_NO_FATAL_FAILURE(draw(read()));
  EXPECT_EQ(made.chains.size(), o.layers.size() == 1 ? 2u : 4u) << "the line and the polyline touch";
  expect_every_vertex();
  expect_nothing_beside();
  EXPECT_EQ(rehearsal.outputs.at(std::to_string(output_number())), 0) << "the tool is up";
}

TEST_P(ConversionTest, ADrawingThatLeavesTheTableSaysWhere) {
  drawing::Box table;
  table.add({0, 0}), table.add({7, 8});
  o.table = table;
  const auto converted = convert(read(), catalog, o);
  ASSERT_TRUE(converted) << converted.error().sentence();
  EXPECT_EQ(converted->off_the_table.size(), o.layers.size())
      << "the dot, and the ellipse where there is one";
}

TEST_P(ConversionTest, WhatIsMissingIsAskedFor) {
  const auto refusal = [&] {
    const auto converted = convert(read(), catalog, o);
    return converted ? std::string("converted") : converted.error().sentence();
  };
  o.layers = {"engrave"};
  EXPECT_THAT(refusal(), HasSubstr("no layer \"engrave\""));
  o.layers = {};
  EXPECT_EQ(refusal(), "converted");
  drawing::Drawing none = read();
  none.unit.clear();
  EXPECT_THAT(convert(none, catalog, o).error().sentence(), HasSubstr("does not say in which unit"));
  o.axes.pop_back();
  EXPECT_THAT(refusal(), HasSubstr("A drawing needs two axes; 1 is given."));
}

TEST_P(ConversionTest, WhatIsOutOfTheReachOfItsCountersIsRefusedByItsStep) {
  const auto refusal = [&](drawing::Curve curve) {
    drawing::Drawing far;
    far.unit = "mm", far.layers = {{"0", true}};
    far.paths = {{{curve}, 1, 2, 0}};
    o.layers.clear();
    const auto converted = convert(far, catalog, o);
    EXPECT_TRUE(converted);
    const auto written = type.language().write(converted->sequence, catalog);
    return written ? written->text : written.error().sentence();
  };
  const double reach = static_cast<double>(catalog.position_max.value) / per_unit;
  const auto line = drawing::Curve::Kind::line;
  EXPECT_THAT(refusal({line, {0, 0}, {reach + 1, 0}, {}, 0}),
              testing::ContainsRegex("[Ss]tep [0-9]+.*goes from"));
  EXPECT_THAT(refusal({line, {0, 0}, {1e30, 0}, {}, 0}), testing::ContainsRegex("[Ss]tep [0-9]+.*goes from"));
  if (going_of(catalog) != drawing::Going::arcs) return;
  const double radius = reach - 2;
  EXPECT_THAT(refusal({drawing::Curve::Kind::arc, {radius, 0}, {0, radius}, {0, 0}, 90}),
              HasSubstr("134216773 is the largest"));
}

TEST(Conversion, AFileOfHalfAGigabyteIsNotRead) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "large.dxf";
  std::ofstream(file) << drawing_text();
  std::filesystem::resize_file(file, 500'000'000);  // of holes
  const auto drawing = read_drawing(file, {});
  std::filesystem::remove(file);
  ASSERT_FALSE(drawing);
  EXPECT_THAT(drawing.error().sentence(), HasSubstr("large.dxf is larger than 256000 kB"));
}

TEST_P(ConversionTest, StairsNeedATolerance) {
  o.tolerance.reset();
  const auto converted = convert(read(), catalog, o);
  if (going_of(catalog) == drawing::Going::stairs) {
    ASSERT_FALSE(converted);
    EXPECT_THAT(converted.error().sentence(), HasSubstr("how far its corners may lie beside the line"));
  } else {
    ASSERT_TRUE(converted);
    EXPECT_EQ(converted->tolerance, 0.5 / per_unit);
  }
}

}  // namespace
}  // namespace hw
