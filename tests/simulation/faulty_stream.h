#pragma once
// A stream with a bad wire behind it.
#include <memory>

#include "core/link/stream.h"
#include "core/time/scheduler.h"
#include "tests/simulation/wire_faults.h"

namespace hw::simulation {

std::unique_ptr<Stream> make_faulty_stream(Scheduler& scheduler, std::unique_ptr<Stream> inner,
                                           WireFaults& faults);

}  // namespace hw::simulation
