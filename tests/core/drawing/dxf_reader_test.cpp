// Drawing files as drawings: every kind of entity, where it is put, and what is told of what is left out.
#include "core/drawing/dxf_reader.h"

#include <cmath>
#include <initializer_list>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace hw::drawing {
namespace {

using testing::HasSubstr;

constexpr double near = 1e-9;

/// Group codes and values.
struct Group {
  int code;
  std::string value;
  Group(int c, int v) : code(c), value(fmt::format("{}", v)) {}
  Group(int c, double v) : code(c), value(fmt::format("{}", v)) {}
  Group(int c, const char* v) : code(c), value(v) {}
};

std::string groups(std::initializer_list<Group> all) {
  std::string text;
  for (const Group& g : all) text += fmt::format("{:>3}\n{}\n", g.code, g.value);
  return text;
}
std::string section(const char* name, const std::string& content) {
  return groups({{0, "SECTION"}, {2, name}}) + content + groups({{0, "ENDSEC"}});
}
std::string file(const std::string& entities, const std::string& before = {}) {
  return before + section("ENTITIES", entities) + groups({{0, "EOF"}});
}
std::string line(double x1, double y1, double x2, double y2, const char* layer = "0") {
  return groups({{0, "LINE"}, {8, layer}, {10, x1}, {20, y1}, {30, 0}, {11, x2}, {21, y2}, {31, 0}});
}
std::string block(const char* name, const std::string& content, double x = 0, double y = 0) {
  return groups({{0, "BLOCK"}, {8, "0"}, {2, name}, {70, 0}, {10, x}, {20, y}, {30, 0}}) + content +
         groups({{0, "ENDBLK"}, {8, "0"}});
}

Drawing read(const std::string& text, double chord = 0.001) {
  auto drawing = read_dxf(text, "a.dxf", Tolerance{chord});
  EXPECT_TRUE(drawing) << drawing.error().sentence();
  return drawing ? *drawing : Drawing();
}

void expect_box(const Drawing& d, double x1, double y1, double x2, double y2, double within = near) {
  const Box box = box_of(d);
  EXPECT_NEAR(box.low.x, x1, within);
  EXPECT_NEAR(box.low.y, y1, within);
  EXPECT_NEAR(box.high.x, x2, within);
  EXPECT_NEAR(box.high.y, y2, within);
}

TEST(DxfReader, LinesPointsArcsAndCircles) {
  const Drawing d =
      read(file(line(0, 0, 3, 4, "cut") + groups({{0, "POINT"}, {8, "0"}, {10, 7}, {20, 8}, {30, 0}}) +
                groups({{0, "ARC"}, {8, "0"}, {10, 1}, {20, 2}, {40, 2}, {50, 350}, {51, 100}}) +
                groups({{0, "CIRCLE"}, {8, "0"}, {10, -1}, {20, -1}, {40, 0.5}})));
  ASSERT_EQ(d.paths.size(), 4u);
  EXPECT_DOUBLE_EQ(d.paths[0].curves[0].length(), 5);
  EXPECT_EQ(d.layers[static_cast<std::size_t>(d.paths[0].layer)].name, "cut");
  EXPECT_EQ(d.paths[1].curves[0].from, (Point{7, 8}));
  const Curve& arc = d.paths[2].curves[0];
  EXPECT_NEAR(arc.degrees, 110, near);
  EXPECT_NEAR(arc.from.x, 1 + 2 * std::cos(-10 * std::acos(-1) / 180), near);
  EXPECT_NEAR(d.paths[3].curves[0].degrees, 360, near);
  EXPECT_TRUE(d.paths[3].closed());
  EXPECT_NEAR(length_of(d), 5 + 2 * 110 / 180. * std::acos(-1) + std::acos(-1), near);
  expect_box(d, -1.5, -1.5, 7, 8);
  EXPECT_TRUE(d.left_out.empty());
}

TEST(DxfReader, APolylineStaysOnePathAndItsBulgesAreArcs) {
  // A square whose right side is a half circle outwards: 2 wide and high.
  const Drawing d = read(file(groups({{0, "LWPOLYLINE"},
                                      {8, "0"},
                                      {90, 4},
                                      {70, 1},
                                      {10, 0},
                                      {20, 0},
                                      {10, 2},
                                      {20, 0},
                                      {42, 1},
                                      {10, 2},
                                      {20, 2},
                                      {10, 0},
                                      {20, 2}})));
  ASSERT_EQ(d.paths.size(), 1u);
  ASSERT_EQ(d.paths[0].curves.size(), 4u);
  EXPECT_TRUE(d.paths[0].closed());
  EXPECT_EQ(d.paths[0].curves[1].kind, Curve::Kind::arc);
  EXPECT_NEAR(d.paths[0].curves[1].degrees, 180, near);
  EXPECT_EQ(d.paths[0].curves[2].from, d.paths[0].curves[1].to);
  expect_box(d, 0, 0, 3, 2);
}

TEST(DxfReader, AnOldPolylineIsTheSame) {
  const auto vertex = [](double x, double y, double bulge) {
    return groups({{0, "VERTEX"}, {8, "0"}, {10, x}, {20, y}, {30, 0}, {42, bulge}});
  };
  const Drawing d = read(file(
      groups({{0, "POLYLINE"}, {8, "pen"}, {66, 1}, {10, 0}, {20, 0}, {30, 0}, {70, 0}}) + vertex(0, 0, 0) +
      vertex(1, 0, -1) + vertex(3, 0, 0) + groups({{0, "SEQEND"}, {8, "0"}}) + line(9, 9, 8, 8)));
  ASSERT_EQ(d.paths.size(), 2u);
  EXPECT_EQ(d.layers[static_cast<std::size_t>(d.paths[0].layer)].name, "pen");
  ASSERT_EQ(d.paths[0].curves.size(), 2u);
  EXPECT_NEAR(d.paths[0].curves[1].degrees, -180, near);
  EXPECT_FALSE(d.paths[0].closed());
  expect_box(d, 0, 0, 9, 9);
}

TEST(DxfReader, AnEllipseAndASplineAreWithinTheTolerance) {
  const double chord = 1e-4, pi = std::acos(-1);
  const Drawing ellipse = read(file(groups({{0, "ELLIPSE"},
                                            {8, "0"},
                                            {100, "AcDbEllipse"},
                                            {10, 1},
                                            {20, 1},
                                            {30, 0},
                                            {11, 3},
                                            {21, 0},
                                            {31, 0},
                                            {40, 0.5},
                                            {41, 0},
                                            {42, 2 * pi}})),
                               chord);
  ASSERT_EQ(ellipse.paths.size(), 1u);
  EXPECT_TRUE(ellipse.paths[0].curves.size() > 50);
  expect_box(ellipse, -2, -0.5, 4, 2.5, chord);
  EXPECT_NEAR(length_of(ellipse), 14.532661309, 0.01);
  // A quarter of a circle as a weighted spline.
  const Drawing spline = read(file(groups({{0, "SPLINE"}, {8, "0"}, {70, 4}, {71, 2}, {72, 6},
                                           {73, 3},       {74, 0},  {40, 0}, {40, 0}, {40, 0},
                                           {40, 1},       {40, 1},  {40, 1}, {41, 1}, {41, std::sqrt(0.5)},
                                           {41, 1},       {10, 2},  {20, 0}, {30, 0}, {10, 2},
                                           {20, 2},       {30, 0},  {10, 0}, {20, 2}, {30, 0}})),
                              chord);
  ASSERT_EQ(spline.paths.size(), 1u) << (spline.left_out.empty() ? "" : spline.left_out[0].why);
  for (const Curve& c : spline.paths[0].curves) {
    EXPECT_NEAR(std::hypot(c.to.x, c.to.y), 2, near);
    EXPECT_NEAR(std::hypot((c.from.x + c.to.x) / 2, (c.from.y + c.to.y) / 2), 2, chord);
  }
  EXPECT_NEAR(length_of(spline), pi, 0.001);
}

TEST(DxfReader, BlocksArePutTurnedScaledAndInRows) {
  const std::string blocks =
      section("BLOCKS", block("part", line(1, 1, 2, 1), 1, 1) + block("outer", groups({{0, "INSERT"},
                                                                                       {8, "0"},
                                                                                       {2, "part"},
                                                                                       {10, 10},
                                                                                       {20, 0},
                                                                                       {30, 0},
                                                                                       {41, 2},
                                                                                       {42, 2},
                                                                                       {50, 90}})));
  const Drawing d = read(file(groups({{0, "INSERT"},
                                      {8, "cut"},
                                      {2, "outer"},
                                      {10, 100},
                                      {20, 0},
                                      {30, 0},
                                      {70, 3},
                                      {71, 2},
                                      {44, 5},
                                      {45, 7}}),
                              blocks));
  ASSERT_EQ(d.paths.size(), 6u);
  EXPECT_EQ(d.layers[static_cast<std::size_t>(d.paths[0].layer)].name, "cut")
      << "what lies on 0 goes with its insert";
  EXPECT_NEAR(d.paths[0].curves[0].from.x, 110, near);
  EXPECT_NEAR(d.paths[0].curves[0].to.y, 2, near);
  expect_box(d, 110, 0, 120, 9);
}

TEST(DxfReader, ACircleStaysACircleOnlyWhereItIsOne) {
  const std::string blocks =
      section("BLOCKS", block("round", groups({{0, "CIRCLE"}, {8, "0"}, {10, 0}, {20, 0}, {40, 1}})));
  const auto put = [](double sx, double sy) {
    return groups({{0, "INSERT"}, {8, "0"}, {2, "round"}, {10, 0}, {20, 0}, {30, 0}, {41, sx}, {42, sy}});
  };
  EXPECT_EQ(read(file(put(3, 3), blocks)).paths[0].curves.size(), 1u);
  EXPECT_NEAR(read(file(put(-3, 3), blocks)).paths[0].curves[0].degrees, -360, near) << "mirrored";
  const Drawing stretched = read(file(put(3, 1), blocks));
  EXPECT_GT(stretched.paths[0].curves.size(), 50u);
  expect_box(stretched, -3, -1, 3, 1, 0.001);
}

TEST(DxfReader, EntitiesSeenFromBelowAreMirrored) {
  const Drawing d = read(file(groups({{0, "ARC"},
                                      {8, "0"},
                                      {10, 5},
                                      {20, 0},
                                      {30, 0},
                                      {40, 1},
                                      {50, 0},
                                      {51, 90},
                                      {210, 0},
                                      {220, 0},
                                      {230, -1}})));
  ASSERT_EQ(d.paths.size(), 1u);
  EXPECT_NEAR(d.paths[0].curves[0].from.x, -6, near);
  EXPECT_NEAR(d.paths[0].curves[0].degrees, -90, near);
  expect_box(d, -6, 0, -5, 1);
}

TEST(DxfReader, LayersThatAreFrozenOrOffAreKnown) {
  const auto layer = [](const char* name, int flags, int colour) {
    return groups({{0, "LAYER"}, {2, name}, {70, double(flags)}, {62, double(colour)}, {6, "CONTINUOUS"}});
  };
  const std::string tables =
      section("TABLES", groups({{0, "TABLE"}, {2, "LAYER"}, {70, 3}}) + layer("cut", 0, 7) +
                            layer("ice", 1, 7) + layer("dark", 0, -7) + groups({{0, "ENDTAB"}}));
  const Drawing d = read(file(line(0, 0, 1, 1, "ice") + line(0, 0, 2, 1, "ice") + line(0, 0, 1, 1), tables));
  ASSERT_GE(d.layers.size(), 3u);
  const auto shown = [&](const char* name) {
    for (const Layer& l : d.layers)
      if (l.name == name) return l.shown;
    return true;
  };
  EXPECT_TRUE(shown("cut"));
  EXPECT_FALSE(shown("ice"));
  EXPECT_FALSE(shown("dark"));
  EXPECT_FALSE(d.layers[static_cast<std::size_t>(d.paths[0].layer)].shown);
  const auto hidden = hidden_layers(d);
  ASSERT_EQ(hidden.size(), 1u) << "nothing lies on the dark one";
  EXPECT_EQ(hidden[0].name, "ice");
  EXPECT_EQ(hidden[0].entities, 2);
}

TEST(DxfReader, TheUnitIsTheFiles) {
  const auto with_unit = [](int unit) {
    return read(file(
        line(0, 0, 1, 1),
        section("HEADER", groups({{9, "$ACADVER"}, {1, "AC1015"}, {9, "$INSUNITS"}, {70, double(unit)}}))));
  };
  EXPECT_EQ(with_unit(4).unit, "mm");
  EXPECT_EQ(with_unit(1).unit, "in");
  EXPECT_EQ(with_unit(0).unit, "") << "it has none";
  const std::pair<int, const char*> others[] = {
      {2, "ft"},  {3, "mi"},  {5, "cm"},  {6, "m"},   {7, "km"},     {8, "uin"},   {9, "mil"},
      {10, "yd"}, {12, "nm"}, {13, "um"}, {14, "dm"}, {15, "dam"},   {16, "hm"},   {11, "angstrom"},
      {17, "Gm"}, {18, "au"}, {19, "ly"}, {20, "pc"}, {21, "us-ft"}, {24, "us-mi"}};
  for (const auto& [number, name] : others) EXPECT_EQ(with_unit(number).unit, name) << number;
  EXPECT_EQ(with_unit(25).unit, "") << "nobody knows that one";
  EXPECT_EQ(with_unit(-1).unit, "");
  EXPECT_EQ(with_unit(4).version, "AC1015");
}

TEST(DxfReader, UnsupportedEntitiesAreNamedWithTheirPlace) {
  const Drawing d = read(file(
      line(0, 0, 1, 0) + groups({{0, "TEXT"}, {8, "0"}, {10, 0}, {20, 0}, {30, 0}, {40, 1}, {1, "margin"}}) +
      groups({{0, "MLINE"}, {8, "0"}, {2, "STANDARD"}}) +
      groups({{0, "LINE"}, {8, "0"}, {10, 0}, {20, 0}, {30, 0}, {11, 1}, {21, 1}, {31, 5}}) +
      groups({{0, "CIRCLE"}, {8, "0"}, {10, 0}, {20, 0}, {40, 0}}) +
      groups({{0, "SPLINE"},
              {8, "0"},
              {70, 0},
              {71, 3},
              {72, 2},
              {73, 1},
              {74, 0},
              {40, 0},
              {40, 1},
              {10, 0},
              {20, 0},
              {30, 0}}) +
      groups({{0, "INSERT"}, {8, "0"}, {2, "nowhere"}, {10, 0}, {20, 0}, {30, 0}}) + line(5, 5, 6, 6)));
  EXPECT_EQ(d.paths.size(), 2u);
  std::string reported;
  for (const LeftOut& l : d.left_out)
    reported += fmt::format("{} {} {}: {}\n", l.entity, l.what, l.line, l.why);
  EXPECT_EQ(reported,
            "2 TEXT 22: it is a text\n3 MLINE 36: it is not drawn with lines and arcs\n4 LINE 42: it is not "
            "flat\n5 CIRCLE 58: its radius is not above 0\n6 SPLINE 68: it has too few control points\n7 "
            "INSERT 92: there is no block nowhere\n");
}

TEST(DxfReader, EntitiesLeftOutAreLocatedInTheDrawing) {
  const std::string text =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n10\n0\n20\n0\n"
      "0\nTEXT\n10\n5\n20\n6\n1\nin a block\n0\nENDBLK\n0\nENDSEC\n"
      "0\nSECTION\n2\nENTITIES\n"
      "0\nTEXT\n8\n0\n10\n 12.5\n20\n-3\n40\n1\n1\nhello\n"
      "0\nHATCH\n10\n0\n20\n0\n91\n0\n10\n7\n20\n8\n"
      "0\nWIPEOUT\n8\n0\n"
      "0\nENDSEC\n0\nEOF\n";
  const auto read = read_dxf(text, "a.dxf", {});
  ASSERT_TRUE(read) << read.error().sentence();
  std::map<std::string, std::optional<Point>> at;
  for (const LeftOut& l : read->left_out) at[l.what + std::to_string(l.entity)] = l.at;
  ASSERT_EQ(at.size(), 4u);
  EXPECT_EQ(at.at("TEXT2"), std::nullopt) << "where the block is inserted it may be seen more than once";
  EXPECT_EQ(at.at("TEXT4"), (Point{12.5, -3}));
  EXPECT_EQ(at.at("HATCH5"), (Point{7, 8})) << "not how high it lies";
  EXPECT_EQ(at.at("WIPEOUT6"), std::nullopt);
}

TEST(DxfReader, APolylineLiesWhereItsFirstVertexDoesAndWhatIsTurnedWhereItIsSeen) {
  const std::string text =
      "0\nSECTION\n2\nENTITIES\n"
      "0\nPOLYLINE\n8\n0\n67\n1\n66\n1\n10\n0\n20\n0\n30\n0\n70\n0\n"
      "0\nVERTEX\n8\n0\n10\n3\n20\n4\n0\nVERTEX\n8\n0\n10\n5\n20\n6\n0\nSEQEND\n8\n0\n"
      "0\nTEXT\n8\n0\n10\n12\n20\n-3\n40\n1\n1\nhello\n210\n0\n220\n0\n230\n-1\n"
      "0\nTEXT\n8\n0\n10\n7\n20\n8\n40\n1\n1\nhello\n210\n0\n220\n0\n230\n1\n"
      "0\nCIRCLE\n10\n5\n20\n2\n30\n10\n40\n3\n210\n0.6\n220\n0\n230\n0.8\n"
      "0\nELLIPSE\n10\n5\n20\n2\n11\n1\n21\n0\n40\n0.5\n41\n0\n42\n6\n210\n3\n220\n0\n230\n4\n"
      "0\nENDSEC\n0\nEOF\n";
  const auto read = read_dxf(text, "a.dxf", {});
  ASSERT_TRUE(read) << read.error().sentence();
  std::map<int, std::optional<Point>> at;  // by line
  for (const LeftOut& l : read->left_out) at[l.line] = l.at;
  ASSERT_EQ(at.size(), 5u);
  auto place = at.begin();  // that of the header of the polyline is none
  EXPECT_EQ(place->second, (Point{3, 4}));
  EXPECT_EQ((++place)->second, (Point{-12, -3})) << "seen from below";
  EXPECT_EQ((++place)->second, (Point{7, 8}));
  const Point askew = (++place)->second.value_or(Point());  // its own X is the drawing's Y
  EXPECT_NEAR(askew.x, -2 * 0.8 + 10 * 0.6, 1e-12);
  EXPECT_NEAR(askew.y, 5, 1e-12);
  EXPECT_EQ((++place)->second, (Point{5, 2})) << "an ellipse is given in space";
}

TEST(DxfReader, AnEntryThatBeginsLikeTheModelIsNotIt) {
  const std::string text =
      "0\nSECTION\n2\nENTITIES\n0\nTEXT\n8\n0\n10\n12\n20\n-3\n40\n1\n1\nhello\n0\nENDSEC\n"
      "0\nSECTION\n2\nOBJECTS\n0\nDICTIONARY\n3\nENTITIES_X\n3\nENTITIES\n0\nENDSEC\n0\nEOF\n";
  const auto read = read_dxf(text, "a.dxf", {});
  ASSERT_TRUE(read) << read.error().sentence();
  ASSERT_EQ(read->left_out.size(), 1u);
  EXPECT_EQ(read->left_out[0].at, (Point{12, -3}));
}

TEST(DxfReader, ABlockThatContainsItselfEnds) {
  const std::string to_b = groups({{0, "INSERT"}, {8, "0"}, {2, "b"}, {10, 1}, {20, 0}, {30, 0}});
  const std::string to_a = groups({{0, "INSERT"}, {8, "0"}, {2, "a"}, {10, 1}, {20, 0}, {30, 0}});
  const Drawing d =
      read(file(to_a, section("BLOCKS", block("a", line(0, 0, 1, 1) + to_b) + block("b", to_a))));
  EXPECT_EQ(d.paths.size(), 1u);
  ASSERT_EQ(d.left_out.size(), 1u);
  EXPECT_EQ(d.left_out[0].why, "block a contains itself");
}

// A LEADER behind the end once made the parser ask for four gigabytes.
TEST(DxfReader, EntitiesBehindTheEndOfTheFileAreNotRead) {
  const Drawing d = read(file(line(0, 0, 1, 1)) + groups({{0, "LEADER"}, {8, "0"}, {76, "99999999"}}) +
                         line(0, 0, 500, 500));
  EXPECT_EQ(d.paths.size(), 1u);
  EXPECT_TRUE(d.left_out.empty());
  expect_box(d, 0, 0, 1, 1);
}

// The parser would read it for ever.
TEST(DxfReader, ALineOfThousandsOfBytesIsOnlyALongText) {
  const std::string words(5000, 'x');
  const Drawing d = read(file(line(0, 0, 1, 1) + groups({{999, words.c_str()}}) + line(0, 0, 500, 500)));
  EXPECT_EQ(d.paths.size(), 2u);
  expect_box(d, 0, 0, 500, 500);
}

struct BadFile {
  const char* name;
  std::string text;
  const char* sentence;
};
std::ostream& operator<<(std::ostream& out, const BadFile& b) { return out << b.name; }
class DxfBad : public testing::TestWithParam<BadFile> {};

TEST_P(DxfBad, IsReportedInASentence) {
  const auto drawing = read_dxf(GetParam().text, "a.dxf", Tolerance());
  ASSERT_FALSE(drawing);
  EXPECT_THAT(drawing.error().sentence(), HasSubstr(GetParam().sentence));
}

INSTANTIATE_TEST_SUITE_P(
    Each, DxfBad,
    testing::Values(BadFile{"CutOff", section("ENTITIES", line(0, 0, 1, 1)),
                            "a.dxf is cut off: it does not end with EOF."},
                    BadFile{"NoDxf", "this is no drawing", "a.dxf is not a DXF file"},
                    BadFile{"Empty", "", "a.dxf is empty."},
                    BadFile{"Binary", std::string("AutoCAD Binary DXF\r\n\x1a\0", 22), "binary DXF"},
                    BadFile{"Picture", "\x89PNG\r\n\x1a\n....", "line 1: a group code was expected here"},
                    BadFile{"ZeroByte",
                            file(groups({{0, "LEADER"}, {8, "0"}}) + std::string("  0\nA\0B\n", 9)),
                            "line 10: it contains a zero byte"},
                    BadFile{"TooManyPoints",
                            file(groups({{0, "LWPOLYLINE"}, {8, "0"}, {90, 2e9}, {70, 0}, {10, 0}, {20, 0}})),
                            "line 6: LWPOLYLINE declares more parts than it has"},
                    BadFile{"NegativeCount", file(groups({{0, "SPLINE"}, {8, "0"}, {71, 3}, {72, -5}})),
                            "SPLINE declares"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace hw::drawing
