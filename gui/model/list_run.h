#pragma once
// Loads a text into the controller and starts it: the list of the contour panel. The text is not started
// after a stop, nor when its panel is no longer looked at. GUI thread.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "gui/model/report.h"

namespace hw::gui {

class ListRun {
 public:
  using Send = std::function<IntentId(IntentBody)>;
  using Words = std::function<std::string(const IntentOutcome&)>;

  /// `places`: the targets of the text.
  void begin(std::string text, std::vector<AxisTarget> places, const Send& send);
  /// The refused start was sent once more, as this intent.
  void started_as(IntentId id) { starting_ = id; }
  /// Once a frame. `words`: the sentence of an outcome, in the units of the axes.
  void follow(const Snapshot& now, const Send& send, const Words& words);
  /// The panel is drawn in this frame.
  void looked_at() { seen_ = true; }
  /// A stop was sent.
  void stopped() { loading_ = starting_ = 0; }

  [[nodiscard]] bool busy() const { return loading_ != 0 || starting_ != 0; }
  /// The start that was sent, for DoubtRemedies.
  [[nodiscard]] const std::optional<intent::RunProgram>& start() const { return start_; }
  /// The outcome of a refused start, returned once.
  [[nodiscard]] std::optional<IntentOutcome> take_refusal() { return std::exchange(refusal_, std::nullopt); }
  [[nodiscard]] std::vector<Report> take_report() { return std::exchange(reports_, {}); }

 private:
  [[nodiscard]] const IntentOutcome* ended(IntentId& id, const Snapshot& now) const;

  IntentId loading_ = 0, starting_ = 0;
  bool seen_ = true;        ///< its panel was drawn since the last frame
  bool may_start_ = false;  ///< no other panel came to the front since it was sent
  std::vector<AxisTarget> places_;
  std::optional<intent::RunProgram> start_;
  std::optional<IntentOutcome> refusal_;
  std::vector<Report> reports_;
};

}  // namespace hw::gui
