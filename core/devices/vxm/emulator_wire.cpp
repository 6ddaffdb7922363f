// Bytes received over RS-232, and immediate replies (Communication Methods, Operation and Status Request
// Commands, App. A).
#include <algorithm>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"
#include "core/devices/vxm/report.h"

namespace hw::vxm {
namespace {

bool is_one_of(std::string_view letters, char c) { return letters.find(c) != std::string_view::npos; }

}  // namespace

int Box::rate() const {
  for (const Baud& b : bauds)
    if (b.number == memory_.setup.baud) return b.rate;
  return bauds.front().rate;
}

void Box::receive(char c) {
  if (!supply_.on || supply_.deaf) return;
  const std::size_t mark = out.size();
  const bool echo_before = host_.mode.echo;
  if (state_.error != 0)
    error_letter(c);
  else if (run_.on)
    running_letter(c);
  else if (!host_.mode.online)
    local_letter(c);
  else
    online_char(c);
  // All received bytes are echoed, even the E that turns echo on; F and G turn it off at once (V06).
  const bool turned_off = echo_before && !host_.mode.echo && (c == 'F' || c == 'G');
  if (host_.mode.echo || (echo_before && !turned_off)) out.insert(mark, 1, c);
  settle();
}

void Box::error_letter(char c) {  // only K and res are accepted (V34)
  if (c == 'K') return kill();
  if (host_.reset_word.is_complete_with(c)) reset();
}

void Box::local_letter(char c) {
  switch (c) {
    case 'E':
    case 'F':
    case 'G': return set_mode_letter(c);
    case 'N': return zero_all();
    case 'V': return verify();
    case 'D': return digitize();
    default: return;  // all else is dropped (V12)
  }
}

void Box::set_mode_letter(char c) {
  host_.mode.enter(c);
  host_.entry.reader.reset();
  host_.entry.drop_unfinished();
  if (Box* s = slave()) s->host_.mode.online = true;
}

void Box::running_letter(char c) {
  if (host_.reset_word.is_complete_with(c)) return reset();
  if (is_one_of(accepted_while_running, c)) {
    switch (c) {
      case 'K': return kill();
      case 'D':
        decelerate();
        if (Box* s = slave()) s->decelerate();
        return;
      case 'H': return hold_toggle();
      case 'G': return go_signal();
      default: status_letter(c); return;
    }
  }
  if (quirks.mode_while_running && is_one_of("EFG", c)) return set_mode_letter(c);
  if ((c == 'Z' || c == 'T') && !motion_.active && (slave() == nullptr || !slave()->motion_.active))
    send_slave_position(c == 'Z' ? 0 : 1);
}

/// Questions that are answered on-line at any time. False: none of them.
bool Box::status_letter(char c) {
  switch (c) {
    case 'V': verify(); return true;
    case 'X': reply(position_reply(axes_[0].counter)); return true;
    case 'Y': reply(position_reply(axes_[1].counter)); return true;
    case '!': capture(); return true;
    case '*': reply(position_reply(last_slowed_at())); return true;
    case '?': reply(std::string(1, static_cast<char>(limits_byte()))); return true;
    case '~': reply(std::string(1, static_cast<char>(inputs_byte()))); return true;
    case '$':
      if (quirks.firmware < firmware_of_outputs) return false;
      reply(std::string(1, static_cast<char>(outputs() & 0x0F)));
      return true;
    case '@': reply(number_reply(terminals_.analog.value())); return true;
    default: return false;
  }
}

void Box::online_char(char c) {
  if (host_.entry.to_slave) {
    if (c == ']')
      host_.entry.to_slave = false;
    else if (Box* s = slave(); s != nullptr && s->supply_.on)
      s->bus_char(c);
    return;
  }
  for (const Reading& reading : host_.entry.reader.feed(c)) {
    obey(reading);
    if (!host_.mode.online || run_.on || state_.error != 0) host_.entry.reader.reset();
  }
}

void Box::obey(const Reading& reading) {
  if (reading.kind == Reading::Kind::letter) return obey_letter(reading.letter);
  if (reading.kind == Reading::Kind::word) return obey_word(reading);
}

void Box::obey_letter(char c) {
  if (c == ')') return store_group();
  host_.entry.group.reset();  // only indexes stand between ( and )
  if (status_letter(c)) return;
  switch (c) {
    case 'E':
    case 'F':
    case 'G': return set_mode_letter(c);
    case 'Q':
      host_.mode.leave();
      if (Box* s = slave()) s->host_.mode.online = false;
      return;
    case 'R': return start_run(host_.entry.program);
    case 'N': return zero_all();
    case 'K': return kill();
    case 'C': return memory_.programs[ix(host_.entry.program)].clear();
    case 'H': state_.hold = !state_.hold; return;
    case 'Z': return send_slave_position(0);
    case 'T': return send_slave_position(1);
    case 'x':
    case 'y':
      for (const std::int32_t p : state_.captures.of(c == 'y' ? 1 : 0)) reply(position_reply(p));
      return;
    case 'M': return reply(number_reply(memory_.programs[ix(host_.entry.program)].free()));
    case '#': return reply(number_reply(host_.entry.motor));
    case '(': host_.entry.group = Command(Op::group, 0, 0); return;
    case '[': host_.entry.to_slave = need_slave() != nullptr; return;
    default: return;  // D without a motion
  }
}

void Box::obey_word(const Reading& w) {
  if (is_stored(w.head)) return store(w);
  host_.entry.group.reset();
  switch (w.head) {
    case Head::PM: return select_program(w);
    case Head::PMA: return associate(w);
    case Head::B:
    case Head::O:
      if (w.has_value) return set_value(w);
      return reply(number_reply(w.head == Head::B ? memory_.setup.backlash : memory_.setup.limit_report));
    case Head::lst:
      return reply(program_listing(host_.entry.program, memory_.programs[ix(host_.entry.program)],
                                   terminals_.analog.value()));
    case Head::del: return memory_.programs[ix(host_.entry.program)].remove_last();
    case Head::res: return reset();
    case Head::rsm: return save();
    case Head::set_D0: return erase();
    default: break;
  }
  if (w.head >= Head::set_M && w.head <= Head::set_I) return set_value(w);
  get_value(w);
}

/// Between [ and ]: the Slave takes commands, but no questions, R or Q (App. G, V99).
void Box::bus_char(char c) {
  if (run_.on || state_.error != 0) return;
  for (const Reading& r : host_.bus_reader.feed(c)) {
    if (r.kind == Reading::Kind::letter && is_one_of("CHN!()", r.letter)) obey_letter(r.letter);
    if (r.kind != Reading::Kind::word) continue;
    const bool asks = r.head >= Head::get_M && r.head <= Head::lst;
    const bool may_ask = r.head == Head::PM || r.head == Head::PMA || r.head == Head::B || r.head == Head::O;
    if (asks || (may_ask && !r.has_value) || r.motor > motors_per_controller || r.head == Head::res) continue;
    obey_word(r);
  }
  out.clear(), replied = 0;
}

void Box::verify() {
  if (run_.on) return reply(std::string(1, busy));
  const Box* s = slave();
  const bool moving = motion_.active || (slave_found() && s->motion_.active);
  if (!host_.mode.online) return reply(std::string(1, moving ? jog_moving : jog_idle));
  if (moving) return reply(std::string(1, busy));
  reply(host_.mode.group_cr ? "R\r" : "R");
}

void Box::send_slave_position(int axis) {
  if (const Box* s = need_slave()) reply(position_reply(s->axes_[ix(axis)].counter));
}

void Box::digitize() {
  std::string text = digitize_line('X', axes_[0].counter) + digitize_line('Y', axes_[1].counter);
  if (slave_found()) {
    const Box& s = linked_.front();
    text += digitize_line('Z', s.axes_[0].counter) + digitize_line('T', s.axes_[1].counter);
  }
  reply(text);
}

void Box::capture() { state_.captures.take(axes_[0].counter, axes_[1].counter); }

void Box::zero_all() {
  for (Axis& a : axes_) {
    a.counter = 0, a.comb = 0;
  }
  if (motion_.active) motion_.from = wrap_position(-factor(motion_.sign) * motion_.applied);
  if (slave_found()) slave()->zero_all();
}

/// Of all motors, including the Slave's (V28).
std::int32_t Box::last_slowed_at() const {
  const Box* s = slave_found() ? slave() : nullptr;
  return (s != nullptr && s->state_.slowing.when > state_.slowing.when ? s->state_.slowing : state_.slowing)
      .counter;
}

int Box::limits_byte() const {
  int byte = 0xFF;
  for (int motor = 1; motor <= max_motors; ++motor) {
    const Box* box = motor <= motors_per_controller ? this : slave_found() ? slave() : nullptr;
    if (box == nullptr) continue;
    const int axis = (motor - 1) % motors_per_controller;
    if (box->limit_active(axis, Sign::minus)) byte &= ~(1 << limit_bit(motor, false));
    if (box->limit_active(axis, Sign::plus)) byte &= ~(1 << limit_bit(motor, true));
  }
  return byte;
}

int Box::inputs_byte() const {
  int byte = 0xFF;
  for (int i = 0; i < 4; ++i) {
    if (line(line_jog + i).low) byte &= ~(1 << i);
    if (line(line_in_1 + i).low) byte &= ~(1 << (first_input_bit + i));
  }
  return byte;
}

void Box::reply(std::string_view text) {
  if (is_slave_) return;
  out += text;
  replied += text.size();
}

/// ^ O W: with a carriage return in G mode (App. O).
void Box::prompt(char c) {
  if (is_slave_) return;
  out += c;
  if (host_.mode.group_cr) out += '\r';
}

void Box::send_error(char letter) {
  if (is_slave_) return;
  out += quirks.error_first;
  out += letter;
}

}  // namespace hw::vxm
