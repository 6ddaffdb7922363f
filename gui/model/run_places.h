#pragma once
// Programs written from a sequence are bound by the user's travel limits and by doubts about positions,
// wherever they are run from; the user's own texts are not. GUI thread.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/sequence/sequence.h"

namespace hw::gui {

class Desk;
class Tab;

/// The targets of the program in the controller's slot, for intent::RunProgram; empty: it comes from no known
/// sequence.
std::vector<AxisTarget> places_of_held(Desk& desk, int slot, const Catalog& catalog, const Snapshot& now);

/// Why the sequence cannot be run from the present positions, in the displayed units: it leaves the user's
/// travel, or depends on an untrusted position. Empty: it can.
std::string why_not_run_there(const Tab& tab, const sequence::Sequence& sequence);
/// The same for a text; empty for one that comes from no known sequence.
std::string why_not_run_there(Tab& tab, const std::string& text);

/// The trust of each axis when the user agreed to a run despite doubts.
using AgreedDoubts = std::array<PositionTrust, max_axes>;
[[nodiscard]] AgreedDoubts doubts_of(const Snapshot& now);
/// Why a run that could begin before its text was loaded must not begin now: a limit of the user's, a doubt
/// about a position or, of a run despite doubts, a doubt other than those in `agreed`. Empty: it may begin.
std::string why_not_begin_any_more(const Tab& tab, const sequence::Sequence& sequence,
                                   const AgreedDoubts& agreed = {});

/// The same by doubts only: travel limits do not bind the user's own texts.
std::string why_doubted_meanwhile(const Tab& tab, const sequence::Sequence& sequence,
                                  const AgreedDoubts& agreed);
/// The effects of a user's own text, as far as the controller's language can be read; none: it cannot be
/// read.
std::optional<sequence::Sequence> read_sequence(Tab& tab, const std::string& text);

// Why no run can begin now: the same words in every panel.
inline constexpr std::string_view no_link_to_run =
    "There is no link. Run is available again when the controller answers.";
inline constexpr std::string_view program_in_transfer = "A program is being transferred.";
inline constexpr std::string_view another_runs =
    "A program is running. Run is available again when it ends or is stopped.";

/// Why nothing can be begun in pieces now; empty: it can.
std::string_view why_no_pieces(Tab& tab);

}  // namespace hw::gui
