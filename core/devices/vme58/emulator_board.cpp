// Power, time, text.
#include "core/devices/vme58/emulator_board.h"

#include <utility>

namespace hw::vme58 {
namespace {

constexpr Duration boot_time = std::chrono::milliseconds(100);  // decision M85

}  // namespace

Board::Board(const BoardOptions& make)
    : make_(make),
      variant_(make.variant),
      fitted_((1u << make.variant->axes()) - 1),
      io_(make.outputs),
      parser_(make.oms_kk),
      motion_(*make.variant) {
  set_factory_values();
}

/// Sets the values that the data sheet leaves open (decisions M47, M96).
void Board::set_factory_values() {
  motion_.board().servo_period = make_.servo_update;
  each_axis(fitted_, [this](int a) {
    AxisSettings& s = motion_.settings(a);
    s.velocity = static_cast<double>(make_.velocity);
    s.acceleration = static_cast<double>(make_.acceleration);
    s.base_velocity = static_cast<double>(make_.base_velocity);
    motion_.changed(a);
  });
}

// --- power and time ----------------------------------------------------------------------------------------

void Board::power(bool on) {
  if (on == powered_) return;
  powered_ = on;
  reset();
  if (!on) boots_until_.reset();
}

/// RS and power-up: everything returns to factory state, and nothing is received until the board is up again.
void Board::reset() {
  note(Note::What::restarts);
  window_ = Window();
  flags_ = Flags();
  const unsigned lines_before = io_.lines_on(), aux_before = io_.aux_high();
  io_.reset();
  note_outputs(lines_before, aux_before);
  parser_.clear();
  motion_.reset();
  set_factory_values();
  tasks_ = {};
  context_ = 0;
  echo_ = false;
  replies_.clear();
  held_.reset();
  waits_empty_.reset();
  recorder_ = ContourRecorder();
  update_due_.reset();
  mail_due_.reset();
  power_drops_at_ = {};
  motion_.take_events(events_);
  events_.clear();
  boots_until_ = now() + boot_time;
}

std::optional<Instant> Board::next_event() const {
  std::optional<Instant> next = motion_.next_event();
  const auto sooner = [&next](std::optional<Instant> t) {
    if (t && (!next || *t < *next)) next = t;
  };
  sooner(boots_until_);
  sooner(update_due_);
  sooner(mail_due_);
  for (const auto& drop : power_drops_at_) sooner(drop);
  for (const BoardTask& t : tasks_) sooner(t.wait_until);
  return next;
}

void Board::advance(Instant to) {
  motion_.advance_to(to);
  const auto due = [to](std::optional<Instant>& t) {
    if (!t || *t > to) return false;
    t.reset();
    return true;
  };
  if (due(boots_until_)) window_.empty_rings();
  take_events();
  for (int a = 0; a < most_axes; ++a)
    if (due(power_drops_at_[ix(a)])) switch_aux(1u << a, false);
  if (due(update_due_)) copy_axis_data();
  if (due(mail_due_)) acknowledge_mail();
  settle();
}

void Board::settle() {
  if (!powered_ || boots_until_) return;
  take_events();
  run_queues();
  pump();
}

// --- text --------------------------------------------------------------------------------------------------

unsigned Board::modes() const {
  if (recorder_.on()) return where::contour;
  if (context_ == context_all) return where::all;
  return context_ == context_tasks ? where::tasks : where::single;
}

/// Takes characters as long as the board can process them: not while a reply or the last command waits for
/// room in its ring or queue (decision M19), and not while WQ waits.
void Board::pump() {
  while (powered_ && !boots_until_) {
    flush_replies();
    if (!replies_.empty()) return;
    if (held_) {
      if (tasks_[ix(context_)].queue.room() < held_->entries()) return;
      put_in_queue(*std::exchange(held_, std::nullopt));
      run_queues();
      continue;
    }
    if (waits_empty_) {
      if (!runs_empty(*waits_empty_)) return;
      waits_empty_.reset();
    }
    const auto c = window_.take();
    if (!c) return;
    if (echo_) replies_ += *c;
    auto outcome = parser_.push(*c, modes());
    source_ = notes_ != nullptr ? notes_->source : 0;
    if (outcome.error) text_error();
    if (!outcome.command) continue;
    outcome.command->source = source_;
    obey(*outcome.command);
    take_events();
    run_queues();
  }
}

void Board::flush_replies() {
  std::size_t sent = 0;
  while (sent < replies_.size() && window_.put(replies_[sent])) ++sent;
  replies_.erase(0, sent);
}

/// Also spoils a recording: without the missing piece it would be another contour.
void Board::text_error() {
  command_error();
  if (recorder_.on()) recorder_.spoil();
}

// --- events of the motion ----------------------------------------------------------------------------------

void Board::take_events() {
  motion_.take_events(events_);
  for (std::size_t i = 0; i < events_.size(); ++i) take_event(events_[i]);
  events_.clear();
}

void Board::take_event(const MotionEvent& e) {
  const unsigned axis = 1u << e.axis;
  const AxisSettings& settings = motion_.settings(e.axis);
  switch (e.what) {
    case MotionEvent::What::began:
      note(Note::What::moves, e.axis);
      power_drops_at_[ix(e.axis)].reset();
      if (settings.power_automatic) switch_aux(axis, true);
      break;
    case MotionEvent::What::rested:
      note(Note::What::rests, e.axis);
      if (settings.power_automatic) power_drops_at_[ix(e.axis)] = now() + settings.settling;
      break;
    case MotionEvent::What::limit_hit:
      note(Note::What::limit, e.axis, e.on);
      flags_.hit_limit(axis);
      if (!settings.soft_limits) empty_queues_of(e.axis);
      break;
    case MotionEvent::What::slipped:
      flags_.set_slip(axis, settings.slip_interrupts ? axis : 0);
      if (settings.slip_kills) empty_queues_of(e.axis);
      break;
    case MotionEvent::What::nearly_done: set_done(axis); break;
    case MotionEvent::What::output: switch_aux(axis, e.on); break;
    case MotionEvent::What::ready: break;
  }
}

/// Empties the axis' own queue, and those of AA and AM if they drive this axis.
void Board::empty_queues_of(int axis) {
  flush(axis);
  for (const int context : {context_all, context_tasks}) {
    const BoardTask& t = tasks_[ix(context)];
    if (((t.running | t.last_axes) >> axis & 1u) != 0) flush(context);
  }
}

void Board::pull_line(int line, bool low) {
  const bool was_true = io_.is_true(line);
  io_.pull(line, low);
  constexpr int interrupting_lines = 2;
  if (powered_ && line < interrupting_lines && !was_true && io_.is_true(line)) flags_.input_fell();
  settle();
}

}  // namespace hw::vme58
