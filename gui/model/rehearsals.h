#pragma once
// Dry runs of program texts, computed outside the frame. The newest of each program (a slot, or one of
// several in one text: ProgramTexts::start_of) is kept with its text and its initial state, so that the
// screen can say whether it still holds. GUI thread.
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "core/device/controller_state.h"
#include "gui/model/worker.h"

namespace hw::gui {

/// How a rehearsal's initial state compares with the present controller. Unless it is `here`, the rehearsal's
/// statements about limits do not hold.
enum class StartMatch : std::uint8_t {
  here,
  elsewhere,
  moving,          ///< elsewhere, and moving
  other_count,     ///< counted in pulses, but the axis now counts its encoder, or the reverse
  unknown,         ///< the axis' position is not known
  doubtful,        ///< the axis' count may be wrong
  other_bench,     ///< switches have been moved since
  other_encoder,   ///< an axis' encoder reads differently
  other_power,     ///< an axis was switched on or off, or its loop, error or alarm has changed
  other_switch,    ///< a limit or home switch of an axis has changed
  other_setup,     ///< a parameter has changed
  other_output,    ///< an output has been switched
  other_input,     ///< an input has changed
  other_analog,    ///< an analog input has changed
  other_readout,   ///< the move mode, a latch or a sync output has changed: see acts_on_programs()
  other_variable,  ///< a variable has changed
  other_program,   ///< another program in the controller has changed
  other_queue      ///< commands wait in the controller's queues now
};
struct StartDifference {
  StartMatch match = StartMatch::here;
  int which = -1;       ///< the first that differs: axis, parameter, output, input or readout in the catalog,
                        ///< variable, slot
  Steps began, stands;  ///< positions, or other values as they are counted
  bool unread = false;  ///< it may have changed: it was known then, and is not known now
  bool operator==(const StartDifference&) const = default;
};

inline constexpr std::string_view no_rehearsal = "This model has no rehearsal.";
/// Why no rehearsal may begin now: it would begin with empty queues, since no controller lists what waits in
/// its own. Empty: it may.
[[nodiscard]] std::string_view why_not_rehearse_now(const Snapshot& now, const Catalog& catalog);

class Rehearsals {
 public:
  using Switches = std::array<SwitchPlaces, max_axes>;
  /// The initial state of a rehearsal.
  struct Scene {
    std::shared_ptr<const ControllerState> state;
    std::optional<Switches> switches;  ///< nothing: their places are not known
  };
  struct Outcome {
    std::string text;  ///< what was rehearsed
    Result<Rehearsal> result;
    Scene scene;
    std::set<int> fills = {};  ///< the slots that its text fills
    int number = 0;            ///< Rehearsals::version() of its arrival; unique
    StartDifference start = {};
    bool compared = false;  ///< `start` is known
  };

  /// Starts a dry run from the present state of the controller and the switches of the bench, as far as
  /// known; the rest is as after power-up. Of `requested`, only the slot, the time and the track count are
  /// used. Does nothing while a dry run is under way for this slot.
  void start(const Language& language, std::string text, const RehearseOptions& requested,
             const ControllerState& from, const BenchView& bench, const Catalog& catalog, Worker& worker);
  /// Announces a dry run of this slot that starts once more is known: it counts as under way from now on.
  void prepare(int slot) { prepared_.insert(slot); }
  [[nodiscard]] bool under_way(int slot) const { return running_.contains(slot) || prepared_.contains(slot); }
  /// Null: none yet.
  [[nodiscard]] const Outcome* of(int slot) const;
  /// First line (from 0) in which the present text differs from the rehearsed one; -1: none.
  [[nodiscard]] int older_than_line(int slot, std::string_view text) const;
  /// The text of a slot that the controller is known to hold; null: not known.
  using Held = std::function<const std::string*(int slot)>;
  /// Once a frame: compares the controller with their initial states. A running program has left its own.
  void follow(const Snapshot& now, const BenchView& bench, const Catalog& catalog, const Held& held = {});
  /// Changes with each result, and when a result's `start` changes.
  [[nodiscard]] int version() const { return version_; }

 private:
  std::map<int, Outcome> outcomes_;
  std::set<int> running_, prepared_;
  int version_ = 0;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
