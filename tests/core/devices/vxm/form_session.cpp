#include "tests/core/devices/vxm/form_session.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

const std::string forms_file = HW_TEST_DIR "/core/devices/vxm/vxm.forms";

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// What stands behind " BAR ", cut off; empty: there is no such bar.
std::string cut_behind(std::string& text, const std::string& bar) {
  const auto at = text.find(bar);
  if (at == text.npos) return {};
  const std::string behind = text.substr(at + bar.size());
  text.erase(at);
  return behind;
}

std::vector<std::string> terms_of(const std::string& sum) {
  std::vector<std::string> terms;
  std::string rest = sum;
  while (!rest.empty()) {
    std::string term = rest;
    rest = cut_behind(term, " + ");
    terms.push_back(term);
  }
  return terms;
}

Duration plain_duration(const std::string& text) {
  std::size_t used = 0;
  const double n = std::stod(text, &used);
  const std::string unit = text.substr(used);
  const double second = unit == "h"     ? 3600
                        : unit == "min" ? 60
                        : unit == "s"   ? 1
                        : unit == "ms"  ? 1e-3
                                        : 1e-6;
  EXPECT_TRUE(second > 1e-6 || unit == "us") << text << " is no time";
  return from_seconds(n * second);
}

/// "250ms", "index(400)", "2*index(400,1000,4)".
Duration term_duration(const std::string& term) {
  const auto bracket = term.find("index(");
  if (bracket == term.npos) return plain_duration(term);
  const int times = bracket == 0 ? 1 : std::stoi(term);
  std::istringstream in(term.substr(bracket + 6));
  double steps = 0, speed = 2000, ramp = 2;
  char between = 0;
  in >> steps >> between;
  if (between == ',') in >> speed >> between;
  if (between == ',') in >> ramp >> between;
  return times * index_time(static_cast<std::int64_t>(steps), speed, ramp);
}

Duration duration_of(const std::string& sum) {
  Duration all{};
  for (const std::string& term : terms_of(sum)) all += term_duration(term);
  return all;
}

Rig made(const std::string& how, const Form& form) {
  if (how == "local") return Rig();
  if (how == "slave") return Rig::online_with_slave();
  if (how == "form") return rig_for(form);
  EXPECT_EQ(how, "online");
  return Rig::online();
}

/// '?' in the pattern is any byte.
bool fits(const std::string& bytes, const std::string& pattern) {
  return std::equal(bytes.begin(), bytes.end(), pattern.begin(), pattern.end(),
                    [](char c, char p) { return p == '?' || p == c; });
}

class FormSession {
 public:
  explicit FormSession(const Form& form) : form_(form), rig_(Rig::online()) {}

  void line(std::string text) {
    cut_behind(text, "  // ");
    // Some of these characters are commands too, with a reply behind their bar.
    const bool is_line_of_ours = text.size() > 2 && text[1] == ' ' && text[2] != '|';
    const char what = is_line_of_ours ? text[0] : '\0';
    const std::string rest = is_line_of_ours ? text.substr(2) : text;
    switch (what) {
      case '>': return rig_.send(bytes_of(rest));
      case '~': return pass(rest);
      case '=': return run(rest);
      case '!': return hand(words_of(rest));
      case '?': return look(rest);
      case '@': rig_ = made(rest, form_); return;
      case '*': EXPECT_TRUE(follow_rule(rest, rig_, form_)) << "no such rule"; return;
      default: return exchange(text);
    }
  }

 private:
  void exchange(std::string text) {
    if (const std::string pattern = cut_behind(text, " |~ "); !pattern.empty()) {
      const std::string got = rig_.ask(bytes_of(text));
      EXPECT_TRUE(fits(got, bytes_of(pattern))) << visible(got);
      return;
    }
    const auto bar = text.rfind(" |");
    if (bar == text.npos) {
      ADD_FAILURE() << "no reply stands behind a bar";
      return;
    }
    const std::string wanted = bar + 3 < text.size() ? text.substr(bar + 3) : "";
    EXPECT_EQ(visible(rig_.ask(bytes_of(text.substr(0, bar)))), wanted);
  }

  void pass(const std::string& what) {
    const auto words = words_of(what);
    if (words[0] == "until") {
      const Duration patience = words.size() > 2 ? duration_of(words[2]) : Duration(24h);
      EXPECT_TRUE(rig_.run_until_output(bytes_of(words.at(1)), patience)) << "it did not come";
    } else if (words[0] == "program") {
      took(rig_.run_program(), what.size() > 8 ? what.substr(8) : "");
    } else {
      rig_.run_for(duration_of(what));
    }
  }

  void run(std::string text) {
    const std::string time = cut_behind(text, " | ");
    took(rig_.run(bytes_of(text)), time);
  }

  static void took(Duration time, std::string wanted) {
    if (wanted.empty()) return;
    const std::string tolerance = cut_behind(wanted, " +- ");
    EXPECT_TRUE(
        same_time(time, duration_of(wanted), tolerance.empty() ? Duration(2us) : duration_of(tolerance)));
  }

  void hand(const std::vector<std::string>& w) {
    if (w[0] == "power") return rig_.power_cycle();
    const bool on = w.back() == "on";
    const auto number = [&](std::size_t i) { return std::stoi(w.at(i)); };
    const bool timed =
        w.size() > 2 && w.back().back() == 's' && std::isdigit(static_cast<unsigned char>(w.back()[0]));
    const Duration held = timed ? duration_of(w.back()) : Duration(50ms);
    std::string button = w.at(1);  // "Slave Run"
    for (std::size_t i = 2; i + timed < w.size(); ++i) button += " " + w[i];
    if (w[0] == "press") return rig_.press(button);
    if (w[0] == "release") return rig_.release(button);
    if (w[0] == "click") return rig_.click(button, held);
    if (w[0] == "input") return rig_.input(number(1), on);
    if (w[0] == "pulse") return rig_.pulse_input(number(1), held);
    if (w[0] == "analog") return rig_.analog(number(1), number(2));
    if (w[0] == "limit") return rig_.limit(number(1), w.at(2)[0], on);
    if (w[0] == "home") return rig_.home_switch(number(1), on);
    if (w[0] == "place") return rig_.place(number(1), place_of(w));
    ADD_FAILURE() << "no such hand";
  }

  static AxisPlace place_of(const std::vector<std::string>& words) {
    AxisPlace place;
    for (const std::string& word : words) {
      const auto equals = word.find('=');
      if (equals == word.npos) continue;
      const Steps value(std::stoll(word.substr(equals + 1)));
      (word.substr(0, equals) == "minus" ? place.minus : place.plus) = value;
    }
    return place;
  }

  void look(std::string what) {
    if (look_at_output(what)) return;
    const std::string tolerance = cut_behind(what, " +- ");
    const auto w = words_of(what);
    if (w[0] == "pulses") return look_at_pulses(w);
    if (w[0] == "widths") return look_at_widths(w);
    if (w[0] == "out") return expect_on(rig_.out(std::stoi(w.at(1))), w.at(2));
    if (w[0] == "online") return expect_on(rig_.online_lamp(), w.at(2));
    const auto seen = number_of(w);
    std::int64_t& before = seen_[w[0] + w.at(1)];
    if (w.back() == "same") {
      EXPECT_EQ(seen, before);
    } else if (w.back() != "any") {
      EXPECT_NEAR(static_cast<double>(seen), std::stod(w.back()),
                  tolerance.empty() ? 0 : std::stod(tolerance));
    }
    before = seen;
  }

  bool look_at_output(const std::string& what) {
    const std::string word = what.substr(0, what.find(' '));
    const std::string wanted = what.size() > word.size() + 1 ? what.substr(word.size() + 1) : "";
    if (word == "came")
      EXPECT_EQ(visible(rig_.output()), wanted);
    else if (word == "begins")
      EXPECT_EQ(visible(rig_.output()).substr(0, wanted.size()), wanted);
    else if (word == "lacks")
      EXPECT_EQ(visible(rig_.output()).find(wanted), std::string::npos);
    else
      return false;
    return true;
  }

  std::int64_t number_of(const std::vector<std::string>& w) {
    if (w[0] == "position") return rig_.position(std::stoi(w.at(1)));
    if (w[0] == "load") return rig_.load(std::stoi(w.at(1)));
    if (w[0] == "way") return std::llabs(rig_.load(std::stoi(w.at(1))) - seen_["load" + w[1]]);
    if (w[0] == "answer") return std::atoll(rig_.ask(bytes_of(w.at(1))).c_str());
    if (w[0] == "used") return rig_.used_bytes();
    if (w[0] == "free") return rig_.free_bytes();
    EXPECT_EQ(w[0], "rate") << "nobody can see that";
    return rig_.emulator().rate();
  }

  void look_at_pulses(const std::vector<std::string>& w) {
    if (w.at(1) == "none") {
      EXPECT_TRUE(rig_.pulses().empty());
      return;
    }
    std::vector<std::int64_t> wanted;
    for (std::size_t i = 2; i < w.size(); ++i) wanted.push_back(std::stoll(w[i]));
    EXPECT_EQ(rig_.pulse_positions(std::stoi(w[1])), wanted);
  }

  /// Of all pulses.
  void look_at_widths(const std::vector<std::string>& w) {
    std::vector<std::int64_t> wanted, seen;
    for (std::size_t i = 1; i < w.size(); ++i) wanted.push_back(duration_of(w[i]).count());
    for (const TriggerPulse& pulse : rig_.pulses()) seen.push_back(pulse.width.count());
    EXPECT_EQ(seen, wanted) << "ns";
  }

  static void expect_on(bool is_on, const std::string& wanted) { EXPECT_EQ(is_on ? "on" : "off", wanted); }

  const Form& form_;
  Rig rig_;
  std::map<std::string, std::int64_t> seen_;  ///< by what is looked at
};

struct WrittenCase {
  std::string id;
  int line = 0;
  std::vector<std::pair<int, std::string>> lines;
};

std::vector<WrittenCase> written_cases() {
  std::vector<WrittenCase> cases;
  std::ifstream file(forms_file);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || (line.substr(0, 2) == "# " && line.substr(0, 3) != "# |")) continue;
    if (line.front() == '[' && line.back() == ']' && line.substr(0, 5) == "[vxm.")
      cases.push_back({line.substr(1, line.size() - 2), number, {}});
    else if (!cases.empty())
      cases.back().lines.emplace_back(number, line);
  }
  return cases;
}

void run_case(const Form& form, const WrittenCase& written) {
  FormSession session(form);
  for (const auto& [number, text] : written.lines) {
    SCOPED_TRACE("vxm.forms:" + std::to_string(number) + ": " + text);
    session.line(text);
  }
}

[[maybe_unused]] const bool all_registered = [] {
  for (const WrittenCase& written : written_cases())
    register_form(
        written.id, [written](const Form& form) { run_case(form, written); }, forms_file.c_str(),
        written.line);
  return true;
}();

}  // namespace

std::string bytes_of(const std::string& visible) {
  if (visible == "''") return {};
  std::string bytes;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const auto end = visible[i] == '<' ? visible.find('>', i) : visible.npos;
    if (end == visible.npos || end - i != 3) {
      bytes += visible[i];
      continue;
    }
    const std::string name = visible.substr(i + 1, 2);
    bytes += name == "cr" ? '\r' : name == "sp" ? ' ' : static_cast<char>(std::stoi(name, nullptr, 16));
    i = end;
  }
  return bytes;
}

}  // namespace hw::vxm::proof
