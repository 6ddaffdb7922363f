// Actions on the bench that concern the loads of the axes.
#include <cmath>

#include "core/devices/vme58/emulator_motion.h"
#include "core/emulation/bench_file.h"
#include "core/emulation/plant_bench.h"

namespace hw::vme58 {

Result<> Motion::place(int a, const AxisPlace& place) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  if (const auto problem = problem_of(place); !problem.empty())
    return fail(FaultKind::refused, std::string(problem) + ".", "Nothing was changed.");
  if (auto bad = check_place(place, true); !bad) return bad;
  if (place.motor && place.motor->present && !x.servo())
    return fail(FaultKind::refused, "A step axis of the bench cannot have a servo motor.",
                "Nothing was changed.",
                "Give motors to servo axes only; the variant of the board says which axes these are.");
  const std::int64_t encoder = x.encoder();
  x.plant.set_place(place);
  const auto& motor = x.plant.place().motor;
  const bool had_motor = std::exchange(x.has_motor, motor && motor->present);
  if (x.has_motor) {
    x.loop.plant.set(*motor);
    if (!had_motor) x.loop.plant.put(static_cast<double>(x.shaft));
    x.loop.plant.jam(x.plant.jammed());
    x.loop.close(x.settings.holding);
  } else if (had_motor) {
    x.shaft = x.loop.plant.counts();
    if (x.settings.holding) x.turn_load(1, x.error());
  }
  x.set_encoder(encoder);
  replan(a);
  schedule_updates();
  return {};
}

void Motion::operate_limit(int a, Sign side, bool on) {
  bring_up_to_date();
  axes_[ix(a)].plant.operate_limit(side, on);
  replan(a);
}

void Motion::operate_home(int a, bool on) {
  bring_up_to_date();
  axes_[ix(a)].plant.operate_home(on);
  replan(a);
}

void Motion::jam(int a, bool on) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  x.plant.jam(on);
  x.loop.plant.jam(on);
  x.loop.wake();
  // An ideal servo that is released goes to its command.
  if (!on && x.servo() && !x.has_motor && x.settings.holding) {
    const std::int64_t back = x.error();
    if (back != 0) x.turn_load(back < 0 ? -1 : 1, std::abs(back));
  }
  replan(a);
  schedule_updates();
}

/// Shifts the load. A closed ideal servo detects the error and is pulled back.
void Motion::slip(int a, std::int64_t counts) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  if (x.settings.tracking) return track(a, counts);
  const std::int64_t load = x.plant.load().value;
  const auto by = static_cast<std::int64_t>(std::llround(static_cast<double>(counts) / x.counts_per_step()));
  x.plant.slip(Steps(x.fitting.encoder ? by : counts));
  if (x.has_motor)
    x.loop.plant.shift(static_cast<double>(x.plant.load().value - load)), x.loop.wake();
  else
    x.shaft += x.plant.load().value - load;
  replan(a);
  if (x.servo() && !x.has_motor && x.settings.holding && !x.plant.jammed()) {
    const std::int64_t back = x.error();
    if (back != 0) x.turn_load(back < 0 ? -1 : 1, std::abs(back));
    replan(a);
  }
  schedule_updates();
}

void Motion::set_encoder(int a, std::int64_t count) {
  bring_up_to_date();
  axes_[ix(a)].set_encoder(count);
}

void Motion::look(BenchView& view) const {
  for (int a = 0; a < most_axes; ++a) {
    const motion::Plant& plant = axes_[ix(a)].plant;
    show_plant(view, a, SeenPlant(plant));
    if (plant.home_operated()) view.homes |= 1u << a;
  }
}

}  // namespace hw::vme58
