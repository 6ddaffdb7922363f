#include "panels/blocks/step_form.h"

#include "core/sequence/fields.h"
#include "panels/blocks/field_lines.h"

namespace hw::panels {

using namespace gui;
namespace {

sequence::Step::Body without_steps(const sequence::Step::Body& body) {
  if (const auto* loop = std::get_if<sequence::Repeat>(&body)) return sequence::Repeat{loop->times, {}};
  const auto* contour = std::get_if<sequence::Contour>(&body);
  if (!contour) return body;
  sequence::Contour frame;
  frame.x = contour->x, frame.y = contour->y, frame.lead_in = contour->lead_in;
  frame.ends_ramped = contour->ends_ramped, frame.own = contour->own, frame.plane = contour->plane;
  return frame;
}

sequence::Step::Body with_steps_of(const sequence::Step::Body& body, sequence::Step::Body frame) {
  if (auto* loop = std::get_if<sequence::Repeat>(&frame))
    loop->steps = std::get<sequence::Repeat>(body).steps;
  if (auto* contour = std::get_if<sequence::Contour>(&frame))
    contour->steps = std::get<sequence::Contour>(body).steps;
  return frame;
}

}  // namespace

bool StepForm::Draft::is_of(const sequence::Step::Body& other) const {
  return body && body->index() == other.index() && *body == without_steps(other);
}

StepForm::Draft StepForm::leave() {
  Draft draft = std::move(waiting_);
  if (draft.problem.empty() && !problem_.empty()) {
    draft.problem = problem_, draft.body = std::move(edited_);
    for (const auto& [id, field] : numbers_) draft.texts.emplace_back(id.substr(path_.size()), field.text);
  }
  forget();
  return draft;
}

std::optional<sequence::Step::Body> StepForm::draw(Frame& f, const EditedStep& step, float width) {
  if (!edited_) edited_ = without_steps(step.body);
  if (path_ != step.path) path_ = step.path;
  for (const auto& [below, text] : waiting_.texts) numbers_[path_ + below].text = text;
  waiting_.texts.clear(), waiting_.problem.clear();
  FieldLines lines(f, step, *edited_, numbers_, width);
  if (std::holds_alternative<sequence::Custom>(*edited_)) lines.with_several_lines();
  std::visit([&lines](auto& b) { fields(lines, b); }, *edited_);
  problem_ = std::move(lines.problem());
  if (lines.refusal_left()) draw_step_refusal(f, step, width);
  if (!lines.changed()) return std::nullopt;
  return with_steps_of(step.body, *edited_);
}

}  // namespace hw::panels
