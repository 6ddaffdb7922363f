// CX: turns a recorded contour into a track and cues, and runs along it. The lead-in goes straight from the
// present place to the start of the contour, arriving at path speed (decision M72); after the last piece CE
// ramps down straight on (M73), CK stops dead (M74).
#include <algorithm>
#include <cmath>

#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {

using motion::Profile;

namespace {

constexpr double longest = 1e12;  // counts: eleven days at full speed
constexpr auto fine = static_cast<double>(motion::Contour::steps_per_count);

/// Adds the pieces of `contour` to `track` and the actions due along it to `score`. False: it is too long.
bool write_plan(const Contour& contour, motion::Contour& track, ContourPlan& plan) {
  const auto here = [&track] { return track.end_of(track.pieces() - 1); };
  std::array<std::size_t, most_axes> places{};  // places of the contour's axes, in order
  std::size_t count = 0;
  for (int a = 0; a < most_axes; ++a)
    if (contour.has(a)) places[count++] = ix(a);
  motion::Contour::Point point = track.end();
  for (std::size_t i = 0; i < count; ++i) point[places[i]] = static_cast<double>(contour.start[places[i]]);
  track.line_to(point);
  plan.events.push_back({ContourEvent::What::at_speed, here()});
  for (const RecordedPiece& piece : contour.pieces) {
    switch (piece.kind) {
      case RecordedPiece::Kind::line:
        point = track.end();
        for (std::size_t i = 0; i < count; ++i) point[places[i]] = static_cast<double>(piece.to[i]);
        track.line_to(point);
        break;
      case RecordedPiece::Kind::arc:
        if (!(std::abs(piece.angle) < longest)) return false;
        track.arc(places[0], places[1], static_cast<double>(piece.centre_first),
                  static_cast<double>(piece.centre_second), piece.angle);
        break;
      case RecordedPiece::Kind::outputs:
        plan.events.push_back({ContourEvent::What::output, here(), piece.outputs, piece.high});
        break;
    }
    if (track.length() > longest) return false;
  }
  plan.events.push_back({ContourEvent::What::end, here()});
  plan.kill = contour.kill;
  if (!contour.kill) track.ray();
  return true;
}

}  // namespace

bool Motion::play(const Contour& contour) {
  bring_up_to_date();
  if (!contour.complete || contour.axes == 0 || board_.contour_velocity <= 0) return false;
  motion::Offsets here{};
  double base = board_.contour_velocity;
  for (int a = 0; a < most_axes; ++a) {
    const MotionAxis& x = axes_[ix(a)];
    here[ix(a)] = x.position;
    if (!contour.has(a)) continue;
    if (x.off() || x.run >= 0) return false;
    base = std::min(base, x.settings.base_velocity);
  }
  auto track = std::make_shared<motion::Contour>(here);
  auto plan = std::make_shared<ContourPlan>();
  if (!write_plan(contour, *track, *plan)) return false;
  const Pps cv(board_.contour_velocity * fine);
  Run ramps;  // gives the ramp before the run exists
  ramps.kind = RunKind::contour, ramps.axes = contour.axes;
  const Profile lead = Profile::change(now_, 0, Pps(base * fine), cv, ramp_of(ramps), Profile::endless);
  begin(RunKind::contour, contour.axes, Track(std::shared_ptr<const motion::Contour>(std::move(track))), lead,
        cv.value, std::move(plan));
  return true;
}

/// Carries out the cues due at the present step. False: the run has ended, or its last ramp has begun.
bool Motion::follow_events(Run& r) {
  const auto plan = r.plan;
  while (r.event < plan->events.size() && plan->events[r.event].step <= r.applied) {
    const ContourEvent& event = plan->events[r.event++];
    switch (event.what) {
      case ContourEvent::What::at_speed: {
        const double cv = board_.contour_velocity * fine;
        if (!r.stopping && std::abs(r.profile.speed(now_).value - cv) > 1e-6 * cv)
          r.profile = Profile::constant(now_, static_cast<double>(r.applied), Pps(cv), Profile::endless);
        break;
      }
      case ContourEvent::What::output:
        for (int a = 0; a < most_axes; ++a)
          if ((event.outputs >> a & 1u) != 0) note_event(MotionEvent::What::output, a, event.high);
        break;
      case ContourEvent::What::end:
        if (plan->kill)
          finish(r, End::cut);
        else
          stop_run(r);
        return r.active && !r.stopping;
    }
  }
  return true;
}

}  // namespace hw::vme58
