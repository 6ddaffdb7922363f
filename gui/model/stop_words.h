#pragma once
// Names the motions that a stop of everything has stopped: for users who pressed Esc to close a list and
// stopped the machine too.
#include <memory>
#include <span>
#include <string>

namespace hw::gui {

class Tab;

/// "Esc closed the open list or dialog. It also stopped table, which was moving." Uses the state known in
/// this frame.
std::string words_of_esc(std::span<const std::unique_ptr<Tab>> tabs);

}  // namespace hw::gui
