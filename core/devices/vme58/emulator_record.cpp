// Recording a contour: CD .. CE or CK.
#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

void Board::begin_recording(const Command& c) {
  contour_ = Contour();
  each(c, context_, [this](int a, double position) {
    contour_.axes |= 1u << a;
    contour_.start[ix(a)] = static_cast<std::int64_t>(position);
  });
  recording_ = true;
  spoiled_ = false;
  recorded_entries_ = 0;
}

void Board::record(const Command& c) {
  if (c.op() == Op::CE || c.op() == Op::CK) return end_recording(c.op() == Op::CK);
  if (recorded_entries_ + c.entries() > make_.contour_size) return text_error();
  recorded_entries_ += c.entries();
  RecordedPiece piece;
  switch (c.op()) {
    case Op::contour_MT:
      for (int place = 0; place < c.operands(); ++place)
        piece.to[ix(place)] = static_cast<std::int64_t>(*c.number[ix(place)]);
      break;
    case Op::CR:
      piece.kind = RecordedPiece::Kind::arc;
      piece.centre_first = static_cast<std::int64_t>(c.first());
      piece.centre_second = static_cast<std::int64_t>(*c.number[1]);
      piece.angle = *c.number[2];
      break;
    default:
      piece.kind = RecordedPiece::Kind::outputs;
      piece.high = c.op() == Op::contour_AN;
      for (const auto& port : c.number)
        if (port) piece.outputs |= 1u << static_cast<int>(*port);
      break;
  }
  contour_.pieces.push_back(piece);
}

void Board::end_recording(bool kill) {
  recording_ = false;
  contour_.kill = kill;
  contour_.complete = !spoiled_;
}

}  // namespace hw::vme58
