// Events of a board for a rehearsal.
#include <algorithm>

#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

void Board::note(Note::What what, int number, bool on) {
  if (notes_ == nullptr) return;
  notes_->list.push_back({what, now(), number, motion_.position(number % most_axes), on, source_});
}

void Board::command_error() {
  flags_.command_error();
  note(Note::What::rejected);
}

void Board::set_done(unsigned axes) {
  flags_.set_done(axes);
  each_axis(axes, [this](int a) { note(Note::What::done, a); });
}

void Board::switch_aux(unsigned axes, bool high) {
  const unsigned before = io_.aux_high();
  io_.set_aux(axes, high);
  note_outputs(io_.lines_on(), before);
}

void Board::drive_line(int line, bool low) {
  const unsigned before = io_.lines_on();
  io_.drive(line, low);
  note_outputs(before, io_.aux_high());
}

void Board::note_outputs(unsigned lines_before, unsigned aux_before) {
  const auto differs = [](unsigned now, unsigned before, int bit) {
    return ((now ^ before) >> bit & 1u) != 0;
  };
  for (int line = 0; line < io_lines; ++line)
    if (differs(io_.lines_on(), lines_before, line)) note(Note::What::line, line, io_.is_true(line));
  each_axis(fitted_, [&](int a) {
    if (differs(io_.aux_high(), aux_before, a)) note(Note::What::aux, a, (io_.aux_high() >> a & 1u) != 0);
  });
}

bool Board::idle() const {
  if (boots_until_ || held_ || waits_empty_ || !replies_.empty() || !window_.all_taken()) return false;
  for (int context = 0; context < contexts; ++context)
    if (!runs_empty(context)) return false;
  bool moving = false;
  each_axis(fitted_, [&](int a) { moving = moving || motion_.moving(a); });
  return !moving;
}

}  // namespace hw::vme58
