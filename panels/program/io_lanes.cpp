#include "panels/program/io_lanes.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace hw::panels {
namespace {

constexpr std::size_t most_in_words = 8;  // of each kind

using LaneLine = RehearsedEvent::Line;

/// A lane in progress: spans that have begun and not ended yet.
struct Open {
  IoLane lane;
  std::optional<double> on_since, waits_since;
  bool seen = false;
};

void add(std::vector<IoLane::Span>& spans, double from, double to, double gap) {
  if (!spans.empty() && from - spans.back().to <= gap)
    spans.back().to = to;
  else
    spans.push_back({from, to});
}

void close(std::optional<double>& since, std::vector<IoLane::Span>& spans, double t, double gap) {
  if (since) add(spans, *since, t, gap);
  since.reset();
}

void take(Open& open, const RehearsedEvent& event, double gap) {
  IoLane& lane = open.lane;
  const bool first = !std::exchange(open.seen, true), on = event.level != 0;
  switch (event.line) {
    case LaneLine::waits: open.waits_since = event.t; return;
    case LaneLine::comes: return close(open.waits_since, lane.waits, event.t, gap);
    case LaneLine::looked_at:
      if (lane.looks.empty() || event.t - lane.looks.back() > gap) lane.looks.push_back(event.t);
      [[fallthrough]];
    case LaneLine::switched: {
      const bool was_on = first && (event.line == LaneLine::looked_at ? on : !on);  // since the start
      if (was_on) open.on_since = 0;
      if (!on) return close(open.on_since, lane.on, event.t, gap);
      if (!open.on_since) open.on_since = event.t;
      return;
    }
    case LaneLine::none: return;
  }
}

void append_spans(std::string& words, std::string_view verb, const std::vector<IoLane::Span>& spans,
                  double end) {
  for (std::size_t i = 0; i < std::min(spans.size(), most_in_words); ++i) {
    words += words.empty() ? "" : ", ";
    words += i == 0 ? fmt::format("{} ", verb) : "";
    const IoLane::Span& s = spans[i];
    words += s.to >= end ? fmt::format("from {:.1f} s to the end", s.from)
                         : fmt::format("from {:.1f} s to {:.1f} s", s.from, s.to);
  }
  if (spans.size() > most_in_words) words += " and more";
}

std::string lane_words(const IoLane& lane, double end) {
  std::string words;
  append_spans(words, "on", lane.on, end);
  append_spans(words, "waited for", lane.waits, end);
  for (std::size_t i = 0; i < std::min(lane.looks.size(), most_in_words); ++i)
    words += fmt::format("{}{}{:.1f} s", words.empty() ? "" : ", ", i == 0 ? "looked at after " : "",
                         lane.looks[i]);
  if (lane.looks.size() > most_in_words) words += " and more";
  return words.empty() ? "off" : words;
}

}  // namespace

std::vector<IoLane> io_lanes(const Rehearsal& r, double finest) {
  std::vector<Open> all;
  std::unordered_map<std::string_view, std::size_t> place;
  const double gap = r.duration_s * finest;
  for (const RehearsedEvent& event : r.events) {
    if (event.line == LaneLine::none) continue;
    const auto [found, is_new] = place.try_emplace(event.name, all.size());
    if (is_new) all.emplace_back().lane.name = event.name;
    take(all[found->second], event, gap);
  }
  std::vector<IoLane> lanes;
  for (Open& open : all) {
    close(open.on_since, open.lane.on, r.duration_s, gap);
    close(open.waits_since, open.lane.waits, r.duration_s, gap);
    open.lane.words = lane_words(open.lane, r.duration_s);
    lanes.push_back(std::move(open.lane));
  }
  return lanes;
}

}  // namespace hw::panels
