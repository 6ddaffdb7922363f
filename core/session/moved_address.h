#pragma once
// The new address of a controller whose set-up has changed its id or baud rate. Pure.
#include <optional>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "core/session/address.h"

namespace hw {

/// None: the address is unchanged, as far as is known, or the controller is an emulator of this process.
/// While the controller answers, only stored values count.
std::optional<Address> moved_address(const Catalog& catalog, const Snapshot& now, const Address& opened);

/// The differences of `to`: "address 07 and 38400 baud".
std::string words_of_move(const Address& from, const Address& to);

}  // namespace hw
