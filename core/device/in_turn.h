#pragma once
// Of many values of which a round of status asks a few: whose turn it is.

namespace hw {

class InTurn {
 public:
  /// The next of `count` that is `wanted(i)`; each comes once before the first comes again. -1: none is.
  template <class Wanted>
  int next(int count, Wanted wanted) {
    for (int tried = 0; tried < count; ++tried) {
      const int place = peek(count);
      next_ = place + 1;
      if (wanted(place)) return place;
    }
    return -1;
  }
  int next(int count) {
    return next(count, [](int) { return true; });
  }
  /// Whose turn comes, if it is wanted; it does not pass by this.
  [[nodiscard]] int peek(int count) const { return next_ < count ? next_ : 0; }
  /// It comes at once.
  void jump_to(int place) { next_ = place; }

 private:
  int next_ = 0;
};

}  // namespace hw
