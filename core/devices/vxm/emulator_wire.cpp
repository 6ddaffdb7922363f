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
  if (!powered_ || blocked_) return;
  const std::size_t mark = out.size();
  const bool echo_before = echo_;
  if (error_ != 0)
    error_letter(c);
  else if (run_.on)
    running_letter(c);
  else if (!online_)
    local_letter(c);
  else
    online_char(c);
  // All received bytes are echoed, even the E that turns echo on; F and G turn it off at once (V06).
  const bool turned_off = echo_before && !echo_ && (c == 'F' || c == 'G');
  if (echo_ || (echo_before && !turned_off)) out.insert(mark, 1, c);
  settle();
}

void Box::error_letter(char c) {  // only K and res are heard (V34)
  if (c == 'K') return kill();
  constexpr std::string_view word = "res";
  reset_letters_ = c == word[ix(reset_letters_)] ? reset_letters_ + 1 : c == 'r' ? 1 : 0;
  if (reset_letters_ == 3) reset();
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
  online_ = true, echo_ = c == 'E', group_cr_ = c == 'G';
  reader_.reset();
  bracket_ = false, group_.reset();
  if (Box* s = slave()) s->online_ = true;
}

void Box::running_letter(char c) {
  constexpr std::string_view word = "res";
  reset_letters_ = c == word[ix(reset_letters_)] ? reset_letters_ + 1 : c == 'r' ? 1 : 0;
  if (reset_letters_ == 3) return reset();
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
  if (mode_while_running && is_one_of("EFG", c)) return set_mode_letter(c);
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
      if (firmware < firmware_of_outputs) return false;
      reply(std::string(1, static_cast<char>(outputs() & 0x0F)));
      return true;
    case '@': reply(number_reply(analog_)); return true;
    default: return false;
  }
}

void Box::online_char(char c) {
  if (bracket_) {
    if (c == ']')
      bracket_ = false;
    else if (Box* s = slave(); s != nullptr && s->powered_)
      s->bus_char(c);
    return;
  }
  for (const Reading& reading : reader_.feed(c)) {
    obey(reading);
    if (!online_ || run_.on || error_ != 0) reader_.reset();
  }
}

void Box::obey(const Reading& reading) {
  if (reading.kind == Reading::Kind::letter) return obey_letter(reading.letter);
  if (reading.kind == Reading::Kind::word) return obey_word(reading);
}

void Box::obey_letter(char c) {
  if (c == ')') return store_group();
  group_.reset();  // only indexes stand between ( and )
  if (status_letter(c)) return;
  switch (c) {
    case 'E':
    case 'F':
    case 'G': return set_mode_letter(c);
    case 'Q':
      online_ = echo_ = group_cr_ = false;
      if (Box* s = slave()) s->online_ = false;
      return;
    case 'R': return start_run(selected_);
    case 'N': return zero_all();
    case 'K': return kill();
    case 'C': return memory_.programs[ix(selected_)].clear();
    case 'H': hold_ = !hold_; return;
    case 'Z': return send_slave_position(0);
    case 'T': return send_slave_position(1);
    case 'x':
    case 'y':
      for (const std::int32_t p : captured_[c == 'y']) reply(position_reply(p));
      return;
    case 'M': return reply(number_reply(memory_.programs[ix(selected_)].free()));
    case '#': return reply(number_reply(current_motor_));
    case '(': group_ = Command(Op::group, 0, 0); return;
    case '[': bracket_ = need_slave() != nullptr; return;
    default: return;  // D without a motion
  }
}

void Box::obey_word(const Reading& w) {
  if (is_stored(w.head)) return store(w);
  group_.reset();
  switch (w.head) {
    case Head::PM: return select_program(w);
    case Head::PMA: return associate(w);
    case Head::B:
    case Head::O:
      if (w.has_value) return set_value(w);
      return reply(number_reply(w.head == Head::B ? memory_.setup.backlash : memory_.setup.limit_report));
    case Head::lst: return reply(program_listing(selected_, memory_.programs[ix(selected_)], analog_));
    case Head::del: return memory_.programs[ix(selected_)].remove_last();
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
  if (run_.on || error_ != 0) return;
  for (const Reading& r : bus_reader_.feed(c)) {
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
  if (!online_) return reply(std::string(1, moving ? jog_moving : jog_idle));
  if (moving) return reply(std::string(1, busy));
  reply(group_cr_ ? "R\r" : "R");
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

void Box::capture() {
  if (captures_ == 4) return;  // the four are kept until the next run (V27)
  for (int axis = 0; axis < 2; ++axis) captured_[ix(axis)][ix(captures_)] = axes_[ix(axis)].counter;
  ++captures_;
}

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
  return s != nullptr && s->slowed_when_ > slowed_when_ ? s->slowed_at_ : slowed_at_;
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
  if (group_cr_) out += '\r';
}

void Box::send_error(char letter) {
  if (is_slave_) return;
  out += error_first;
  out += letter;
}

}  // namespace hw::vxm
