// From a drawing to a controller that draws it: the emulator goes through every vertex, and nowhere else with
// its tool down.
#include "core/session/conversion.h"

#include <cmath>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>

#include "core/device/pieces_together.h"
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

TEST_P(ConversionTest, ADrawingThatLeavesTheTableReportsWhere) {
  drawing::Box table;
  table.add({0, 0}), table.add({7, 8});
  o.table = table;
  const auto converted = convert(read(), catalog, o);
  ASSERT_TRUE(converted) << converted.error().sentence();
  EXPECT_EQ(converted->off_the_table.size(), o.layers.size())
      << "the dot, and the ellipse where there is one";
}

TEST_P(ConversionTest, AMissingLayerUnitOrAxisIsNamed) {
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
  EXPECT_THAT(convert(none, catalog, o).error().sentence(), HasSubstr("does not name its unit"));
  o.axes.pop_back();
  EXPECT_THAT(refusal(), HasSubstr("A drawing needs two axes; 1 is given."));
}

TEST_P(ConversionTest, AnAxisDrawsInOneDirectionAndDoesNotLowerTheToolToo) {
  const auto refusal = [&] {
    const auto converted = convert(read(), catalog, o);
    return converted ? std::string("converted") : converted.error().sentence();
  };
  o.axes.push_back(o.axes[0]);
  EXPECT_THAT(refusal(), HasSubstr("draws, and so cannot lower the tool"));
  o.axes = {o.axes[0], o.axes[0]};
  EXPECT_THAT(refusal(), HasSubstr("would be both axes of the drawing"));
}

TEST_P(ConversionTest, AToleranceOrScaleThatLosesTheShapeIsRefused) {
  const auto refusal = [&] {
    const auto converted = convert(read(), catalog, o);
    return converted ? std::string("converted") : converted.error().sentence();
  };
  o.tolerance = 1000;
  EXPECT_THAT(refusal(), HasSubstr("A tolerance of 1000 mm is larger than the whole drawing"));
  o.tolerance = 0.1;
  for (sequence::Axis& axis : o.axes) axis.per_unit = 1e-9;
  EXPECT_THAT(refusal(), HasSubstr("The whole drawing is smaller than one of the"));
}

TEST_P(ConversionTest, ALayerIsTheSameInCapitalsAndAnUnknownOneListsThem) {
  o.layers = {"CUT"};
  EXPECT_TRUE(convert(read(), catalog, o));
  o.layers = {"engrave"};
  EXPECT_THAT(convert(read(), catalog, o).error().sentence(), HasSubstr("It has \"cut\""));
}

TEST(Conversion, ContoursNeedAGivenSpeed) {
  EmulatorDrawing vme("vme58");
  vme.o.cutting = {};
  EXPECT_THAT(convert(read(), vme.catalog, vme.o).error().sentence(),
              HasSubstr("Give the speed with the tool on."));
}

TEST_P(ConversionTest, OneSpeedAloneIsNotTakenForTheOther) {
  const auto refusal = [&] {
    const auto converted = convert(read(), catalog, o);
    return converted ? std::string("converted") : converted.error().sentence();
  };
  o.cutting_name = "--cut-speed", o.travel_name = "--travel-speed";
  o.cutting = {}, o.travel = {20, 0, 0};
  EXPECT_THAT(refusal(), HasSubstr("Give --cut-speed")) << "it would cut as fast as it travels";
  o.cutting = {10, 0, 0}, o.travel = {};
  if (catalog.can.contours)
    EXPECT_EQ(refusal(), "converted") << "a contour has a speed of its own";
  else
    EXPECT_THAT(refusal(), HasSubstr("Give --travel-speed too."));
}

/// What is said of a drawing that is this curve.
class FarConversionTest : public ConversionTest {
 protected:
  std::string refusal(const drawing::Curve& curve) {
    drawing::Drawing far;
    far.unit = "mm", far.layers = {{"0", true}};
    far.paths = {{{curve}, 1, 2, 0}};
    o.layers.clear();
    const auto converted = convert(far, catalog, o);
    if (!converted) return converted.error().sentence();
    const auto written = type.language().write(converted->sequence, catalog);
    return written ? written->text : written.error().sentence();
  }
};
INSTANTIATE_TEST_SUITE_P(Every, FarConversionTest, testing::Values("vxm", "pmx-4ex-sa", "vme58"),
                         [](const auto& info) { return std::string(info.param).substr(0, 3); });

TEST_P(FarConversionTest, IsRefusedByItsStep) {
  const double reach = static_cast<double>(catalog.position_max.value) / per_unit;
  const auto line = drawing::Curve::Kind::line;
  EXPECT_THAT(refusal({line, {0, 0}, {reach + 1, 0}, {}, 0}),
              testing::ContainsRegex("(Entity|[Ss]tep) [0-9]+.*the range of a "));
  EXPECT_THAT(refusal({line, {0, 0}, {1e12, 0}, {}, 0}),
              testing::ContainsRegex("(Entity|[Ss]tep) [0-9]+.*the range of a "));
  for (const double far : {1e30, -1e300}) {
    const std::string sentence = refusal({line, {0, 0}, {far, 0}, {}, 0});
    EXPECT_THAT(sentence,
                HasSubstr(far > 0 ? "Entity 1, line 2 of the file, reaches 1e+30 mm" : "reaches -1e+300 mm"));
    EXPECT_LT(sentence.size(), 160u) << sentence;
  }
}

TEST_P(FarConversionTest, AnArcIsRefusedByTheLargestThatIsPossible) {
  if (curve_mode_of(catalog) != drawing::CurveMode::arcs) GTEST_SKIP() << "it draws no arcs";
  const double radius = static_cast<double>(catalog.position_max.value) / per_unit - 2;
  EXPECT_THAT(refusal({drawing::Curve::Kind::arc, {radius, 0}, {0, radius}, {0, 0}, 90}),
              HasSubstr("134216773 is the largest"));
}

/// Of a file that says it is in mm.
std::filesystem::path file_of(const char* name, std::initializer_list<std::pair<int, std::string_view>> all) {
  std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file) << pairs({{0, "SECTION"}, {2, "HEADER"}, {9, "$INSUNITS"}, {70, "4"}, {0, "ENDSEC"}})
                      << pairs({{0, "SECTION"}, {2, "ENTITIES"}}) << pairs(all)
                      << pairs({{0, "ENDSEC"}, {0, "EOF"}});
  return file;
}
/// How far the corners of a VXM's stairs lie beside what `at` goes along, for t from 0 to 1.
double farthest_corner(const std::filesystem::path& file, double tolerance,
                       const std::function<drawing::Point(double t)>& at) {
  const Catalog catalog = *find_device_type("vxm")->make_catalog({});
  ConversionOptions o;
  o.axes = {{"1", 1000}, {"2", 1000}};
  o.tolerance = tolerance;
  const auto drawing = read_drawing(file, catalog, o);
  EXPECT_TRUE(drawing) << drawing.error().sentence();
  const auto made = convert(*drawing, catalog, o);
  EXPECT_TRUE(made) << made.error().sentence();
  std::vector<drawing::Point> curve;
  for (int n = 0; n <= 5'000; ++n) curve.push_back(at(n / 5'000.0));
  drawing::Point corner;
  double farthest = 0;  // squared
  for (const sequence::Step& step : made->sequence.steps) {
    const auto* move = std::get_if<sequence::Move>(&step.body);
    if (!move) continue;
    corner = {move->to[0].value_or(corner.x), move->to[1].value_or(corner.y)};
    if (&step - made->sequence.steps.data() < 3) continue;  // one axis, then the other, to its begin
    double nearest = 1e18;
    for (const drawing::Point& on : curve) {
      const double dx = on.x - corner.x, dy = on.y - corner.y, squares = dx * dx + dy * dy;
      if (squares < nearest) nearest = squares;
    }
    if (nearest > farthest) farthest = nearest;
  }
  return std::sqrt(farthest);
}

// Flattened, and then made into stairs: both together keep what was asked for.
TEST(Conversion, StairsOfCurvesStayWithinTheTolerance) {
  const auto spline =
      file_of("spline.dxf",
              {{0, "SPLINE"}, {8, "0"},   {70, "8"}, {71, "3"},  {72, "8"},  {73, "4"},  {74, "0"}, {40, "0"},
               {40, "0"},     {40, "0"},  {40, "0"}, {40, "1"},  {40, "1"},  {40, "1"},  {40, "1"}, {10, "0"},
               {20, "0"},     {10, "40"}, {20, "0"}, {10, "60"}, {20, "20"}, {10, "60"}, {20, "60"}});
  const auto ellipse = file_of("ellipse.dxf", {{0, "ELLIPSE"},
                                               {8, "0"},
                                               {10, "0"},
                                               {20, "0"},
                                               {11, "40"},
                                               {21, "0"},
                                               {40, "0.5"},
                                               {41, "0"},
                                               {42, "6.283185307179586"}});
  for (const double tolerance : {2.0, 0.5, 0.1}) {
    const double off_spline = farthest_corner(spline, tolerance, [](double t) {
      const double u = 1 - t, b = 3 * t * u * u, c = 3 * t * t * u, d = t * t * t;
      return drawing::Point{40 * b + 60 * c + 60 * d, 20 * c + 60 * d};
    });
    EXPECT_LE(off_spline, tolerance) << "spline";
    EXPECT_GT(off_spline, tolerance / 4) << "it is used";
    EXPECT_LE(farthest_corner(ellipse, tolerance,
                              [](double t) {
                                const double angle = t * 2 * std::acos(-1);
                                return drawing::Point{40 * std::cos(angle), 20 * std::sin(angle)};
                              }),
              tolerance)
        << "ellipse";
  }
  std::filesystem::remove(spline), std::filesystem::remove(ellipse);
}

TEST(Conversion, CurvesAreAsFineWhenTheyAreDrawnLarger) {
  const auto file = file_of("larger.dxf", {{0, "ELLIPSE"},
                                           {8, "0"},
                                           {10, "0"},
                                           {20, "0"},
                                           {11, "40"},
                                           {21, "0"},
                                           {40, "0.5"},
                                           {41, "0"},
                                           {42, "6.283185307179586"}});
  const Catalog catalog = *find_device_type("vxm")->make_catalog({});
  ConversionOptions o;
  o.axes = {{"1", 1000}, {"2", 1000}};
  o.tolerance = 0.5;
  const auto curves_at = [&](double times) {
    o.times = times;
    const auto drawing = read_drawing(file, catalog, o);
    EXPECT_TRUE(drawing) << drawing.error().sentence();
    return drawing->paths.front().curves.size();
  };
  const std::size_t as_drawn = curves_at(1), larger = curves_at(100);
  std::filesystem::remove(file);
  EXPECT_GT(larger, as_drawn * 2);
}

TEST(Conversion, AFileOfHalfAGigabyteIsNotRead) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "large.dxf";
  std::ofstream(file) << drawing_text();
  std::filesystem::resize_file(file, 500'000'000);  // of holes
  const auto drawing = read_drawing(file, {}, {});
  std::filesystem::remove(file);
  ASSERT_FALSE(drawing);
  EXPECT_THAT(drawing.error().sentence(),
              HasSubstr("large.dxf has 500 MB: a file of more than 256 MB is not read."));
}

TEST_P(ConversionTest, AnEntityOutOfRangeIsNamedWithItsLine) {
  const std::string header = pairs({{0, "SECTION"}, {2, "ENTITIES"}, {0, "CIRCLE"}, {8, "0"}});
  const auto far =
      drawing::read_dxf(header + "10\n0\n20\n0\n40\n2000000\n" + pairs({{0, "ENDSEC"}, {0, "EOF"}}), "a.dxf",
                        drawing::Tolerance{1});
  ASSERT_TRUE(far) << far.error().sentence();
  o.drawing_unit = "mm", o.layers.clear();
  const auto converted = convert(*far, catalog, o);
  ASSERT_FALSE(converted) << "and no memory is filled with it before";
  EXPECT_THAT(converted.error().sentence(), HasSubstr("Entity 1, line 6 of the file, reaches"));
  EXPECT_THAT(converted.error().sentence(), HasSubstr("the range of a " + catalog.short_name + " is "));
}

TEST(Conversion, AnOutlineIsShownWhereTheUnitIsNotGiven) {
  const std::string lines = pairs({{0, "SECTION"}, {2, "ENTITIES"}, {0, "LINE"}, {8, "0"}}) +
                            "10\n10\n20\n20\n11\n40\n21\n60\n" + pairs({{0, "ENDSEC"}, {0, "EOF"}});
  const auto drawing = drawing::read_dxf(lines, "a.dxf", {});
  ASSERT_TRUE(drawing) << drawing.error().sentence();
  ConversionOptions o;
  o.placing.origin = drawing::Placing::Origin::lower_left;
  auto outline = outline_of(*drawing, o);
  ASSERT_TRUE(outline) << outline.error().sentence();
  EXPECT_FALSE(outline->unit_is_given);
  EXPECT_DOUBLE_EQ(outline->path.way_on, 50);
  o.drawing_unit = "in", o.times = 0.5;
  outline = outline_of(*drawing, o);
  ASSERT_TRUE(outline);
  EXPECT_TRUE(outline->unit_is_given);
  EXPECT_NEAR(outline->path.way_on, 50 * 25.4 / 2, 1e-9);
  EXPECT_NEAR(outline->path.points.back().y, 40 * 25.4 / 2, 1e-9);
}

TEST_P(ConversionTest, AGivenUnitOverridesTheFile) {
  auto sentence = drawing::read_dxf(drawing_text(), "a.dxf", drawing::Tolerance{0.01});
  ASSERT_TRUE(sentence) << sentence.error().sentence();
  sentence->unit = "mm";
  const auto by_file = convert(*sentence, catalog, o);
  ASSERT_TRUE(by_file) << by_file.error().sentence();
  o.drawing_unit = "cm", o.times = 0.2;
  const auto by_user = convert(*sentence, catalog, o);
  ASSERT_TRUE(by_user) << by_user.error().sentence();
  EXPECT_NEAR(by_user->drawn, 2 * by_file->drawn, 1e-6 * by_file->drawn);
}

TEST(Conversion, EveryUnitOfADxfFileHasALength) {
  for (int number = 1; number <= 24; ++number) {
    const std::string header = pairs({{0, "SECTION"}, {2, "HEADER"}, {9, "$INSUNITS"}}) + "70\n" +
                               std::to_string(number) + "\n" + pairs({{0, "ENDSEC"}, {0, "EOF"}});
    const auto drawing = drawing::read_dxf(header, "a.dxf", {});
    ASSERT_TRUE(drawing) << drawing.error().sentence();
    EXPECT_TRUE(millimetres(drawing->unit)) << number << ": " << drawing->unit;
  }
  EXPECT_DOUBLE_EQ(*millimetres("yd"), 914.4);
  EXPECT_DOUBLE_EQ(*millimetres("km"), 1e6);
  EXPECT_FALSE(millimetres(""));
}

TEST(Conversion, OfToolsThatSeveralDrawWithItIsReportedWhatALostLinkMeans) {
  std::vector<Catalog> members;
  for (const char* id : {"01", "02"})
    members.push_back(*find_device_type("dmx-k-sa")->make_catalog({{"id", id}}));
  const std::vector<const Catalog*> all{&members[0], &members[1]};
  const auto together = catalog_together(all);
  ASSERT_TRUE(together);
  sequence::Sequence s;
  s.axes = {{"01", 100}, {"02", 100}};
  EXPECT_EQ(*tool_remark(s, *together), "") << "it has none";
  s.pen_down = {{sequence::Output{1, true}}}, s.pen_up = {{sequence::Output{1, false}}};
  s.steps = {{sequence::Pen{true}}, {sequence::Pen{false}}};
  EXPECT_THAT(*tool_remark(s, *together), HasSubstr("output 1"));
  EXPECT_THAT(*tool_remark(s, *together),
              HasSubstr("While the link is lost the console cannot switch it off"));
}

TEST_P(ConversionTest, TheWayWithTheToolUpIsTheOneThatTheMachineGoes) {
  const auto made = convert(read(), catalog, o);
  ASSERT_TRUE(made) << made.error().sentence();
  const bool in_turn = curve_mode_of(catalog) == drawing::CurveMode::stairs;
  double way = 0;
  drawing::Point at;
  for (const drawing::Chain& chain : made->chains) {
    const double dx = std::fabs(chain.begin().x - at.x), dy = std::fabs(chain.begin().y - at.y);
    way += in_turn ? dx + dy : std::hypot(dx, dy);
    at = chain.end();
  }
  EXPECT_NEAR(made->way, way, 1e-9);
}

TEST_P(ConversionTest, StairsNeedATolerance) {
  o.tolerance.reset();
  const auto converted = convert(read(), catalog, o);
  if (curve_mode_of(catalog) == drawing::CurveMode::stairs) {
    ASSERT_FALSE(converted);
    EXPECT_THAT(converted.error().sentence(), HasSubstr("how far its corners may lie from the line"));
  } else {
    ASSERT_TRUE(converted);
    EXPECT_EQ(converted->tolerance, 0.5 / per_unit);
  }
}

}  // namespace
}  // namespace hw
