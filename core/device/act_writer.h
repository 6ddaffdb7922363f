#pragma once
// Base of the writers that turn a sequence into pieces which the console runs act by act, without a program
// in the controller. A piece is one chain of the tool; it begins and ends with the tool up.
#include "core/device/pieces.h"
#include "core/device/sequence_draft.h"

namespace hw {

/// The last place, at or before `from`, that the steps reach with the tool up.
[[nodiscard]] std::size_t last_tool_up(const sequence::StepList& steps, std::size_t from);

class ActWriter {
 public:
  ActWriter(const sequence::Sequence& sequence, const Catalog& catalog, std::size_t from)
      : draft_(sequence, catalog), from_(from) {}
  virtual ~ActWriter() = default;

 protected:
  /// The acts of all steps; those before `from` are followed but not carried out.
  [[nodiscard]] Result<> write_all();

  // ---- parts of a list, in this order
  /// All axes move to their places in the draft.
  virtual Result<> go(const sequence::OwnSpeeds& own) = 0;
  virtual void act(IntentBody what) = 0;
  /// A pause after the previous act.
  virtual Result<> pause(Duration time) = 0;
  virtual Result<> speeds(const sequence::Speeds& given) = 0;
  /// The tool goes up.
  virtual void end_piece() = 0;
  /// It cannot be done in this way.
  virtual Result<> unfit() = 0;
  [[nodiscard]] virtual bool can_move(int place) const = 0;
  /// Everything so far is in the list.
  virtual void flush() {}

  [[nodiscard]] bool emits() const { return ix(place_) >= from_; }
  [[nodiscard]] bool cuts() const { return tool_down_ && !draft_.in_routine(); }
  /// Index of the present step in the sequence's list.
  [[nodiscard]] int place() const { return place_; }
  /// The places, as far as known.
  [[nodiscard]] std::vector<AxisTarget> stands() const;

  SequenceDraft draft_;

 private:
  Result<> write(const sequence::Step& step, std::size_t place);
  template <class Other>
  Result<> write(const Other&) {
    return unfit();
  }
  Result<> write(const sequence::Comment&) { return {}; }
  Result<> write(const sequence::WaitMotion&) {
    return {};
  }  // each act waits until the moves of the one before have ended
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
