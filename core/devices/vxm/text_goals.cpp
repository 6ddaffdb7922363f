#include "core/devices/vxm/text_goals.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/device/sequence_travel.h"

namespace hw::vxm {
namespace {

using StoredCommands = std::vector<TextCommand>;
using Programs = std::array<ProgramContents, program_count>;

/// Interprets programs command by command (Looping/Branching). Waits end at once. Ends at the first command
/// whose successor depends on an unknown value.
class ProgramWalk {
 public:
  /// `zeroed`: the counts are 0 when the program begins. `left`: the commands that may still be walked for
  /// the whole text.
  ProgramWalk(const HeldPrograms& held, const Snapshot& now, bool zeroed, int& left)
      : programs_(held.contents), left_(left) {
    for (int i = 0; i < now.axis_count && i < max_motors && !held.program_4_first; ++i)
      if (now.axes[ix(i)].position_known || zeroed) at_[ix(i)] = zeroed ? 0 : now.axes[ix(i)].goal().value;
  }

  void run(int program) {
    stack_.push_back({program, 0, {}});
    while (!stack_.empty() && left_ > 0) {
      --left_;
      Frame& frame = stack_.back();
      const auto& commands = programs_[ix(frame.program)];
      if (!commands) return;
      if (frame.next == commands->size()) {
        stack_.pop_back();
      } else if (const std::size_t behind = behind_unit(*commands, frame.next);
                 is_left_out(frame, *commands, behind)) {
        frame.next = behind;
      } else if (!step((*commands)[frame.next++], *commands)) {
        return;
      }
    }
    if (!stack_.empty()) go_on_without_end();
  }
  [[nodiscard]] std::vector<AxisTarget> places() && { return std::move(places_); }

 private:
  struct Frame {
    int program;
    std::size_t next;
    std::vector<std::pair<std::size_t, std::int64_t>> loops;  ///< place of the loop, passes so far
  };
  using Counts = std::array<std::optional<std::int64_t>, max_motors>;

  /// False: the next command is not known.
  bool step(const TextCommand& c, const StoredCommands& commands) {
    if (c.flaw != Flaw::none) return false;  // a listing with a spoilt byte
    Frame& frame = stack_.back();
    switch (c.verb) {
      case Verb::index_by:
        if (at_[ix(c.motor - 1)]) go_to(c.motor, *at_[ix(c.motor - 1)] + c.signed_value());
        return true;
      case Verb::index_to: go_to(c.motor, c.signed_value()); return true;
      case Verb::zero_here: at_[ix(c.motor - 1)] = 0; return true;
      case Verb::home: at_[ix(c.motor - 1)].reset(); return true;
      case Verb::loop_forever:
        repeats(program_count);
        frame.next = loop_target(commands, frame.next - 1);
        return true;
      case Verb::loop: return !c.minus && loop(frame, c, commands);
      case Verb::jump:
        if (stack_.size() == 1) repeats(static_cast<int>(c.value));
        frame = {static_cast<int>(c.value), 0, {}};
        return true;
      case Verb::jump_return:
        if (stack_.size() > deepest) return false;
        stack_.push_back({static_cast<int>(c.value), 0, {}});
        return true;
      case Verb::loop_always:
      case Verb::loop_reverse:
      case Verb::jump_pick: return false;  // these reverse distances
      default: return true;
    }
  }
  void go_to(int motor, std::int64_t place) {
    at_[ix(motor - 1)] = place;
    places_.push_back({AxisId{static_cast<std::uint8_t>(motor - 1)}, Steps(place)});
  }
  static bool loop(Frame& frame, const TextCommand& c, const StoredCommands& commands) {
    const std::size_t place = frame.next - 1;
    auto open = std::find_if(frame.loops.begin(), frame.loops.end(),
                             [place](const auto& loop) { return loop.first == place; });
    if (open == frame.loops.end()) open = frame.loops.insert(frame.loops.end(), {place, 0});
    if (++open->second < c.value)
      frame.next = loop_target(commands, place);
    else
      frame.loops.erase(open);
    return true;
  }
  /// Place behind the command at `place`: a pair, and U92 with its index, are one (decision V39).
  static std::size_t behind_unit(const StoredCommands& commands, std::size_t place) {
    const TextCommand& c = commands[place];
    const std::size_t next = place + 1;
    if (c.verb == Verb::user && c.value == 92 && next < commands.size() &&
        commands[next].verb == Verb::index_by)
      return next + 1;
    if (c.verb != Verb::pair_begins) return next;
    const auto end = std::find_if(commands.begin() + static_cast<std::ptrdiff_t>(place), commands.end(),
                                  [](const TextCommand& other) { return other.verb == Verb::pair_ends; });
    return static_cast<std::size_t>(end - commands.begin()) + (end == commands.end() ? 0 : 1);
  }
  /// On its last pass Lx leaves out the command right before it (decision V37), unless that is a loop command
  /// itself (decision V38).
  static bool is_left_out(const Frame& frame, const StoredCommands& commands, std::size_t behind) {
    if (behind >= commands.size() || commands[behind].verb != Verb::loop) return false;
    const Verb own = commands[frame.next].verb;
    if (own >= Verb::loop_forever && own <= Verb::loop_reverse) return false;
    return std::any_of(frame.loops.begin(), frame.loops.end(), [&](const auto& loop) {
      return loop.first == behind && loop.second == commands[behind].value - 1;
    });
  }
  /// L0, or a jump outside of any call: the commands after it are the same each time. `which`: program jumped
  /// to.
  void repeats(int which) {
    Counts& before = before_[ix(which)];
    for (std::size_t m = 0; m < at_.size(); ++m) grew_by_[m] = at_[m] && before[m] ? *at_[m] - *before[m] : 0;
    before = at_;
  }
  /// The program still runs: an axis that the last pass has moved further moves on in that direction.
  void go_on_without_end() {
    for (std::size_t m = 0; m < at_.size(); ++m)
      if (grew_by_[m] != 0)
        places_.push_back(
            {AxisId{static_cast<std::uint8_t>(m)}, grew_by_[m] > 0 ? without_end : Steps(0) - without_end});
  }
  static std::size_t loop_target(const StoredCommands& commands, std::size_t place) {
    while (place-- > 0) {
      if (commands[place].verb == Verb::marker_set) return place + 1;
      if (commands[place].verb == Verb::marker_reset) return 0;
    }
    return 0;
  }

  static constexpr std::size_t deepest = 16;  // more than the controller allows

  const Programs& programs_;
  Counts at_;
  std::array<Counts, program_count + 1> before_{};  ///< at the last jump to each program; at the last L0
  std::array<std::int64_t, max_motors> grew_by_{};  ///< over the last pass of an endless repetition
  std::vector<Frame> stack_;
  std::vector<AxisTarget> places_;
  int& left_;
};

bool acts(const TextCommand& c, char letter) { return c.verb == Verb::letter && c.letter == letter; }
bool is_named(const TextCommand& c, std::string_view word) { return c.verb == Verb::word && c.name == word; }

}  // namespace

void change(ProgramContents& program, const TextCommand& c) {
  if (c.verb == Verb::empty || acts(c, 'C')) program.emplace();
  if (!program) return;
  if (is_named(c, "del") && !program->empty()) {
    const bool pair = program->back().verb == Verb::pair_ends;  // deleted as one
    program->pop_back();
    while (pair && !program->empty() && program->back().verb != Verb::pair_begins) program->pop_back();
    if (pair && !program->empty()) program->pop_back();
  }
  if (c.stored()) program->push_back(c);
}

TextGoals goals_of(std::string_view text, Listening now, HeldPrograms held, const Snapshot& snapshot) {
  TextGoals goals;
  std::string whole(text);
  if (ends_open(whole)) whole += '\r';
  bool zeroed = false;
  int left = most_goal_commands;
  for (const TextCommand& c : read_text(whole)) {
    const bool taken = now.takes(c), runs = taken && acts(c, 'R') && !now.local;
    zeroed = zeroed || (taken && acts(c, 'N'));
    now.follow(c);
    if (taken && is_named(c, "res"))
      held = {{}, 0, held.program_4_first}, zeroed = true;  // the programs that it holds are those stored
    if (taken && (c.verb == Verb::select || c.verb == Verb::empty)) held.selected = static_cast<int>(c.value);
    if (held.selected < 0 || held.selected >= program_count) continue;
    if (taken) change(held.contents[ix(held.selected)], c);
    if (!runs) continue;
    ProgramWalk walk(held, snapshot, zeroed, left);
    walk.run(held.selected);
    const std::vector<AxisTarget> places = std::move(walk).places();
    goals.places.insert(goals.places.end(), places.begin(), places.end());
  }
  return goals;
}

}  // namespace hw::vxm
