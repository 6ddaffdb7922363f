#include "tests/core/devices/vme58/form_case.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace hw::vme58::proof {
namespace {

std::vector<std::string> columns_of(const std::string& line) {
  std::vector<std::string> columns;
  std::istringstream in(line);
  for (std::string c; std::getline(in, c, '\t');) columns.push_back(c);
  columns.resize(12);
  return columns;
}

std::vector<Form> read_rows() {
  std::vector<Form> rows;
  std::ifstream file(HW_TEST_DIR "/core/devices/vme58/vme58.tsv");
  std::string line;
  std::getline(file, line);  // headings
  while (std::getline(file, line)) {
    auto c = columns_of(line);
    rows.push_back({c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]});
  }
  return rows;
}

std::map<std::string, FormBody, std::less<>>& all_cases() {
  static std::map<std::string, FormBody, std::less<>> all;
  return all;
}

/// Text that brings the board into a mode of the table.
struct Mode {
  std::string_view name, text;
};
constexpr Mode table_modes[] = {
    {"AX mode", "AX "}, {"AA/AM mode", "AA "}, {"AA/AM mode", "AM "}, {"contour", "AA CD0,0; "}};

bool is_one_of(std::string_view what, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), what) != list.end();
}

/// What has to stand before the end of a loop.
std::string opener(const Form& f) {
  const std::string l = f.letters();
  return l == "LE" ? "LS2 " : l == "WD" ? "WS0 " : l == "WG" ? "WH " : "";
}

int numbers_in(std::string_view text) {
  int count = 0;
  bool inside = false;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    count += digit && !inside;
    inside = digit || (inside && c == '.');
  }
  return count;
}

bool taken(const Form& f, const Mode& mode) {
  if (f.letters() == "WA" && mode.text == "AM ") return false;  // decision M94
  // The form with a list has a row of its own.
  const auto& rows = form_table();
  const bool has_list =
      std::any_of(rows.begin(), rows.end(), [&](const Form& o) { return o.id == f.id + ".list"; });
  if (has_list && mode.name == "AA/AM mode") return true;
  return f.taken_in(mode.name);
}

/// Refused where the table does not list the mode. Commands that stop or answer are taken inside a contour
/// too.
void check_modes(const Form& f) {
  for (const Mode& mode : table_modes) {
    if (is_one_of(f.letters(), {"II", "MT", "AN", "AF", "RQ"})) continue;  // M55; two meanings: their bodies
    if (mode.name == "contour" && !f.taken_in("contour") && (f.is("immediate") || f.is("query"))) continue;
    Rig rig;
    // The wait keeps what goes into a queue there, so that nothing is done yet.
    const std::string queue = mode.text == "AX " ? "AX WT1000 " : "AA WT1000 AM WT1000 ";
    rig.send(queue + std::string(mode.text) + opener(f));
    rig.status();
    rig.send(f.example + "\r");
    EXPECT_EQ(rig.command_error(), !taken(f, mode)) << f.example << " in " << mode.text;
  }
}

void check_room(const Form& f) {
  if (is_one_of(f.letters(), {"ST", "SA", "SD", "KL", "FL", "FP"})) return;  // empty it: their bodies
  const bool single = f.taken_in("AX mode");
  if (!single && !f.taken_in("AA/AM mode")) return;
  Rig rig;
  const std::string mode = single ? "AX " : "AA ";
  rig.send(mode + "WT1000 " + opener(f));
  const int before = std::atoi(rig.value("RQ").c_str());
  rig.send(f.example + "\r");
  // AC, VL and VB wait in the queue although they only set something (decision M17).
  const bool queued = f.is("stored") || is_one_of(f.letters(), {"AC", "VL", "VB"});
  const int needed = queued ? 1 + numbers_in(f.example) : 0;
  EXPECT_EQ(before - std::atoi(rig.value(mode + "RQ").c_str()), needed)
      << f.example << ": entries of the queue";
}

void check_answer(const Form& f) {
  for (const Mode& mode : table_modes) {
    if (!taken(f, mode)) continue;
    Rig rig;
    rig.send(mode.text);
    const std::string reply = rig.ask(f.example);
    ASSERT_GE(reply.size(), 5u) << f.example << " in " << mode.text;
    EXPECT_EQ(reply.substr(0, 2), "\n\r");
    EXPECT_EQ(reply.back(), '\r');
  }
}

void check_silence(const Form& f) {
  Rig rig;
  for (const Mode& mode : table_modes) {
    if (!taken(f, mode)) continue;
    rig.send(mode.text);
    EXPECT_EQ(visible(rig.ask(f.example + "\r")), "") << f.example << " in " << mode.text;
    rig.send("AX ");
  }
}

void check_table(const Form& f) {
  if (is_one_of(f.kind, {"dpram", "register"}) || f.letters() == "RS" || f.id == "vme58.mailbox") return;
  if (f.letters() == "WQ") return;  // takes nothing in any more: its body
  check_modes(f);
  if (f.letters() == "EN") return;  // its echo is in all that follows
  if (!f.is("query")) check_room(f);
  if (f.is("query"))
    check_answer(f);
  else
    check_silence(f);
}

class FormCaseTest : public ::testing::Test {
 public:
  FormCaseTest(std::string id, FormBody body) : id_(std::move(id)), body_(std::move(body)) {}
  void TestBody() override {
    const auto& table = form_table();
    const auto row = std::find_if(table.begin(), table.end(), [&](const Form& f) { return f.id == id_; });
    ASSERT_NE(row, table.end()) << "no row " << id_;
    SCOPED_TRACE(row->form + ", example " + row->example + " (" + row->manual + ")");
    check_table(*row);
    body_(*row);
  }

 private:
  std::string id_;
  FormBody body_;
};

}  // namespace

std::string Form::arg(std::string_view name) const {
  std::istringstream in(args);
  for (std::string part; std::getline(in, part, ';');)
    if (part.size() > name.size() && part.compare(0, name.size(), name) == 0 && part[name.size()] == ':')
      return part.substr(name.size() + 1);
  return {};
}

const std::vector<Form>& form_table() {
  static const std::vector<Form> table = read_rows();
  return table;
}

bool register_form(const std::string& id, FormBody body, const char* file, int line) {
  std::string name = id;
  std::replace(name.begin(), name.end(), '.', '_');
  EXPECT_TRUE(all_cases().emplace(id, body).second) << id << " has two cases";
  ::testing::RegisterTest("Vme58Form", name.c_str(), nullptr, nullptr, file, line,
                          [id, body]() -> ::testing::Test* { return new FormCaseTest(id, body); });
  return true;
}

bool has_case(std::string_view id) { return all_cases().find(id) != all_cases().end(); }

std::vector<std::string> cases_without_row() {
  std::vector<std::string> found;
  for (const auto& [id, body] : all_cases())
    if (std::none_of(form_table().begin(), form_table().end(),
                     [&id = id](const Form& f) { return f.id == id; }))
      found.push_back(id);
  return found;
}

}  // namespace hw::vme58::proof
