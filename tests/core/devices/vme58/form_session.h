#pragma once
// The cases of vme58.forms, which are text, to be read beside the data sheet:
//
//   [vme58.move.MR]          the id of a row of vme58.tsv; a board 8S as after power-up
//   > AX VL1000 GO ID        sends, with a blank behind; >> without
//   AX RP | 400              sends, and the reply at that very instant without its control characters
//   AX EA |~ ???P*           the same, where ? is any character and * any end
//   WY || <lf><cr>...        the reply as it came
//   ~ 250ms                  time passes (ns, us, ms, s, min, h)
//   ~ done XY | move(1000,1000,10000) - 1s +- 10us
//                            until these axes are done; how long that took: a move from rest to rest of WAY,
//                            SPEED, ACCELERATION
//   ~ quiet                  until nothing happens by itself
//   ! line 0 low             a hand: line N low, limit X + on, home X on, slip X COUNTS, jam X on, place X
//   minus= plus=
//                            home=A..B index= counts=; or the bus: write REGISTER 0x90, mail CW, acknowledge
//   ? position X 400 +- 2    what is seen: position, velocity, room, load, encoder, or a value of the axis
//   data by its
//                            name, of an axis (also "position X > 5"); moving X yes, aux X high, line 8 low,
//                            error yes (and clears it), done XY, limit X, home none, slip X, status slip yes,
//                            register io_low 0xFF, interrupt no, waiting 0, came TEXT; forget
//                            status|done|output
//   @ 4E jumpers=IOI         another board
//   * gain KP proportional_gain
//                            the gain can be read in the window; negative ones are refused; an ideal axis
//                            does not care
//   # text                   a remark; so is what stands behind "  // "
