// Sentences for text that is no command.
#include <algorithm>
#include <cctype>

#include <fmt/core.h>

#include "core/devices/vxm/program_analysis.h"

namespace hw::vxm {
namespace {

std::string number(std::int64_t n) { return std::to_string(n); }

/// "S2M", "L"
std::string form_with_motor(const Reading& w, int motor) {
  std::string text(form_of(w.head).text);
  if (takes_motor(w.head)) text += number(motor) + "M";
  return text;
}

/// Columns of the sign and digits typed after the form.
Place place_of_value(std::string_view text, const Place& p) {
  std::size_t from = text.size();
  while (from > 0 && (std::isdigit(static_cast<unsigned char>(text[from - 1])) != 0 || text[from - 1] == ' '))
    --from;
  if (from > 0 && text[from - 1] == '-') --from;
  while (from < text.size() && text[from] == ' ') ++from;
  return {p.line, p.column + static_cast<int>(from), static_cast<int>(text.size() - from)};
}

std::string complaint(const Reading& w, std::int64_t value, const std::string& v, const Refusal& r,
                      int motor) {
  switch (w.head) {
    case Head::S:
    case Head::SA:
      return v + (value > r.max ? " is too fast for motor " : " is too slow for motor ") + number(motor) +
             ".";
    case Head::A:
      return v + (value > r.max ? " is too steep a ramp for motor " : " is not a ramp for motor ") +
             number(motor) + ".";
    case Head::I: return v + " steps are too many for one index of motor " + number(motor) + ".";
    case Head::IA: return v + " lies beyond the position register of motor " + number(motor) + ".";
    case Head::L:
    case Head::LA: return v + " passes are not a loop.";
    case Head::J:
    case Head::JM: return "There is no program " + v + ".";
    case Head::P:
    case Head::PA: return "A pause of " + v + " cannot be set.";
    default: return v + " is out of range.";
  }
}

std::string range_sentence(const Reading& w, const Refusal& r, int motor) {
  const std::string form = form_with_motor(w, motor);
  const bool speed = w.head == Head::S || w.head == Head::SA;
  const bool only_minus = r.max < 0;
  const std::int64_t low = only_minus ? -r.max : r.min, high = only_minus ? -r.min : r.max;
  const bool signed_form = w.minus && r.min >= 0 &&
                           (w.head == Head::L || w.head == Head::LA || w.head == Head::JM ||
                            w.head == Head::P || w.head == Head::PA);
  return form + (only_minus || signed_form ? "-" : "") + " takes " + number(low) + " to " + number(high) +
         (speed ? " steps/s." : ".");
}

Problem at(const Place& p, std::string sentence) {
  Problem problem;
  problem.line = p.line, problem.column = p.column, problem.length = p.length;
  problem.sentence = std::move(sentence);
  return problem;
}

Problem range_problem(const Reading& w, const Refusal& r, std::string_view text, const Place& p, int motor) {
  const bool by_sign = r.min < 0;  // forms where the sign is part of the value
  const std::int64_t value = w.minus && by_sign ? -w.value : w.value;
  const Place where = place_of_value(text, p);
  // With more digits than the reader keeps, the typed text is shown instead of the value.
  constexpr int most_digits = 9;
  const std::string typed(text.substr(text.size() - static_cast<std::size_t>(where.length)));
  const std::string number_shown = where.length > most_digits ? typed : number(value);
  Problem problem =
      at(where, complaint(w, value, number_shown, r, motor) + " " + range_sentence(w, r, motor));
  if (w.head == Head::J || w.head == Head::JM) return problem;  // the intended program cannot be guessed
  const std::int64_t nearest = std::clamp(value, r.min, r.max);
  problem.fix_text = (w.minus && !by_sign && w.head != Head::A ? "-" : "") + number(nearest);
  problem.fix_label = "Use " + problem.fix_text;
  return problem;
}

std::string u_sentence(std::int64_t u) {
  static constexpr std::array<int, 9> older{10, 40, 41, 60, 61, 70, 71, 72, 73};
  const std::string name = "U" + number(u);
  if (std::find(older.begin(), older.end(), u) != older.end())
    return name + " belongs to the VP9000. A VXM does not know it.";
  if (u > slave_u_offset && u < 2 * slave_u_offset)
    return name + " is not among the commands that a Slave carries out for its Master.";
  return "A VXM knows no " + name + ".";
}

}  // namespace

Problem problem_of(const Reading& w, const Refusal& r, std::string_view text, const Place& p,
                   int current_motor) {
  const int motor = w.motor == 0 ? current_motor : w.motor;
  if (r.kind == Refusal::Kind::motor)
    return at(p, (motor == 99 ? "There is no such motor." : "There is no motor " + number(motor) + ".") +
                     " Motors are 1 to 4.");
  if (r.nf90_only) {
    Problem problem = at(p, "L-0 sets a loop marker in NF90 emulation only. LM0 does the same.");
    problem.fix_label = "Use LM0", problem.fix_text = "LM0";
    return problem;
  }
  if (r.kind == Refusal::Kind::range) return range_problem(w, r, text, p, motor);
  if (w.head == Head::U) return at(p, u_sentence(w.value));
  if (w.head == Head::LM) return at(p, "LM knows 0, -0, -2 and -3 only.");
  return at(place_of_value(text, p),
            "There is no speed range " + number(w.value) +
                " of the analog input. Ranges are 1 to 6, 11 to 15, 21 to 24, 31 to 33, "
                "41, 42 and 51.");
}

namespace {

/// Whether `text` is nothing but whole commands.
bool is_good(const std::string& text) {
  Reader reader;
  bool any = false;
  for (const char c : text + ",")
    for (const Reading& r : reader.feed(c)) {
      if (r.kind == Reading::Kind::letter && std::isalpha(static_cast<unsigned char>(r.letter)) != 0)
        return false;
      if (r.kind != Reading::Kind::word) return false;
      if (is_stored(r.head) && std::holds_alternative<Refusal>(meaning(r, 1, false))) return false;
      any = true;
    }
  return any;
}

struct ValueRange {
  std::int64_t low = 0, high = 0;
  bool also_zero = false;
};

/// Of a set command, B or O, by the table of set-up values.
ValueRange range_of_setting(const Reading& w) {
  if (w.head == Head::B) return {0, max_backlash};
  if (w.head == Head::O) return {0, max_limit_report};
  constexpr std::string_view set = "set";
  const Form& form = form_of(w.head);
  const std::string name =
      std::string(form.text.substr(set.size())) + (form.motor == Part::required ? "mM" : "");
  for (const SetupFact& fact : setup_facts)
    if (fact.mnemonic == name) return {fact.min, fact.max, fact.also_zero};
  return {};
}

/// Escapes bytes that no font can draw.
std::string readable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F)
      out += fmt::format("\\x{:02X}", byte);
    else
      out += c;
  }
  return out;
}

}  // namespace

bool may_be_set(const Reading& w) {
  if (form_of(w.head).motor == Part::required && (w.motor < 1 || w.motor > max_motors)) return false;
  if (w.head == Head::PMA) return w.value < program_count || (w.value == pma_off && !w.minus);
  if (w.minus && (w.head != Head::set_L || w.value == 0)) return false;
  if (w.head == Head::set_B)
    return std::any_of(bauds.begin(), bauds.end(), [&](const Baud& b) { return b.number == w.value; });
  const ValueRange range = range_of_setting(w);
  const std::int64_t value = w.minus ? -w.value : w.value;
  return (value >= range.low && value <= range.high) || (range.also_zero && value == 0);
}

Problem problem_of_setting(const Reading& w, std::string_view text, const Place& p) {
  const Form& form = form_of(w.head);
  if (form.motor == Part::required && (w.motor < 1 || w.motor > max_motors))
    return at(p, "There is no such motor. Motors are 1 to 4.");
  const ValueRange range = range_of_setting(w);
  std::string allowed = number(range.low) + " to " + number(range.high);
  if (range.also_zero && range.low > 0) allowed += ", or 0";
  if (w.head == Head::set_B) allowed = "9, 19 or 38";
  if (w.head == Head::PMA) allowed = "0 to 4, -0 to -4, or 255";
  return at(p, readable(text) + " is not possible: " + std::string(form.text) + " takes " + allowed + ".");
}

Problem problem_of_text(std::string_view text, const Place& p, bool number_missing) {
  const std::string shown = readable(text);
  if (number_missing) return at(p, shown + " needs a number.");
  std::string upper = shown;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string no_plus = shown;
  no_plus.erase(std::remove(no_plus.begin(), no_plus.end(), '+'), no_plus.end());
  Problem problem = at(p, "\"" + shown + "\" is not a command of a VXM.");
  if (upper != shown && is_good(upper)) {
    problem.sentence =
        "\"" + shown + "\" is not a command: capital and small letters differ. Write " + upper + ".";
    problem.fix_text = upper;
  } else if (no_plus != shown && is_good(no_plus)) {
    problem.sentence = "A plus sign is not known. Write " + no_plus + ".";
    problem.fix_text = no_plus;
  } else if (shown.size() > 1 && shown.back() == ')' && is_good(shown.substr(0, shown.size() - 1))) {
    problem.sentence = "A comma is missing before ).";
    problem.fix_text = shown.substr(0, shown.size() - 1) + ",)";
  } else if (shown.find_first_of("{}%&") != std::string::npos) {
    problem.sentence = "\"" + shown + "\" belongs to the VP9000. A VXM does not know it.";
  }
  if (!problem.fix_text.empty()) problem.fix_label = "Use " + problem.fix_text;
  return problem;
}

}  // namespace hw::vxm
