#pragma once
// Dry runs of program texts, worked out beside the frame. The newest of each slot is kept with the text that
// it is of and with what it began from, so that the screen can say whether it still holds. GUI thread.
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/device/catalog.h"
#include "core/device/controller_state.h"
#include "gui/model/worker.h"

namespace hw::gui {

/// How a rehearsal's beginning compares with the controller as it is; where it is not `here`, what it says of
/// limits does not hold.
enum class Footing : std::uint8_t {
  here,
  elsewhere,
  moving,          ///< elsewhere, and under way
  other_count,     ///< it counts pulses where the axis counts its encoder, or the other way round
  unknown,         ///< where the axis stands is not known
  doubtful,        ///< its count may not be true
  other_bench,     ///< switches have been placed elsewhere since
  other_encoder,   ///< the encoder of an axis reads otherwise
  other_power,     ///< an axis has been switched on or off, or its loop, error or alarm has come or gone
  other_switch,    ///< a limit or home switch of an axis is operated, or is no more
  other_setup,     ///< a parameter has another value
  other_output,    ///< an output has been switched
  other_input,     ///< an input stands otherwise
  other_analog,    ///< an analog input reads otherwise
  other_readout,   ///< the move mode, a latch or a sync output is another: see acts_on_programs()
  other_variable,  ///< a variable has another value
  other_program    ///< another program of the controller has been changed
};
struct Stand {
  Footing footing = Footing::here;
  int which = -1;       ///< the first that differs: axis, parameter, output, input or readout in the catalog,
                        ///< variable, slot
  Steps began, stands;  ///< positions, or other values as they are counted
  bool operator==(const Stand&) const = default;
};

class Rehearsals {
 public:
  using Switches = std::array<SwitchPlaces, max_axes>;
  /// What a rehearsal began from.
  struct Scene {
    std::shared_ptr<const ControllerState> state;
    std::optional<Switches> switches;  ///< nothing: nobody knows where they are
  };
  struct Outcome {
    std::string text;  ///< what was rehearsed
    Result<Rehearsal> result;
    Scene scene;
    int number = 0;  ///< Rehearsals::version() when it came; no two have the same
    Stand stand = {};
    bool compared = false;  ///< `stand` is known
  };

  /// From the controller as it is, among the switches of the bench, as far as both are known; what is not is
  /// as after power-up. Of `wish` the slot, the time and the track count. Nothing happens while one is under
  /// way for this slot.
  void start(const Language& language, std::string text, const RehearseOptions& wish,
             const ControllerState& from, const BenchView& bench, const Catalog& catalog, Worker& worker);
  /// One for this slot is to be started as soon as something else is known: under way until then too.
  void prepare(int slot) { prepared_.insert(slot); }
  [[nodiscard]] bool under_way(int slot) const { return running_.contains(slot) || prepared_.contains(slot); }
  /// Null: none yet.
  [[nodiscard]] const Outcome* of(int slot) const;
  /// First line (from 0) in which the present text differs from the rehearsed one; -1: none.
  [[nodiscard]] int older_than_line(int slot, std::string_view text) const;
  /// The text of a slot that the controller is known to hold; null: not known.
  using Held = std::function<const std::string*(int slot)>;
  /// Once a frame: whether the controller still is what they began from. One that runs has left that.
  void follow(const Snapshot& now, const BenchView& bench, const Catalog& catalog, const Held& held = {});
  /// Changes with each result and each Stand.
  [[nodiscard]] int version() const { return version_; }

 private:
  std::map<int, Outcome> outcomes_;
  std::set<int> running_, prepared_;
  int version_ = 0;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
