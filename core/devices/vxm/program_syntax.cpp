#include "core/devices/vxm/program_syntax.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr std::array<Form, 49> forms{{
    {Head::I, "I", Part::optional, Part::required},
    {Head::IA, "IA", Part::optional, Part::required},
    {Head::S, "S", Part::optional, Part::required},
    {Head::SA, "SA", Part::optional, Part::required},
    {Head::A, "A", Part::optional, Part::required},
    {Head::L, "L", Part::none, Part::required},
    {Head::LA, "LA", Part::none, Part::required},
    {Head::LM, "LM", Part::none, Part::required},
    {Head::J, "J", Part::none, Part::required},
    {Head::JM, "JM", Part::none, Part::required},
    {Head::P, "P", Part::none, Part::required},
    {Head::PA, "PA", Part::none, Part::required},
    {Head::U, "U", Part::none, Part::required},
    {Head::PM, "PM", Part::none, Part::optional},
    {Head::PMA, "PMA", Part::none, Part::optional},
    {Head::B, "B", Part::none, Part::optional},
    {Head::O, "O", Part::none, Part::optional},
    {Head::set_M, "setM", Part::required, Part::required},
    {Head::set_MA, "setMA", Part::required, Part::required},
    {Head::set_B, "setB", Part::none, Part::required},
    {Head::set_DM, "setDM", Part::none, Part::required},
    {Head::set_D0, "setD0", Part::none, Part::none},
    {Head::set_DA, "setDA", Part::none, Part::required},
    {Head::set_j, "setj", Part::required, Part::required},
    {Head::set_J, "setJ", Part::required, Part::required},
    {Head::set_jA, "setjA", Part::required, Part::required},
    {Head::set_JA, "setJA", Part::required, Part::required},
    {Head::set_L, "setL", Part::required, Part::required},
    {Head::set_P, "setP", Part::required, Part::required},
    {Head::set_PA, "setPA", Part::none, Part::required},
    {Head::set_I, "setI", Part::none, Part::required},
    {Head::get_M, "getM", Part::required, Part::none},
    {Head::get_DM, "getDM", Part::none, Part::none},
    {Head::get_D0, "getD0", Part::none, Part::none},
    {Head::get_D1, "getD1", Part::none, Part::none},
    {Head::get_D2, "getD2", Part::none, Part::none},
    {Head::get_DA, "getDA", Part::none, Part::none},
    {Head::get_j, "getj", Part::required, Part::none},
    {Head::get_J, "getJ", Part::required, Part::none},
    {Head::get_jA, "getjA", Part::required, Part::none},
    {Head::get_JA, "getJA", Part::required, Part::none},
    {Head::get_L, "getL", Part::required, Part::none},
    {Head::get_P, "getP", Part::required, Part::none},
    {Head::get_PA, "getPA", Part::none, Part::none},
    {Head::get_I, "getI", Part::none, Part::none},
    {Head::lst, "lst", Part::none, Part::none},
    {Head::del, "del", Part::none, Part::none},
    {Head::res, "res", Part::none, Part::none},
    {Head::rsm, "rsm", Part::none, Part::none},
}};

constexpr std::string_view letters = "QRNKCDEFGHVXYZTxyM!#*?~$@()[]";
constexpr std::int64_t absurd = 1'000'000'000;  // beyond every range

constexpr int no_such_motor = 99;  // 0 would mean: none given

bool is_silent(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\0'; }

const Form* find_form(std::string_view text) {
  for (const Form& f : forms)
    if (f.text == text && !text.empty()) return &f;
  return nullptr;
}

bool begins_a_form(std::string_view text) {
  return std::any_of(forms.begin(), forms.end(),
                     [&](const Form& f) { return f.text.substr(0, text.size()) == text; });
}

/// Forms that act on their last character, without an ender (V04).
bool acts_at_once(const Form& f) { return f.value == Part::none && f.head != Head::set_D0; }

}  // namespace

const Form& form_of(Head head) {
  return *std::find_if(forms.begin(), forms.end(), [&](const Form& f) { return f.head == head; });
}

Reader::Readings Reader::feed(char c) {
  Readings out;
  const std::int64_t here = place_++;
  if (comment_) {
    if (c != '\r') return out;
    comment_ = false;
  } else if (c == ';') {
    comment_ = true;
    return out;
  }
  if (is_silent(c)) return out;
  if (is_ender(c)) {
    current_.end = here;
    if (stage_ != Stage::start) end_command(out);
    return out;
  }
  if (stage_ == Stage::skip) return out;
  if (stage_ != Stage::start) {
    if (go_on_with(c, out)) return out;
    const bool digit_read =
        stage_ == Stage::head ? is_digit(text().back()) : digits_ > 0;  // setD0 has a digit
    if (digit_read) {  // all characters up to the ender are lost (V07)
      stage_ = Stage::skip;
      return out;
    }
    current_.end = here;
    give(out, Reading::Kind::broken);
  }
  current_.begin = here;
  start_with(c, out);
  return out;
}

void Reader::start_with(char c, Readings& out) {
  current_.end = current_.begin + 1;
  if (letters.find(c) != std::string_view::npos) {
    current_.letter = c;
    give(out, Reading::Kind::letter);
  } else if (begins_a_form({&c, 1})) {
    stage_ = Stage::head;
    take_head(c);
  } else {
    current_.letter = c;
    give(out, Reading::Kind::unknown);
  }
}

bool Reader::take_head(char c) {
  if (text_size_ == text_.size()) return false;
  text_[text_size_++] = c;
  if (begins_a_form(text())) return true;
  --text_size_;
  return false;
}

bool Reader::go_on_with(char c, Readings& out) {
  if (stage_ == Stage::head) {
    const Form* whole = find_form(text());
    if (take_head(c)) {
      const Form* form = find_form(text());
      if (form == nullptr) return true;
      current_.head = form->head;
      if (acts_at_once(*form) && form->motor == Part::none) {
        current_.end = place_;
        give(out, Reading::Kind::word);
      }
      return true;
    }
    if (whole == nullptr || (whole->motor == Part::none && whole->value == Part::none)) return false;
    current_.head = whole->head;
    stage_ = whole->motor == Part::none ? Stage::value : Stage::motor_or_value;
    number_ = 0, digits_ = 0;
  }
  return take_number(c, out);
}

bool Reader::take_number(char c, Readings& out) {
  const Form& form = form_of(current_.head);
  if (stage_ == Stage::motor_or_value) {
    if (is_digit(c)) return take_value(c);
    if (c == 'M' && digits_ > 0 && !current_.minus) {
      current_.motor = digits_ == 1 && number_ != 0 ? static_cast<int>(number_) : no_such_motor;
      number_ = 0, digits_ = 0, stage_ = Stage::value;
      if (form.value == Part::none) {
        current_.end = place_;
        give(out, Reading::Kind::word);
      }
      return true;
    }
    if (form.motor == Part::required) {
      digits_ = 0;  // the digit is not part of the value
      return false;
    }
  }
  if (c == '-' && digits_ == 0 && !current_.minus) {
    current_.minus = true;
    return true;
  }
  return is_digit(c) && take_value(c);
}

bool Reader::take_value(char c) {
  ++digits_;
  number_ = std::min(number_ * 10 + (c - '0'), absurd);
  return true;
}

void Reader::end_command(Readings& out) {
  const Form* whole = stage_ == Stage::head ? find_form(text()) : &form_of(current_.head);
  if (stage_ == Stage::skip || whole == nullptr) return give(out, Reading::Kind::broken);
  current_.head = whole->head;
  const bool number_is_motor = stage_ == Stage::motor_or_value && whole->motor == Part::required;
  current_.has_value = stage_ != Stage::head && digits_ > 0 && !number_is_motor;
  if (!current_.has_value && (whole->value == Part::required || current_.minus || number_is_motor))
    return give(out, Reading::Kind::no_number);
  current_.value = current_.has_value ? number_ : 0;
  give(out, Reading::Kind::word);
}

void Reader::give(Readings& out, Reading::Kind kind) {
  current_.kind = kind;
  out.items[static_cast<std::size_t>(out.count++)] = current_;
  begin_again();
  digits_ = 0, number_ = 0;
}

bool is_stored(Head head) { return head <= Head::U; }
bool takes_motor(Head head) { return head <= Head::A; }

namespace {

using Meaning = std::variant<Command, Refusal>;

Refusal out_of(std::int64_t min, std::int64_t max) { return {Refusal::Kind::range, min, max, false}; }

Meaning ranged(Op op, int motor, const Reading& w, std::int64_t min, std::int64_t max) {
  if (w.value < min || w.value > max) return out_of(min, max);
  return Command(op, motor, static_cast<std::int32_t>(w.value));
}

Meaning index_of(const Reading& w, int motor) {
  if (w.value == 0) return Command(Op::home, motor, w.minus ? -1 : 1);
  if (w.value > max_index) return w.minus ? out_of(-max_index, -1) : out_of(1, max_index);
  return Command(Op::index, motor, static_cast<std::int32_t>(w.minus ? -w.value : w.value));
}

Meaning index_to_of(const Reading& w, int motor) {
  if (w.value == 0 && w.minus) return Command(Op::set_zero, motor, 0);
  const std::int64_t target = w.minus ? -w.value : w.value;
  if (target < position_min || target > position_max) return out_of(position_min, position_max);
  return Command(Op::index_to, motor, static_cast<std::int32_t>(target));
}

Meaning speed_of(const Reading& w, int motor, bool full) {
  if (!w.minus) return ranged(full ? Op::speed_full : Op::speed, motor, w, min_speed, max_speed);
  if (w.value > 99 || find_analog_range(static_cast<int>(w.value)) == nullptr)
    return Refusal{Refusal::Kind::choice, 0, 0, false};
  return Command(full ? Op::analog_speed_full : Op::analog_speed, motor, static_cast<std::int32_t>(w.value));
}

Meaning loop_of(const Reading& w, bool nf90) {
  if (w.head == Head::L && w.value == 0) {
    if (!w.minus) return Command(Op::loop_endless, 0, 0);
    if (nf90) return Command(Op::marker_nf90, 0, 0);
    return Refusal{Refusal::Kind::range, min_loop, max_loop, true};
  }
  const bool always = w.head == Head::LA;
  const Op op = w.minus ? (always ? Op::loop_always_alternate : Op::loop_alternate)
                        : (always ? Op::loop_always : Op::loop);
  return ranged(op, 0, w, min_loop, max_loop);
}

Meaning marker_of(const Reading& w) {
  if (w.value == 0) return Command(w.minus ? Op::marker_reset : Op::marker, 0, 0);
  if (w.minus && w.value == 2) return Command(Op::mirror_2, 0, 0);
  if (w.minus && w.value == 3) return Command(Op::mirror_12, 0, 0);
  return Refusal{Refusal::Kind::choice, 0, 0, false};
}

Meaning jump_of(const Reading& w) {
  if (w.head == Head::J && w.minus) return out_of(0, program_count - 1);
  const Op op = w.head == Head::J ? Op::jump : w.minus ? Op::call_pick : Op::call;
  return ranged(op, 0, w, 0, program_count - 1);
}

Meaning pause_of(const Reading& w) {
  const bool out = w.head == Head::PA;
  if (w.minus) return ranged(out ? Op::pause_out_fine : Op::pause_fine, 0, w, 1, max_pause);
  return ranged(out ? Op::pause_out : Op::pause, 0, w, 0, max_pause);
}

Meaning user_of(const Reading& w) {
  const auto known = [&](const auto& list) {
    return std::find(list.begin(), list.end(), w.value) != list.end();
  };
  if (w.minus || (!known(u_commands) && !known(slave_u_commands)))
    return Refusal{Refusal::Kind::choice, 0, 0, false};
  return Command(Op::user, 0, static_cast<std::int32_t>(w.value));
}

}  // namespace

std::variant<Command, Refusal> meaning(const Reading& w, int current, bool nf90) {
  const int motor = w.motor == 0 ? current : w.motor;
  if (takes_motor(w.head) && (motor < 1 || motor > max_motors))
    return Refusal{Refusal::Kind::motor, 1, max_motors, false};
  switch (w.head) {
    case Head::I: return index_of(w, motor);
    case Head::IA: return index_to_of(w, motor);
    case Head::S: return speed_of(w, motor, false);
    case Head::SA: return speed_of(w, motor, true);
    case Head::A:
      if (w.minus) return out_of(min_accel, max_accel);
      return ranged(Op::accel, motor, w, min_accel, max_accel);
    case Head::L:
    case Head::LA: return loop_of(w, nf90);
    case Head::LM: return marker_of(w);
    case Head::J:
    case Head::JM: return jump_of(w);
    case Head::P:
    case Head::PA: return pause_of(w);
    case Head::U: return user_of(w);
    default: return Refusal{Refusal::Kind::choice, 0, 0, false};
  }
}

}  // namespace hw::vxm
