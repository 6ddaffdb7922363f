#pragma once
// One case for each command form of the tables pmx-4ex-sa.tsv and dmx-k-sa.tsv (every form in the manuals,
// with the page it stands on). The cases are text, to be read beside a manual:
//
//   [pmx.ls.set]                 the id; a fresh controller
//   LS=500 | OK                  a command and its whole reply
//   PS | 1688:0:0:0 +- 1         numbers may be off by so much
//   ~ 250ms                      time passes (s, ms, us)
//   ~ rest X                     until the axis rests
//   ! limit X + on               a hand on the bench: input N, home AXIS, limit AXIS SIDE, alarm AXIS, jam
//   AXIS
//                                on|off; analog N MV; slip AXIS COUNTS; power cycle;
//                                place AXIS minus= plus= home=A..B index= counts=
//   ? out 3 on                   an output terminal; ? load X 400; ? pulses 1 2
//   * refusals X1000 X           the command is refused in each state that refuses motion of that axis
//   * program pmx_example_1      compiles tests/language/good/pmx_example_1.prg and loads it with SA
//   # text                       a remark
//
// Beside what the lines say it is checked that a case sends the table's example, provokes every error reply
// of the table, and looks at an effect.
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {

struct Form {
  std::string id, example, kind, errors;
};

std::vector<Form> form_table(Which which);

struct FormCase {
  std::string id;
  int line = 0;
  std::vector<std::pair<int, std::string>> lines;  ///< number, text
};
std::vector<FormCase> form_cases(Which which);
/// Longer sessions, not of one form: pmx-4ex-sa.sessions, dmx-k-sa.sessions.
std::vector<FormCase> session_cases(Which which);
void run_session(Which which, const FormCase& body);

/// Runs it; failures name the line of the file.
void run_form_case(Which which, const Form& form, const FormCase& body);

}  // namespace hw::arcus::proof
