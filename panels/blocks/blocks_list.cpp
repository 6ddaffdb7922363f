// The column of blocks.
#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/blocks/block_text.h"
#include "panels/blocks/blocks.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

constexpr float row_height = 40, row_gap = 4, indent = 20;

/// What is old or not known is no place to be taught.
bool is_seen_now(const Frame& f, const AxisState& axis) {
  return f.connected() && axis.position_known && !is_stale(axis.seen_at, f.clock, f.now.poll_period);
}

}  // namespace

void Blocks::draw_palette(Frame& f, float height) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), at.y));
  begin_part(ui, "blocks/palette", ui.px(148), ui.px(height), Tone::panel, 8);
  gap(ui, 8);
  if (auto body = palette_.draw(f, editor_->sequence(), true)) add(std::move(*body));
  gap(ui, 8);
  end_part();
}

/// Behind the chosen block, into a chosen loop, or at the end.
void Blocks::add(seq::Step::Body body) {
  seq::StepPath at{editor_->sequence().steps.size()};
  if (chosen_.path) {
    at = *chosen_.path;
    const seq::Step* step = editor_->at(at);
    if (const auto* loop = step ? std::get_if<seq::Repeat>(&step->body) : nullptr)
      at.push_back(loop->steps.size());
    else
      ++at.back();
  }
  choose(editor_->insert(at, seq::Step{std::move(body)}));
}

void Blocks::choose(std::optional<seq::StepPath> path) {
  if (path && (path->empty() || !editor_->at(*path))) path.reset();
  rows_.follow(*editor_);
  chosen_.path = std::move(path);
  chosen_.row = rows_.row_of(chosen_.path);
  form_.forget();
}

/// Up or down among all rows, in and out of loops.
void Blocks::move(int rows) {
  if (!chosen_.path) return;
  seq::StepPath to = *chosen_.path;
  if (rows < 0 && to.back() > 0) {
    --to.back();
    const seq::Step* above = editor_->at(to);
    if (const auto* loop = above ? std::get_if<seq::Repeat>(&above->body) : nullptr)
      to.push_back(loop->steps.size());
  } else if (rows < 0) {
    to.pop_back();  // out of its loop, in front of it
  } else {
    ++to.back();
    const seq::Step* below = editor_->at(to);
    if (below && std::holds_alternative<seq::Repeat>(below->body)) {
      to.push_back(0);
    } else if (below) {
      ++to.back();
    } else {
      to.pop_back();  // out of its loop, behind it
      if (!to.empty()) ++to.back();
    }
  }
  if (to.empty()) return;
  if (const auto moved = editor_->move(*chosen_.path, to)) choose(moved);
}

/// What was carried comes there; behind a loop is within it.
void Blocks::drop(const RowDrag::Drop& d) {
  if (d.from >= rows_.size() || d.to >= rows_.size()) return;
  seq::StepPath to = rows_.path(d.to);
  const seq::Step* there = editor_->at(to);
  if (d.behind && there && std::holds_alternative<seq::Repeat>(there->body))
    to.push_back(0);
  else if (d.behind)
    ++to.back();
  if (const auto moved = editor_->move(rows_.path(d.from), to)) choose(moved);
}

void Blocks::change_chosen(std::optional<seq::StepPath> (seq::Editor::*change)(const seq::StepPath&)) {
  const seq::StepPath at = *chosen_.path;
  choose((editor_->*change)(at));
}

/// The target becomes where the axes are now: of those that it names, or of all while it is as it was made.
void Blocks::take_here(const Frame& f, seq::Move m) {
  const seq::Sequence& s = editor_->sequence();
  const bool untouched =
      std::all_of(m.to.begin(), m.to.end(), [](const auto& to) { return !to || *to == 0; });
  for (std::size_t a = 0; a < s.axes.size(); ++a) {
    const int axis = f.catalog.find_axis(s.axes[a].name);
    if ((!m.to[a] && !untouched) || axis < 0 || !is_seen_now(f, f.now.axes[ix(axis)])) continue;
    m.to[a] = static_cast<double>(f.now.axes[ix(axis)].commanded().value) / s.axes[a].per_unit;
  }
  editor_->replace(*chosen_.path, m);
  form_.forget();
}

void Blocks::draw_list(Frame& f, float left, float width, float height) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (left > 0)
    ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + ui.hair(), ui.px(f.area.bottom())),
                                              ui[Tone::line]);
  begin_part(ui, "blocks/list", ui.px(width), ui.px(height), Tone::panel, 12);
  const float inner = ImGui::GetContentRegionAvail().x / ui.scale;
  section_title(ui, "Blocks", "rehearsed");
  const bool palette_aside = left > 0;
  if (!palette_aside) {
    if (auto body = palette_.draw(f, editor_->sequence(), false)) add(std::move(*body));
    gap(ui, 8);
  }
  if (f.area.width < 760) draw_block_problem(f, *work_.written(), inner);
  draw_rows(f, inner);
  if (const auto dropped = drag_.finish(ui)) drop(*dropped);
  draw_end(f, inner, palette_aside);
  draw_total(f, inner);
  gap(ui, 16);
  end_part();
}

/// Of very many rows those out of sight only take their place: then not even scripts find them.
void Blocks::draw_rows(Frame& f, float width) {
  constexpr int very_many = 500, beyond_sight = 3;
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float pitch = ui.px(row_height) + ui.px(row_gap);
  const int count = static_cast<int>(rows_.size()), chosen = chosen_.row;
  const auto top_of = [&](int row) {
    return at.y + static_cast<float>(row) * pitch + (chosen >= 0 && row > chosen ? chosen_.height_px : 0.0f);
  };
  int first = 0, behind = count;
  if (count >= very_many) {
    const float above = ImGui::GetWindowPos().y - at.y, below = above + ImGui::GetWindowHeight();
    const auto row_at = [&](float y) {
      const bool under = chosen >= 0 && y > static_cast<float>(chosen + 1) * pitch;
      const float rows =
          (under ? std::max(y - chosen_.height_px, static_cast<float>(chosen) * pitch) : y) / pitch;
      return std::clamp(static_cast<int>(rows), 0, count);
    };
    first = std::max(row_at(above) - beyond_sight, 0);
    behind = std::min(row_at(below) + beyond_sight + 1, count);
    if (chosen >= 0 && chosen < first) draw_row_at(f, chosen, ImVec2(at.x, top_of(chosen)), width);
  }
  for (int row = first; row < behind; ++row) draw_row_at(f, row, ImVec2(at.x, top_of(row)), width);
  if (chosen >= behind) draw_row_at(f, chosen, ImVec2(at.x, top_of(chosen)), width);
  ImGui::SetCursorScreenPos(ImVec2(at.x, top_of(count)));
}

void Blocks::draw_row_at(Frame& f, int row, ImVec2 at, float width) {
  if (ix(row) >= rows_.size()) return;  // one above has just been removed
  ImGui::SetCursorScreenPos(at);
  draw_row(f, ix(row), width);
}

void Blocks::draw_row(Frame& f, std::size_t row, float width) {
  Ui& ui = f.ui;
  const BlockRows::Words& words = rows_.words(row);
  const bool skipped = rows_.step(row).skipped, refused = is_refused(row);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = indent * static_cast<float>(rows_.depth(row));
  const bool chosen = chosen_.row == static_cast<int>(row);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), at.y));
  const Touch t = touch(ui, {Path("blocks/{}", row + 1), Kind::button, words.title, words.summary},
                        ImVec2(ui.px(width - left), ui.px(row_height)));
  const bool live = run_.live_step() == static_cast<int>(row);
  const Tone ground = refused     ? Tone::fault_t
                      : live      ? Tone::motion_t
                      : chosen    ? Tone::sel
                      : t.hovered ? Tone::hover
                                  : Tone::raised;
  if (!skipped || chosen) draw_fill(ui, t.rect, ui[ground]);
  if (skipped) draw_dashed_outline(ui, t.rect, ui[Tone::edge]);
  if (chosen)
    ImGui::GetWindowDrawList()->AddRectFilled(t.rect.min, ImVec2(t.rect.min.x + ui.px(3), t.rect.max.y),
                                              ui[refused ? Tone::fault : Tone::ink]);
  const float middle = std::floor(t.rect.centre().y), x = t.rect.min.x, right = t.rect.max.x - ui.px(12);
  const Tone ink = skipped ? Tone::ink3 : Tone::ink, ink2 = skipped ? Tone::ink3 : Tone::ink2;
  draw_text_line(ui, x + ui.px(12), x + ui.px(48), middle, Face::small, ui[Tone::ink3], words.number);
  draw_text_line(ui, x + ui.px(48), x + ui.px(152), middle, Face::body_bold, ui[ink], words.title);
  const std::string_view at_right = skipped   ? "left out"
                                    : refused ? "not written"
                                    : live    ? run_.live_words()
                                              : trial_.time_of(row);
  const Face face = live ? Face::small_bold : Face::small;
  const float said = at_right.empty() ? 0 : std::ceil(text_width(ui, face, at_right)) + ui.px(8);
  draw_text_line(ui, x + ui.px(152), right - said, middle, Face::body, ui[ink2], words.summary);
  draw_text_right(ui, ImVec2(right, middle - ui.line(face) / 2), face, ui[live ? Tone::motion : Tone::ink3],
                  at_right);
  show(ui, {Path("blocks/{}/time", row + 1), Kind::text, live ? "State" : "Rehearsed", at_right},
       {ImVec2(right - said, t.rect.min.y), ImVec2(right, t.rect.max.y)});
  drag_.see(ui, row, t);
  draw_ring(ui, t);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y + ui.px(row_gap)));
  const float below = ImGui::GetCursorScreenPos().y;
  if (chosen) draw_chosen(f, row, left, width);
  if (chosen) chosen_.height_px = ImGui::GetCursorScreenPos().y - below;
  if (t.clicked && !drag_.carries()) choose(chosen ? std::nullopt : std::optional(rows_.path(row)));
}

bool Blocks::is_refused(std::size_t row) const {
  const auto& refused = work_.written()->refused;
  return refused && work_.up_to_date() && rows_.is_at(row, *refused);
}

void Blocks::draw_chosen(Frame& f, std::size_t row, float left, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float inner = width - left - 24;
  if (is_refused(row)) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left + 12), at.y));
    const std::string_view problem = work_.written()->problem;
    const std::size_t why = problem.find("): ");
    wrapped(ui, Face::body, Tone::fault, problem.substr(why == problem.npos ? 0 : why + 3), inner);
    gap(ui, 4);
  }
  ImGui::Indent(ui.px(left + 12));
  const std::uint64_t version = editor_->version();
  draw_tools(f, rows_.step(row));
  gap(ui, 4);
  if (editor_->version() == version && chosen_.path)
    if (auto body =
            form_.draw(f, Path("blocks/{}", row + 1), rows_.step(row).body, editor_->sequence(), inner))
      editor_->replace(*chosen_.path, std::move(*body));
  ImGui::Unindent(ui.px(left + 12));
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + ui.px(8)));
}

void Blocks::draw_tools(Frame& f, const seq::Step& step) {
  Ui& ui = f.ui;
  const float left = ImGui::GetCursorScreenPos().x, edge = left + ImGui::GetContentRegionAvail().x;
  const auto tool = [&](const char* id, const char* label, Icon icon = Icon::none,
                        std::string_view why_not = {}) {
    ButtonOptions look;
    look.disabled = why_not;
    look.style = ButtonStyle::outlined;
    look.icon = icon;
    const float width = ui.px(button_width(ui, label, look));
    if (ImGui::GetCursorScreenPos().x + width > edge) {
      ImGui::NewLine();
      ImGui::SetCursorScreenPos(ImVec2(left, ImGui::GetCursorScreenPos().y));
    }
    const bool clicked = button(ui, id, label, look).clicked;
    ImGui::SameLine(0, ui.px(4));
    return clicked;
  };
  const seq::StepPath at = *chosen_.path;
  const auto* move = std::get_if<seq::Move>(&step.body);
  const bool is_seen = std::any_of(f.now.axes.begin(), f.now.axes.begin() + f.now.axis_count,
                                   [&f](const AxisState& axis) { return is_seen_now(f, axis); });
  if (move && !move->relative &&
      tool("blocks/here", "Take here", Icon::none, is_seen ? "" : "Where the axes stand is not known now."))
    return take_here(f, *move);
  if (tool("blocks/up", "", Icon::chevron_up)) return this->move(-1);
  if (tool("blocks/down", "", Icon::chevron_down)) return this->move(1);
  if (tool("blocks/remove", "", Icon::cross)) return choose(editor_->remove(at));
  if (tool("blocks/duplicate", "Duplicate")) return choose(editor_->duplicate(at));
  if (tool("blocks/skip", step.skipped ? "Take in" : "Leave out"))
    return choose(editor_->skip(at, !step.skipped));
  if (std::holds_alternative<seq::Repeat>(step.body)) {
    if (tool("blocks/unloop", "Take out of loop")) return choose(editor_->take_out_of_loop(at));
  } else if (tool("blocks/loop", "Into a loop")) {
    return choose(editor_->put_into_loop(at));
  }
  ImGui::NewLine();
}

/// How long all of it takes, or why nobody can say.
void Blocks::draw_total(Frame& f, float width) {
  Ui& ui = f.ui;
  const ProgramFacts& program = f.catalog.program;
  if (work_.written()->cost > 0 && program.capacity > 0) {
    gap(ui, 8);
    const Path used("{} of {} {}", work_.written()->cost, program.capacity, program.capacity_unit);
    key_value(ui, "blocks/memory", "Memory", used);
  }
  if (trial_.total().empty()) return;
  gap(ui, 8);
  if (!trial_.ends()) return wrapped(ui, Face::body, Tone::ink2, trial_.total(), width);
  key_value(ui, "blocks/total", "Rehearsed", trial_.total());
}

/// Where the next block goes when none is chosen.
void Blocks::draw_end(Frame& f, float width, bool palette_aside) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Touch t = touch(ui, {"blocks/end", Kind::button, "Next block here"}, ImVec2(ui.px(width), ui.px(32)));
  draw_dashed_outline(ui, t.rect, ui[chosen_.path ? Tone::edge : Tone::ink2]);
  draw_text_centred(ui, t.rect, Face::body, ui[chosen_.path ? Tone::ink3 : Tone::ink2],
                    rows_.size() > 0 ? "Next block here"
                    : palette_aside  ? "Choose a block at the left: it comes here"
                                     : "Type the name of a block above: it comes here");
  draw_ring(ui, t);
  if (t.clicked) choose(std::nullopt);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
}

}  // namespace hw::panels
