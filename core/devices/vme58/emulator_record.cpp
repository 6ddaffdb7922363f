// Recording a contour: CD .. CE or CK.
#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

void Board::begin_recording(const Command& c) {
  recorder_.begin();
  each(c, context_,
       [this](int a, double position) { recorder_.goes(a, static_cast<std::int64_t>(position)); });
}

void Board::record(const Command& c) {
  if (c.op() == Op::CE || c.op() == Op::CK) return recorder_.end(c.op() == Op::CK);
  if (recorder_.entries() + c.entries() > make_.contour_size) return text_error();
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
  recorder_.add(piece, c.entries());
}

}  // namespace hw::vme58
