#pragma once
// Controllers that share a wire and a tab of the console. The panels act on the chosen one, all stay in
// sight, and Stop reaches all. GUI thread.
#include <cstdint>
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

/// A drawing for the controllers of a bus to carry out together, with its latest rehearsal.
struct DrawnTogether {
  std::string name;                                    ///< of the drawing's file
  std::shared_ptr<const sequence::Sequence> sequence;  ///< null: no drawing
  std::shared_ptr<const Rehearsal> rehearsal;          ///< see rehearse_together()
  int number = 0;                                      ///< grows with each drawing
  std::uint64_t pieces = 0;                            ///< Pieces::drawing of its pieces
};

struct Bus {
  std::shared_ptr<SessionGroup> group;  ///< null in tests of panels
  std::string default_name;             ///< the catalog's short name and the ids
  std::vector<Tab*> members;            ///< in the order of their ids; owned by the console
  std::size_t chosen = 0;
  DrawnTogether drawn;
  std::shared_ptr<const sequence::Sequence> begun;  ///< latest: carried out together, now or before

  [[nodiscard]] Tab& front() const { return *members[chosen]; }
  /// The user's name, kept in the first member's profile; else the default.
  [[nodiscard]] std::string_view name() const;
  void rename(std::string name);
  /// The member in the worst state; the chosen one if none is worse.
  [[nodiscard]] Tab& worst() const;
  /// The member that the status line is about: in trouble, else in the worst state.
  [[nodiscard]] Tab& most_urgent() const;
  /// The number of members that are connected.
  [[nodiscard]] std::size_t connected() const;
  void stop_all(StoppedBy by = StoppedBy::button);
  /// Sends `request` (a hold, its end, another speed) to each member that is working in pieces.
  void send_to_pieces(const IntentBody& request);
  /// State of the member that is working in pieces, or was last.
  [[nodiscard]] const PiecesState& pieces() const;
};

/// "01, 02 and 03".
std::string in_words(std::span<const std::string_view> names);

/// Returns whether the sentence names the device of the bus that it is about: "02 moves to ...".
bool mentions(std::string_view sentence, std::string_view id);

/// The state of a controller, or the worst on its bus; `moving` when several move.
State worst_state(const Tab& tab);

}  // namespace hw::gui
