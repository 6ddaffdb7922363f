#pragma once
// The positions of a rehearsal, as many as memory allows.
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/device/language.h"

namespace hw {

/// The interval of a path for display.
constexpr double track_seen_every_s = 0.02;

/// In order of time. The beginning and the end of a rest are kept; a long track is thinned.
class Track {
 public:
  static constexpr std::size_t most_places = 300'000;  // 24 MB
  void add(const RehearsedPlace& place);
  /// Nothing has changed since the last place.
  [[nodiscard]] bool rests(const RehearsedPlace& place) const;
  /// Keeps one place in so many: 1, 2, 4 ...
  [[nodiscard]] int every() const { return every_; }
  [[nodiscard]] std::vector<RehearsedPlace> take() { return std::move(places_); }

 private:
  void thin_out();
  std::vector<RehearsedPlace> places_;
  int every_ = 1;
};

/// Keeps one in so many of the samples taken every `every_s`; 1: all.
[[nodiscard]] int thinned_to(std::span<const RehearsedPlace> track, double every_s);

}  // namespace hw
