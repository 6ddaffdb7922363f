// What several forms have in common, named in vxm.forms behind a "*". Each makes controllers of its own, but
// for kept, dropped and forget-output, which go on with the one of the case.
#include <map>
#include <sstream>

#include "tests/core/devices/vxm/form_case.h"
#include "tests/core/devices/vxm/form_session.h"

namespace hw::vxm::proof {
namespace {

using Words = std::vector<std::string>;

// kept QUERY COMMAND...
void keep(Rig& rig, const Form&, const Words& w) { expect_kept(rig, w.at(0), {w.begin() + 1, w.end()}); }

// dropped COMMAND...
void drop(Rig& rig, const Form&, const Words& w) {
  for (const std::string& command : w) expect_dropped(rig, command);
}

void forget_output(Rig& rig, const Form&, const Words&) { rig.output(); }

// setting QUERY BEFORE AFTER
void change_setting(Rig&, const Form& form, const Words& w) {
  expect_setting(form, w.at(0), w.at(1), w.at(2));
}

// get FALLBACK SET AFTER: the factory value, then what was set, in every on-line mode with its <cr> (V22).
void get(Rig&, const Form& form, const Words& w) {
  Rig rig = rig_for(form);
  EXPECT_EQ(visible(rig.ask(form.example)), w.at(0) + "<cr>");
  rig.send(w.at(1) + ",");
  EXPECT_EQ(visible(rig.ask(form.example)), w.at(2) + "<cr>");
  rig.send("G");
  EXPECT_EQ(visible(rig.ask(form.example)), w.at(2) + "<cr>") << "G mode";
  rig.send("E");
  rig.output();
  EXPECT_EQ(visible(rig.ask(form.example)), form.example + w.at(2) + "<cr>") << "echo";
}

// get-each HEAD TAIL SET FALLBACK: of all four motors.
void get_of_each_motor(Rig&, const Form&, const Words& w) {
  Rig rig = Rig::online_with_slave();
  for (const char motor : {'1', '2', '3', '4'}) {
    const std::string name = w.at(0) + motor + w.at(1);
    EXPECT_EQ(visible(rig.ask("get" + name)), w.at(3) + "<cr>") << name;
    rig.send("set" + name + w.at(2) + ",");
    EXPECT_EQ(visible(rig.ask("get" + name)), w.at(2) + "<cr>") << name;
  }
}

void bus_error(Rig&, const Form& form, const Words&) { expect_bus_error(form); }

// slave-output ON OFF NUMBER
void switch_slave_output(Rig&, const Form& form, const Words& w) {
  const int number = std::stoi(w.at(2));
  Rig rig = Rig::online_with_slave();
  rig.run(w.at(0) + ",");
  EXPECT_TRUE(rig.out(number));
  EXPECT_EQ(rig.view().outputs, 1u << (number - 1)) << "none of the Master's";
  rig.run(w.at(1) + ",");
  EXPECT_FALSE(rig.out(number));
  expect_bus_error(form);
}

// output ON OFF NUMBER
void switch_output(Rig&, const Form&, const Words& w) {
  const std::string &on = w.at(0), &off = w.at(1);
  const int number = std::stoi(w.at(2));
  Rig rig = Rig::online();
  rig.run(on + ",");
  EXPECT_TRUE(rig.out(number));
  EXPECT_EQ(rig.ask("$"), std::string(1, static_cast<char>(1 << (number - 1))));
  rig.run(off + ",");
  EXPECT_FALSE(rig.out(number));
  rig.run(on + ",U5,");
  rig.run(off + ",");
  EXPECT_FALSE(rig.out(number));
}

// skip COMMAND INPUT low|high: at which level what follows is left out. The program adds 1 step when it is
// not, 10 behind it.
void skip(Rig&, const Form&, const Words& w) {
  const int input = std::stoi(w.at(1));
  for (const bool low : {false, true}) {
    Rig rig = Rig::online();
    rig.input(input, low);
    rig.run_for(10ms);
    rig.run(w.at(0) + ",I1M1,I1M10,");
    EXPECT_EQ(rig.position(1), low == (w.at(2) == "low") ? 10 : 11) << (low ? "low" : "high");
  }
}

// counts HEAD REFUSED...
void expect_counts(Rig&, const Form&, const Words& w) {
  Rig rig = Rig::online();
  rig.send(w.at(0) + "2,");
  EXPECT_EQ(rig.used_bytes(), 3);
  rig.send(w[0] + "65535,");
  EXPECT_EQ(rig.used_bytes(), 6);
  for (std::size_t i = 1; i < w.size(); ++i) expect_dropped(rig, w[0] + bytes_of(w[i]));
}

// range HEAD LOWEST HIGHEST BYTES BEYOND...: the highest and lowest value are stored; beyond them the command
// is dropped (V09), as without one (V10).
void expect_range(Rig&, const Form&, const Words& w) {
  const int bytes = std::stoi(w.at(3));
  Rig rig = Rig::online();
  rig.send(w.at(0) + w.at(1) + ",");
  EXPECT_EQ(rig.used_bytes(), bytes) << w[1];
  rig.send(w[0] + w.at(2) + ",");
  EXPECT_EQ(rig.used_bytes(), 2 * bytes) << w[2];
  for (std::size_t i = 4; i < w.size(); ++i) expect_dropped(rig, w[0] + bytes_of(w[i]));
}

// short AFTER SHORTCUT LISTED: a short form means the motor named last.
void expect_short(Rig&, const Form&, const Words& w) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("#"), "1\r");
  rig.send(w.at(0) + ",C");
  EXPECT_EQ(rig.ask("#"), "2\r");
  rig.send(w.at(1) + ",");
  const std::string list = rig.ask("lst");
  EXPECT_NE(list.find("\r" + w.at(2) + "\r"), std::string::npos) << visible(list);
}

void expect_refused(Rig&, const Form& form, const Words&) {
  Rig rig = Rig::online();
  rig.send("I1M400,");
  expect_dropped(rig, form.example);
  EXPECT_EQ(rig.ask("V"), "R") << "and the next command is read as ever";
  rig.send("I1M7,");
  EXPECT_EQ(rig.used_bytes(), 8);
}

// A single character is dropped at once: what follows is a command.
void expect_refused_character(Rig&, const Form& form, const Words&) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask(form.example + "V"), "R");
  rig.send(form.example + "I1M7,");
  EXPECT_EQ(rig.used_bytes(), 4);
}

using Rule = void (*)(Rig&, const Form&, const Words&);
const std::map<std::string, Rule, std::less<>> rules = {
    {"bus-error", bus_error},
    {"counts", expect_counts},
    {"dropped", drop},
    {"forget-output", forget_output},
    {"get", get},
    {"get-each", get_of_each_motor},
    {"kept", keep},
    {"output", switch_output},
    {"range", expect_range},
    {"refused", expect_refused},
    {"refused-character", expect_refused_character},
    {"setting", change_setting},
    {"short", expect_short},
    {"skip", skip},
    {"slave-output", switch_slave_output},
};

}  // namespace

bool follow_rule(const std::string& text, Rig& rig, const Form& form) {
  std::istringstream in(text);
  std::string name;
  in >> name;
  const auto rule = rules.find(name);
  if (rule == rules.end()) return false;
  Words words;
  for (std::string word; in >> word;) words.push_back(word == "''" ? "" : word);
  rule->second(rig, form, words);
  return true;
}

}  // namespace hw::vxm::proof
