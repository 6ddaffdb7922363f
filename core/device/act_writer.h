#pragma once
// A sequence that is done act by act, without a program in the controller: what all who make such pieces of
// it share. A piece is what the tool draws in one go; it begins and ends with the tool up.
#include "core/device/pieces.h"
#include "core/device/sequence_draft.h"

namespace hw {

/// The last place, `from` or one before it, to which the steps come with the tool up.
[[nodiscard]] std::size_t last_tool_up(const sequence::StepList& steps, std::size_t from);

class ActWriter {
 public:
  ActWriter(const sequence::Sequence& sequence, const Catalog& catalog, std::size_t from)
      : draft_(sequence, catalog), from_(from) {}
  virtual ~ActWriter() = default;

 protected:
  /// Of all steps; what stands before `from` is followed and not done.
  [[nodiscard]] Result<> write_all();

  // ---- what a list is made of, in this order
  /// All axes go to where the draft has them now.
  virtual Result<> go(const sequence::OwnSpeeds& own) = 0;
  virtual void act(IntentBody what) = 0;
  /// Passes behind the act before.
  virtual Result<> pause(Duration time) = 0;
  virtual Result<> speeds(const sequence::Speeds& said) = 0;
  /// The tool is up, and was down.
  virtual void end_piece() = 0;
  /// It cannot be done so.
  virtual Result<> unfit() = 0;
  [[nodiscard]] virtual bool can_move(int place) const = 0;
  /// Whatever went before stands in the list.
  virtual void flush() {}

  [[nodiscard]] bool emits() const { return ix(place_) >= from_; }
  [[nodiscard]] bool cuts() const { return tool_down_ && !draft_.in_routine(); }
  /// Of the step at hand, in the sequence's own list.
  [[nodiscard]] int place() const { return place_; }
  /// Where they are known.
  [[nodiscard]] std::vector<AxisTarget> stands() const;

  SequenceDraft draft_;

 private:
  Result<> write(const sequence::Step& step, std::size_t place);
  template <class Other>
  Result<> write(const Other&) {
    return unfit();
  }
  Result<> write(const sequence::Comment&) { return {}; }
  Result<> write(const sequence::WaitMotion&) { return {}; }  // each act waits, and the moves of one go on
  Result<> write(const sequence::Speed& step);
  Result<> write(const sequence::Move& step);
  Result<> write(const sequence::Arc& step);
  Result<> write(const sequence::Output& step);
  Result<> write(const sequence::Delay& step);
  Result<> write(const sequence::Pen& step);
  Result<> routine(bool down);
  Result<> begin_here();
  [[nodiscard]] double tolerance(const sequence::Plane& plane) const;

  const std::size_t from_;
  int place_ = 0;
  bool tool_down_ = false, drew_ = false;
};

}  // namespace hw
