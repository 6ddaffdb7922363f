#pragma once
// The remarks of a text on their way into blocks: those with a line of their own become comments, those
// behind commands are counted.
#include <string>
#include <string_view>
#include <vector>

#include "core/device/sequence_reading.h"

namespace hw {

class TextRemarks {
 public:
  explicit TextRemarks(std::string_view text) : text_(text) {}
  /// In the order of the text, its mark included. `behind` a command of its line.
  void add(Stretch at, bool behind) { all_.push_back({at, behind}); }

  /// Where to go on; returns where it was.
  std::size_t go_to(std::size_t place);
  /// Those from there on in front of a place. Lines that follow each other are one comment.
  void read_before(std::size_t place, ReadSteps& list);
  /// Those within a step: what stays the controller's own text shows them there.
  void pass(const ReadStep& step);
  /// Behind everything else: those that are left.
  void finish(ReadText& read);

 private:
  struct Remark {
    Stretch at;
    bool behind;
    bool seen = false;
  };
  /// That have not been seen yet.
  template <class Take>
  void each_before(std::size_t place, Take take);

  std::string_view text_;
  std::vector<Remark> all_;
  std::size_t from_ = 0;  ///< place in the text
  int unshown_ = 0;
};

}  // namespace hw
