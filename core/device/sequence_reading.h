#pragma once
// What the readers of all languages share while they make steps of a text: the stretch of the text that each
// step has come from, and the proof that the steps are that text.
//
// A reader takes its text apart as well as it can. prove() has the steps written by the language's own
// writer, compares what both texts command, and leaves to the controller's own text what would come out
// otherwise. So a reader may be bold: what it shows is never another program.
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

/// Of a text, in bytes.
struct Stretch {
  std::size_t begin = 0, end = 0;
  [[nodiscard]] bool covers(std::size_t at) const { return begin <= at && at < end; }
};

/// A Custom has its words only: its text is the stretch.
struct ReadStep {
  sequence::Step::Body body;
  Stretch at;
  std::vector<ReadStep> inner{};  ///< of a loop, in the order of the text
  Stretch inside{};               ///< where they stand
};
using ReadSteps = std::vector<ReadStep>;

/// `why` as a name for it: "no block sets a variable".
inline ReadStep own_text(std::string why, Stretch at) { return {sequence::Custom{std::move(why), {}}, at}; }

struct ReadText {
  /// In the unit and axes of `frame`; where it has none, in steps of all.
  ReadText(const sequence::Sequence& frame, const Catalog& catalog);

  std::string unit;
  std::vector<sequence::Axis> axes;
  ReadSteps steps{}, pen_up{}, pen_down{};
  std::vector<std::string> remarks{};
  /// Of what the text uses before it sets it; there is a remark about it.
  std::map<std::string, std::string> assumed{};

  /// Of an axis of the catalog, its place in `axes`; -1: it is not among them.
  [[nodiscard]] int place_of(const Catalog& catalog, int axis) const;
  [[nodiscard]] double units(int place, std::int64_t steps) const {
    return static_cast<double>(steps) / axes[static_cast<std::size_t>(place)].per_unit;
  }
};

/// A command as far as it decides whether two texts are the same program.
struct Deed {
  enum class Flow : std::uint8_t {
    on,
    begins_block,  ///< of a branch or a loop
    next_branch,   ///< of the same block
    ends_block,
    changes_all,  ///< begins a program, or calls one: whatever was set may be set otherwise
  };
  std::string text;  ///< in one spelling
  Stretch at;
  std::string sets{};    ///< not empty: it sets this to `text`, and does nothing where it is so already
  bool constant = true;  ///< false: it may set another value each time
  bool speed = false;
  Flow flow = Flow::on;
  std::string uses{};  ///< not empty: what it does depends on how this is set
  Stretch set_at{};    ///< by what; essentials() finds it out
};
using Deeds = std::vector<Deed>;

/// Those that do something, each that uses what is set with its value in front ("?": nobody knows it). Where
/// all of those are known, what has set them counts for nothing more. `assumed`: is set at the begin.
[[nodiscard]] Deeds essentials(const Deeds& deeds, const std::map<std::string, std::string>& assumed);

/// What prove() asks of a language.
struct ReadingLanguage {
  std::function<Result<SequenceText>(const sequence::Sequence&)> write;
  std::function<Deeds(std::string_view text)> deeds;
  char comment_mark = ';';  ///< from it to the end of a line nothing is commanded
};

/// The fault names the line that no block can hold.
[[nodiscard]] Result<SequenceRead> prove(ReadText read, std::string_view text,
                                         const ReadingLanguage& language);

/// From 0.
[[nodiscard]] int line_of(std::string_view text, std::size_t at);
/// "Line 3: why".
[[nodiscard]] tl::unexpected<Fault> no_block_for(std::string_view text, std::size_t at, std::string_view why);

}  // namespace hw
