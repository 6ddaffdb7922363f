#include "tests/core/devices/vme58/form_session.h"

#include <fstream>
#include <sstream>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

const std::string board_forms = HW_TEST_DIR "/core/devices/vme58/vme58.forms";

using Words = std::vector<std::string>;

Words words_in(const std::string& text) {
  std::istringstream in(text);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// What stands behind the bar, cut off.
std::string cut_at(std::string& text, const std::string& bar) {
  const auto at = text.find(bar);
  if (at == text.npos) return {};
  const std::string behind = text.substr(at + bar.size());
  text.erase(at);
  return behind;
}

Duration time_of(const std::string& text) {
  std::size_t used = 0;
  const double n = std::stod(text, &used);
  const std::string unit = text.substr(used);
  EXPECT_TRUE(unit == "h" || unit == "min" || unit == "s" || unit == "ms" || unit == "us" || unit == "ns")
      << text << " is no time";
  return from_seconds(n * (unit == "h"     ? 3600
                           : unit == "min" ? 60
                           : unit == "s"   ? 1
                           : unit == "ms"  ? 1e-3
                           : unit == "us"  ? 1e-6
                                           : 1e-9));
}

/// "move(1000,1000,10000) - 1s": from rest to rest, reaching its speed.
double seconds_of(std::string text) {
  const std::string less = cut_at(text, " - ");
  std::istringstream in(text.substr(text.find('(') + 1));
  double way = 0, speed = 1, rate = 1;
  char comma = 0;
  in >> way >> comma >> speed >> comma >> rate;
  return way / speed + speed / rate - (less.empty() ? 0 : seconds(time_of(less)));
}

constexpr std::pair<std::string_view, std::uint16_t> register_names[] = {
    {"control", reg::control}, {"status", reg::status}, {"io_low", reg::io_low},
    {"io_high", reg::io_high}, {"slip", reg::slip},     {"done", reg::done},
    {"limit", reg::limit},     {"home", reg::home},     {"vector", reg::vector},
};
constexpr std::pair<std::string_view, std::uint8_t> status_names[] = {
    {"command_error", status::command_error},
    {"initialized", status::initialized},
    {"slip", status::slip},
    {"overtravel", status::overtravel},
    {"done", status::done},
    {"board_interrupted", status::board_interrupted},
    {"direct_interrupt", status::direct_interrupt},
    {"interrupt", status::interrupt},
};
constexpr std::string_view value_names[] = {"encoder_position",      "command_position",
                                            "command_velocity",      "acceleration",
                                            "maximum_velocity",      "base_velocity",
                                            "proportional_gain",     "differential_gain",
                                            "integral_gain",         "acceleration_feed_forward",
                                            "velocity_feed_forward", "offset"};
static_assert(std::size(value_names) == axis_values);

template <class T, std::size_t N>
T named(const std::pair<std::string_view, T> (&names)[N], const std::string& name) {
  for (const auto& [known, value] : names)
    if (known == name) return value;
  ADD_FAILURE() << "there is no " << name;
  return {};
}

AxisValue value_named(const std::string& name) {
  for (std::size_t i = 0; i < std::size(value_names); ++i)
    if (value_names[i] == name) return static_cast<AxisValue>(i);
  ADD_FAILURE() << "nobody can see " << name;
  return {};
}

std::string letters_of(unsigned bits) {
  std::string letters;
  for (const char letter : axis_letters)
    if ((bits & bit_of(letter)) != 0) letters += letter;
  return letters.empty() ? "none" : letters;
}

bool matches(const std::string& text, const std::string& pattern) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '*') return true;
    if (i >= text.size() || (pattern[i] != '?' && pattern[i] != text[i])) return false;
  }
  return text.size() == pattern.size();
}

AxisPlace board_place(const Words& words) {
  AxisPlace place;
  for (const std::string& word : words) {
    std::string key = word;
    const std::string value = cut_at(key, "=");
    if (value.empty()) continue;
    if (key == "minus") place.minus = Steps(std::stoll(value));
    if (key == "plus") place.plus = Steps(std::stoll(value));
    if (key == "index") place.index_every = Steps(std::stoll(value));
    if (key == "counts") place.counts_per_step = std::stod(value);
    if (key != "home") continue;
    place.home_from = Steps(std::stoll(value));
    place.home_to = Steps(std::stoll(value.substr(value.find("..") + 2)));
  }
  return place;
}

Rig board_like(const std::string& text) {
  const Words words = words_in(text);
  DeviceOptions options;
  if (words.at(0) != "8S") options["variant"] = words[0];
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::string key = words[i];
    options[key.substr(0, key.find('='))] = key.substr(key.find('=') + 1);
  }
  return Rig(options);
}

void expect_gain_of(const Words& w) {
  const std::string gain = w.at(1);
  const AxisValue value = value_named(w.at(2));
  Rig rig;
  rig.send("AX " + gain + "12.5 ");
  EXPECT_EQ(rig.axis_value('X', value), 12) << "the whole part (decision M27)";
  rig.send(gain + "-1 ");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.axis_value('X', value), 12);
  rig.send("MR1000 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.value("AX RE"), "1000");
  Rig steps = Rig::model("8");
  steps.send("AX " + gain + "1 ");
  EXPECT_TRUE(steps.command_error()) << "servo axes only";
}

class BoardSession {
 public:
  void line(std::string text) {
    cut_at(text, "  // ");
    if (text.substr(0, 3) == ">> ") return rig_.send(text.substr(3));
    const std::string rest = text.size() > 2 ? text.substr(2) : "";
    switch (text.size() > 2 && text[1] == ' ' ? text[0] : '\0') {
      case '>': return rig_.send(rest + " ");
      case '~': return pass(rest);
      case '!': return hand(words_in(rest));
      case '?': return look(rest);
      case '@': rig_ = board_like(rest); return;
      case '*': return expect_gain_of(words_in(rest));
      default: return exchange(text);
    }
  }

 private:
  void exchange(std::string text) {
    if (const std::string wanted = cut_at(text, " |~ "); !wanted.empty()) {
      const std::string got = rig_.value(text);
      EXPECT_TRUE(matches(got, wanted)) << got;
    } else if (const auto raw = text.find(" ||"); raw != text.npos) {
      EXPECT_EQ(visible(rig_.ask(text.substr(0, raw))), raw + 4 <= text.size() ? text.substr(raw + 4) : "");
    } else if (const auto bar = text.find(" |"); bar != text.npos) {
      EXPECT_EQ(rig_.value(text.substr(0, bar)), bar + 3 <= text.size() ? text.substr(bar + 3) : "");
    } else {
      ADD_FAILURE() << "no reply stands behind a bar";
    }
  }

  void pass(std::string what) {
    std::string time = cut_at(what, " | ");
    if (what == "quiet") return rig_.run_until_quiet();
    if (what.substr(0, 5) != "done ") return rig_.run_for(time_of(what));
    const double took = seconds(rig_.run_until_done(what.substr(5)));
    if (time.empty()) return;
    const std::string tolerance = cut_at(time, " +- ");
    EXPECT_NEAR(took, seconds_of(time), seconds(time_of(tolerance)));
  }

  void hand(const Words& w) {
    if (w[0] == "acknowledge") {
      rig_.bus().acknowledge();
      return;
    }
    const bool on = w.back() == "on";
    const char axis = w.at(1)[0];
    const AxisId id{static_cast<std::uint8_t>(axis_letters.find(axis))};
    if (w[0] == "line") return rig_.line(std::stoi(w[1]), w.at(2) == "low");
    if (w[0] == "limit") return rig_.limit(axis, w.at(2)[0], on);
    if (w[0] == "home") return rig_.home_switch(axis, on);
    if (w[0] == "slip") return rig_.operate(bench::Slip(id, Steps(std::stoll(w.at(2)))));
    if (w[0] == "jam") return rig_.operate(bench::Jam(id, on));
    if (w[0] == "place") return rig_.place(axis, board_place(w));
    if (w[0] == "mail") return rig_.mail(w[1]);
    if (w[0] == "write")
      return rig_.write8(named(register_names, w[1]),
                         static_cast<std::uint8_t>(std::stoi(w.at(2), nullptr, 16)));
    ADD_FAILURE() << "no such hand";
  }

  void look(std::string what) {
    const std::string tolerance = cut_at(what, " +- ");
    const Words w = words_in(what);
    if (w[0] == "came") {
      EXPECT_EQ(visible(rig_.output()), what.size() > 5 ? what.substr(5) : "");
    } else if (w[0] == "forget") {
      w.at(1) == "output" ? void(rig_.output()) : w[1] == "done" ? void(rig_.done()) : void(rig_.status());
    } else if (const std::string seen = word_for(w); !seen.empty()) {
      EXPECT_EQ(seen, w.back());
    } else {
      compare(static_cast<double>(number_of(w)), w, tolerance.empty() ? 0 : std::stod(tolerance));
    }
  }

  static std::string yes(bool is_so) { return is_so ? "yes" : "no"; }

  /// What is seen as a word; empty: it is a number.
  std::string word_for(const Words& w) {
    if (w[0] == "error") return yes(rig_.command_error());
    if (w[0] == "moving") return yes(rig_.moving(w.at(1)[0]));
    if (w[0] == "aux") return rig_.aux_high(w.at(1)[0]) ? "high" : "low";
    if (w[0] == "line") return rig_.line_low(std::stoi(w.at(1))) ? "low" : "high";
    if (w[0] == "interrupt") return yes(rig_.bus().interrupt().has_value());
    if (w[0] == "status") return yes((rig_.status() & named(status_names, w.at(1))) != 0);
    if (w[0] == "done" || w[0] == "limit" || w[0] == "home" || w[0] == "slip")
      return letters_of(rig_.read8(named(register_names, w[0])));
    return {};
  }

  std::int64_t number_of(const Words& w) {
    const char axis = w.at(1)[0];
    if (w[0] == "position") return rig_.position(axis);
    if (w[0] == "velocity") return rig_.velocity(axis);
    if (w[0] == "room") return rig_.room(axis);
    if (w[0] == "load") return rig_.view().load_position[axis_letters.find(axis)].value;
    if (w[0] == "encoder") return std::stoll(rig_.value(std::string("A") + axis + " RE"));
    if (w[0] == "register") return rig_.read8(named(register_names, w[1]));
    if (w[0] == "waiting") return rig_.waiting();
    return rig_.axis_value(axis, value_named(w[0]));
  }

  static void compare(double seen, const Words& w, double tolerance) {
    const std::string& wanted = w.back();
    const double number = wanted.substr(0, 2) == "0x" ? std::stoi(wanted, nullptr, 16) : std::stod(wanted);
    const std::string& how = w[w.size() - 2];
    if (how == ">")
      EXPECT_GT(seen, number);
    else if (how == "<")
      EXPECT_LT(seen, number);
    else
      EXPECT_NEAR(seen, number, tolerance);
  }

  Rig rig_;
};

struct BoardCase {
  std::string id;
  int line = 0;
  std::vector<std::pair<int, std::string>> lines;
};

std::vector<BoardCase> board_cases() {
  std::vector<BoardCase> cases;
  std::ifstream file(board_forms);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    if (line.front() == '[')
      cases.push_back({line.substr(1, line.size() - 2), number, {}});
    else if (!cases.empty())
      cases.back().lines.emplace_back(number, line);
  }
  return cases;
}

void run_board_case(const BoardCase& written) {
  BoardSession session;
  for (const auto& [number, text] : written.lines) {
    SCOPED_TRACE("vme58.forms:" + std::to_string(number) + ": " + text);
    session.line(text);
  }
}

[[maybe_unused]] const bool board_cases_registered = [] {
  for (const BoardCase& written : board_cases())
    register_form(
        written.id, [written](const Form&) { run_board_case(written); }, board_forms.c_str(), written.line);
  return true;
}();

}  // namespace
}  // namespace hw::vme58::proof
