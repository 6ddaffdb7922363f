#pragma once
// Draws the fields of a step of a sequence, from the description that its file format has too
// (core/sequence/fields.h). If the controller cannot do the step, the reason is beside the field concerned.
// Ids: `PATH/KEY`, of a move `PATH/to/AXIS`, `PATH/axes/1`, `PATH/axes/2` and `PATH/way` of an arc,
// `PATH/stairs/N/until`, `PATH/nearest`, `PATH/refusal`.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/device/refused_steps.h"
#include "core/sequence/sequence.h"
#include "core/sequence/words.h"
#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// The step to edit.
struct EditedStep {
  std::string_view path;
  const sequence::Step::Body& body;
  const sequence::Sequence& of;
  const sequence::Look& look;
  const RefusedStep* refused = nullptr;  ///< null: the step was written
};

class StepForm {
 public:
  /// Rejected input.
  struct Draft {
    std::string problem;                       ///< StepForm::problem(); empty: all input was accepted
    std::optional<sequence::Step::Body> body;  ///< the present body, without the steps inside it
    std::vector<std::pair<std::string, std::string>>
        texts;  ///< texts of fields, by their id without that of the block
    [[nodiscard]] bool is_of(const sequence::Step::Body& body) const;
  };
  /// Draws at ImGui's cursor. Returns the edited body; nullopt: unchanged. Allocates nothing at rest.
  std::optional<sequence::Step::Body> draw(gui::Frame& frame, const EditedStep& step, float width);
  /// Call when another step is shown, or the same step with other values.
  void forget() { numbers_.clear(), edited_.reset(), problem_.clear(), waiting_ = {}; }
  /// As forget(), but returns the input that was not accepted.
  [[nodiscard]] Draft leave();
  /// Puts a draft back into the fields of its block.
  void take_up(Draft draft) { waiting_ = std::move(draft), problem_ = waiting_.problem; }
  /// Rejected input, which leaves the step unchanged: "Output: from 0 to 64."; empty: none.
  [[nodiscard]] std::string_view problem() const { return problem_; }

 private:
  std::map<std::string, gui::NumberField, std::less<>> numbers_;
  std::optional<sequence::Step::Body> edited_;  ///< without the steps inside it
  std::string problem_, path_;                  ///< path_: id of the block drawn last
  Draft waiting_;                               ///< draft of take_up(), until its fields are drawn
};

}  // namespace hw::panels
