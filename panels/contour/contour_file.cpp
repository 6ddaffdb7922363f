#include "panels/contour/contour_file.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/sequence/sequence_file.h"
#include "core/session/user_files.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "panels/lines.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::uintmax_t largest_file = 1u << 20;

tl::unexpected<Fault> not_this(const std::string& file, std::string_view what) {
  return fail(FaultKind::text, fmt::format("{} {}.", file, what), "The list here is unchanged.",
              "Open it in Blocks.");
}

/// Scales lengths and positions by the first factor, speeds by its magnitude.
void scale(sequence::Contour& c, double by, double up_by) {
  c.x *= by, c.y *= up_by, c.lead_in *= std::abs(by);
  if (c.own) c.own->high *= std::abs(by), c.own->low *= std::abs(by);
  for (sequence::Step& step : c.steps) {
    if (auto* arc = std::get_if<sequence::Arc>(&step.body)) arc->x *= by, arc->y *= up_by;
    auto* move = std::get_if<sequence::Move>(&step.body);
    if (!move) continue;
    if (auto& to = move->to[static_cast<std::size_t>(c.plane.right)]) *to *= by;
    if (auto& to = move->to[static_cast<std::size_t>(c.plane.up)]) *to *= up_by;
  }
}

void scale(sequence::SpeedStairs& s, double by) {
  s.stop_at *= by;
  for (auto& stair : s.stairs) stair.until *= by, stair.speed *= std::abs(by);
}

/// Whether the step can be a row of the list.
bool has_a_row(const sequence::Step& step, const sequence::Plane& plane) {
  if (step.skipped) return false;
  if (const auto* output = std::get_if<sequence::Output>(&step.body)) return output->output >= 0;
  const auto* move = std::get_if<sequence::Move>(&step.body);
  if (!move) return std::holds_alternative<sequence::Arc>(step.body);
  for (int axis = 0; axis < max_axes; ++axis)
    if (move->to[static_cast<std::size_t>(axis)] && axis != plane.right && axis != plane.up) return false;
  return !move->relative;
}

/// Turns the contour into the plane of the list. Each line gets both coordinates; a coordinate left out keeps
/// its value.
void lay_out(sequence::Contour& c) {
  const auto right = static_cast<std::size_t>(c.plane.right), up = static_cast<std::size_t>(c.plane.up);
  double x = c.x, y = c.y;
  for (sequence::Step& step : c.steps) {
    if (auto* move = std::get_if<sequence::Move>(&step.body)) {
      x = move->to[right].value_or(x), y = move->to[up].value_or(y);
      move->to = {x, y};
    } else if (auto* arc = std::get_if<sequence::Arc>(&step.body)) {
      const double turn = arc->degrees * std::numbers::pi / 180, dx = x - arc->x, dy = y - arc->y;
      x = arc->x + dx * std::cos(turn) - dy * std::sin(turn);
      y = arc->y + dx * std::sin(turn) + dy * std::cos(turn);
      arc->plane = {};
    }
  }
  c.plane = {};
}

Result<sequence::Sequence> with_rows(const sequence::Sequence& s, const sequence::Contour& from,
                                     const std::string& file) {
  sequence::Contour c = from;
  for (const sequence::Step& step : c.steps)
    if (!has_a_row(step, c.plane))
      return not_this(file, "has a contour with more than lines, arcs and outputs");
  const auto right = static_cast<std::size_t>(c.plane.right), up = static_cast<std::size_t>(c.plane.up);
  if (right >= s.axes.size() || up >= s.axes.size() || right == up)
    return not_this(file, "does not name two axes for its contour");
  // A path has a single speed, so the steps of both axes must be equally long.
  if (std::abs(s.axes[right].per_unit) != std::abs(s.axes[up].per_unit))
    return not_this(file, "has two axes with steps of different length");
  scale(c, s.axes[right].per_unit, s.axes[up].per_unit);
  sequence::Sequence made;
  made.axes = {{s.axes[right].name}, {s.axes[up].name}};
  lay_out(c);
  made.steps = {{std::move(c)}};
  return made;
}

}  // namespace

sequence::Sequence in_unit(sequence::Sequence s, double per_step, const std::string& unit) {
  s.unit = unit;
  for (sequence::Axis& axis : s.axes) axis.per_unit = 1 / per_step;
  for (sequence::Step& step : s.steps) {
    if (auto* contour = std::get_if<sequence::Contour>(&step.body)) scale(*contour, per_step, per_step);
    if (auto* stairs = std::get_if<sequence::SpeedStairs>(&step.body)) scale(*stairs, per_step);
  }
  return s;
}

Result<sequence::Sequence> only_step_of(const sequence::Sequence& s, const std::string& file) {
  const sequence::Step* only = nullptr;
  for (const sequence::Step& step : s.steps) {
    if (step.skipped || std::holds_alternative<sequence::Comment>(step.body)) continue;
    if (std::exchange(only, &step)) return not_this(file, "does more than one contour or staircase");
  }
  if (!only) return not_this(file, "has no contour and no staircase");
  if (const auto* contour = std::get_if<sequence::Contour>(&only->body)) return with_rows(s, *contour, file);
  const auto* from = std::get_if<sequence::SpeedStairs>(&only->body);
  if (!from || from->axis < 0 || static_cast<std::size_t>(from->axis) >= s.axes.size())
    return not_this(file, "has no contour and no staircase");
  sequence::SpeedStairs stairs = *from;
  const sequence::Axis& axis = s.axes[static_cast<std::size_t>(std::exchange(stairs.axis, 0))];
  scale(stairs, axis.per_unit);
  sequence::Sequence made;
  made.axes = {{axis.name}};
  made.steps = {{std::move(stairs)}};
  return made;
}

void ContourFile::draw_buttons(Frame& f, std::string_view why_not_save, std::string_view name) {
  Ui& ui = f.ui;
  ButtonOptions look{.style = ButtonStyle::quiet, .height = 40};
  const float width = button_width(ui, "Open", look) + button_width(ui, "Save", look);
  next_in_toolbar(f, 0, width);
  const ImVec2 next = ImGui::GetCursorScreenPos();
  const bool own_row = next.y > ImGui::GetItemRectMax().y;
  ImGui::SetCursorScreenPos(ImVec2(own_row ? next.x : ui.px(f.area.right() - 4 - width), next.y));
  if (button(ui, "contour/open", "Open", look).clicked)
    open_.ask_open("Open a contour or staircase", open_.folder(), {".toml"});
  ImGui::SameLine(0, 0);
  look.disabled = why_not_save;
  look.tip = "As a sequence, which Blocks opens too.";
  if (button(ui, "contour/save", "Save", look).clicked)
    save_.ask_save("Save the list", save_.folder() / fmt::format("{}.toml", name), {".toml"});
}

std::optional<sequence::Sequence> ContourFile::draw_open(Frame& f) {
  const auto path = open_.draw(f.ui);
  if (!path) return {};
  const std::string name = path->filename().string();
  const auto opened = read_file(*path, largest_file)
                          .and_then([&](std::string text) { return sequence::read_sequence(text, name); })
                          .and_then([&](const sequence::Sequence& s) { return only_step_of(s, name); });
  f.withdraw(&open_);  // the message why the last file was not opened
  if (opened) return *opened;
  f.toast(Severity::fault, opened.error().sentence(), &open_);
  return {};
}

void ContourFile::save(Frame& f, const std::filesystem::path& path, const sequence::Sequence& s) {
  Desk& desk = f.tab.desk();
  const void* attempt = &save_;
  f.withdraw(attempt);
  desk.work.worker().run([path, text = sequence::write_sequence(s)] { return write_file(path, text); },
                         [&console = f.console, attempt, saved = saved_, path](Result<> written) {
                           if (!written)
                             return console.toast(Severity::fault, written.error().sentence(), attempt);
                           *saved = true;
                           console.toast(Severity::ok, fmt::format("Saved as {}.", path.string()));
                         },
                         desk.work.alive());
}

bool ContourFile::take_saved() { return std::exchange(*saved_, false); }

}  // namespace hw::panels
