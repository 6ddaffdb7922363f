#include "emulator_drawing.h"

#include <gmock/gmock.h>

namespace hw {

EmulatorDrawing::EmulatorDrawing(const char* model)
    : type(*find_device_type(model)), catalog(*type.make_catalog({})) {
  out = static_cast<int>(catalog.outputs.size()) - 1;
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
  auto first = rehearsal.track.begin();
  // Each piece is tried with its outputs as after power-up, where some are on until its first step.
  while (!track.empty() && first != rehearsal.track.end() && first->position == rehearsal.track[0].position &&
         first->outputs == rehearsal.track[0].outputs)
    ++first;
  track.insert(track.end(), first, rehearsal.track.end());
  rehearsal.track = std::move(track);
}

}  // namespace hw
