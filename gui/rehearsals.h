#pragma once
// Dry runs of program texts, worked out beside the frame. The newest of each slot is kept with the text that
// it is of and with what it began from, so that the screen can say whether it still holds. GUI thread.
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/device/snapshot.h"
#include "gui/worker.h"

namespace hw::gui {

/// How a rehearsal's beginning compares with the axes as they stand; where it is not `here`, what it says of
/// limits does not hold.
enum class Footing : std::uint8_t {
  here,
  elsewhere,
  moving,       ///< elsewhere, and under way
  other_count,  ///< it counts pulses where the axis counts its encoder, or the other way round
  unknown,      ///< where the axis stands is not known
  doubtful,     ///< its count may not be true
  other_bench   ///< switches have been placed elsewhere since
};
struct Stand {
  Footing footing = Footing::here;
  int axis = -1;  ///< in the catalog: the first that is not where it was rehearsed
  Steps began, stands;
  bool operator==(const Stand&) const = default;
};

class Rehearsals {
 public:
  using Switches = std::array<SwitchPlaces, max_axes>;
  /// What a rehearsal began from.
  struct Scene {
    std::array<AxisState, max_axes> axes{};
    int axis_count = 0;
    std::uint32_t moving = 0;          ///< bit per axis
    std::optional<Switches> switches;  ///< nothing: nobody knows where they are
    Scene() = default;
    Scene(const Snapshot& now, const BenchView& bench);
  };
  struct Outcome {
    std::string text;  ///< what was rehearsed
    Result<Rehearsal> result;
    Scene scene;
    int number = 0;  ///< Rehearsals::version() when it came; no two have the same
    Stand stand = {};
    bool compared = false;  ///< `stand` is known
  };

  /// From where the axes stand, among the switches of the bench, as far as both are known; else from 0, as an
  /// emulator is made. Nothing happens while one is under way for this slot.
  void start(const Language& language, std::string text, RehearseOptions options, const Snapshot& now,
             const BenchView& bench, Worker& worker);
  [[nodiscard]] bool under_way(int slot) const { return running_.contains(slot); }
  /// Null: none yet.
  [[nodiscard]] const Outcome* of(int slot) const;
  /// First line (from 0) in which the present text differs from the rehearsed one; -1: none.
  [[nodiscard]] int older_than_line(int slot, std::string_view text) const;
  /// Once a frame: whether they still begin where the axes stand. One that runs has left there.
  void follow(const Snapshot& now, const BenchView& bench, const Catalog& catalog);
  /// Changes with each result and each Stand.
  [[nodiscard]] int version() const { return version_; }

 private:
  std::map<int, Outcome> outcomes_;
  std::map<int, bool> running_;
  int version_ = 0;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
