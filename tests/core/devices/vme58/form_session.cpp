#include "tests/core/devices/vme58/form_session.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/core/devices/vme58/form_names.h"

namespace hw::vme58::proof {
namespace {

const std::string board_forms = HW_TEST_DIR "/core/devices/vme58/vme58.forms";

/// What stands behind the bar, cut off.
std::string cut_at(std::string& text, const std::string& bar) {
  const auto at = text.find(bar);
  if (at == text.npos) return {};
  const std::string behind = text.substr(at + bar.size());
  text.erase(at);
  return behind;
}

Duration time_of(std::string text) {
  if (const std::string less = cut_at(text, " - "); !less.empty()) return time_of(text) - time_of(less);
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

/// "move(1000,1000,10000) - 1s": from rest to rest, reaching its speed; or a time.
double seconds_of(std::string text) {
  if (text.find("move(") == text.npos) return seconds(time_of(text));
  const std::string less = cut_at(text, " - ");
  std::istringstream in(text.substr(text.find('(') + 1));
  double way = 0, speed = 1, rate = 1;
  char comma = 0;
  in >> way >> comma >> speed >> comma >> rate;
  return way / speed + speed / rate - (less.empty() ? 0 : seconds(time_of(less)));
}

bool matches(const std::string& text, const std::string& pattern) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '*') return true;
    if (i >= text.size() || (pattern[i] != '?' && pattern[i] != text[i])) return false;
  }
  return text.size() == pattern.size();
}

/// What is left of a line behind so many words.
std::string behind_words(const std::string& text, int count) {
  std::size_t at = 0;
  for (; count > 0 && at != text.npos; --count) at = text.find(' ', at + 1);
  return at == text.npos ? "" : text.substr(at + 1);
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
    if (key == "motor") place.motor = Motor();
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

std::string yes(bool is_so) { return is_so ? "yes" : "no"; }

/// What an axis did from ms to ms, on its way to where it was sent.
struct Watched {
  std::vector<std::int64_t> encoder;
  std::int64_t target = 0, worst_error = 0;

  [[nodiscard]] double overshoot() const {
    double most = 0;
    for (const std::int64_t at : encoder)
      most = std::max(most, static_cast<double>(at) / static_cast<double>(target) - 1);
    return most;
  }
  [[nodiscard]] int crossings() const {
    int count = 0;
    bool below = true;
    for (const std::int64_t at : encoder)
      if (at != target && (at < target) != below) ++count, below = at < target;
    return count;
  }
};

class BoardSession {
 public:
  explicit BoardSession(const Form& form) : form_(form) {}

  void line(std::string text) {
    cut_at(text, "  // ");
    if (text.substr(0, 3) == ">> ") return rig_.send(characters_in(text.substr(3)));
    const std::string rest = text.size() > 2 ? text.substr(2) : "";
    switch (text.size() > 2 && text[1] == ' ' ? text[0] : '\0') {
      case '>': return rig_.send(characters_in(rest) + " ");
      case '~': return pass(rest);
      case '!': return hand(rest);
      case '?': return look(rest);
      case '=': remembered_[words_in(rest).at(0)] = number_of(words_in(behind_words(rest, 1))); return;
      case '@': rig_ = board_like(rest); return;
      case '*': EXPECT_TRUE(follow_rule(rest, rig_, form_)) << "no such rule"; return;
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
    const Words w = words_in(what);
    const Instant begin = rig_.now();
    if (w[0] == "quiet")
      rig_.run_until_quiet();
    else if (w[0] == "done")
      rig_.run_until_done(w.at(1));
    else if (w[0] == "until")
      wait_until(what.substr(6));
    else if (w[0] == "watch")
      watch(w.at(1)[0], time_of(w.at(2)));
    else
      rig_.run_for(time_of(what));
    took_ = seconds(rig_.now() - begin);
    if (time.empty()) return;
    const std::string tolerance = cut_at(time, " +- ");
    EXPECT_NEAR(took_, seconds_of(time), tolerance.empty() ? 0 : seconds(time_of(tolerance)));
  }

  void wait_until(std::string what) {
    const Duration step = time_of(cut_at(what, " every "));
    const Words w = words_in(what);
    const Instant end = rig_.now() + 60s;
    while (number_of(w) != wanted_number(w.back())) {
      if (rig_.now() >= end) {
        ADD_FAILURE() << "it was not seen in a minute";
        return;
      }
      rig_.run_for(step);
    }
  }

  void watch(char axis, Duration time) {
    watched_ = {};
    for (Duration passed{}; passed < time; passed += 1ms) {
      rig_.run_for(1ms);
      watched_.encoder.push_back(encoder(axis));
      watched_.target = rig_.position(axis);
      watched_.worst_error =
          std::max(watched_.worst_error, std::abs(watched_.target - watched_.encoder.back()));
    }
  }

  void hand(const std::string& text) {
    const Words w = words_in(text);
    if (w[0] == "acknowledge") {
      rig_.bus().acknowledge();
      return;
    }
    if (write(w, text)) return;
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
    if (w[0] == "blanks") return rig_.send(std::string(std::stoul(w[1]), ' '));
    ADD_FAILURE() << "no such hand";
  }

  /// False: it is no cycle of the bus.
  bool write(const Words& w, const std::string& text) {
    if (w[0] != "write" && w[0] != "write16" && w[0] != "write32" && w[0] != "cells") return false;
    std::uint16_t place = place_named(w.at(1), form_);
    const auto value = static_cast<std::uint32_t>(std::stoul(w.at(2), nullptr, 0));
    if (w[0] == "write") rig_.write8(place, static_cast<std::uint8_t>(value));
    if (w[0] == "write16") rig_.write16(place, static_cast<std::uint16_t>(value));
    if (w[0] == "write32") rig_.write32(place, value);
    if (w[0] != "cells") return true;
    for (const char c : characters_in(behind_words(text, 3))) {
      rig_.write16(place, static_cast<std::uint16_t>(value | static_cast<std::uint8_t>(c)));
      place = static_cast<std::uint16_t>(place + 2);
    }
    return true;
  }

  void look(std::string what) {
    const std::string tolerance = cut_at(what, " +- ");
    const Words w = words_in(what);
    if (w[0] == "came") {
      look_at_output(w, what);
    } else if (w[0] == "cells") {
      look_at_cells(place_named(w.at(1), form_), characters_in(behind_words(what, 2)));
    } else if (w[0] == "forget") {
      w.at(1) == "output" ? void(rig_.output()) : w[1] == "done" ? void(rig_.done()) : void(rig_.status());
    } else if (const std::string seen = word_for(w); !seen.empty()) {
      EXPECT_EQ(seen, w.back());
    } else {
      compare(number_of(w), w, tolerance.empty() ? 0 : std::stod(tolerance));
    }
  }

  void look_at_output(const Words& w, const std::string& what) {
    const bool repeated = w.size() > 3 && w[2] == "times";
    const std::string once = behind_words(what, repeated ? 3 : 1);
    std::string wanted;
    for (int left = repeated ? std::stoi(w[1]) : 1; left > 0; --left) wanted += once;
    EXPECT_EQ(visible(rig_.output()), wanted);
  }

  void look_at_cells(std::uint16_t place, const std::string& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_EQ(rig_.read16(static_cast<std::uint16_t>(place + 2 * i)), static_cast<std::uint8_t>(wanted[i]))
          << "cell " << i;
  }

  /// What is seen as a word; empty: it is a number.
  std::string word_for(const Words& w) {
    if (w[0] == "error") return yes(rig_.command_error());
    if (w[0] == "moving") return yes(rig_.moving(w.at(1)[0]));
    if (w[0] == "aux") return rig_.aux_high(w.at(1)[0]) ? "high" : "low";
    if (w[0] == "line") return rig_.line_low(std::stoi(w.at(1))) ? "low" : "high";
    if (w[0] == "interrupt") return yes(rig_.bus().interrupt().has_value());
    if (w[0] == "status") return yes((rig_.status() & status_bit_named(w.at(1))) != 0);
    if (w[0] == "done" || w[0] == "limit" || w[0] == "home" || w[0] == "slip")
      return letters_of(rig_.read8(place_named(w[0], form_)));
    return {};
  }

  double number_of(const Words& w) {
    if (w[0] == "took") return took_;
    if (w[0] == "overshoot") return watched_.overshoot();
    if (w[0] == "crossings") return watched_.crossings();
    if (w[0] == "error_watched") return static_cast<double>(watched_.worst_error);
    if (w[0] == "waiting") return rig_.waiting();
    if (w[0] == "interrupt_vector") return rig_.bus().interrupt().value_or(0);
    if (w[0] == "register") return rig_.read8(place_named(w.at(1), form_));
    if (w[0] == "read16") return rig_.read16(place_named(w.at(1), form_));
    if (w[0] == "read32") return rig_.read32(place_named(w.at(1), form_));
    return static_cast<double>(number_of_axis(w[0], w.at(1)));
  }

  double number_of_axis(const std::string& what, const std::string& letters) {
    const char axis = letters[0];
    const auto both = [&](std::int64_t (Rig::*see)(char)) {
      return std::hypot(static_cast<double>((rig_.*see)(axis)),
                        static_cast<double>((rig_.*see)(letters.at(1))));
    };
    if (what == "distance") return both(&Rig::position);
    if (what == "speed") return both(&Rig::velocity);
    if (what == "position") return static_cast<double>(rig_.position(axis));
    if (what == "velocity") return static_cast<double>(rig_.velocity(axis));
    if (what == "room") return rig_.room(axis);
    if (what == "load") return static_cast<double>(rig_.view().load_position[axis_letters.find(axis)].value);
    if (what == "encoder") return static_cast<double>(encoder(axis));
    return rig_.axis_value(axis, value_named(what));
  }

  std::int64_t encoder(char axis) { return std::stoll(rig_.value(std::string("A") + axis + " RE")); }

  void compare(double seen, const Words& w, double tolerance) {
    const double number = wanted_number(w.back());
    const std::string& how = w[w.size() - 2];
    if (how == ">")
      EXPECT_GT(seen, number);
    else if (how == "<")
      EXPECT_LT(seen, number);
    else if (how == "multiple")
      EXPECT_EQ(std::fmod(seen, number), 0) << seen;
    else
      EXPECT_NEAR(seen, number, tolerance);
  }

  /// A number, or "plain", "plain+0.05", "2*x" of what was kept.
  double wanted_number(std::string text) {
    if (text.substr(0, 2) == "0x") return static_cast<double>(std::stoul(text, nullptr, 16));
    const auto name = std::find_if(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c); });
    if (name == text.end()) return std::stod(text);
    const double factor = name == text.begin() ? 1 : std::stod(text);
    text.erase(text.begin(), name);
    const auto sign = text.find_first_of("+-");
    const auto kept = remembered_.find(text.substr(0, sign));
    if (kept == remembered_.end()) {
      ADD_FAILURE() << "nothing was kept as " << text;
      return 0;
    }
    return factor * kept->second + (sign == text.npos ? 0 : std::stod(text.substr(sign)));
  }

  const Form& form_;
  Rig rig_;
  std::map<std::string, double> remembered_;
  Watched watched_;
  double took_ = 0;
};

void run_board_case(const BoardCase& written, const Form& form) {
  BoardSession session(form);
  for (const auto& [number, text] : written.lines) {
    SCOPED_TRACE("vme58.forms:" + std::to_string(number) + ": " + text);
    session.line(text);
  }
}

[[maybe_unused]] const bool board_cases_registered = [] {
  for (const BoardCase& written : read_board_cases(board_forms))
    register_form(
        written.id, [written](const Form& form) { run_board_case(written, form); }, board_forms.c_str(),
        written.number);
  return true;
}();

}  // namespace
}  // namespace hw::vme58::proof
