// Drawings: a file of 100,000 entities against what dxflib takes for it when nobody listens, in turns of one
// run; and 20,000 chains put into order.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <sstream>
#include <vector>

#include <benchmark/benchmark.h>
#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include "core/drawing/chains.h"
#include "core/drawing/dxf_reader.h"

namespace hw {
namespace {

constexpr int entities = 100'000, chains = 20'000;

class DrawingText {
 public:
  /// As a part file mixes them, or lines only: little to do for a reader beyond the parser's work.
  explicit DrawingText(bool mixed) {
    add("  0\nSECTION\n  2\nENTITIES\n");
    for (int n = 0; n < entities; ++n) {
      x_ = n % 400 * 2.5, y_ = n / 400 * 2.5;
      mixed ? mix(n % 20) : line();
    }
    add("  0\nENDSEC\n  0\nEOF\n");
  }
  std::string text;

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> form, Args&&... args) {
    fmt::format_to(std::back_inserter(text), form, std::forward<Args>(args)...);
  }
  void mix(int kind) {
    if (kind < 8) return line();
    if (kind < 12) return polyline();
    if (kind < 15)
      return add("  0\nARC\n  8\ncut\n 10\n{:.6f}\n 20\n{:.6f}\n 40\n1.25\n 50\n10.5\n 51\n200.0\n", x_, y_);
    if (kind < 18) return add("  0\nCIRCLE\n  8\ncut\n 10\n{:.6f}\n 20\n{:.6f}\n 40\n1.25\n", x_, y_);
    if (kind < 19) return spline();
    add("  0\nELLIPSE\n  8\ncut\n 10\n{:.6f}\n 20\n{:.6f}\n 30\n0.0\n 11\n1.0\n 21\n0.2\n 31\n0.0\n "
        "40\n0.5\n 41\n0.0\n 42\n3.0\n",
        x_, y_);
  }
  void line() {
    add("  0\nLINE\n  8\ncut\n 10\n{:.6f}\n 20\n{:.6f}\n 30\n0.0\n 11\n{:.6f}\n 21\n{:.6f}\n 31\n0.0\n", x_,
        y_, x_ + 1.5, y_ + 0.75);
  }
  void polyline() {
    add("  0\nLWPOLYLINE\n  8\ncut\n 90\n6\n 70\n1\n");
    for (int i = 0; i < 6; ++i)
      add(" 10\n{:.6f}\n 20\n{:.6f}\n 42\n{}\n", x_ + i, y_ + i % 2, i % 3 == 0 ? "0.25" : "0.0");
  }
  void spline() {
    add("  0\nSPLINE\n  8\ncut\n 70\n8\n 71\n3\n 72\n8\n 73\n4\n 74\n0\n");
    for (const int knot : {0, 0, 0, 0, 1, 1, 1, 1}) add(" 40\n{}.0\n", knot);
    for (int i = 0; i < 4; ++i) add(" 10\n{:.6f}\n 20\n{:.6f}\n 30\n0.0\n", x_ + 0.5 * i, y_ + i % 2);
  }
  double x_ = 0, y_ = 0;
};

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double median(std::vector<double> of) {
  const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
  std::nth_element(of.begin(), middle, of.end());
  return *middle;
}

/// Each time right behind the other: what else the machine does in that second falls on both, and one pair
/// that it falls on unevenly is not the median.
void drawing_read_against_dxflib(benchmark::State& state) {
  const DrawingText drawing(state.range(0) != 0);
  std::vector<double> shares, reads;
  for (auto _ : state) {
    const double began = cpu_ms();
    {
      std::istringstream in(drawing.text);
      DL_CreationAdapter nobody;
      DL_Dxf parser;
      if (!parser.in(in, &nobody)) return state.SkipWithError("it is not parsed");
    }
    const double parsed = cpu_ms();
    {
      const auto read = drawing::read_dxf(drawing.text, "bench.dxf", drawing::Tolerance{0.01});
      if (!read || read->paths.size() != entities) return state.SkipWithError("it is not read");
    }
    const double done = cpu_ms();
    reads.push_back(done - parsed), shares.push_back((done - parsed) / (parsed - began));
  }
  state.counters["read_ms"] = median(reads);
  state.counters["of_the_parse"] = median(shares);
}
BENCHMARK(drawing_read_against_dxflib)
    ->ArgName("mixed")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(9)
    ->Unit(benchmark::kMillisecond);

/// Open ones all over the table; the same with one that lies far away; rings of 12 corners; all on one line.
enum Kind : std::int64_t { open_ends, one_far_away, rings, on_a_line };

std::vector<drawing::Chain> chains_of(Kind kind) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 500), turn(0, 6.28);
  std::vector<drawing::Chain> all(chains);
  for (drawing::Chain& chain : all) {
    const drawing::Point at{place(random), kind == on_a_line ? 0 : place(random)};
    const double angle = turn(random);
    drawing::Point from = at;
    const auto line_to = [&](drawing::Point to) {
      chain.curves.push_back({drawing::Curve::Kind::line, from, to, {}, 0});
      from = to;
    };
    if (kind != rings)
      line_to({at.x + 3 * std::cos(angle), kind == on_a_line ? 0 : at.y + 3 * std::sin(angle)});
    for (int i = 1; kind == rings && i <= 12; ++i)
      line_to(i == 12 ? at : drawing::Point{at.x + std::sin(i * 0.5236), at.y + 1 - std::cos(i * 0.5236)});
  }
  if (kind == one_far_away) all.front().curves.front().to = {1e7, 1e7};
  return all;
}

void drawing_ordered(benchmark::State& state) {
  const std::vector<drawing::Chain> as_drawn = chains_of(static_cast<Kind>(state.range(0)));
  double way = 0, longest_s = 0;
  int reports = 0;
  for (auto _ : state) {
    std::vector<drawing::Chain> all = as_drawn;
    auto last = std::chrono::steady_clock::now();
    drawing::order(all, {}, [&](double) {
      const auto now = std::chrono::steady_clock::now();
      longest_s = std::max(longest_s, std::chrono::duration<double>(now - std::exchange(last, now)).count());
      ++reports;
      return true;
    });
    way = drawing::way_between(all, {});
  }
  state.counters["way"] = way / drawing::way_between(as_drawn, {});
  state.counters["reports"] = static_cast<double>(reports) / static_cast<double>(state.iterations());
  state.counters["longest_silence_ms"] = longest_s * 1e3;
}
BENCHMARK(drawing_ordered)
    ->ArgName("kind")
    ->Arg(open_ends)
    ->Arg(one_far_away)
    ->Arg(rings)
    ->Arg(on_a_line)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hw
