#pragma once
// Describes the bench of an emulated device: a part of the catalog.
#include <cstdint>
#include <string>
#include <vector>

namespace hw {

enum class LampColour : std::uint8_t { green, yellow, red };
struct BenchButton {
  std::string name;  ///< "Run", "1-"
  bool moves = false;
  int row = 0;               ///< on its front panel
  int supply = 0;            ///< index of the supply whose front panel has it
  bool stops = false;        ///< a Stop: drawn as one
  std::string caption = {};  ///< shown once over adjacent buttons with the same caption: "Motor 1"
};
struct BenchLamp {
  std::string name;
  LampColour colour;
  int supply = 0;
};
/// A box on the bench with a power switch of its own.
struct BenchSupply {
  std::string name;      ///< name of a second box: "Slave"; empty: the device itself
  bool breaker = false;  ///< has a circuit breaker that is reset by hand
};
/// The controls and lamps that a person can reach on the emulated device.
struct BenchFacts {
  std::string panel_title;  ///< "VXM front panel"
  std::vector<BenchSupply> supplies{BenchSupply{}};
  std::vector<BenchButton> buttons;
  std::vector<BenchLamp> lamps;
};

}  // namespace hw
