// The column of blocks, and the palette that they come from.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/index.h"
#include "gui/area.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/blocks.h"
#include "panels/measures.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

constexpr float row_height = 40, indent = 20;

struct PaletteEntry {
  const char *group, *id, *label;
  seq::Step::Body (*make)(const seq::Sequence& of);
};

seq::Move whole_move(const seq::Sequence& of, bool relative) {
  seq::Move m;
  m.relative = relative;
  if (!of.axes.empty()) m.to[0] = 0;
  return m;
}

constexpr std::array<PaletteEntry, 18> palette{{
    {"Motion", "blocks/add/speed", "Speed",
     [](const seq::Sequence&) -> seq::Step::Body {
       return seq::Speed{{1000, 100, 300}};
     }},
    {"Motion", "blocks/add/move", "Move to",
     [](const seq::Sequence& of) -> seq::Step::Body { return whole_move(of, false); }},
    {"Motion", "blocks/add/move_by", "Move by",
     [](const seq::Sequence& of) -> seq::Step::Body { return whole_move(of, true); }},
    {"Motion", "blocks/add/arc", "Arc",
     [](const seq::Sequence&) -> seq::Step::Body {
       return seq::Arc{0, 0, 90, {}};
     }},
    {"Motion", "blocks/add/circle", "Circle",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Arc{}; }},
    {"Motion", "blocks/add/jog", "Jog", [](const seq::Sequence&) -> seq::Step::Body { return seq::Jog{}; }},
    {"Motion", "blocks/add/home", "Home",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Home{}; }},
    {"Motion", "blocks/add/stop", "Stop",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Stop{}; }},
    {"Waiting", "blocks/add/wait_motion", "Until still",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::WaitMotion{}; }},
    {"Waiting", "blocks/add/delay", "Delay",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Delay{500}; }},
    {"Waiting", "blocks/add/wait_input", "Wait for input",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::WaitInput{}; }},
    {"Waiting", "blocks/add/move_on_input", "Move on input",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::MoveOnInput{}; }},
    {"Signals", "blocks/add/output", "Output",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Output{}; }},
    {"Signals", "blocks/add/enable", "Motor power",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Enable{}; }},
    {"Signals", "blocks/add/pen", "Tool",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Pen{true}; }},
    {"Order", "blocks/add/loop", "Loop",
     [](const seq::Sequence&) -> seq::Step::Body {
       seq::Repeat loop;
       loop.times = 2;
       return loop;
     }},
    {"Order", "blocks/add/comment", "Comment",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Comment{"what comes now"}; }},
    {"Order", "blocks/add/custom", "Own text",
     [](const seq::Sequence&) -> seq::Step::Body { return seq::Custom{}; }},
}};

/// Typed so far: the beginning of one of its words, however it is written.
bool is_named(const PaletteEntry& entry, std::string_view typed) {
  const std::string_view label = entry.label;
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  for (std::size_t at = 0; at <= label.size(); ++at) {
    if (at > 0 && label[at - 1] != ' ') continue;
    const std::string_view rest = label.substr(at, typed.size());
    if (std::equal(rest.begin(), rest.end(), typed.begin(), typed.end(), same)) return true;
  }
  return false;
}

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
  draw_finder(f, true);
  gap(ui, 8);
  end_part();
}

/// A name is typed, and those that have it are there; `all`: before anything is typed, too.
void Blocks::draw_finder(Frame& f, bool all) {
  Ui& ui = f.ui;
  FieldOptions field;
  field.width = fill;
  field.placeholder = "Add by name";
  field.keep_focus = true;  // for the next one
  const Field typed = text_field(ui, "blocks/add_by_name", "Add by name", wanted_, field);
  if (!all && wanted_.empty()) return;
  const PaletteEntry* first = nullptr;
  std::string_view group;
  for (const PaletteEntry& entry : palette) {
    if (!is_named(entry, wanted_)) continue;
    if (!first) first = &entry;
    if (all && group != entry.group) {
      group = entry.group;
      gap(ui, 8);
      text(ui, Face::small, Tone::ink2, group);
    }
    ButtonOptions look;
    look.style = ButtonStyle::quiet;
    look.width = fill;
    if (!button(ui, entry.id, entry.label, look).clicked) continue;
    add(entry.make(editor_->sequence()));
    if (!all) return wanted_.clear();
  }
  if (!first) wrapped(ui, Face::small, Tone::ink2, "No block has such a name.");
  if (typed.entered && first && !wanted_.empty()) {
    add(first->make(editor_->sequence()));
    wanted_.clear();
  }
}

/// Behind the chosen block, into a chosen loop, or at the end.
void Blocks::add(seq::Step::Body body) {
  seq::StepPath at{editor_->sequence().steps.size()};
  if (chosen_) {
    at = *chosen_;
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
  chosen_ = std::move(path);
  form_.forget();
}

/// Up or down among all rows, in and out of loops.
void Blocks::move(int rows) {
  if (!chosen_) return;
  seq::StepPath to = *chosen_;
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
  if (const auto moved = editor_->move(*chosen_, to)) choose(moved);
}

/// What was carried comes there; behind a loop is within it.
void Blocks::drop(const RowDrag::Drop& d) {
  if (d.from >= rows_.size() || d.to >= rows_.size()) return;
  seq::StepPath to = rows_[d.to].path;
  const seq::Step* there = editor_->at(to);
  if (d.behind && there && std::holds_alternative<seq::Repeat>(there->body))
    to.push_back(0);
  else if (d.behind)
    ++to.back();
  if (const auto moved = editor_->move(rows_[d.from].path, to)) choose(moved);
}

void Blocks::change_chosen(std::optional<seq::StepPath> (seq::Editor::*change)(const seq::StepPath&)) {
  const seq::StepPath at = *chosen_;
  choose((editor_->*change)(at));
}

/// The target becomes where the axes are now.
void Blocks::take_here(const Frame& f, seq::Move m) {
  const seq::Sequence& s = editor_->sequence();
  for (std::size_t a = 0; a < s.axes.size(); ++a) {
    const int axis = f.catalog.find_axis(s.axes[a].name);
    if (!m.to[a] || axis < 0 || !is_seen_now(f, f.now.axes[ix(axis)])) continue;
    m.to[a] = static_cast<double>(f.now.axes[ix(axis)].commanded().value) / s.axes[a].per_unit;
  }
  editor_->replace(*chosen_, m);
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
    draw_finder(f, false);
    gap(ui, 8);
  }
  const bool problem_here = f.area.width < 760 && !problem_.empty();
  if (problem_here) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, Tone::fault, problem_, inner);
    show(ui, {"blocks/problem", Kind::text, "Problem", problem_},
         {from, ImVec2(from.x + ui.px(inner), ImGui::GetCursorScreenPos().y)});
    gap(ui, 8);
  }
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (!pass_over(ui, row)) draw_row(f, row, inner);
  if (const auto dropped = drag_.finish(ui)) drop(*dropped);
  draw_end(f, inner, palette_aside);
  draw_total(f, inner);
  gap(ui, 16);
  end_part();
}

/// Of very many rows those out of sight only take their place: then not even scripts find them.
bool Blocks::pass_over(Ui& ui, std::size_t row) {
  constexpr std::size_t very_many = 500;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float bottom = at.y + ui.px(row_height) + ui.px(4);
  const bool in_sight = bottom >= ImGui::GetWindowPos().y - ui.px(100) &&
                        at.y <= ImGui::GetWindowPos().y + ImGui::GetWindowHeight() + ui.px(100);
  if (rows_.size() < very_many || in_sight || (chosen_ && rows_[row].path == *chosen_)) return false;
  ImGui::SetCursorScreenPos(ImVec2(at.x, bottom));
  return true;
}

void Blocks::draw_row(Frame& f, std::size_t row, float width) {
  Ui& ui = f.ui;
  const Row& r = rows_[row];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = indent * static_cast<float>(r.path.size() - 1);
  const bool chosen = chosen_ && r.path == *chosen_;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), at.y));
  const Touch t = touch(ui, {Path("blocks/{}", row + 1), Kind::button, r.title, r.summary},
                        ImVec2(ui.px(width - left), ui.px(row_height)));
  const bool live = run_.live_step() == static_cast<int>(row);
  const Tone ground = r.refused   ? Tone::fault_t
                      : live      ? Tone::motion_t
                      : chosen    ? Tone::sel
                      : t.hovered ? Tone::hover
                                  : Tone::raised;
  if (!r.skipped || chosen) draw_fill(ui, t.rect, ui[ground]);
  if (r.skipped) draw_dashed_outline(ui, t.rect, ui[Tone::edge]);
  if (chosen)
    ImGui::GetWindowDrawList()->AddRectFilled(t.rect.min, ImVec2(t.rect.min.x + ui.px(3), t.rect.max.y),
                                              ui[r.refused ? Tone::fault : Tone::ink]);
  const float middle = std::floor(t.rect.centre().y), x = t.rect.min.x, right = t.rect.max.x - ui.px(12);
  const Tone ink = r.skipped ? Tone::ink3 : Tone::ink, ink2 = r.skipped ? Tone::ink3 : Tone::ink2;
  draw_text_line(ui, x + ui.px(12), x + ui.px(48), middle, Face::small, ui[Tone::ink3], r.number);
  draw_text_line(ui, x + ui.px(48), x + ui.px(152), middle, Face::body_bold, ui[ink], r.title);
  const std::string_view at_right = r.skipped   ? "left out"
                                    : r.refused ? "not written"
                                    : live      ? run_.live_words()
                                                : trial_.time_of(row);
  const Face face = live ? Face::small_bold : Face::small;
  const float said = at_right.empty() ? 0 : std::ceil(text_width(ui, face, at_right)) + ui.px(8);
  draw_text_line(ui, x + ui.px(152), right - said, middle, Face::body, ui[ink2], r.summary);
  draw_text_right(ui, ImVec2(right, middle - ui.line(face) / 2), face, ui[live ? Tone::motion : Tone::ink3],
                  at_right);
  show(ui, {Path("blocks/{}/time", row + 1), Kind::text, live ? "State" : "Rehearsed", at_right},
       {ImVec2(right - said, t.rect.min.y), ImVec2(right, t.rect.max.y)});
  drag_.see(ui, row, t);
  draw_ring(ui, t);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y + ui.px(4)));
  if (t.clicked && !drag_.carries()) choose(chosen ? std::nullopt : std::optional(r.path));
  if (chosen) draw_chosen(f, row, left, width);
}

void Blocks::draw_chosen(Frame& f, std::size_t row, float left, float width) {
  Ui& ui = f.ui;
  const seq::StepPath path = rows_[row].path;
  const seq::Step* step = editor_->at(path);
  if (!step) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float inner = width - left - 24;
  if (rows_[row].refused) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left + 12), at.y));
    const std::size_t why = problem_.find("): ");
    wrapped(ui, Face::body, Tone::fault,
            std::string_view(problem_).substr(why == problem_.npos ? 0 : why + 3), inner);
    gap(ui, 4);
  }
  ImGui::Indent(ui.px(left + 12));
  draw_tools(f, *step);
  gap(ui, 4);
  seq::Step::Body body = step->body;
  if (form_.draw(f, Path("blocks/{}", row + 1), body, editor_->sequence(), inner))
    editor_->replace(path, std::move(body));
  ImGui::Unindent(ui.px(left + 12));
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + ui.px(8)));
}

void Blocks::draw_tools(Frame& f, const seq::Step& step) {
  Ui& ui = f.ui;
  const float left = ImGui::GetCursorScreenPos().x, edge = left + ImGui::GetContentRegionAvail().x;
  const auto tool = [&](const char* id, const char* label, Icon icon = Icon::none) {
    ButtonOptions look;
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
  const seq::StepPath at = *chosen_;
  const auto* move = std::get_if<seq::Move>(&step.body);
  if (move && !move->relative && tool("blocks/here", "Take here")) return take_here(f, *move);
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
  if (trial_.total().empty()) return;
  Ui& ui = f.ui;
  gap(ui, 8);
  if (!trial_.ends()) return wrapped(ui, Face::body, Tone::ink2, trial_.total(), width);
  key_value(ui, "blocks/total", "Rehearsed", trial_.total());
}

/// Where the next block goes when none is chosen.
void Blocks::draw_end(Frame& f, float width, bool palette_aside) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Touch t = touch(ui, {"blocks/end", Kind::button, "Next block here"}, ImVec2(ui.px(width), ui.px(32)));
  draw_dashed_outline(ui, t.rect, ui[chosen_ ? Tone::edge : Tone::ink2]);
  draw_text_centred(ui, t.rect, Face::body, ui[chosen_ ? Tone::ink3 : Tone::ink2],
                    !rows_.empty()  ? "Next block here"
                    : palette_aside ? "Choose a block at the left: it comes here"
                                    : "Type the name of a block above: it comes here");
  draw_ring(ui, t);
  if (t.clicked) choose(std::nullopt);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
}

}  // namespace hw::panels
