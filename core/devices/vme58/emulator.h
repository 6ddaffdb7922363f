#pragma once
// The VME58 in miniature: a board in a 4 KiB window (Emulator::bus()), no byte stream. Options of the
// address:
//   variant=8S|4S4|8|4E|2S2|2S6|6S2|4S|4   in any case, 8S by default
//   jumpers=IIO    general lines 0-3, 4-7, 8-11: I input, O output; 12 and 13 are always outputs
//   firmware=2.24  the revision in the reply to WY; hosts rely on it
//   quirk=padded|oms-kk|deaf-mailbox   several joined by +: board_options.h
//
// The bench starts with axes that have no travel limits, home zones or motors, and with inputs open, that is
// high. Inputs are numbered from 1 as everywhere in this program: number n is the maker's line n-1.
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/emulation/emulator.h"

namespace hw::vme58 {

[[nodiscard]] Result<std::unique_ptr<Emulator>> make_emulator(
    const std::map<std::string, std::string>& options);

}  // namespace hw::vme58
