#include "emulator_drawing.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace hw {

using drawing::Point;

static double beside(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squares = dx * dx + dy * dy;
  const double t = squares > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squares, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

static double nearest_of(const std::vector<std::pair<Point, Point>>& lines, Point p) {
  double nearest = 1e9;
  for (const auto& [from, to] : lines) nearest = std::min(nearest, beside(p, from, to));
  return nearest;
}

EmulatorDrawing::EmulatorDrawing(const char* model)
    : type(*find_device_type(model)),
      catalog(*type.make_catalog({})),
      out(static_cast<int>(catalog.outputs.size()) - 1) {
  for (const std::size_t a : {0, 1}) o.axes.push_back({catalog.axes[a].name, per_unit});
  o.tolerance = catalog.can.one_axis_at_a_time ? 0.15 : 0.02;
  o.cutting = {4, 0.5, 100}, o.travel = {8, 0.5, 100};
  if (type.model == "vxm") o.cutting.low = o.travel.low = 0;
  o.pen_down = {{sequence::Output{output_number(), true}}};
  o.pen_up = {{sequence::Output{output_number(), false}}};
}

void EmulatorDrawing::draw(const drawing::Drawing& drawing) {
  const auto converted = convert(drawing, catalog, o);
  ASSERT_TRUE(converted) << converted.error().sentence();
  made = *converted;
  const auto pieces = type.language().in_pieces(made.sequence, catalog);
  ASSERT_TRUE(pieces) << pieces.error().sentence();
  std::vector<std::int64_t> stands;
  for (const Piece& piece : pieces->all) {
    const auto* load = std::get_if<intent::LoadProgram>(&*piece.does.front().what);
    ASSERT_TRUE(load) << "a session draws it, see tests/transports/pmx_buffer_test.cpp";
    ASSERT_NO_FATAL_FAILURE(rehearse(load->text, stands));
    stands.clear();
    for (const RehearsedAxis& axis : rehearsal.axes) stands.push_back(axis.position);
  }
}

/// Behind what has been drawn so far.
void EmulatorDrawing::rehearse(const std::string& text, std::vector<std::int64_t> start_at) {
  RehearseOptions options;
  options.track_every_s = 0.002;
  options.device = catalog.made_from;
  options.start_at = std::move(start_at);
  auto done = type.language().rehearse(text, options);
  ASSERT_TRUE(done) << done.error().sentence() << "\n" << text;
  ASSERT_TRUE(done->finished) << done->error << "\n" << text;
  std::vector<RehearsedPlace> track = std::move(rehearsal.track);
  rehearsal = std::move(*done);
  track.insert(track.end(), rehearsal.track.begin(), rehearsal.track.end());
  rehearsal.track = std::move(track);
}

void EmulatorDrawing::expect_every_vertex() const {
  for (const drawing::Chain& chain : made.chains)
    for (const drawing::Curve& curve : chain.curves)
      for (const Point end : {curve.from, curve.to})
        EXPECT_LE(nearest_pass(end, curve.length() < 1 / per_unit), 1 / per_unit) << end.x << ", " << end.y;
}

void EmulatorDrawing::expect_nothing_beside() const {
  constexpr std::size_t looks = 1000;
  const std::vector<std::pair<Point, Point>> lines = drawn_lines();
  std::size_t n = 0, seen = 0;
  // Some outputs are on when the power comes, until the first step switches them off.
  while (n < rehearsal.track.size() && rehearsal.track[n].position == rehearsal.track[0].position) ++n;
  const std::size_t every = std::max<std::size_t>(rehearsal.track.size() / looks, 1);
  for (; n < rehearsal.track.size(); n += every) {
    if (!down(n)) continue;
    ++seen;
    ASSERT_LE(nearest_of(lines, at(n)), *o.tolerance + 1 / per_unit)
        << n << ": " << at(n).x << ", " << at(n).y;
  }
  if (made.drawn > 0) {
    EXPECT_GT(seen, 100u);
  }
}

Point EmulatorDrawing::at(std::size_t n) const {
  const auto& p = rehearsal.track[n].position;
  return {static_cast<double>(p[0]) / per_unit, static_cast<double>(p[1]) / per_unit};
}

/// With the tool down; for a dot that may take no time.
double EmulatorDrawing::nearest_pass(Point to, bool dot) const {
  double nearest = 1e9;
  for (std::size_t n = 1; n < rehearsal.track.size(); ++n)
    if (dot || down(n) || down(n - 1)) nearest = std::min(nearest, beside(to, at(n - 1), at(n)));
  return nearest;
}

std::vector<std::pair<Point, Point>> EmulatorDrawing::drawn_lines() const {
  std::vector<std::pair<Point, Point>> lines;
  for (const drawing::Chain& chain : made.chains)
    for (const drawing::Curve& curve : chain.curves) {
      Point from = curve.from;
      drawing::chords(curve, 0.0005, [&](Point to) {
        lines.emplace_back(from, to);
        from = to;
      });
    }
  return lines;
}

}  // namespace hw
