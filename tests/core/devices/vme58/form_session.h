#pragma once
// The cases of vme58.forms, which are text, to be read beside the data sheet (form_text.h tells how lines are
// repeated and named):
//
//   [vme58.move.MR]          the id of a row of vme58.tsv; a board 8S as after power-up
//   > AX VL1000 GO ID        sends, with a blank behind; >> without
//   AX RP | 400              sends, and the reply at that very instant without its control characters
//   AX EA |~ ???P*           the same, where ? is any character and * any end
//   WY || <lf><cr>...        the reply as it came
//   ~ 250ms                  time passes (ns, us, ms, s, min, h; "100ms - 1ns")
//   ~ done XY | move(1000,1000,10000) - 1s +- 10us
//                            until these axes are done; how long that took: a time, or a move from rest to
//                            rest of WAY, SPEED, ACCELERATION
//   ~ quiet                  until nothing happens by itself; | as above
//   ~ until encoder X 200 every 10ms
//                            until that is seen, at most a minute
//   ~ watch X 1s             time passes, and each ms the axis is looked at (overshoot, crossings, error)
//   ! line 0 low             a hand: line N low, limit X + on, home X on, slip X COUNTS, jam X on, blanks N
//   (sent),
//                            place X minus= plus= home=A..B index= counts= motor=yes; or the bus: write
//                            REGISTER 0x90, write16 PLACE VALUE, write32, cells PLACE 0xBE00 TEXT (its high
//                            bytes), mail CW, acknowledge
//   ? position X 400 +- 2    what is seen: position, velocity, room, load, encoder, or a value of the axis
//   data by its
//                            name, of an axis; distance XY and speed XY from zero; also "> 5", "< 5",
//                            "multiple 100"; moving X yes, aux X high, line 8 low, error yes (and clears it),
//                            done XY, limit X, home none, slip X, status slip yes, register io_low 0xFF,
//                            read16 PLACE VALUE, read32, cells PLACE TEXT, interrupt no, interrupt_vector 99,
//                            waiting 0, came TEXT, came 15 times TEXT, took 2.5 (seconds, of the ~ before),
//                            overshoot 0.05, crossings 2, error_watched 3 (all of the ~ watch before), forget
//                            status|done|output
//   = plain took             keeps what is seen under a name: ? took > plain+0.05, ? position Y 2*x +- 3
//   @ 4E jumpers=IOI         another board
//   * not-writable           a rule of form_rules.cpp
//   # text                   a remark; so is what stands behind "  // "
// A PLACE of the window is a name of facts.h or "first" of the row, with an offset: first+500, vector-1.
#include <string>

#include "tests/core/devices/vme58/form_case.h"
#include "tests/core/devices/vme58/form_text.h"

namespace hw::vme58::proof {

/// False: there is no such rule.
bool follow_rule(const std::string& text, Rig& rig, const Form& form);

}  // namespace hw::vme58::proof
