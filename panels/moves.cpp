#include "panels/moves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/control/action_choice.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float file_height = 40, number_width = 44;

float cell_width(const Catalog& c, float width) {
  const auto n = static_cast<float>(c.move_list.columns.size());
  return std::floor((width - number_width - remove_width - between * n) / n);
}

}  // namespace

void Moves::draw(Frame& f) {
  if (!std::exchange(made_, true))
    for (std::size_t i = 0; i < f.catalog.actions.size(); ++i)
      if (f.catalog.actions[i].of_move_buffer) {
        actions_.emplace_back(f.catalog, static_cast<int>(i));
        if (const int set = f.catalog.find_readout(f.catalog.actions[i].sets); set >= 0)
          beside_switch_.set(static_cast<std::size_t>(set));
      }
  follow(f);
  draw_toolbar(f);
  draw_file_line(f);
  const bool side = f.area.width >= 680;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = f.area.width - (!side ? 0 : f.area.width >= 720 ? side_width : narrow_side_width);
  draw_table(f, width, (f.ui.px(f.area.bottom()) - at.y) / f.ui.scale);
  if (side) {
    const float x = f.ui.px(f.area.x + width);
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(x, at.y), ImVec2(x + f.ui.hair(), f.ui.px(f.area.bottom())), f.ui[Tone::line]);
    ImGui::SetCursorScreenPos(ImVec2(x + f.ui.hair(), at.y));
    // The side reaches to the end of the panel. The rest of a window that scrolls would be lower.
    begin_part(f.ui, "list/side", 0, f.ui.px(f.area.bottom()) - at.y, Tone::panel, 16);
    draw_side(f, ImGui::GetContentRegionAvail().x / f.ui.scale);
    end_part();
  }
  draw_dialogs(f);
}

/// Whether moves wait in the controller's buffer. They may as long as the buffer was not asked after the last
/// move was sent.
bool Moves::buffer_waits(const Frame& f) const {
  const int free = find_free_places(f.catalog);
  const auto i = static_cast<std::size_t>(std::max(free, 0));
  if (free < 0 || !f.connected() || !f.now.readouts_known[i]) return false;
  return f.now.readouts_seen_at[i] <= sent_at_ || f.now.readouts[i] < f.catalog.move_list.depth;
}

void Moves::follow(Frame& f) {
  const IntentOutcome* outcome = f.now.outcome_of(started_);
  const bool ended = outcome && outcome->state != IntentState::pending;
  const bool unseen = f.now.forgotten(started_);
  const bool was_sent = unseen || (ended && outcome->state != IntentState::refused);
  if (f.now.feed.running || was_sent) sent_at_ = f.clock;
  if (f.connected())  // without a link the controller may still work on the list
    works_ =
        f.now.feed.running || buffer_waits(f) || (works_ && f.now.feed.total > 0 && f.now.any_axis_moving());
  if (unseen) started_ = 0;
  if (!ended) return;
  started_ = 0;
  if (outcome->state == IntentState::done || doubt_.take_refusal(f, *outcome)) return;
  past_ = outcome->past;
  refused_ = f.tab.messages.words_of(*outcome);
  int decimals = 0;
  if (!cell_past_limit(f.catalog, decimals)) past_.reset(), f.toast(Severity::fault, refused_);
}

/// The field of the position past a limit; null: it was removed or overwritten.
NumberField* Moves::cell_past_limit(const Catalog& catalog, int& decimals) {
  const auto& columns = catalog.move_list.columns;
  if (!past_ || past_->row < 0 || ix(past_->row) >= rows_.size()) return nullptr;
  Row& row = rows_[ix(past_->row)];
  for (std::size_t c = 0; c < std::min(columns.size(), row.size()); ++c)
    if (columns[c].is_place && columns[c].of_axis == past_->axis.index) {
      decimals = columns[c].decimals;
      const auto value = row[c].value();
      return value && std::llround(*value * std::pow(10.0, decimals)) == past_->place.value ? &row[c]
                                                                                            : nullptr;
    }
  return nullptr;
}

/// Offers the nearest allowed position for that cell of the list.
void Moves::draw_refusal(Frame& f, const Rect& beside) {
  int decimals = 0;
  NumberField* cell = cell_past_limit(f.catalog, decimals);
  if (!cell) past_.reset();  // the refused number was changed
  if (!past_) return;
  const Path label("Put {} into move {}",
                   format_with_unit(past_->nearest, f.tab.settings.unit(past_->axis)).view(), past_->row + 1);
  const std::array<Action, 1> actions = {Action{.id = "list/nearest", .label = label}};
  card_.begin(f, {.id = "list/refused", .about = "Start", .words = refused_, .actions = actions}, beside);
  const RefusalTouch done = card_.end();
  if (done.action == 0) {
    cell->set(static_cast<double>(past_->nearest.value) / std::pow(10.0, decimals), decimals);
    edited_ = true;
  }
  if (done.action == 0 || done.closed) past_.reset();
}

// ---- toolbar

std::string_view Moves::why_not_start(const Frame& f) const {
  if (!f.connected()) return "There is no link. The list stays here.";
  if (f.now.feed.running)
    return "A list is being sent. Start is available again when it has ended or was aborted.";
  if (rows_.empty()) return "The list is empty.";
  return f.tab.why_not_move();
}

void Moves::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  ButtonOptions go;
  go.icon = Icon::play;
  go.moving = true;
  go.height = 40;
  go.disabled = why_not_start(f);
  go.tip = "Feeds the moves into the controller's buffer, in this order, as places become free.";
  const Touch started = button(ui, "list/start", "Start", go);
  if (started.clicked) start(f);
  ImGui::SameLine(0, ui.px(8));
  ButtonOptions stop;
  stop.icon = Icon::stop;
  stop.stops = true;
  stop.height = 40;
  stop.disabled = works_ || started_ != 0 ? "" : "No list is being sent.";
  stop.tip =
      "Stops the axes and sends no more moves. Buffered mode is switched off, and moves in the buffer are "
      "dropped.";
  if (button(ui, "list/abort", "Abort", stop).clicked) abort(f);
  const float left = ImGui::GetItemRectMax().x + ui.px(16);
  const float right = ui.px(f.area.right() - 16);
  if (doubt_.open())
    if (const IntentId sent = doubt_.draw(f, "list", "Start", started.rect)) started_ = sent;
  draw_progress(f, left, right, at.y + ui.px(toolbar_height / 2));
  draw_refusal(f, started.rect);
  end_toolbar(f, at);
}

/// Stops the axes first, then switches off the buffer, the only action that it accepts while busy.
void Moves::abort(Frame& f) {
  f.send(intent::Stop());
  for (const ActionForm& a : actions_)
    if (a.only_a_button() && f.catalog.actions[static_cast<std::size_t>(a.action())].while_busy)
      f.send(intent::Act(a.action(), {}));
}

void Moves::draw_progress(Frame& f, float left, float right, float middle) {
  Ui& ui = f.ui;
  const FeedState& feed = f.now.feed;
  const bool any = feed.total > 0;
  const Path words("{} of {} moves sent{}", feed.sent, feed.total,
                   feed.running              ? ""
                   : feed.sent == feed.total ? ", all of them"
                                             : ", then ended");
  const Path count("{} moves, {} fit into the buffer at once", rows_.size(), f.catalog.move_list.depth);
  const std::string_view shown = any ? words.view() : count.view();
  const float width = std::ceil(text_width(ui, Face::body, shown));
  draw_text_line(ui, std::max(left, right - width), right + 1, middle, Face::body, ui[Tone::ink2], shown);
  show(ui, {"list/progress", Kind::text, "Progress", shown, {}, false, {}},
       {ImVec2(left, middle - ui.px(16)), ImVec2(right, middle + ui.px(16))});
  const float bar = std::min(ui.px(160), right - width - ui.px(12) - left);
  if (!any || bar < ui.px(40)) return;
  ImGui::SetCursorScreenPos(ImVec2(right - width - ui.px(12) - bar, std::floor(middle - ui.px(4))));
  MeterOptions o;
  o.tone = feed.running ? Tone::motion : Tone::ink2;
  o.words = words;
  o.width = bar / ui.scale;
  meter(ui, "list/meter", "Moves sent", static_cast<float>(feed.sent) / static_cast<float>(feed.total), o);
}

void Moves::draw_file_line(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ui.px(file_height / 2);
  const ButtonOptions quiet{.style = ButtonStyle::quiet};
  const std::string name = file_.empty() ? (edited_ ? "not in a file" : "") : file_.filename().string();
  const float buttons = button_width(ui, "New", quiet) + button_width(ui, "Open", quiet) +
                        button_width(ui, "Save", quiet) + button_width(ui, "Add a move", quiet);
  const float left = ui.px(f.area.x + 16), end = ui.px(f.area.right() - 4 - buttons);
  draw_text_line(ui, left, end, middle, Face::body_bold, ui[file_.empty() ? Tone::warn : Tone::ink], name);
  if (!file_.empty() && edited_)
    draw_text_line(ui, left + std::ceil(text_width(ui, Face::body_bold, name)) + ui.px(8), end, middle,
                   Face::body, ui[Tone::warn], "edited");
  show(ui, {"list/file", Kind::text, "File", name, {}, false, {}},
       {ImVec2(left, at.y), ImVec2(end, at.y + ui.px(file_height))});
  ImGui::SetCursorScreenPos(ImVec2(end, at.y + ui.px(4)));
  if (button(ui, "list/add", "Add a move", quiet).clicked) {
    add_row(f.catalog);
    to_end_ = true;
  }
  ImGui::SameLine(0, 0);
  const bool fresh = button(ui, "list/new", "New", quiet).clicked;
  ImGui::SameLine(0, 0);
  const bool opens = button(ui, "list/open", "Open", quiet).clicked;
  ImGui::SameLine(0, 0);
  const bool saves = button(ui, "list/save", "Save", quiet).clicked;
  if (fresh || opens) {
    asked_to_open_ = opens;
    asking_ = edited_ && !rows_.empty();
    if (!asking_) begin_new(f);
  }
  if (saves)
    save_.ask_save("Save the moves",
                   file_.empty() ? save_.folder() / ("list" + f.catalog.move_list.file_suffix) : file_,
                   {f.catalog.move_list.file_suffix});
  draw_line_across(f, at.y + ui.px(file_height) - ui.hair());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(file_height)));
}

// ---- table

void Moves::draw_table(Frame& f, float width, float height) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), ImGui::GetCursorScreenPos().y));
  begin_part(ui, "list/table", ui.px(width), ui.px(height), Tone::panel, 16);
  const float inner = ImGui::GetContentRegionAvail().x / ui.scale;
  draw_head(f, inner);
  std::size_t removed = rows_.size();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows_.size()), ui.px(list_row_height));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      if (draw_row(f, static_cast<std::size_t>(i), inner)) removed = static_cast<std::size_t>(i);
  clipper.End();
  if (removed < rows_.size()) {
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(removed));
    edited_ = true;
  }
  if (rows_.empty()) {
    gap(ui, 12);
    wrapped(ui, Face::body, Tone::ink2, "Add a move, or open a list. A list may be longer than the buffer.");
  }
  gap(ui, 16);
  if (std::exchange(to_end_, false)) ImGui::SetScrollHereY(1);
  end_part();
}

/// A unit that does not fit beside the title of its column is below it.
void Moves::draw_head(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto& columns = f.catalog.move_list.columns;
  const float cell = cell_width(f.catalog, width);
  const auto title_of = [](const ActionField& c) {
    return Path("{}{}{}", c.label, c.unit.empty() ? "" : ", ", c.unit);
  };
  const bool one_line = std::all_of(columns.begin(), columns.end(), [&](const ActionField& c) {
    return text_width(ui, Face::small, title_of(c)) <= ui.px(cell);
  });
  float x = at.x + ui.px(number_width);
  for (const ActionField& c : columns) {
    const float end = x + ui.px(cell);
    if (one_line) {
      draw_text_line(ui, x, end, at.y + ui.px(14), Face::small, ui[Tone::ink2], title_of(c));
    } else {
      draw_text_line(ui, x, end, at.y + ui.px(12), Face::small, ui[Tone::ink2], c.label);
      draw_text_line(ui, x, end, at.y + ui.px(28), Face::small, ui[Tone::ink2], c.unit);
    }
    const Path title = title_of(c);
    show(ui, {Path("list/title/{}", c.id), Kind::text, c.label, title, {}, false, {}},
         {ImVec2(x, at.y), ImVec2(end, at.y + ui.px(one_line ? 28 : 40))});
    x += ui.px(cell + between);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(one_line ? 28 : 40)));
}

/// Returns true when the row must be removed.
bool Moves::draw_row(Frame& f, std::size_t row, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::size_t number = row + 1;
  const bool done = f.now.feed.running && static_cast<std::int64_t>(row) < f.now.feed.sent;
  draw_text_line(ui, at.x, at.x + ui.px(number_width), at.y + ui.px(16), Face::code_field,
                 ui[done ? Tone::motion : Tone::ink3], Path("{}", number));
  const float cell = cell_width(f.catalog, width);
  for (std::size_t c = 0; c < rows_[row].size(); ++c) {
    const ActionField& info = f.catalog.move_list.columns[c];
    const double scale = std::pow(10.0, info.decimals);
    NumberOptions o;
    o.range = {static_cast<double>(info.minimum) / scale,
               static_cast<double>(info.maximum) / scale,
               info.decimals,
               {}};
    o.width = cell;
    o.sentence_below = false;
    if (!rows_[row][c].sentence.empty()) o.tip = rows_[row][c].sentence;
    ImGui::SetCursorScreenPos(
        ImVec2(at.x + ui.px(number_width + static_cast<float>(c) * (cell + between)), at.y));
    if (number_field(ui, Path("list/{}/{}", number, info.id), info.label, std::nullopt, rows_[row][c], o)
            .field.edited)
      edited_ = true;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - remove_width), at.y));
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.icon = Icon::cross;
  o.width = 32;
  o.tip = "Removes this move from the list.";
  const bool gone = button(ui, Path("list/{}/remove", number), "", o).clicked;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(list_row_height)));
  return gone;
}

// ---- the side: state of the buffer

void Moves::draw_side(Frame& f, float width) {
  Ui& ui = f.ui;
  const int group = f.catalog.move_list.readout_group;
  section_title(ui, group >= 0 ? f.catalog.readout_groups[static_cast<std::size_t>(group)] : "Buffer");
  draw_readouts(f, group, width, beside_switch_);
  gap(ui, 8);
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    ActionForm& a = actions_[i];
    if (is_of_choice(f.catalog, a)) {
      draw_action_choice(f, actions_, i, width);
      i = end_of_choice(f.catalog, actions_, i) - 1;
    } else if (a.only_a_button()) {
      a.draw_button(f, width);
      gap(ui, 4);
      a.draw_refusal(f, width);
    } else {
      a.draw(f, width);
    }
  }
  for (std::size_t i = 0; i < f.catalog.params.size(); ++i)
    if (f.catalog.params[i].of_move_buffer) draw_param(f, i, width);
}

/// Draws a parameter with two values. A change is effective at once.
void Moves::draw_param(Frame& f, std::size_t i, float width) {
  const ParamInfo& p = f.catalog.params[i];
  if (p.choices.size() != 2) return;
  const ParamState& has = f.now.params[i];
  const bool on = has.value == p.choices[1].value;
  gap(f.ui, 8);
  wrapped(f.ui, Face::small, Tone::ink2, p.label, width);
  gap(f.ui, 4);
  ToggleOptions o;
  o.width = width;
  o.state = !has.known ? ToggleState::stale : on ? ToggleState::on : ToggleState::off;
  o.disabled = f.no_link();
  o.tip = p.explanation;
  // "1: ramp in between"
  std::string_view words = p.choices[1].label;
  if (const auto colon = words.find(": "); colon != words.npos) words.remove_prefix(colon + 2);
  if (toggle_lamp(f.ui, Path("list/param/{}", p.mnemonic), words, o).clicked)
    f.send(intent::SetParam(p.mnemonic, p.choices[on ? 0 : 1].value));
}

}  // namespace hw::panels
