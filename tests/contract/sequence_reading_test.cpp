// Programs as they are: those of the manuals and those of the house become steps that are the same program,
// or are refused with a sentence that names a line.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "core/device/language.h"
#include "core/device/registry.h"
#include "core/sequence/steps_in.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::HasSubstr;
using testing::StartsWith;

struct Example {
  std::string model, name, text;
};
void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

void add_folder(std::vector<Example>& all, const std::string& folder, std::string_view begin,
                std::string_view suffix, const std::string& model) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin) || !name.ends_with(suffix)) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    all.push_back({model, name, std::move(text).str()});
  }
}

std::vector<Example> examples() {
  std::vector<Example> all;
  const std::string tests = HW_TEST_DIR, house = HW_SOURCE_DIR "/assets/examples";
  add_folder(all, tests + "/language/good", "pmx_", ".prg", "pmx-4ex-sa");
  add_folder(all, tests + "/language/good", "dmx_", ".prg", "dmx-k-sa");
  add_folder(all, tests + "/core/devices/vxm/examples", "", ".vxm", "vxm");
  add_folder(all, house, "", ".vxm", "vxm");
  add_folder(all, house, "plate", ".prg", "pmx-4ex-sa");
  add_folder(all, house, "", ".vme", "vme58");
  // Data sheet, examples 1 to 3.
  all.push_back(
      {"vme58", "home_then_move", "AX\nVL1000 AC10000\nKP2 KD6 HN\nHM0\nVL5000 AC50000\nMA-10000 GO ID\n"});
  all.push_back({"vme58", "three_axes",
                 "AX KP2 KD6 HN\nAY KP2 KD6 HN\nAZ KP2 KD6 HN\nAM\nVL5000,5000,5000;\n"
                 "AC50000,50000,50000;\nMA1000,2000,3000; GO ID\n"});
  all.push_back({"vme58", "a_hole",
                 "AX AF \nAA\nAC,,10000,10000;\nCV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\n"
                 "CR0,0,6.2831853\nAF0;\nMT-10,10000\nCE\nMT,,-1000,0; GO\nCX\n"});
  std::sort(all.begin(), all.end(), [](const Example& a, const Example& b) { return a.name < b.name; });
  return all;
}

class SequenceReadingTest : public testing::TestWithParam<Example> {
 protected:
  SequenceReadingTest()
      : type(*find_device_type(GetParam().model)),
        catalog(
            *type.make_catalog(GetParam().model == "vxm" ? DeviceOptions{{"motors", "4"}} : DeviceOptions())),
        language(type.language()) {
    frame.unit = catalog.step_word;
    for (const AxisInfo& axis : catalog.axes) frame.axes.push_back({axis.name});
  }
  /// A minute of it.
  Rehearsal rehearsed(const std::string& text) {
    RehearseOptions options;
    options.for_seconds = 60;
    options.axes = static_cast<int>(catalog.axes.size());
    auto done = language.rehearse(text, options);
    EXPECT_TRUE(done) << done.error().sentence() << "\n" << text;
    return done ? std::move(*done) : Rehearsal();
  }

  const DeviceType& type;
  const Catalog catalog;
  const Language& language;
  seq::Sequence frame;
};
INSTANTIATE_TEST_SUITE_P(Of, SequenceReadingTest, testing::ValuesIn(examples()), [](const auto& info) {
  std::string name = info.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST_P(SequenceReadingTest, IsTheSameProgramAsBlocksOrRefusedByLine) {
  const std::string& text = GetParam().text;
  const auto read = language.read(text, frame, catalog);
  if (!read) {
    EXPECT_THAT(read.error().what, StartsWith("Line "));
    RecordProperty("refused", read.error().what);
    return;
  }
  RecordProperty("blocks", seq::count_steps(read->sequence.steps));
  const auto written = language.write(read->sequence, catalog);
  ASSERT_TRUE(written) << written.error().sentence();
  const ProgramReport report = language.analyse(written->text, 0);
  for (const Problem& p : report.problems) EXPECT_FALSE(p.error) << p.sentence << "\n" << written->text;
  const Rehearsal was = rehearsed(text), is = rehearsed(written->text);
  EXPECT_EQ(is.finished, was.finished) << is.error;
  EXPECT_EQ(is.outputs, was.outputs);
  EXPECT_EQ(is.sent_to_host, was.sent_to_host);
  ASSERT_EQ(is.axes.size(), was.axes.size());
  if (was.finished) {
    EXPECT_NEAR(is.duration_s, was.duration_s, 0.02 + 0.001 * was.duration_s) << written->text;
  }
  for (std::size_t a = 0; a < was.axes.size(); ++a) {
    EXPECT_EQ(is.axes[a].minimum, was.axes[a].minimum) << written->text;
    EXPECT_EQ(is.axes[a].maximum, was.axes[a].maximum) << written->text;
    if (!was.finished)
      continue;  // one more command in an endless loop, and it stands elsewhere after a minute
    EXPECT_EQ(is.axes[a].position, was.axes[a].position) << written->text;
    EXPECT_EQ(is.axes[a].travel, was.axes[a].travel) << written->text;
  }
}

/// Whatever is typed: a text with a line less is read or refused, and what is read can be written.
TEST_P(SequenceReadingTest, WithoutOneLineItIsStillReadOrRefused) {
  const std::string& text = GetParam().text;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string less = text.substr(0, begin) + text.substr(end);
    begin = end;
    const auto read = language.read(less, frame, catalog);
    if (!read) {
      EXPECT_FALSE(read.error().what.empty());
      continue;
    }
    const auto written = language.write(read->sequence, catalog);
    ASSERT_TRUE(written) << written.error().sentence() << "\n" << less;
    EXPECT_FALSE(language.analyse(written->text, 0).has_errors()) << less << "becomes\n" << written->text;
  }
}

}  // namespace
}  // namespace hw
