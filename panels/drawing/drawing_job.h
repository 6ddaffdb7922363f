#pragma once
// A drawing file on its way to a program: read, converted, written and rehearsed by the worker, anew whenever
// what is wanted of it has changed.
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/drawing/tool_path.h"
#include "core/session/conversion.h"
#include "gui/model/bus.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// What each controller does, in the order of the axes that draw; one alone: its own.
using Parts = std::vector<std::shared_ptr<const Pieces>>;
/// `language` null: controllers of one axis each draw together, see catalog_together().
Result<Parts> parts_of(const sequence::Sequence& sequence, const Catalog& catalog, const Language* language,
                       int from_step);

/// How long it has been at the step that was told last: controllers that run a stored program tell no other
/// until it ends.
class StepClock {
 public:
  /// Once a frame.
  void follow(const PiecesState& now, Instant clock);
  [[nodiscard]] double at_it_s() const { return at_it_s_; }

 private:
  std::int32_t step_ = -1, done_ = 0;
  Instant seen_at_{};
  double at_it_s_ = 0;  ///< without the times in which it was held
};

class DrawingJob {
 public:
  struct Made {
    Conversion conversion;
    SequenceText written;              ///< empty: several controllers draw it, and there is no one program
    std::string frame;                 ///< text that goes once around it with the tool off
    std::string problem;               ///< of the text: it does not fit; empty: none
    std::optional<double> duration_s;  ///< as rehearsed
    std::optional<double> at_least_s;  ///< by the speeds that are asked for; together: with ramps
    Parts parts;                       ///< empty: it has no pieces
    std::string no_pieces;             ///< why
    /// As rehearsed, or as their lengths say what was not; empty: nothing tells.
    std::vector<double> chain_seconds;
    std::shared_ptr<const drawing::ToolPath> path;  ///< in the units of the axes; a source is a chain
    /// Of controllers that draw together: the lines that are meant. Then `path` is how they really go, as far
    /// as it was rehearsed.
    std::shared_ptr<const drawing::ToolPath> meant;
    std::shared_ptr<const Rehearsal> together;  ///< of these; null: not rehearsed
    double beside = 0;                          ///< so far `path` lies beside lines of `meant`, at most
  };

  /// From a step of its sequence on, at that share of its speeds, so long after it was come to; none: nothing
  /// tells.
  [[nodiscard]] static std::optional<double> seconds_left(const Made& made, int step, int percent,
                                                          double at_it_s = 0);

  /// The file is read, and converted as is wanted then. One that cannot be read leaves the drawing of before.
  void open(gui::Frame& frame, const std::filesystem::path& file, const ConversionOptions& wanted);
  /// How many files have been opened: what was wanted of the one before is not meant for the next.
  [[nodiscard]] int opened() const { return opened_; }
  /// Once a frame; `version` changes with `wanted`. `scale`: units of the axes in a mm.
  void follow(gui::Frame& frame, const ConversionOptions& wanted, std::uint64_t version,
              drawing::Point scale);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Null: none has been opened.
  [[nodiscard]] const drawing::Drawing* drawing() const { return drawing_.get(); }
  /// Null: not made, or what is wanted cannot be done; see fault().
  [[nodiscard]] const Made* made() const { return made_.get(); }
  [[nodiscard]] std::shared_ptr<const Made> shared_made() const { return made_; }
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] bool busy() const { return reading_ || converting_; }
  /// What of it is done, from 0 to 1, while it is put into order; 1: that is behind it.
  [[nodiscard]] float ordered() const { return *ordered_; }
  /// What it is at; empty: nothing.
  [[nodiscard]] std::string_view busy_with() const;
  /// Units of the axes in a mm.
  [[nodiscard]] drawing::Point scale() const { return scale_; }
  /// Grows with each result.
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  void show_on_bus(gui::Bus& bus) const;
  using Drawing = std::shared_ptr<const drawing::Drawing>;
  void read(gui::Frame& frame, const std::filesystem::path& file, const ConversionOptions& wanted, bool anew);
  void take(Result<Drawing> read, gui::Console& console);

  std::filesystem::path file_, reading_file_;
  int opened_ = 0;
  Drawing drawing_;
  std::shared_ptr<const Made> made_;
  std::string fault_;
  bool reading_ = false, anew_ = false;    ///< anew: somebody has opened what is being read
  bool converting_ = false, old_ = false;  ///< old: what was converted is of another file
  int reads_ = 0;                          ///< the last one counts
  drawing::Point scale_;
  struct ReadAs {
    double chord = 0;       ///< finest_chord()
    std::string file_unit;  ///< where the file does not say it
    bool operator==(const ReadAs&) const = default;
  } flattened_as_, read_as_;  ///< the drawing; what was read last, which may have failed
  static ReadAs as(const gui::Frame& frame, const ConversionOptions& wanted) {
    return {finest_chord(frame.catalog, wanted), wanted.drawing_unit};
  }
  std::uint64_t wanted_ = 0, version_ = 0;
  /// Set by the worker, which may outlive this.
  std::shared_ptr<std::atomic<float>> ordered_ = std::make_shared<std::atomic<float>>(0.0f);
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
