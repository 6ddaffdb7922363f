#pragma once
// Turns the remarks of a text into blocks: remarks on lines of their own become comments, remarks behind
// commands are only counted.
#include <string>
#include <string_view>
#include <vector>

#include "core/device/sequence_reading.h"

namespace hw {

class TextRemarks {
 public:
  explicit TextRemarks(std::string_view text) : text_(text) {}
  /// In the order of the text, comment mark included. `behind`: after a command on its line.
  void add(Stretch at, bool behind) { all_.push_back({at, behind}); }

  /// Sets where to continue; returns the place before.
  std::size_t go_to(std::size_t place);
  /// The remarks from there up to a place. Consecutive lines are one comment.
  void read_before(std::size_t place, ReadSteps& list);
  /// Skips the remarks within a step, which its own text shows.
  void pass(const ReadStep& step);
  /// The remaining ones, behind everything else.
  void finish(ReadText& read);

 private:
  struct Remark {
    Stretch at;
    bool behind;
    bool seen = false;
  };
  /// Remarks not handled yet.
  template <class Take>
  void each_before(std::size_t place, Take take);

  std::string_view text_;
  std::vector<Remark> all_;
  std::size_t from_ = 0;  ///< place in the text
  int unshown_ = 0;
};

}  // namespace hw
