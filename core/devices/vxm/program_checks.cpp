// Problems of a program as a whole, before it runs.
#include <algorithm>

#include "core/devices/vxm/program_analysis.h"

namespace hw::vxm {
namespace {

bool starts_nonstop(const Command& c) {
  return c.op == Op::user && (c.value == 7 || c.value == 8 || c.value == 77);
}
bool ends_nonstop(const Command& c) {
  return c.op == Op::user && (c.value == 9 || c.value == 91 || c.value == 92 || c.value == 99);
}

class Checks {
 public:
  Checks(Analysis& analysis, int slot)
      : analysis_(analysis), slot_(slot), commands_(analysis.programs[slot]) {}

  void all() {
    memory();
    unreachable();
    jumps();
    nonstop();
    homing();
  }

 private:
  void report(bool error, const StoredCommand& s, std::string sentence) {
    analysis_.report.problems.push_back(
        {error, s.place.line, s.place.column, s.place.length, std::move(sentence), {}, {}});
  }

  void memory() {
    int bytes = 0;
    const StoredCommand* first_over = nullptr;
    for (const StoredCommand& s : commands_) {
      bytes += bytes_of(s.command);
      if (bytes > program_bytes && first_over == nullptr) first_over = &s;
    }
    if (first_over == nullptr) return;
    report(true, *first_over,
           "Program " + std::to_string(slot_) + " needs " + std::to_string(bytes) +
               " bytes and has 256: " + std::to_string(bytes - program_bytes) + " too many.");
  }

  void unreachable() {
    for (std::size_t i = 0; i + 1 < commands_.size(); ++i) {
      const Op op = commands_[i].command.op;
      if (op != Op::loop_endless && op != Op::jump) continue;
      const bool may_be_skipped =
          i > 0 && commands_[i - 1].command.op == Op::user &&
          (commands_[i - 1].command.value == 11 || commands_[i - 1].command.value == 12 ||
           commands_[i - 1].command.value == 21 || commands_[i - 1].command.value == 22);
      const bool may_be_left_out =
          commands_[i + 1].command.op == Op::loop || commands_[i + 1].command.op == Op::loop_alternate;
      if (may_be_skipped || may_be_left_out) continue;
      report(false, commands_[i + 1],
             "Nothing after " + listing_of(commands_[i].command) + " is ever reached.");
      return;
    }
  }

  void jumps() {
    if (!analysis_.has_headings) return;  // the controller may hold the other programs
    for (const StoredCommand& s : commands_) {
      const Op op = s.command.op;
      if (op != Op::jump && op != Op::call && op != Op::call_pick) continue;
      const auto found = analysis_.programs.find(s.command.value);
      if (found == analysis_.programs.end() || found->second.empty())
        report(false, s, "Program " + std::to_string(s.command.value) + " is empty in this text.");
    }
  }

  void nonstop() {
    const StoredCommand* open = nullptr;
    int motor = 0;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      const StoredCommand& s = commands_[i];
      const Command& c = s.command;
      if (ends_nonstop(c)) {
        const bool index_next = i + 1 < commands_.size() && commands_[i + 1].command.op == Op::index;
        if (c.value == 92 && !index_next)
          report(true, s, "U92 needs the index over which to stop right after it.");
        open = nullptr, motor = 0;
      } else if (starts_nonstop(c)) {
        if (open == nullptr) open = &s;
      } else if (open != nullptr) {
        inside_nonstop(s, *open, motor);
      }
    }
    const bool leaves = std::any_of(commands_.begin(), commands_.end(), [](const StoredCommand& s) {
      return s.command.op == Op::jump || s.command.op == Op::call;
    });
    if (open != nullptr && !leaves)
      report(true, *open,
             listing_of(open->command) + " begins nonstop indexing, and no U9, U91, U92 or U99 ends it.");
  }

  void inside_nonstop(const StoredCommand& s, const StoredCommand& open, int& motor) {
    const Command& c = s.command;
    const std::string start = listing_of(open.command);
    if (c.op == Op::index) {
      if (c.motor > motors_per_controller)
        return report(true, s, "Only motors 1 and 2 can index without stopping.");
      if (motor != 0 && motor != c.motor)
        return report(true, s, "After " + start + " all indexes must be of one motor.");
      motor = c.motor;
      return;
    }
    const bool speed = c.op >= Op::speed && c.op <= Op::analog_speed_full;
    const bool flow = is_loop(c.op) || c.op == Op::jump || c.op == Op::call || c.op == Op::call_pick;
    const int u = c.value % slave_u_offset;
    const bool output = c.op == Op::user && (u == 4 || u == 5 || (u >= 14 && u <= 19));
    if (!speed && !flow && !output)
      report(true, s,
             listing_of(c) + " is not allowed between " + start +
                 " and U9: only indexes, speeds, loops, jumps and outputs are.");
  }

  void homing() {
    std::array<int, max_motors + 1> speed{};
    speed.fill(default_speed);
    for (const StoredCommand& s : commands_) {
      const Command& c = s.command;
      if (c.op == Op::speed || c.op == Op::speed_full) speed[c.motor] = c.value;
      if (c.op == Op::home && speed[c.motor] > hard_stop_safe_speed)
        report(false, s,
               "Above 1000 steps/s homing is unreliable and may damage the switch; motor " +
                   std::to_string(c.motor) + " is set to " + std::to_string(speed[c.motor]) + ".");
    }
  }

  Analysis& analysis_;
  int slot_;
  const std::vector<StoredCommand> commands_;
};

}  // namespace

void check_programs(Analysis& analysis) {
  std::vector<int> slots;
  for (const auto& [slot, commands] : analysis.programs) slots.push_back(slot);
  for (const int slot : slots) Checks(analysis, slot).all();
  std::stable_sort(analysis.report.problems.begin(), analysis.report.problems.end(),
                   [](const Problem& a, const Problem& b) {
                     return a.line != b.line ? a.line < b.line : a.column < b.column;
                   });
}

}  // namespace hw::vxm
