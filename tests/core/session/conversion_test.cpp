// From a drawing to a controller that draws it: the emulator goes through every vertex, and nowhere else with
// its tool down.
#include "core/session/conversion.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "core/drawing/dxf_reader.h"

namespace hw {
namespace {

using drawing::Point;
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

double beside(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squares = dx * dx + dy * dy;
  const double t = squares > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squares, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

struct ConversionTest : testing::TestWithParam<const char*> {
  ConversionTest() : type(*find_device_type(GetParam())), catalog(*type.make_catalog({})) {
    out = static_cast<int>(catalog.outputs.size()) - 1;  // of a VME58 one that contours switch
    for (int a : {0, 1}) o.axes.push_back({catalog.axes[static_cast<std::size_t>(a)].name, per_unit});
    o.layers = {"cut"};
    if (!catalog.can.one_axis_at_a_time) o.layers.push_back("round");  // of a VXM they would not fit
    o.tolerance = catalog.can.one_axis_at_a_time ? 0.15 : 0.02;
    o.cutting = {4, 0.5, 100}, o.travel = {8, 0.5, 100};
    if (type.model == "vxm") o.cutting.low = o.travel.low = 0;
    o.pen_down = {{sequence::Output{catalog.output_number(ix_of(out)), true}}};
    o.pen_up = {{sequence::Output{catalog.output_number(ix_of(out)), false}}};
  }
  static std::size_t ix_of(int n) { return static_cast<std::size_t>(n); }
  /// Drawn by the emulator.
  void draw() {
    const auto converted = convert(read(), catalog, o);
    ASSERT_TRUE(converted) << converted.error().sentence();
    made = *converted;
    const auto text = type.language().write(made.sequence, catalog);
    ASSERT_TRUE(text) << text.error().sentence();
    RehearseOptions options;
    options.track_every_s = 0.001;
    options.device = catalog.made_from;
    const auto done = type.language().rehearse(text->text, options);
    ASSERT_TRUE(done) << done.error().sentence() << "\n" << text->text;
    ASSERT_TRUE(done->finished) << done->error << "\n" << text->text;
    rehearsal = *done;
  }
  Point at(std::size_t n) const {
    const auto& p = rehearsal.track[n].position;
    return {static_cast<double>(p[0]) / per_unit, static_cast<double>(p[1]) / per_unit};
  }
  bool down(std::size_t n) const { return (rehearsal.track[n].outputs >> out & 1u) != 0; }
  /// With the tool down; for a dot that may take no time.
  double nearest_pass(Point to, bool dot) const {
    double nearest = 1e9;
    for (std::size_t n = 1; n < rehearsal.track.size(); ++n)
      if (dot || down(n) || down(n - 1)) nearest = std::min(nearest, beside(to, at(n - 1), at(n)));
    return nearest;
  }
  /// Some outputs are on when the power comes.
  std::size_t first_up() const {
    std::size_t n = 0;
    while (n < rehearsal.track.size() && down(n)) ++n;
    return n;
  }
  double off_the_drawing(Point p) const {
    double nearest = 1e9;
    for (const drawing::Chain& chain : made.chains)
      for (const drawing::Curve& curve : chain.curves) {
        Point from = curve.from;
        drawing::chords(curve, 0.0005, [&](Point to) {
          nearest = std::min(nearest, beside(p, from, to));
          from = to;
        });
      }
    return nearest;
  }

  static constexpr double per_unit = 200;
  const DeviceType& type;
  const Catalog catalog;
  int out;
  ConversionOptions o;
  Conversion made;
  Rehearsal rehearsal;
};
INSTANTIATE_TEST_SUITE_P(Every, ConversionTest, testing::Values("vxm", "pmx-4ex-sa", "vme58"),
                         [](const auto& info) { return std::string(info.param).substr(0, 3); });

TEST_P(ConversionTest, TheToolGoesThroughEveryVertexAndNowhereElse) {
  ASSERT_NO_FATAL_FAILURE(draw());
  EXPECT_EQ(made.chains.size(), o.layers.size() == 1 ? 2u : 4u) << "the line and the polyline touch";
  const double step = 1.5 / per_unit;  // half of one in each axis, and the way between two looks
  for (const drawing::Chain& chain : made.chains)
    for (const drawing::Curve& curve : chain.curves) {
      for (const Point end : {curve.from, curve.to})
        EXPECT_LE(nearest_pass(end, curve.length() == 0), step) << end.x << ", " << end.y;
    }
  int seen = 0;
  for (std::size_t n = first_up(); n < rehearsal.track.size(); n += 7) {
    if (!down(n)) continue;
    ++seen;
    ASSERT_LE(off_the_drawing(at(n)), *o.tolerance + step) << n << ": " << at(n).x << ", " << at(n).y;
  }
  EXPECT_GT(seen, 100);
  EXPECT_EQ(rehearsal.outputs.at(std::to_string(catalog.output_number(ix_of(out)))), 0) << "the tool is up";
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
