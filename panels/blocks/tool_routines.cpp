#include "panels/blocks/tool_routines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/steps_in.h"
#include "core/session/tool_routine.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/blocks/block_measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

/// Converts positions to the units shown, or back.
seq::StepList in_other_units(seq::StepList steps, const seq::Look& look, bool shown) {
  for (seq::Step& step : steps)
    if (auto* move = std::get_if<seq::Move>(&step.body))
      for (std::size_t a = 0; a < move->to.size(); ++a)
        if (auto& to = move->to[a])
          to = shown ? look.of_axis(static_cast<int>(a)).shown(*to)
                     : look.of_axis(static_cast<int>(a)).kept(*to);
  return steps;
}

bool same_tool(const seq::Sequence& a, const seq::Sequence& b) {
  return a.axes == b.axes && a.pen_up == b.pen_up && a.pen_down == b.pen_down;
}

bool has_tool(const seq::StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const seq::Step& step) {
    const seq::StepList* inner = seq::steps_in(step);
    return std::holds_alternative<seq::Pen>(step.body) || (inner && has_tool(*inner));
  });
}

}  // namespace

std::array<std::string, 2> ToolRoutines::written() const {
  return {write_routine(in_other_units(of_->pen_down, look_, true), *catalog_, of_->axes),
          write_routine(in_other_units(of_->pen_up, look_, true), *catalog_, of_->axes)};
}

void ToolRoutines::follow(const seq::Editor& editor, const Catalog& catalog, const seq::Look& look) {
  catalog_ = &catalog;
  if (of_ == editor.shared() && look_ == look) return;
  const bool same = of_ && same_tool(*of_, editor.sequence()) && look_ == look && loads_ == editor.loads();
  of_ = editor.shared();
  loads_ = editor.loads();
  // A refused routine is dropped with the last block that shows it.
  if (same && !problem_.empty() && !has_tool(of_->steps)) texts_ = kept_, problem_.clear();
  if (same) return;
  look_ = look;
  texts_ = kept_ = written();
  problem_.clear(), why_not_.clear();
  const auto again = read();
  if (again && !same_tool(*again, *of_))
    why_not_ = "These routines come from a file and contain more than the fields here can show.";
  if (!why_not_.empty() || !again) problem_.clear();
}

/// Reads both at once, because one routine must switch off the outputs that the other switches on.
std::optional<seq::Sequence> ToolRoutines::read() {
  seq::Sequence frame = seq::frame_of(*of_);
  const PerUnit upright = [](const std::string&) { return 1.0; };
  for (auto [text, steps] : {std::pair{&texts_[0], &frame.pen_down}, std::pair{&texts_[1], &frame.pen_up}}) {
    auto routine = read_routine(*text, *catalog_, upright, frame.axes);
    if (!routine) return problem_ = fmt::format("Tool: {}", routine.error().sentence()), std::nullopt;
    *steps = in_other_units(std::move(*routine), look_, false);
  }
  if (auto back = switches_back(frame.pen_down, frame.pen_up, *catalog_); !back)
    return problem_ = fmt::format("Tool: {}", back.error().sentence()), std::nullopt;
  problem_.clear();
  return frame;
}

std::optional<seq::Sequence> ToolRoutines::draw(Frame& f, std::string_view path, float width) {
  if (!of_) return std::nullopt;
  Ui& ui = f.ui;
  bool done = false;
  const auto line = [&](std::string_view key, std::string_view label, std::string& text) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text_line(ui, at.x, at.x + ui.px(field_label_width - 8), at.y + ui.px(16), Face::body,
                   ui[Tone::ink2], label);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(field_label_width), at.y));
    FieldOptions o;
    o.face = Face::code_field;
    o.width = width - field_label_width;
    o.placeholder = "nothing";
    o.disabled = why_not_;
    o.tip = "All Tool blocks do this in order: outputs on or off, an axis to a place, a wait.";
    const Field field = text_field(ui, Path("{}/{}", path, key), label, text, o);
    done = done || field.entered || field.left;
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(field_line_height)));
  };
  line("pen_down", "Down does", texts_[0]);
  line("pen_up", "Up does", texts_[1]);
  auto changed = done && texts_ != kept_ ? read() : std::nullopt;
  if (done && texts_ == kept_) problem_.clear();
  if (!problem_.empty()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::small, Tone::fault, problem_, width);
    show(ui, {Path("{}/routine", path), Kind::text, "Refused", problem_},
         {at, ImVec2(at.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  }
  return changed;
}

}  // namespace hw::panels
