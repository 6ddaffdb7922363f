#pragma once
// A memory window on a bus that fails, is slow, or on which nothing answers.
#include <memory>

#include "core/link/window.h"
#include "core/time/scheduler.h"
#include "tests/simulation/wire_faults.h"

namespace hw::simulation {

std::unique_ptr<Window> make_faulty_window(Scheduler& scheduler, std::unique_ptr<Window> inner,
                                           WireFaults& faults);

}  // namespace hw::simulation
