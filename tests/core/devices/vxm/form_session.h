#pragma once
// The cases of vxm.forms, which are text, to be read beside the manual:
//
//   [vxm.index.inc.pos]      the id of a row of vxm.tsv; a controller on-line with an empty program
//   M | 256<cr>              sends, and the whole reply at that very instant (also an empty one)
//   X |~ ?????????           the same, where ? is any byte
//   > I1M400,                sends
//   ~ 250ms                  time passes (us, ms, s, min, h; terms with +)
//   ~ until ^ 5s             until that came out, within so long (24 h); it can still be looked at
//   ~ program 2s             R, and on to its prompt; how long that took
//   = I1M400, | index(400) + 500ms +- 1ms
//                            C, the text, R, and on to its prompt; index(STEPS,SPEED,ACCELERATION)
//   ! press Run              a hand: press, release, click BUTTON [TIME], input N on, pulse N [TIME], analog
//   N V,
//                            limit M + on, home M on, place M minus= plus=, power
//   ? position 1 400 +- 2    what is seen: position M N, load M N, out N on, used N, free N, rate N, came
//   TEXT (since
//                            the last look), pulses M N N, pulses none, online lamp on
//   @ slave                  another controller: online, local (as powered up), slave (two on the bus,
//   on-line), form
//                            (as the form needs it)
//   * kept getM1M setM1M7    a rule that several forms have in common, see form_rules.cpp
//   # text                   a remark; so is what stands behind "  // "
//
// Bytes that cannot be printed stand in brackets: <cr>, <1B>; <sp> is a blank at an end. '' is nothing at
// all.
#include <string>

namespace hw::vxm::proof {

class Rig;
struct Form;

/// "kept getM1M setM1M7": the rule of that name in form_rules.cpp. False: there is none.
bool follow_rule(const std::string& text, Rig& rig, const Form& form);

/// The bytes that visible() shows so.
std::string bytes_of(const std::string& visible);

}  // namespace hw::vxm::proof
