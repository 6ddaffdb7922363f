#pragma once
// Controllers that share a wire and one tab of the console: one is chosen and the other panels act on it, all
// stay in sight, and Stop reaches all. GUI thread.
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "gui/model/axis_look.h"

namespace hw {
class SessionGroup;
struct Rehearsal;
namespace sequence {
struct Sequence;
}
}  // namespace hw

namespace hw::gui {

class Tab;

/// A drawing that the controllers of a bus can do together, as it was rehearsed last.
struct DrawnTogether {
  std::string name;                                    ///< of its file
  std::shared_ptr<const sequence::Sequence> sequence;  ///< null: there is none
  std::shared_ptr<const Rehearsal> rehearsal;          ///< see rehearse_together()
  int number = 0;                                      ///< grows with each
};

struct Bus {
  std::shared_ptr<SessionGroup> group;  ///< null in tests of panels
  std::string default_name;             ///< the catalog's short name and the ids
  std::vector<Tab*> members;            ///< in the order of their ids; owned by the console
  std::size_t chosen = 0;
  DrawnTogether drawn;
  std::shared_ptr<const sequence::Sequence> begun;  ///< latest: what its controllers do together, or did

  [[nodiscard]] Tab& front() const { return *members[chosen]; }
  /// The user's, which the first member's profile keeps; else the default.
  [[nodiscard]] std::string_view name() const;
  void rename(std::string name);
  /// The one whose state is the worst; the chosen one if none is worse.
  [[nodiscard]] Tab& worst() const;
  /// How many answer.
  [[nodiscard]] std::size_t connected() const;
  void stop_all(StoppedBy by = StoppedBy::button);
  /// To each that is at pieces: a hold, its end, another speed.
  void tell_pieces(const IntentBody& wish);
  /// Of the one that is at them, or was last.
  [[nodiscard]] const PiecesState& pieces() const;
};

/// "01, 02 and 03".
std::string in_words(std::span<const std::string_view> names);

/// Whether the sentence says of whom on a bus it speaks: "02 moves to ...".
bool speaks_of(std::string_view sentence, std::string_view id);

/// Of a controller, or of the worst on its bus; `moving` when several move.
State worst_state(const Tab& tab);

}  // namespace hw::gui
