#pragma once
// What is told when a link that was lost at work is back. Nothing that was on its way is sent again, and
// whether it was carried out no transport can know: where the axes stand shows it.
#include <array>
#include <string>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw {

class LossReport {
 public:
  /// The link was lost just now. `at_work`: something moved or ran; `on_the_way`: something was being asked
  /// of the controller.
  void lost(const Snapshot& last_known, bool at_work, bool on_the_way, Instant at);
  /// After a round of status that went well: what is to be told, once; empty: nothing, or not yet. `at_work`:
  /// something moves or runs still.
  std::string back(const Catalog& catalog, const Snapshot& known, bool at_work, Instant at);

 private:
  struct Place {
    bool known = false;
    Steps position{};
  };
  bool owed_ = false, was_at_work_ = false;
  Instant lost_at_{};
  std::uint32_t restarts_ = 0;
  std::array<Place, max_axes> places_{};
};

}  // namespace hw
