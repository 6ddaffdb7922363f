#pragma once
// Chooses in turn among many values of which a status round reads only a few.

namespace hw {

class InTurn {
 public:
  /// The next of `count` for which `wanted(i)`; each comes once before the first comes again. -1: none.
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
  /// The next in turn; does not advance.
  [[nodiscard]] int peek(int count) const { return next_ < count ? next_ : 0; }
  /// Makes `place` the next in turn.
  void jump_to(int place) { next_ = place; }

 private:
  int next_ = 0;
};

}  // namespace hw
