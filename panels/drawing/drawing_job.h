#pragma once
// Turns a drawing file into a program. The worker reads, converts, writes and rehearses it, and does so again
// after each change of the options.
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

/// The pieces of each controller, in the order of the drawing axes. A single controller has one entry.
using Parts = std::vector<std::shared_ptr<const Pieces>>;
/// `language` is null if several controllers of one axis each draw together, see catalog_together().
/// `number`: see Pieces::drawing.
Result<Parts> parts_of(const sequence::Sequence& sequence, const Catalog& catalog, const Language* language,
                       int from_step, std::uint64_t number);

/// Measures the time spent at the step reported last. A controller that runs a stored program reports no
/// other step until it ends.
class StepClock {
 public:
  /// Call once a frame. `at_work`: whether this time counts, as the time of a transfer may not.
  void follow(const PiecesState& now, Instant clock, bool at_work = true);
  [[nodiscard]] double time_at_step_s() const { return time_at_step_s_; }

 private:
  std::int32_t step_ = -1, done_ = 0;
  bool running_ = false;  ///< as of the last follow()
  Instant seen_at_{};
  double time_at_step_s_ = 0;  ///< in seconds, without the time during which the run was held
};

class DrawingJob {
 public:
  struct Made {
    Conversion conversion;
    SequenceText written;              ///< empty: several controllers draw, without a common program
    std::string problem;               ///< why the text does not fit; empty: it fits
    std::optional<double> duration_s;  ///< from the rehearsal
    std::optional<double> at_least_s;  ///< least duration at the requested speeds; with ramps if several
                                       ///< controllers draw together
    bool with_transfers = false;       ///< all times below include the transfer of each piece
    std::uint64_t number = 0;          ///< Pieces::drawing of its pieces
    Parts parts;                       ///< empty: no pieces
    std::string no_pieces;             ///< why there are no pieces
    /// Duration of each chain, from the rehearsal, else from their lengths; empty: unknown.
    std::vector<double> chain_seconds;
    std::shared_ptr<const drawing::ToolPath>
        path;  ///< in the units of the axes; the source of a run is its chain
    /// The intended lines of controllers that draw together. `path` is then their real path, as far as it was
    /// rehearsed.
    std::shared_ptr<const drawing::ToolPath> meant;
    std::shared_ptr<const Rehearsal> together;  ///< rehearsal of these controllers; null: not rehearsed
    double beside = 0;                          ///< greatest distance between `path` and the lines of `meant`
  };

  /// The time left from a step of the sequence on, at `percent` of its speeds, `time_at_step_s` after
  /// reaching the step; nullopt: unknown.
  [[nodiscard]] static std::optional<double> seconds_left(const Made& made, int step, int percent,
                                                          double time_at_step_s = 0);

  /// Reads the file, then converts it with the options `wanted`. If the file cannot be read, the previous
  /// drawing stays.
  void open(gui::Frame& frame, const std::filesystem::path& file, const ConversionOptions& wanted);
  /// Number of files opened, because options of a file do not apply to the next file.
  [[nodiscard]] int opened() const { return opened_; }
  /// Call once a frame. `version` changes with `wanted`. `scale`: units of the axes per mm.
  void follow(gui::Frame& frame, const ConversionOptions& wanted, std::uint64_t version,
              drawing::Point scale);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// The open drawing; null: none is open.
  [[nodiscard]] const drawing::Drawing* drawing() const { return drawing_.get(); }
  /// The results; null: not made yet, or cannot be made with these options, see fault().
  [[nodiscard]] const Made* made() const { return made_.get(); }
  [[nodiscard]] std::shared_ptr<const Made> shared_made() const { return made_; }
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// The outline to show until the drawing is made, in the units of the axes; null: none.
  [[nodiscard]] std::shared_ptr<const Outline> outline() const { return made_ ? nullptr : outline_; }
  [[nodiscard]] bool busy() const { return reading_ || converting_; }
  /// Progress of ordering the chains, from 0 to 1; 1: finished.
  [[nodiscard]] float ordered() const { return *ordered_; }
  /// Names the work under way; empty: none.
  [[nodiscard]] std::string_view busy_with() const;
  /// Units of the axes per mm.
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
  std::shared_ptr<const Outline> outline_;
  std::string fault_;
  bool reading_ = false, anew_ = false;    ///< anew_: the user opened the file that is being read
  bool converting_ = false, old_ = false;  ///< old_: the conversion under way is of another file
  int reads_ = 0;                          ///< number of the latest reading, the only one that counts
  drawing::Point scale_;
  struct ReadAs {
    double chord = 0;       ///< finest_chord()
    std::string file_unit;  ///< unit that overrides the unit of the file; empty: the file's
    double times = 1;       ///< factor by which the drawing is enlarged
    bool operator==(const ReadAs&) const = default;
  } flattened_as_,
      read_as_;  ///< flattened_as_: of the drawing; read_as_: of the latest reading, which may have failed
  static ReadAs as(const gui::Frame& frame, const ConversionOptions& wanted) {
    return {finest_chord(frame.catalog, wanted), wanted.drawing_unit, wanted.times};
  }
  std::uint64_t wanted_ = 0, version_ = 0;
  /// Set by the worker, which may outlive this object.
  std::shared_ptr<std::atomic<float>> ordered_ = std::make_shared<std::atomic<float>>(0.0f);
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
