// hw_simulation: plays an operator against the real sessions, links and drivers, with a judge. Usage: below.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include <fmt/core.h>
#include <unistd.h>

#include "tests/simulation/draw.h"
#include "tests/simulation/lua_text.h"
#include "tests/simulation/random.h"
#include "tests/simulation/shrink.h"
#include "tests/simulation/stage.h"
#include "tests/simulation/steps.h"

namespace hw::simulation {
namespace {

constexpr const char* usage =
    "hw_simulation --model MODEL --seed N [--seeds COUNT] [--minutes M] [--bus] [--calm]\n"
    "              [--until-failure] [--no-shrink] [--but LAW] [--skip SEED] [--keep FOLDER]\n"
    "hw_simulation [--trace] [--but LAW] --replay FILE...     exit 1 when one of them breaks a law\n"
    "hw_simulation --print --model MODEL --seed N       the plan, without running it\n";

struct Options {
  std::string model = "vxm", keep, but;
  std::uint64_t seed = 1, seeds = 1;
  Drawing drawing;
  bool until_failure = false, shrinks = true, prints = false, traces = false;
  std::vector<std::string> replays;
  std::set<std::uint64_t> skipped;  ///< seeds that find what is known
};

struct Outcome {
  std::optional<Finding> finding;
  std::uint64_t fingerprint = 0;
};

/// A console that spins at one instant never comes back, and no law can tell: the plan that makes it do so is
/// printed.
class SpinWatch {
 public:
  explicit SpinWatch(const Plan& plan) {
    text() = "It spins: it has not come back after a minute of real time.\n" + plan.written();
    std::signal(SIGALRM, [](int) {
      [[maybe_unused]] const auto written = ::write(STDOUT_FILENO, text().data(), text().size());
      ::_exit(3);
    });
    ::alarm(60);
  }
  ~SpinWatch() { ::alarm(0); }
  SpinWatch(const SpinWatch&) = delete;
  SpinWatch& operator=(const SpinWatch&) = delete;

 private:
  static std::string& text() {
    static std::string of_this_plan;
    return of_this_plan;
  }
};

Outcome play(const Plan& plan, const std::string& but = {}, Trace* trace = nullptr) {
  const SpinWatch watch(plan);
  Stage stage(plan);
  stage.judge().trace_to(trace);
  stage.judge().leave_out(but);
  stage.run();
  return {stage.judge().finding(), stage.judge().fingerprint()};
}

struct Statistics {
  std::map<Verb::Kind, int> steps;
  std::map<std::string, int> findings;
  int sessions = 0;
  double simulated_s = 0;
  std::uint64_t bytes = 0;  ///< of all wires and their times: two builds that do the same print the same

  void count(const Plan& plan) {
    ++sessions;
    simulated_s += seconds(plan.length);
    for (const Step& step : plan.steps) ++steps[find_verb(step.verb)->kind];
  }
  void print(double wall_s) const {
    std::cout << fmt::format(
        "{} sessions, {:.0f} simulated seconds in {:.1f} s ({:.0f} times real time): {} actions, {} stops, "
        "{} hands on the bench, {} faults. All bytes: {:016x}.\n",
        sessions, simulated_s, wall_s, simulated_s / wall_s, of(Verb::Kind::action), of(Verb::Kind::stop),
        of(Verb::Kind::bench), of(Verb::Kind::fault), bytes);
    for (const auto& [law, count] : findings) std::cout << fmt::format("  {}: {}\n", law, count);
  }
  [[nodiscard]] int of(Verb::Kind kind) const {
    const auto found = steps.find(kind);
    return found == steps.end() ? 0 : found->second;
  }
};

// "3 to 4" of one run is "5 to 6" of the next: what is found is the law and its words without their numbers.
std::string kind_of(const Finding& finding) {
  std::string kind = finding.law + ": ";
  for (const char c : finding.sentence)
    if ((c < '0' || c > '9') && c != '-') kind += c;
  return kind;
}

void show(const Finding& finding) {
  std::cout << fmt::format("  {} at {:.3f} s: {}\n", finding.law, seconds(finding.at), finding.sentence);
}

void keep(const Plan& plan, const std::string& folder, std::uint64_t seed) {
  const std::string law = plan.finding.substr(0, plan.finding.find(':'));
  const std::string path = fmt::format("{}/{}-{}-{}.plan", folder, plan.model, law, seed);
  std::error_code cannot_be_made;  // then it cannot be written either
  std::filesystem::create_directories(folder, cannot_be_made);
  std::ofstream file(path);
  file << plan.written() << std::flush;
  std::cout << (file ? "  kept as " : "  not kept, it cannot be written: ") << path << "\n";
}

void examine(Plan plan, const Finding& finding, const Options& options, std::uint64_t seed) {
  const std::string kind = kind_of(finding);
  if (options.shrinks)
    plan = shrink(std::move(plan), [&](const Plan& less) {
      const auto again = play(less, options.but).finding;
      return again && kind_of(*again) == kind;
    });
  const auto found = play(plan, options.but).finding;
  plan.finding = found ? found->law + ": " + found->sentence : finding.law;
  std::cout << plan.written() << "-- as a script:\n" << lua_script(plan);
  if (!options.keep.empty()) keep(plan, options.keep, seed);
}

int search(const Options& options) {
  Statistics statistics;
  const auto began = std::chrono::steady_clock::now();
  for (std::uint64_t seed = options.seed; seed < options.seed + options.seeds; ++seed) {
    if (options.skipped.contains(seed)) continue;
    const Plan plan = draw_plan(options.model, seed, options.drawing);
    if (options.prints) {
      std::cout << plan.written();
      continue;
    }
    statistics.count(plan);
    auto [finding, fingerprint] = play(plan, options.but);
    statistics.bytes = statistics.bytes * 31 + fingerprint;
    constexpr std::uint64_t played_twice = 16;  // each so many sessions are played again: the law "same"
    if (!finding && seed % played_twice == 0 && play(plan, options.but).fingerprint != fingerprint)
      finding = Finding{"same", {}, "The same plan has brought other bytes."};
    if (!finding) continue;
    ++statistics.findings[finding->law];
    std::cout << fmt::format("{} seed {}\n", options.model, seed);
    show(*finding);
    examine(plan, *finding, options, seed);
    std::cout << std::flush;
    if (options.until_failure) break;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
  if (!options.prints) statistics.print(wall.count());
  return statistics.findings.empty() ? 0 : 1;
}

int replay(const std::vector<std::string>& files, const std::string& but, bool traces) {
  int failures = 0;
  for (const std::string& file : files) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    const auto plan = Plan::read(text.str());
    if (!in || !plan || plan->model.empty()) {
      std::cerr << file << ": " << (plan ? "There is no plan in it." : plan.error().sentence()) << "\n";
      return 2;
    }
    Trace trace(std::cout);
    const auto finding = play(*plan, but, traces ? &trace : nullptr).finding;
    failures += finding.has_value();
    std::cout << file << (finding ? ":\n" : ": good\n");
    if (finding) show(*finding);
  }
  return failures == 0 ? 0 : 1;
}

int run(const std::vector<std::string>& words) {
  Options o;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&] { return i + 1 < words.size() ? words[++i] : std::string(); };
    if (word == "--model")
      o.model = value();
    else if (word == "--seed")
      o.seed = std::stoull(value());
    else if (word == "--seeds")
      o.seeds = std::stoull(value());
    else if (word == "--minutes")
      o.drawing.length = Millis(static_cast<std::int64_t>(std::stod(value()) * 60'000));
    else if (word == "--bus")
      o.drawing.bus = true;
    else if (word == "--calm")
      o.drawing.faults = false;
    else if (word == "--until-failure")
      o.until_failure = true, o.seeds = ~std::uint64_t{0} - o.seed;
    else if (word == "--no-shrink")
      o.shrinks = false;
    else if (word == "--keep")
      o.keep = value();
    else if (word == "--print")
      o.prints = true;
    else if (word == "--skip")
      o.skipped.insert(std::stoull(value()));
    else if (word == "--but")
      o.but = value();
    else if (word == "--trace")
      o.traces = true;
    else if (word == "--replay") {
      while (i + 1 < words.size()) o.replays.push_back(words[++i]);
    } else {
      std::cerr << usage;
      return 2;
    }
  }
  return o.replays.empty() ? search(o) : replay(o.replays, o.but, o.traces);
}

}  // namespace
}  // namespace hw::simulation

int main(int argc, char** argv) try {
  return hw::simulation::run({argv + 1, argv + argc});
} catch (const std::exception& e) {
  std::cerr << e.what() << "\n";
  return 2;
}
