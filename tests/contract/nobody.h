#pragma once
// The other end of a wire on which something answers that is no controller at all.
#include "core/session/wire.h"

namespace hw {

enum class Habit : std::uint8_t {
  echo,  ///< gives back what it is sent; of a window: a piece of plain memory
  ones,  ///< 0xFF to whatever it is sent; of a window: the bus when no board is there
  noise  ///< other bytes each time
};

Wire wire_to_nobody(Scheduler& scheduler, Habit habit, bool window);

}  // namespace hw
