#include "panels/blocks/block_palette.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

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

}  // namespace

std::optional<seq::Step::Body> BlockPalette::draw(Frame& f, const seq::Sequence& of, bool all) {
  Ui& ui = f.ui;
  FieldOptions field;
  field.width = fill;
  field.placeholder = "Add by name";
  field.keep_focus = true;  // for the next one
  const Field typed = text_field(ui, "blocks/add_by_name", "Add by name", wanted_, field);
  if (!all && wanted_.empty()) return std::nullopt;
  const PaletteEntry *first = nullptr, *clicked = nullptr;
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
    if (button(ui, entry.id, entry.label, look).clicked) clicked = &entry;
  }
  if (!first) wrapped(ui, Face::small, Tone::ink2, "No block has such a name.");
  const bool entered = typed.entered && first && !wanted_.empty();
  if (entered || (clicked && !all)) wanted_.clear();
  if (clicked) return clicked->make(of);
  return entered ? std::optional(first->make(of)) : std::nullopt;
}

}  // namespace hw::panels
