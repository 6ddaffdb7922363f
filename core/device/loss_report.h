#pragma once
// The report after a link that was lost during motion is back. Nothing is sent again. No transport can know
// whether a command on its way was carried out: the positions of the axes show it.
#include <array>
#include <string>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw {

class LossReport {
 public:
  /// The link was just lost. `at_work`: something moved or ran; `on_the_way`: a command or question was on
  /// its way.
  void lost(const Snapshot& last_known, bool at_work, bool on_the_way, Instant at);
  /// After a good status round: the report, once; empty: nothing, or not yet. `at_work`: something still
  /// moves or runs.
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
