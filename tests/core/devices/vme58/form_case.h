#pragma once
// One case for each row of vme58.tsv: the 139 command forms with the part of the data sheet that they stand
// in, and the places of the window and the bits of its registers. It is text in vme58.forms, see
// form_session.h, which registers a test for each id. Before the case runs, what the table says of a command
// is checked: the modes in which it is taken, the room that it needs in a queue, whether it is answered. The
// case asserts one effect: reply, register or memory contents, motion.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {

struct Form {
  std::string id, form, example, kind, when, args, fallback, reply, memory, effect, manual, ambiguity;

  [[nodiscard]] bool is(std::string_view some_kind) const { return kind == some_kind; }
  [[nodiscard]] bool taken_in(std::string_view mode) const {
    return when == "any" || when.find(mode) != std::string::npos;
  }
  /// Of a field of `args` ("offset:0..1;hex:0x000;bytes:2"), what stands behind its name.
  [[nodiscard]] std::string arg(std::string_view name) const;
  [[nodiscard]] std::string letters() const { return example.substr(0, 2); }
};

/// All rows of vme58.tsv.
const std::vector<Form>& form_table();

using FormBody = std::function<void(const Form&)>;
bool register_form(const std::string& id, FormBody body, const char* file, int line);
bool has_case(std::string_view id);
/// Ids that have a case but no row.
std::vector<std::string> cases_without_row();

}  // namespace hw::vme58::proof
