// The programs in tests/language: each says in comments that begin with `;#` what is to be expected of it.
//   for MODEL...             which languages it is written in
//   lines N                  low-level lines
//   error LINE:COL WORDS     a problem that is said there, with these words in its sentence; warning
//   likewise.
//                            All problems of a program have to be listed.
//   start N...               programs to start (otherwise 0)
//   at MS NAME=VALUE...      values that change from outside; error0=1: axis 0 is in error
//   after MS WHAT...         NAME=VALUE or NAME=LOW..HIGH (V1, PX, DO, state0: 0 stopped, 1 runs, 2 paused,
//                            4 error; line0: text line), did:ACTION, count:ACTION=N, least:ACTION=N (blanks
//                            as _)
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/devices/arcus/language/decompiler.h"
#include "core/devices/arcus/language/listing.h"
#include "fake_controller.h"

namespace hw::arcus::language {
namespace {

namespace fs = std::filesystem;

struct Step {
  std::int64_t at_ms = 0;
  bool change = false;
  std::vector<std::string> words;
};
struct ProgramFile {
  fs::path path;
  std::string text;
  std::vector<std::string> models;
  std::vector<std::string> problems;  ///< "error 3:5 words"
  std::vector<int> start;
  std::vector<Step> steps;
  int lines = -1;
};

std::vector<std::string> words_of(std::istream& in) {
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

ProgramFile read_program(const fs::path& path) {
  ProgramFile file;
  file.path = path;
  std::ifstream in(path);
  std::stringstream whole;
  whole << in.rdbuf();
  file.text = whole.str();
  for (std::string line; std::getline(whole, line);) {
    if (!line.starts_with(";#")) continue;
    std::istringstream rest(line.substr(2));
    std::string what;
    rest >> what;
    if (what == "for") file.models = words_of(rest);
    if (what == "lines") rest >> file.lines;
    if (what == "error" || what == "warning") {
      std::string words;
      std::getline(rest, words);
      file.problems.push_back(what + words);
    }
    if (what == "start")
      for (const std::string& n : words_of(rest)) file.start.push_back(std::stoi(n));
    if (what == "at" || what == "after") {
      Step& step = file.steps.emplace_back();
      rest >> step.at_ms;
      step.change = what == "at";
      step.words = words_of(rest);
    }
  }
  if (file.start.empty()) file.start.push_back(0);
  return file;
}

std::vector<ProgramFile> programs_in(const char* folder) {
  std::vector<ProgramFile> files;
  for (const auto& entry : fs::directory_iterator(fs::path(HW_TEST_DIR) / "language" / folder))
    if (entry.path().extension() == ".prg") files.push_back(read_program(entry.path()));
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

const Dialect& dialect_of(const std::string& model) {
  return model == "pmx-4ex-sa" ? pmx_4ex_sa() : dmx_k_sa();
}

void expect_problems(const ProgramFile& file, const Compilation& compiled) {
  std::vector<std::string> sentence;
  for (const Problem& p : compiled.problems)
    sentence.push_back(std::string(p.error ? "error " : "warning ") + std::to_string(p.line + 1) + ":" +
                       std::to_string(p.column + 1) + " " + p.sentence);
  for (std::size_t i = 0; i < std::max(sentence.size(), file.problems.size()); ++i) {
    const std::string got = i < sentence.size() ? sentence[i] : "nothing";
    const std::string wanted = i < file.problems.size() ? file.problems[i] : "nothing";
    std::istringstream parts(wanted);
    std::string kind, place, words;
    parts >> kind >> place;
    std::getline(parts >> std::ws, words);
    EXPECT_TRUE(got.starts_with(kind + " " + place) && got.find(words) != std::string::npos)
        << "said:   " << got << "\nwanted: " << wanted;
  }
}

int value_of(const Workbench& bench, const std::string& name) {
  if (name.starts_with("state")) return static_cast<int>(bench.vm.state(name.back() - '0'));
  if (name.starts_with("line")) return bench.source_line(name.back() - '0');
  if (name[0] == 'V') return bench.vm.variable(std::stoi(name.substr(1)));
  return bench.host.get(name);
}

void expect_word(const Workbench& bench, std::string word) {
  const auto colon = word.find(':'), equals = word.find('=');
  if (colon != std::string::npos) {
    const std::string how = word.substr(0, colon);
    const int wanted = how == "did" ? 1 : std::stoi(word.substr(equals + 1));
    std::string action = word.substr(colon + 1, equals == std::string::npos ? equals : equals - colon - 1);
    std::replace(action.begin(), action.end(), '_', ' ');
    const auto count = std::count(bench.host.done.begin(), bench.host.done.end(), action);
    if (how == "count")
      EXPECT_EQ(count, wanted) << word;
    else
      EXPECT_GE(count, wanted) << word << " but is " << count;
    return;
  }
  const int value = value_of(bench, word.substr(0, equals));
  const std::string wanted = word.substr(equals + 1);
  const auto dots = wanted.find("..");
  const int low = std::stoi(wanted),
            high = dots == std::string::npos ? low : std::stoi(wanted.substr(dots + 2));
  EXPECT_TRUE(value >= low && value <= high) << word << " but is " << value;
}

void take_step(Workbench& bench, const Step& step) {
  bench.run_for(Instant(std::chrono::milliseconds(step.at_ms)) - bench.now);
  SCOPED_TRACE("after " + std::to_string(step.at_ms) + " ms");
  for (const std::string& word : step.words) {
    const auto equals = word.find('=');
    if (!step.change)
      expect_word(bench, word);
    else if (word.starts_with("error"))
      bench.host.error[static_cast<std::size_t>(word[5] - '0')] = word.back() == '1';
    else
      bench.host.set(word.substr(0, equals), std::stoi(word.substr(equals + 1)));
  }
}

void run(const ProgramFile& file, const Dialect& dialect) {
  Workbench bench(dialect);
  bench.load(file.text);
  if (file.lines >= 0) {
    EXPECT_EQ(bench.compiled.lines.size(), static_cast<std::size_t>(file.lines));
  }
  for (const int program : file.start) bench.start(program);
  for (const Step& step : file.steps) take_step(bench, step);
}

void expect_round_trips(const Compilation& compiled, const Dialect& dialect) {
  for (const std::string& line : compiled.lines) {
    EXPECT_LE(line.size(), static_cast<std::size_t>(max_line_length)) << line;
    EXPECT_NE(line.front(), '=') << line;
    EXPECT_EQ(line.find(' '), std::string::npos) << line;
  }
  const Program loaded = decode(compiled.lines, dialect);
  EXPECT_TRUE(loaded.bad_lines.empty());
  EXPECT_EQ(loaded.code, compiled.program.code);
  EXPECT_EQ(encode(loaded, dialect), compiled.lines);

  const std::string listing = write_listing(compiled.lines, dialect);
  const Compilation from_listing = compile(listing, dialect);
  EXPECT_TRUE(from_listing.ok());
  EXPECT_EQ(write_listing(from_listing.lines, dialect), listing);

  const Decompiled shown = decompile(compiled.lines, dialect);
  const Compilation again = compile(shown.text, dialect);
  EXPECT_TRUE(again.ok()) << shown.text;
  EXPECT_EQ(again.lines, compiled.lines);
  EXPECT_EQ(again.source_line, shown.source_line);
  EXPECT_EQ(decompile(again.lines, dialect).text, shown.text);
}

TEST(ProgramFiles, GoodOnesDoWhatTheyState) {
  const auto files = programs_in("good");
  ASSERT_GE(files.size(), 16U);
  for (const ProgramFile& file : files)
    for (const std::string& model : file.models) {
      SCOPED_TRACE(file.path.filename().string() + " for " + model);
      const Compilation compiled = compile(file.text, dialect_of(model));
      expect_problems(file, compiled);
      expect_round_trips(compiled, dialect_of(model));
      run(file, dialect_of(model));
    }
}

TEST(ProgramFiles, BadOnesAreExplainedLineByLine) {
  const auto files = programs_in("bad");
  ASSERT_GE(files.size(), 5U);
  for (const ProgramFile& file : files)
    for (const std::string& model : file.models) {
      SCOPED_TRACE(file.path.filename().string() + " for " + model);
      const Compilation compiled = compile(file.text, dialect_of(model));
      EXPECT_FALSE(compiled.ok());
      expect_problems(file, compiled);
    }
}

TEST(ProgramFiles, AtTheLimits) {
  const auto files = programs_in("limit");
  ASSERT_GE(files.size(), 5U);
  for (const ProgramFile& file : files)
    for (const std::string& model : file.models) {
      SCOPED_TRACE(file.path.filename().string() + " for " + model);
      const Compilation compiled = compile(file.text, dialect_of(model));
      expect_problems(file, compiled);
      if (!compiled.ok()) continue;
      expect_round_trips(compiled, dialect_of(model));
      run(file, dialect_of(model));
    }
}

/// The small examples of the language references: pieces of programs, so some lack their END.
TEST(ProgramFiles, PiecesOfTheLanguageReferencesCompile) {
  for (const Dialect* dialect : {&pmx_4ex_sa(), &dmx_k_sa()}) {
    std::ifstream in(fs::path(HW_TEST_DIR) / "language" / "reference" /
                     (std::string(dialect->model) + ".txt"));
    std::string name, text;
    int pieces = 0;
    const auto check = [&] {
      if (name.empty()) return;
      ++pieces;
      SCOPED_TRACE(std::string(dialect->model) + " " + name);
      const bool ended = text.find("\nEND\n") != std::string::npos;
      const Compilation compiled = compile(ended ? text : text + "END\n", *dialect);
      for (const Problem& p : compiled.problems) EXPECT_FALSE(p.error) << p.line + 1 << ": " << p.sentence;
      expect_round_trips(compiled, *dialect);
    };
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with('[')) {
        text += line + "\n";
        continue;
      }
      check();
      name = line, text.clear();
    }
    check();
    EXPECT_GE(pieces, dialect == &pmx_4ex_sa() ? 60 : 45);
  }
}

}  // namespace
}  // namespace hw::arcus::language
