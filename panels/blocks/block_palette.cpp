#include "panels/blocks/block_palette.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "core/device/refused_steps.h"
#include "gui/model/tab.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/touch.h"
#include "panels/blocks/block_icons.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

struct PaletteEntry {
  const char *group, *id, *label;
  BlockCandidates (*make)(const seq::Sequence& of, const Catalog& catalog);
};

/// The length of `steps` steps of the first axis, in the unit of the sequence, rounded.
double about_steps(const seq::Sequence& of, double steps) {
  const double units = of.axes.empty() ? steps : steps / std::fabs(of.axes[0].per_unit);
  const double ten = std::pow(10.0, std::floor(std::log10(units)));
  const double round = units / ten < 2 ? 1 : units / ten < 5 ? 2 : 5;
  return ten < 1 ? round / std::round(1 / ten) : round * ten;
}
seq::Move whole_move(const seq::Sequence& of, bool relative) {
  seq::Move m;
  m.relative = relative;
  if (!of.axes.empty()) m.to[0] = 0;
  return m;
}
BlockCandidates speeds(const seq::Sequence& of, const Catalog&) {
  const double high = about_steps(of, 1000), low = about_steps(of, 100);
  return {seq::Speed{{high, low, 300}}, seq::Speed{{high, 0, 300}}, seq::Speed{{high, low, 0}},
          seq::Speed{{high, 0, 0}}};
}
/// The arc begins beside the origin, where the tool can go.
BlockCandidates arcs(const seq::Sequence& of, double degrees) {
  return {seq::Arc{0, 0, degrees, {}}, seq::Arc{about_steps(of, 1000), 0, degrees, {}}};
}
BlockCandidates jogs(const seq::Sequence& of, const Catalog&) {
  seq::Jog with_speed;
  with_speed.own = seq::Speeds{about_steps(of, 1000), 0, 0};
  return {seq::Jog{}, with_speed};
}
/// The contour has a first line, because an empty contour is refused.
BlockCandidates contours(const seq::Sequence& of, const Catalog&) {
  const double length = about_steps(of, 1000);
  seq::Move line;
  if (of.axes.size() > 1) line.to[0] = length, line.to[1] = 0;
  seq::Contour with_speed;
  with_speed.steps = {{line}};
  seq::Contour as_before = with_speed;
  with_speed.own = seq::Speeds{length, 0, 0};
  return {as_before, with_speed};
}
/// The second stair is twice as fast as the first.
BlockCandidates speed_stairs(const seq::Sequence& of, const Catalog&) {
  const double unit = about_steps(of, 1000);
  return {seq::SpeedStairs{0, {{unit, unit}, {3 * unit, 2 * unit}}, 4 * unit}};
}
int first_input(const Catalog& catalog) { return catalog.inputs.empty() ? 1 : catalog.input_number(0); }
BlockCandidates waits(const seq::Sequence&, const Catalog& catalog) {
  const int input = first_input(catalog);
  return {seq::WaitInput{input, true}, seq::WaitInput{input, false}};
}
BlockCandidates input_moves(const seq::Sequence&, const Catalog& catalog) {
  seq::MoveOnInput move;
  move.input = first_input(catalog);
  return {move};
}
BlockCandidates outputs(const seq::Sequence&, const Catalog& catalog) {
  BlockCandidates all;
  for (std::size_t i = 0; i < catalog.outputs.size(); ++i)
    all.emplace_back(seq::Output{catalog.output_number(i), true, 0});
  if (all.empty()) all.emplace_back(seq::Output{});
  return all;
}
BlockCandidates loops(const seq::Sequence&, const Catalog&) {
  seq::Repeat loop;
  loop.times = 2;
  return {loop};
}
template <class Body>
BlockCandidates plain(const seq::Sequence&, const Catalog&) {
  return {Body{}};
}
using SequenceRef = const seq::Sequence&;
using CatalogRef = const Catalog&;

constexpr std::array<PaletteEntry, 20> palette{
    {{"Motion", "blocks/add/speed", "Speed", speeds},
     {"Motion", "blocks/add/move", "Move to",
      [](SequenceRef of, CatalogRef) -> BlockCandidates { return {whole_move(of, false)}; }},
     {"Motion", "blocks/add/move_by", "Move by",
      [](SequenceRef of, CatalogRef) -> BlockCandidates { return {whole_move(of, true)}; }},
     {"Motion", "blocks/add/arc", "Arc", [](SequenceRef of, CatalogRef) { return arcs(of, 90); }},
     {"Motion", "blocks/add/circle", "Circle", [](SequenceRef of, CatalogRef) { return arcs(of, 360); }},
     {"Motion", "blocks/add/contour", "Contour", contours},
     {"Motion", "blocks/add/jog", "Jog", jogs},
     {"Motion", "blocks/add/home", "Home", plain<seq::Home>},
     {"Motion", "blocks/add/stop", "Stop", plain<seq::Stop>},
     {"Motion", "blocks/add/speed_stairs", "Speed stairs", speed_stairs},
     {"Waiting", "blocks/add/wait_motion", "Until still", plain<seq::WaitMotion>},
     {"Waiting", "blocks/add/delay", "Delay",
      [](SequenceRef, CatalogRef) -> BlockCandidates { return {seq::Delay{500}}; }},
     {"Waiting", "blocks/add/wait_input", "Wait for input", waits},
     {"Waiting", "blocks/add/move_on_input", "Move on input", input_moves},
     {"Signals", "blocks/add/output", "Output", outputs},
     {"Signals", "blocks/add/enable", "Motor power", plain<seq::Enable>},
     {"Signals", "blocks/add/pen", "Tool",
      [](SequenceRef, CatalogRef) -> BlockCandidates { return {seq::Pen{true}}; }},
     {"Order", "blocks/add/loop", "Loop", loops},
     {"Order", "blocks/add/comment", "Comment",
      [](SequenceRef, CatalogRef) -> BlockCandidates { return {seq::Comment{"what comes next"}}; }},
     {"Order", "blocks/add/custom", "Own text", plain<seq::Custom>}}};

/// The block whose icon is drawn. The icon does not depend on the controller.
const seq::Step::Body& drawn_as(std::size_t entry) {
  static const std::vector<seq::Step::Body> all = [] {
    std::vector<seq::Step::Body> made;
    const Catalog none;
    for (const PaletteEntry& e : palette) made.push_back(e.make({}, none).front());
    return made;
  }();
  return all[entry];
}

/// Whether the typed text begins a word of the entry. Case is ignored.
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

bool same_frame(const seq::Sequence& a, const seq::Sequence& b) {
  return a.unit == b.unit && a.axes == b.axes && a.tolerance == b.tolerance && a.pen_up == b.pen_up &&
         a.pen_down == b.pen_down;
}

/// Why the controller refuses the last step of the sequence; empty: it accepts the step.
std::string refusal_of_last(const PartialWriter& writer, const seq::Sequence& s, const Catalog& catalog) {
  std::vector<RefusedStep> refused;
  const auto written = writer.write_with_gaps(s, catalog, refused);
  if (!written) return written.error().what;
  for (const RefusedStep& r : refused)
    if (r.step == static_cast<int>(s.steps.size()) - 1) return r.why;
  return {};
}

/// Why the controller never accepts any of these, neither at the beginning nor after a move, whatever the
/// tool; empty: it can accept one.
std::string why_never(const PartialWriter& writer, const seq::Sequence& of, const Catalog& catalog,
                      const BlockCandidates& ways) {
  std::string why;
  seq::Sequence alone = seq::frame_of(of), behind = alone;
  if (!catalog.outputs.empty()) {
    const int first = catalog.output_number(0);
    if (behind.pen_down.empty()) behind.pen_down = {{seq::Output{first, true, 0}}};
    if (behind.pen_up.empty()) behind.pen_up = {{seq::Output{first, false, 0}}};
  }
  seq::Move origin;
  for (std::size_t a = 0; a < of.axes.size(); ++a) origin.to[a] = 0;
  const double high = about_steps(of, 1000);
  behind.steps = {{seq::Speed{{high, high / 10, 300}}}, {origin}, {seq::WaitMotion{}}};
  for (const seq::Step::Body& way : ways)
    for (seq::Sequence* at : {&alone, &behind}) {
      at->steps.push_back({way});
      std::string refusal = refusal_of_last(writer, *at, catalog);
      at->steps.pop_back();
      if (refusal.empty()) return {};
      if (why.empty()) why = std::move(refusal);
    }
  if (!why.empty()) why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
  return why;
}

/// Draws a row of the palette. A press anywhere on the row counts.
bool draw_entry(Ui& ui, std::size_t entry, std::string_view why_not) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const Touch t = touch(ui, {.id = palette[entry].id, .label = palette[entry].label, .disabled = why_not},
                        ImVec2(width, ui.px(32)));
  if (t.hovered && t.enabled) draw_fill(ui, t.rect, ui[Tone::hover]);
  const float middle = std::floor(t.rect.centre().y);
  draw_block_icon(ImGui::GetWindowDrawList(), drawn_as(entry), ImVec2(at.x + ui.px(12), middle), ui.px(12),
                  ui[t.enabled ? Tone::ink2 : Tone::ink3]);
  draw_text_line(ui, at.x + ui.px(28), t.rect.max.x, middle, Face::body_medium,
                 ui[t.enabled ? Tone::ink : Tone::ink3], palette[entry].label);
  draw_ring(ui, t);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
  return t.clicked;
}

}  // namespace

void BlockPalette::find_unavailable(Frame& f, const seq::Sequence& of) {
  if (!why_not_.empty() && same_frame(asked_for_, of)) return;
  asked_for_ = seq::frame_of(of);
  why_not_.assign(palette.size(), {});
  const auto* writer = dynamic_cast<const PartialWriter*>(f.tab.desk().programs.language());
  if (!writer || of.axes.empty()) return;
  for (std::size_t i = 0; i < palette.size(); ++i)
    why_not_[i] = why_never(*writer, of, f.catalog, palette[i].make(of, f.catalog));
}

BlockCandidates BlockPalette::draw(Frame& f, const seq::Sequence& of, bool all) {
  Ui& ui = f.ui;
  find_unavailable(f, of);
  FieldOptions field;
  field.width = fill;
  field.placeholder = "Add by name";
  field.keep_focus = true;  // for the next block
  const Field typed = text_field(ui, "blocks/add_by_name", "Add by name", wanted_, field);
  if (!all && wanted_.empty()) return {};
  const PaletteEntry *first = nullptr, *clicked = nullptr;
  std::string_view group;
  bool any = false;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const PaletteEntry& entry = palette[i];
    if (!is_named(entry, wanted_)) continue;
    if (!first && why_not_[i].empty()) first = &entry;
    any = true;
    if (all && group != entry.group) {
      group = entry.group;
      gap(ui, 8);
      text(ui, Face::small, Tone::ink2, group);
    }
    if (draw_entry(ui, i, why_not_[i])) clicked = &entry;
  }
  if (!any) wrapped(ui, Face::small, Tone::ink2, "No block has this name.");
  const bool entered = typed.entered && first && !wanted_.empty();
  if (entered || (clicked && !all)) wanted_.clear();
  if (clicked) return clicked->make(of, f.catalog);
  return entered ? first->make(of, f.catalog) : BlockCandidates();
}

}  // namespace hw::panels
