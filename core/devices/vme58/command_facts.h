#pragma once
// Every command of the data sheet: its two letters, the modes that accept it, its operands. Facts only,
// shared by driver and emulator. Queued commands take one entry of a board queue, and one more for each
// operand (decision M18).
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

/// Modes in which a command is understood.
namespace where {
inline constexpr unsigned single = 1;   ///< one axis addressed: AX .. AS
inline constexpr unsigned all = 2;      ///< AA
inline constexpr unsigned tasks = 4;    ///< AM
inline constexpr unsigned contour = 8;  ///< between CD and CE or CK
inline constexpr unsigned lists = all | tasks, axes = single | lists, any = axes | contour;
}  // namespace where

/// When a command takes effect (decision M17).
enum class When : std::uint8_t { at_once, queued, query, recorded };

enum class Shape : std::uint8_t {
  none,
  one,     ///< one number whatever the mode
  list,    ///< one number in a single-axis mode, else one per axis
  pair,    ///< two numbers
  triple,  ///< three numbers
  axes,    ///< inside a contour: one per axis of the contour
  ports,   ///< inside a contour: one or more numbers of auxiliary outputs
};

/// Kind of a number: whether user units multiply it (decision M90) and whether its fraction counts (M15).
enum class Number : std::uint8_t {
  whole,   ///< never multiplied, fraction cut
  counts,  ///< positions, distances, speeds, rates: multiplied; fraction cut, rounded with user units
  speed,   ///< JF: multiplied, keeps its fraction
  real,    ///< never multiplied, keeps its fraction
};

enum class Op : std::uint8_t {
  // clang-format off
  AA, AM, AX, AY, AZ, AT, AU, AV, AR, AS,
  EN, EF, HH, HL, LF, LN, SL, SF, CN, PN, PF, PI, BI, UN, RS,
  AC, VL, VB, LP, MA, MR, MT, ML, RM, GO, GD, JG, JF, FL,
  ST, SA, SD, KL, LS, LE, WS, WD, WH, WG, CW, HM, HR, KM, KR,
  ID, II, IN, IC, CA, WA, WQ, SW, WT,
  WY, RP, RQ, RA, RI, QA, QI, RC, RV, RU, UU, UF,
  AN, AF, PA, SE, BL, BH, BX, RB,
  CD, CE, CK, CR, CV, CX, contour_MT, contour_AN, contour_AF,
  KP, KI, KD, KV, KA, KO, KN,
  ER, HV, HG, HD, HF, HN, IP, ES, TN, TF, IS, RL, ET, HE, HS, EA, RE,
  MP, MM, MV, SP, FP,
  KK,
  // clang-format on
};

/// Opens a block that is repeated: LS .. LE, WS .. WD, WH .. WG.
constexpr bool begins_block(Op op) { return op == Op::LS || op == Op::WS || op == Op::WH; }

/// The command that opens the block closed by `end`.
constexpr std::optional<Op> block_begin_of(Op end) {
  switch (end) {
    case Op::LE: return Op::LS;
    case Op::WD: return Op::WS;
    case Op::WG: return Op::WH;
    default: return std::nullopt;
  }
}

struct CommandFact {
  std::string_view letters;
  Op op;
  unsigned where;
  When when;
  Shape shape = Shape::none;
  Number number = Number::whole;
  double min = 0,
         max = 0;  ///< of each number, in counts; see `second` for pair and triple
  double second_min = 0, second_max = 0;
  bool needs_encoder = false;  ///< refused on an axis without one (decision M83)
  bool needs_servo = false;
};

namespace command_limits {
inline constexpr double p = position_max, d = distance_max, v = velocity_max, a = acceleration_max;
inline constexpr double ms = wait_max_ms, big = whole_max, huge = std::numeric_limits<double>::max();
}  // namespace command_limits

/// A mnemonic with two meanings is listed twice, the contour command last.
inline constexpr auto command_facts = [] {
  using namespace command_limits;
  using enum Op;
  using enum When;
  using enum Shape;
  using enum Number;
  namespace w = where;
  return std::to_array<CommandFact>({
      // clang-format off
      {"AA", AA, w::any, at_once}, {"AM", AM, w::any, at_once},
      {"AX", AX, w::any, at_once}, {"AY", AY, w::any, at_once}, {"AZ", AZ, w::any, at_once},
      {"AT", AT, w::any, at_once}, {"AU", AU, w::any, at_once}, {"AV", AV, w::any, at_once},
      {"AR", AR, w::any, at_once}, {"AS", AS, w::any, at_once},
      {"EN", EN, w::any, at_once}, {"EF", EF, w::any, at_once},
      {"HH", HH, w::single, at_once}, {"HL", HL, w::single, at_once},
      {"LF", LF, w::single, at_once}, {"LN", LN, w::single, at_once},
      {"SL", SL, w::single, at_once}, {"SF", SF, w::single, at_once},
      {"CN", CN, w::any, at_once}, {"PN", PN, w::any, at_once, one, whole, 1, parabolic_max},
      {"PF", PF, w::any, at_once},
      {"PI", PI, w::single, at_once, one, whole, 0, big},
      {"BI", BI, w::single, at_once}, {"UN", UN, w::single, at_once},
      {"RS", RS, w::any, at_once},
      {"AC", AC, w::axes, queued, list, counts, 0, a}, {"VL", VL, w::axes, queued, list, counts, 0, v},
      {"VB", VB, w::axes, queued, list, counts, 0, v},
      {"LP", LP, w::axes, at_once, list, counts, -p, p},
      {"MA", MA, w::axes, queued, list, counts, -p, p}, {"MR", MR, w::axes, queued, list, counts, -d, d},
      {"MT", MT, w::lists, queued, list, counts, -p, p}, {"ML", ML, w::lists, queued, list, counts, -d, d},
      {"RM", RM, w::single, queued, one, counts, -big, big},
      {"GO", GO, w::axes, queued}, {"GD", GD, w::axes, queued},
      {"JG", JG, w::axes, queued, list, counts, -v, v}, {"JF", JF, w::single, queued, one, speed, -v, v},
      {"FL", FL, w::any, at_once}, {"ST", ST, w::any, at_once}, {"SA", SA, w::any, at_once},
      {"SD", SD, w::any, at_once}, {"KL", KL, w::any, at_once},
      {"LS", LS, w::axes, queued, one, whole, 1, big}, {"LE", LE, w::axes, queued},
      {"WS", WS, w::axes, queued, one, whole, 0, io_lines - 1}, {"WD", WD, w::axes, queued},
      {"WH", WH, w::axes, queued}, {"WG", WG, w::axes, queued}, {"CW", CW, w::any, at_once},
      {"HM", HM, w::axes, queued, list, counts, -p, p}, {"HR", HR, w::axes, queued, list, counts, -p, p},
      {"KM", KM, w::axes, queued}, {"KR", KR, w::axes, queued},
      {"ID", ID, w::axes, queued}, {"II", II, w::axes, queued},
      {"IN", IN, w::axes, queued, list, counts, 0, d},
      {"IC", IC, w::any, at_once}, {"CA", CA, w::single, at_once},
      {"WA", WA, w::all, queued}, {"WQ", WQ, w::any, at_once},
      {"SW", SW, w::axes, queued, one, whole, 0, io_lines - 1}, {"WT", WT, w::axes, queued, one, whole, 0, ms},
      {"WY", WY, w::any, query}, {"RP", RP, w::any, query}, {"RQ", RQ, w::any, query},
      {"RA", RA, w::single, query}, {"RI", RI, w::any, query}, {"QA", QA, w::single, query},
      {"QI", QI, w::any, query}, {"RC", RC, w::any, query}, {"RV", RV, w::any, query}, {"RU", RU, w::any, query},
      {"UU", UU, w::axes, at_once, list, real, -huge, huge}, {"UF", UF, w::axes, at_once},
      {"AN", AN, w::axes, queued}, {"AF", AF, w::axes, queued},
      {"PA", PA, w::single, at_once, one, whole, 0, 1}, {"SE", SE, w::single, at_once, one, whole, 0, ms},
      {"BL", BL, w::any, queued, one, whole, 0, io_lines - 1}, {"BH", BH, w::any, queued, one, whole, 0, io_lines - 1},
      {"BX", BX, w::any, query}, {"RB", RB, w::any, query},
      {"CD", CD, w::lists, at_once, list, counts, -p, p}, {"CE", CE, w::contour, recorded},
      {"CK", CK, w::contour, recorded},
      {"CR", CR, w::contour, recorded, triple, counts, -p, p, -huge, huge},
      {"CV", CV, w::any, at_once, one, counts, 0, v}, {"CX", CX, w::lists, queued},
      {"MT", contour_MT, w::contour, recorded, axes, counts, -p, p},
      {"AN", contour_AN, w::contour, recorded, ports, whole, 0, most_axes - 1},
      {"AF", contour_AF, w::contour, recorded, ports, whole, 0, most_axes - 1},
      {"KP", KP, w::single, at_once, one, real, 0, huge, 0, 0, false, true},
      {"KI", KI, w::single, at_once, one, real, 0, huge, 0, 0, false, true},
      {"KD", KD, w::single, at_once, one, real, 0, huge, 0, 0, false, true},
      {"KV", KV, w::single, at_once, one, real, 0, huge, 0, 0, false, true},
      {"KA", KA, w::single, at_once, one, real, 0, huge, 0, 0, false, true},
      {"KO", KO, w::single, at_once, one, real, -huge, huge, 0, 0, false, true},
      {"KN", KN, w::single, at_once, one, whole, 0, integration_exponent_max, 0, 0, false, true},
      {"ER", ER, w::single, at_once, pair, whole, 1, big, 1, big, true},
      {"HV", HV, w::single, at_once, one, counts, 0, v, 0, 0, true},
      {"HG", HG, w::single, at_once, one, real, 0, huge, 0, 0, true},
      {"HD", HD, w::single, at_once, one, whole, 0, d, 0, 0, true},
      {"HF", HF, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"HN", HN, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"IP", IP, w::axes, queued, none, whole, 0, 0, 0, 0, true},
      {"ES", ES, w::single, at_once, one, whole, 0, d, 0, 0, true},
      {"TN", TN, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"TF", TF, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"IS", IS, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"RL", RL, w::any, query},
      {"ET", ET, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"HE", HE, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"HS", HS, w::single, at_once, none, whole, 0, 0, 0, 0, true},
      {"EA", EA, w::single, query, none, whole, 0, 0, 0, 0, true},
      {"RE", RE, w::any, query, none, whole, 0, 0, 0, 0, true},
      {"MP", MP, w::single, queued}, {"MM", MM, w::single, queued},
      {"MV", MV, w::single, queued, pair, counts, -p, p, 0, v},
      {"SP", SP, w::single, queued, one, counts, -p, p}, {"FP", FP, w::single, at_once, one, counts, -p, p},
      // clang-format on
  });
}();

/// Not in the data sheet. Existing drivers send KK2 to find out whether an axis has a servo loop; boards with
/// the quirk `oms-kk` accept it (decision M98).
inline constexpr CommandFact oms_kk{
    "KK", Op::KK, where::single, When::at_once, Shape::one, Number::real, 0, command_limits::huge,
    0,    0,      false,         true};

/// The command with these two letters that one of `modes` accepts; else one that other modes accept, else
/// null.
constexpr const CommandFact* find_command(char first, char second, unsigned modes) {
  const CommandFact* found = nullptr;
  for (const CommandFact& f : command_facts) {
    if (f.letters[0] != first || f.letters[1] != second) continue;
    if ((f.where & modes) != 0) return &f;
    if (found == nullptr) found = &f;
  }
  return found;
}

}  // namespace hw::vme58
