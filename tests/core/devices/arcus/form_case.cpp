#include "tests/core/devices/arcus/form_case.h"

#include <fstream>
#include <set>
#include <sstream>

#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus::proof {
namespace {

std::string folder() { return HW_TEST_DIR "/core/devices/arcus/"; }
std::string model_name(Which which) { return which == Which::pmx ? "pmx-4ex-sa" : "dmx-k-sa"; }

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

int axis_of(const std::string& letter) {
  const auto at = std::string_view("XYZU").find(letter);
  return at == std::string_view::npos ? 0 : static_cast<int>(at);
}

Duration duration_of(const std::string& text) {
  std::size_t used = 0;
  const double n = std::stod(text, &used);
  const std::string unit = text.substr(used);
  return from_seconds(unit == "s" ? n : unit == "ms" ? n / 1e3 : n / 1e6);
}

bool near(const std::string& got, const std::string& wanted, double tolerance) {
  const auto a = split(got, ':'), b = split(wanted, ':');
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].empty() || a[i].find_first_not_of("-0123456789.") != std::string::npos) return false;
    if (std::abs(std::stod(a[i]) - std::stod(b[i])) > tolerance) return false;
  }
  return true;
}

AxisPlace place_of(const std::vector<std::string>& words) {
  AxisPlace place;
  for (const std::string& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos) continue;
    const std::string key = word.substr(0, equals), value = word.substr(equals + 1);
    if (key == "minus") place.minus = Steps(std::stoll(value));
    if (key == "plus") place.plus = Steps(std::stoll(value));
    if (key == "index") place.index_every = Steps(std::stoll(value));
    if (key == "counts") place.counts_per_step = std::stod(value);
    if (key == "backlash") place.backlash = Steps(std::stoll(value));
    if (key == "home") {
      place.home_from = Steps(std::stoll(value));
      place.home_to = Steps(std::stoll(value.substr(value.find("..") + 2)));
    }
  }
  return place;
}

class Running {
 public:
  explicit Running(Which which) : which_(which), rig_(which) {}

  void line(const std::string& text) {
    if (text[0] == '~') return pass(trimmed(text.substr(1)));
    if (text[0] == '!') return hand(split(trimmed(text.substr(1)), ' '));
    if (text.substr(0, 2) == "? ") return look(split(trimmed(text.substr(1)), ' '));
    if (text.substr(0, 9) == "* program") return load(trimmed(text.substr(9)));
    if (text[0] == '*') return refusals(split(trimmed(text.substr(1)), ' '));
    const auto bar = text.rfind(" |");
    if (bar == std::string::npos) return fail("no reply stands behind a bar: " + text);
    exchange(trimmed(text.substr(0, bar)), trimmed(text.substr(bar + 2)));
  }

  std::set<std::string> sent, errors;
  int effects = 0;

 private:
  static void fail(const std::string& why) { ADD_FAILURE() << why; }

  void exchange(const std::string& command, const std::string& wanted) {
    const std::string got = rig_.ask(command);
    const auto tolerance = wanted.find(" +- ");
    if (tolerance == std::string::npos)
      EXPECT_EQ(got, wanted) << "to " << command;
    else
      EXPECT_TRUE(near(got, wanted.substr(0, tolerance), std::stod(wanted.substr(tolerance + 4))))
          << command << " gave " << got << ", not " << wanted;
    note(command, got);
  }

  void note(const std::string& command, const std::string& reply) {
    sent.insert(command);
    if (reply == "?" + command)
      errors.insert("?[Command]");
    else if (!reply.empty() && reply[0] == '?')
      errors.insert(reply);
    else if (reply != "OK")
      ++effects;
  }

  void pass(const std::string& what) {
    if (what.substr(0, 4) == "rest")
      rig_.run_to_rest(what.size() > 5 ? axis_of(what.substr(5)) : 0);
    else
      rig_.run_for(duration_of(what));
  }

  void hand(const std::vector<std::string>& w) {
    const bool on = !w.empty() && w.back() == "on";
    const auto number = [&](std::size_t i) { return std::stoi(w.at(i)); };
    if (w.at(0) == "input") return rig_.input(number(1), on);
    if (w.at(0) == "limit") return rig_.limit(axis_of(w.at(1)), w.at(2)[0], on);
    if (w.at(0) == "home") return rig_.home_switch(axis_of(w.at(1)), on);
    if (w.at(0) == "alarm") return rig_.alarm(axis_of(w.at(1)), on);
    if (w.at(0) == "jam") return rig_.jam(axis_of(w.at(1)), on);
    if (w.at(0) == "slip") return rig_.slip(axis_of(w.at(1)), std::stoll(w.at(2)));
    if (w.at(0) == "analog") return rig_.analog(number(1), number(2));
    if (w.at(0) == "place") return rig_.place(axis_of(w.at(1)), place_of(w));
    if (w.at(0) != "power") return fail("no such hand: " + w.at(0));
    rig_.power_cycle();
    if (w.size() > 2) rig_.set_address(w[2]);  // it comes back with another number
  }

  void look(const std::vector<std::string>& w) {
    ++effects;
    if (w.at(0) == "out")
      EXPECT_EQ(rig_.out(std::stoi(w.at(1))), w.at(2) == "on") << "output " << w.at(1);
    else if (w.at(0) == "load")
      EXPECT_EQ(rig_.load(axis_of(w.at(1))), std::stoll(w.at(2)));
    else if (w.at(0) == "raw")
      EXPECT_EQ(rig_.output(), w.size() > 1 ? w.at(1) + "\r" : "") << "unasked";
    else if (w.at(0) == "rate")
      EXPECT_EQ(rig_.emulator().rate(), std::stoi(w.at(1)));
    else
      EXPECT_EQ(static_cast<int>(rig_.emulator().pulses().size()), std::stoi(w.at(2)));
  }

  void load(const std::string& name) {
    std::ifstream file(HW_TEST_DIR "/language/good/" + name + ".prg");
    std::ostringstream text;
    text << file.rdbuf();
    const auto& dialect = which_ == Which::pmx ? language::pmx_4ex_sa() : language::dmx_k_sa();
    const language::Compilation made = language::compile(text.str(), dialect);
    if (!made.ok() || made.lines.empty()) return fail(name + " does not compile");
    for (std::size_t n = 0; n < made.lines.size(); ++n)
      rig_.ok("SA" + std::to_string(n) + "=" + made.lines[n]);
  }

  void expect_refusal(Rig& rig, const std::string& command, const std::string& wanted) {
    const std::string got = rig.ask(command);
    EXPECT_EQ(got, wanted) << "to " << command;
    note(command, got);
  }

  /// In a fresh controller each: limit, alarm, StepNLoop error, moving.
  void refusals(const std::vector<std::string>& w) {
    const std::string& command = w.at(1);
    const bool pmx = which_ == Which::pmx;
    const std::string axis = pmx ? w.at(2) : "";
    const int n = axis_of(axis);
    Rig limit(which_);
    limit.limit(n, '+', true);
    limit.ok("J" + axis + "+");
    expect_refusal(limit, command, pmx ? "?LIMIT" : "?State Error");
    if (pmx) {
      Rig alarm(which_);
      alarm.alarm(n, true);
      expect_refusal(alarm, command, "?ALARM");
    }
    Rig loop(which_);
    loop.ok("SL" + axis + "=1");
    loop.slip(n, 5000);
    expect_refusal(loop, command, pmx ? "?ERRORED" : "?State Error");
    Rig moving(which_);
    moving.ok("J" + axis + "-");
    expect_refusal(moving, command, pmx ? "?PULSING" : "?Moving");
  }

  Which which_;
  Rig rig_;
};

}  // namespace

std::vector<Form> form_table(Which which) {
  std::vector<Form> rows;
  std::ifstream file(folder() + model_name(which) + ".tsv");
  std::string line;
  std::getline(file, line);  // headings
  while (std::getline(file, line)) {
    auto f = split(line, '\t');
    f.resize(12);
    rows.push_back({f[0], f[2], f[3], f[7]});
  }
  return rows;
}

namespace {

std::vector<FormCase> read_cases(const std::string& name) {
  std::vector<FormCase> cases;
  std::ifstream file(folder() + name);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line = trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    if (line.front() == '[' && line.back() == ']')
      cases.push_back({line.substr(1, line.size() - 2), number, {}});
    else if (!cases.empty())
      cases.back().lines.emplace_back(number, line);
  }
  return cases;
}

void run_lines(Running& running, const std::string& file, const FormCase& body) {
  for (const auto& [number, text] : body.lines) {
    SCOPED_TRACE(file + ":" + std::to_string(number) + ": " + text);
    running.line(text);
  }
}

}  // namespace

std::vector<FormCase> form_cases(Which which) { return read_cases(model_name(which) + ".forms"); }
std::vector<FormCase> session_cases(Which which) { return read_cases(model_name(which) + ".sessions"); }

void run_session(Which which, const FormCase& body) {
  Running running(which);
  run_lines(running, model_name(which) + ".sessions", body);
}

void run_form_case(Which which, const Form& form, const FormCase& body) {
  Running running(which);
  run_lines(running, model_name(which) + ".forms", body);
  EXPECT_TRUE(running.sent.count(form.example) != 0) << "the example " << form.example << " was not sent";
  EXPECT_GT(running.effects, 0) << "no effect was looked at";
  for (const std::string& part : split(form.errors, ';')) {
    const std::string head = part.substr(0, part.find(": "));
    for (const std::string& error : split(head, ',')) {
      const std::string wanted = trimmed(error);
      if (!wanted.empty() && wanted[0] == '?') {
        EXPECT_TRUE(running.errors.count(wanted) != 0) << "the error " << wanted << " was not provoked";
      }
    }
  }
}

}  // namespace hw::arcus::proof
