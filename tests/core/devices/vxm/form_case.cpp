#include "tests/core/devices/vxm/form_case.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace hw::vxm::proof {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string f; std::getline(in, f, '\t');) fields.push_back(f);
  fields.resize(12);
  return fields;
}

std::vector<Form> read_table() {
  std::vector<Form> rows;
  std::ifstream file(HW_TEST_DIR "/core/devices/vxm/vxm.tsv");
  std::string line;
  std::getline(file, line);  // headings
  while (std::getline(file, line)) {
    auto f = fields_of(line);
    rows.push_back({f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10]});
  }
  return rows;
}

std::map<std::string, FormBody, std::less<>>& cases() {
  static std::map<std::string, FormBody, std::less<>> all;
  return all;
}

bool starts_with(std::string_view text, std::string_view head) { return text.substr(0, head.size()) == head; }

bool needs_slave(const Form& f) {
  return starts_with(f.id, "vxm.bus.") || starts_with(f.id, "vxm.pma.") || f.id == "vxm.status.pos3" ||
         f.id == "vxm.status.pos4";
}

// In local mode D is a command of its own (digitize): a form with a D in it says something there whatever
// becomes of its other letters.
bool speaks_locally_by_its_d(const Form& f) { return f.example.find('D') != std::string::npos; }

void check_stored(const Form& f) {
  Rig local = rig_for(f);
  local.send("Q");
  EXPECT_EQ(local.ask(f.example + ","), "") << "in local mode";
  local.send("F");
  EXPECT_EQ(local.used_bytes(), 0) << "stored in local mode";

  Rig online = rig_for(f);
  EXPECT_EQ(online.ask(f.example + ","), "") << "on-line";
  EXPECT_EQ(online.used_bytes(), f.bytes()) << "memory used";

  Rig running = rig_for(f);
  running.send("P20,R");
  EXPECT_EQ(running.ask(f.example + ","), "") << "while a program runs";
  EXPECT_TRUE(running.run_until_output("^", 3s));
  EXPECT_EQ(running.used_bytes(), 3) << "stored while a program runs";
}

// What lst shows can be typed again and gives the same program.
void check_listing_round_trip(const Form& f) {
  Rig rig = rig_for(f);
  rig.send(f.example + ",");
  const std::string listed = rig.ask("lst");
  const auto heading = listed.find('\r');
  ASSERT_NE(heading, std::string::npos) << visible(listed);
  EXPECT_EQ(listed.substr(0, heading), "PM0 M" + std::to_string(256 - f.bytes()));
  EXPECT_GT(listed.size(), heading + 1) << "no command listed";
  rig.send("C");
  rig.send(listed.substr(heading + 1));
  EXPECT_EQ(visible(rig.ask("lst")), visible(listed));
}

void check_echo(const Form& f) {
  Rig rig = rig_for(f);
  rig.send("E");
  EXPECT_EQ(visible(rig.ask(f.example + "\r")), visible(f.example + "\r")) << "echo";
}

void check_silent(const Form& f) {
  for (const char* state : {"local", "online", "running"}) {
    Rig rig = rig_for(f);
    if (state == std::string_view("local")) rig.send("Q");
    if (state == std::string_view("running")) rig.send("P20,R");
    const std::string got = rig.ask(f.example + ",");
    if (state != std::string_view("local") || !speaks_locally_by_its_d(f)) {
      EXPECT_EQ(visible(got), "") << state;
    }
    rig.run_for(3s);
    rig.send("F");
    EXPECT_EQ(rig.used_bytes(), state == std::string_view("running") ? 3 : 0) << state;
  }
}

void check_query(const Form& f) {
  Rig local = rig_for(f);
  local.send("Q");
  const std::string in_local = local.ask(f.example + ",");
  if (f.accepted_when("local")) {
    EXPECT_NE(in_local, "") << "in local mode";
  } else if (!speaks_locally_by_its_d(f)) {
    EXPECT_EQ(visible(in_local), "") << "in local mode";
  }

  Rig online = rig_for(f);
  EXPECT_EQ(online.ask(f.example + ",") != "", f.accepted_when("online")) << "on-line";
  EXPECT_EQ(online.used_bytes(), 0);

  // Z and T are answered while nothing turns (V13), which is so during a pause.
  const bool in_pause = f.accepted_when("running") || f.example == "Z" || f.example == "T";
  Rig running = rig_for(f);
  running.send("P20,R");
  EXPECT_EQ(running.ask(f.example + ",") != "", in_pause) << "while a program runs";
  EXPECT_TRUE(running.run_until_output("^", 3s));
}

void check_states(const Form& f) {
  if (f.is("stored")) {
    check_stored(f);
    check_listing_round_trip(f);
    check_echo(f);
  } else if (f.is("set") || f.is("refused")) {
    check_silent(f);
    check_echo(f);
  } else if (f.is("query")) {
    check_query(f);
  }
  // Each form of kind immediate or mode acts in its own way: its body goes through the states.
}

class FormTest : public ::testing::Test {
 public:
  FormTest(std::string id, FormBody body) : id_(std::move(id)), body_(std::move(body)) {}
  void TestBody() override {
    const auto& table = form_table();
    const auto row = std::find_if(table.begin(), table.end(), [&](const Form& f) { return f.id == id_; });
    ASSERT_NE(row, table.end()) << "no row " << id_;
    SCOPED_TRACE(row->form + ", example " + row->example + " (" + row->manual + ")");
    check_states(*row);
    body_(*row);
  }

 private:
  std::string id_;
  FormBody body_;
};

}  // namespace

bool Form::accepted_when(std::string_view state) const {
  return when == "any" || when.find(state) != std::string::npos;
}

int Form::bytes() const {
  const int own = memory.empty() ? 0 : std::atoi(memory.c_str());
  // A parenthesized pair takes two bytes beside its indexes (V101).
  const auto indexes = example[0] == '(' ? std::count(example.begin(), example.end(), 'I') : 0;
  return own + 4 * static_cast<int>(indexes);
}

const std::vector<Form>& form_table() {
  static const std::vector<Form> table = read_table();
  return table;
}

bool register_form(const std::string& id, FormBody body, const char* file, int line) {
  std::string name = id;
  std::replace(name.begin(), name.end(), '.', '_');
  EXPECT_TRUE(cases().emplace(id, body).second) << id << " has two cases";
  ::testing::RegisterTest("VxmForm", name.c_str(), nullptr, nullptr, file, line,
                          [id, body]() -> ::testing::Test* { return new FormTest(id, body); });
  return true;
}

bool has_case(std::string_view id) { return cases().find(id) != cases().end(); }

std::vector<std::string> cases_without_row() {
  std::vector<std::string> found;
  for (const auto& [id, body] : cases())
    if (std::none_of(form_table().begin(), form_table().end(),
                     [&id = id](const Form& f) { return f.id == id; }))
      found.push_back(id);
  return found;
}

Rig rig_for(const Form& form) {
  Rig rig = needs_slave(form) ? Rig::online_with_slave() : Rig::online();
  if (starts_with(form.id, "vxm.nf90.")) rig.send("setDM9,");
  return rig;
}

void expect_setting(const Form& form, const std::string& query, const std::string& before,
                    const std::string& after) {
  const std::string set = form.example + ",";
  Rig rig = rig_for(form);
  EXPECT_EQ(visible(rig.ask(query)), visible(before + "\r")) << "before";
  rig.send("Q");
  rig.send(set);
  rig.send("F");
  rig.output();
  EXPECT_EQ(visible(rig.ask(query)), visible(before + "\r")) << "sent in local mode";
  rig.send("P1,R" + set);
  rig.run_for(1s);
  rig.output();
  EXPECT_EQ(visible(rig.ask(query)), visible(before + "\r")) << "sent while a program ran";
  EXPECT_EQ(visible(rig.ask(set)), "");
  EXPECT_EQ(visible(rig.ask(query)), visible(after + "\r")) << "sent on-line";
}

void expect_kept(Rig& rig, const std::string& query, const std::vector<std::string>& commands) {
  const std::string before = rig.ask(query);
  for (const std::string& c : commands) {
    EXPECT_EQ(rig.ask(c + ","), "") << c;
    EXPECT_EQ(visible(rig.ask(query)), visible(before)) << c;
  }
}

void expect_bus_error(const Form& form) {
  Rig lone = Rig::online();
  EXPECT_EQ(lone.ask(form.example + ","), "");
  EXPECT_EQ(lone.used_bytes(), form.bytes());
  lone.send("R");
  lone.run_for(1s);
  EXPECT_EQ(lone.output(), "EB");
  EXPECT_EQ(lone.ask("V"), "J") << "it resets";
}

void expect_dropped(Rig& rig, const std::string& command) {
  const std::string before = rig.ask("lst");
  EXPECT_EQ(visible(rig.ask(command + ",")), "") << command;
  EXPECT_EQ(visible(rig.ask("lst")), visible(before)) << command;
}

}  // namespace hw::vxm::proof
