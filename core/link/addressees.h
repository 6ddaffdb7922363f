#pragma once
// Which devices of a wire that several share something is for. Pure, any thread.

namespace hw {

class Addressees {
 public:
  static constexpr Addressees none() { return Addressees(nobody); }
  static constexpr Addressees all() { return Addressees(everybody); }
  /// A negative address is that of a device that is alone on its wire: none.
  static constexpr Addressees one(int address) { return Addressees(address < 0 ? nobody : address); }

  [[nodiscard]] constexpr bool any() const { return address_ != nobody; }
  /// Somebody is among both.
  [[nodiscard]] constexpr bool share(Addressees other) const {
    if (!any() || !other.any()) return false;
    return address_ == everybody || other.address_ == everybody || address_ == other.address_;
  }
  friend constexpr bool operator==(Addressees, Addressees) = default;

 private:
  static constexpr int nobody = -1, everybody = -2;
  explicit constexpr Addressees(int address) : address_(address) {}
  int address_;
};

}  // namespace hw
