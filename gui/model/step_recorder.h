#pragma once
// Makes steps of a servo axis and records them: one step, or to and fro until it is switched off. A recording
// continues while other panels are in front; the next step of a series is made only while its panel is looked
// at. GUI thread.
#include <cstdint>
#include <deque>
#include <functional>
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "gui/model/report.h"
#include "gui/model/step_response.h"

namespace hw::gui {

class StepRecorder {
 public:
  struct Plan {
    AxisId axis{};
    Steps step{};  ///< of the first step; every second one goes back
    double length_ms = 0;
    bool operator==(const Plan&) const = default;
  };
  using Send = std::function<IntentId(IntentBody)>;
  /// One frame.
  struct View {
    const Snapshot& now;
    Instant clock;
    std::function<std::string_view(AxisId)> why_not_move;  ///< Tab::why_not_move()
    Send send;
  };

  /// Makes one step away from the present place.
  void record(const Plan& plan, const View& view);
  /// To and fro until end_where_it_began().
  void repeat(const Plan& plan, const View& view);
  /// As many times to and fro as the scatter takes.
  void learn_scatter(const Plan& plan, const View& view);
  /// A step away from the start is followed by one back.
  void end_where_it_began();
  /// Why no step can be made now; empty: it can.
  [[nodiscard]] std::string_view why_not(AxisId axis, const View& view) const;

  /// Once a frame, after the samples were taken.
  void follow(const View& view);
  /// Takes a sample of the recording under way; drops others.
  void take(const AxisSample& sample);
  /// Its panel is drawn in this frame.
  void looked_at() { frame_.seen = true; }
  /// A stop was sent.
  void stopped() { frame_.stopped = true; }
  /// Another command of its own panel ends no series.
  void sent_beside(IntentId id) { newest_ = id; }
  /// Another axis was chosen. Not while it is busy.
  void forget_runs();

  [[nodiscard]] bool busy() const { return stage_ != Stage::idle; }
  [[nodiscard]] bool records() const { return stage_ == Stage::arming || stage_ == Stage::recording; }
  [[nodiscard]] bool repeats() const { return series_.on; }
  /// Oldest first. The last one is under way while it records().
  [[nodiscard]] const std::deque<StepRun>& runs() const { return results_.runs; }
  /// Number and measures of the latest complete run; 0: none.
  [[nodiscard]] int measured_number() const { return results_.measured_number; }
  [[nodiscard]] const StepMeasures& measured() const { return results_.measured; }
  /// Of the axis, step and length recorded last.
  [[nodiscard]] const StepScatter& scatter() const { return results_.scatter; }
  [[nodiscard]] std::vector<Report> take_report() { return std::exchange(reports_, {}); }

 private:
  enum class Stage : std::uint8_t {
    idle,
    arming,     ///< the recording is requested; the step follows its first sample
    recording,  ///< the step is made
    pausing     ///< between two steps of a series
  };
  struct Series {
    bool on = false;
    int steps_left = 0;  ///< even, so that the axis returns to its start; negative: until it is ended
    bool learns_scatter = false;
    int spare = StepScatter::enough;  ///< repetitions that may be made again
  };
  /// The link and the controller when the latest step was requested.
  struct Before {
    std::uint64_t timeouts = 0;
    std::uint32_t restarts = 0;
  };
  /// The times of the samples of the run under way.
  struct Span {
    bool any = false;
    Instant first{}, last{};
  };

  /// The step under way, or the latest one.
  struct Step {
    int sign = 1, number = 0;
    Before before;
    Span span;
    Instant since{};  ///< its stage began
    IntentId move = 0;
  };
  struct Frame {
    Instant at{};
    bool seen = true;      ///< its panel was drawn since the last frame
    bool stopped = false;  ///< since the last frame
  };
  struct Results {
    std::deque<StepRun> runs;
    StepMeasures measured;
    int measured_number = 0;
    StepScatter scatter;
  };

  void begin(const Plan& plan, int steps, const View& view);
  void request(const View& view);
  void make_step(const View& view);
  void pause(const View& view);
  void finish(const View& view);
  void drop_run();
  void end_series(std::string_view why);
  bool ended_early(const View& view);
  void count_into_scatter();
  [[nodiscard]] bool was_away(const View& view);
  [[nodiscard]] std::string_view interruption(const View& view, bool away) const;
  void follow_series(const View& view, std::string_view between, bool stopped);
  [[nodiscard]] bool asked_by_others(const View& view) const { return view.now.outcomes[0].id > newest_; }
  void report(Severity severity, std::string sentence) {
    reports_.push_back({severity, std::move(sentence)});
  }

  Stage stage_ = Stage::idle;
  Series series_;
  Plan plan_;
  Step step_;
  Frame frame_;
  IntentId newest_ = 0;  ///< the latest command of its panel
  Results results_;
  std::vector<Report> reports_;
};

/// Recorded milliseconds unless the user types another number.
inline constexpr double usual_length_ms = 230;

}  // namespace hw::gui
