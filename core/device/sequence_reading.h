#pragma once
// Shared by all language readers, which turn a text into steps: the stretch of text of each step, and the
// proof that the steps stand for that text.
//
// A reader interprets its text as well as it can. prove() writes the steps with the language's own writer,
// compares the commands of both texts, and keeps differing parts as the controller's own text. A reader may
// therefore guess: the steps never show another program.
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"

namespace hw {

/// A stretch of text, in bytes.
struct Stretch {
  std::size_t begin = 0, end = 0;
  [[nodiscard]] bool covers(std::size_t at) const { return begin <= at && at < end; }
};

/// A Custom step has only a reason: its text is the stretch.
struct ReadStep {
  sequence::Step::Body body;
  Stretch at;
  std::vector<ReadStep> inner{};  ///< of a loop, in the order of the text
  Stretch inside{};               ///< their stretches
};
using ReadSteps = std::vector<ReadStep>;

/// `why` describes it: "no block sets a variable".
inline ReadStep own_text(std::string why, Stretch at) { return {sequence::Custom{std::move(why), {}}, at}; }

struct ReadText {
  /// In the unit and axes of `frame`; if it has no axes, in steps of all axes.
  ReadText(const sequence::Sequence& frame, const Catalog& catalog);

  std::string unit;
  std::vector<sequence::Axis> axes;
  ReadSteps steps{}, pen_up{}, pen_down{};
  std::vector<std::string> remarks{};
  /// Values that the text uses before it sets them; each has a remark.
  std::map<std::string, std::string> assumed{};

  /// The place in `axes` of an axis of the catalog; -1: not among them.
  [[nodiscard]] int place_of(const Catalog& catalog, int axis) const;
  [[nodiscard]] double units(int place, std::int64_t steps) const {
    return static_cast<double>(steps) / axes[static_cast<std::size_t>(place)].per_unit;
  }
};

/// The essence of a command: decides whether two texts are the same program.
struct Operation {
  enum class Flow : std::uint8_t {
    on,
    begins_block,  ///< of a branch or a loop
    next_branch,   ///< of the same block
    ends_block,
    changes_all,  ///< begins or calls a program: settings may change
  };
  std::string text;  ///< in one normal spelling
  Stretch at;
  std::string
      sets{};  ///< not empty: the command sets this to `text`, and has no effect if that is its value already
  bool constant = true;  ///< false: the command may set another value each time
  bool speed = false;
  Flow flow = Flow::on;
  std::string uses{};  ///< not empty: its effect depends on this setting
  Stretch set_at{};    ///< the value that it depends on; found by essentials()
};
using Operations = std::vector<Operation>;

/// The commands with an effect, each with the settings that it uses in front ("?": unknown). If all are
/// known, the commands that set them are dropped. `assumed`: set at the beginning.
[[nodiscard]] Operations essentials(const Operations& operations,
                                    const std::map<std::string, std::string>& assumed);

/// The parts of a language that prove() needs.
struct ReadingLanguage {
  std::function<Result<SequenceText>(const sequence::Sequence&)> write;
  std::function<Operations(std::string_view text)> operations;
  char comment_mark = ';';  ///< begins a comment to the end of the line
};

/// The fault names a line that no block can hold.
[[nodiscard]] Result<SequenceRead> prove(ReadText read, std::string_view text,
                                         const ReadingLanguage& language);

/// Reasons that all readers word alike.
namespace why {
inline constexpr std::string_view no_block = "no block does this";
inline constexpr std::string_view no_test = "no block tests this condition";
inline constexpr std::string_view no_such_loop = "no loop of blocks continues like this";
inline constexpr std::string_view no_such_axis = "an axis that the blocks do not have";
inline constexpr std::string_view too_deep = "nested too deep for blocks";
inline constexpr std::string_view unlike_speeds = "speeds that differ between axes";
}  // namespace why
inline constexpr const char* blocks_unchanged = "The blocks are unchanged.";

/// From 0.
[[nodiscard]] int line_of(std::string_view text, std::size_t at);
/// "Line 3: why".
[[nodiscard]] tl::unexpected<Fault> no_block_for(std::string_view text, std::size_t at, std::string_view why);

}  // namespace hw
