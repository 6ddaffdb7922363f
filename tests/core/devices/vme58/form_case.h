#pragma once
// One case for each row of vme58.tsv: the 139 command forms with the part of the data sheet that they stand
// in, and the places of the window and the bits of its registers. It is text in vme58.forms (see
// form_session.h) or, where it loops and computes,
//
//   VME58_FORM("vme58.sync.SW") { ... }
//
// Both register a test for that id. Before the case runs, what the table says of a command is checked: the
// modes in which it is taken, the room that it needs in a queue, whether it is answered. The case asserts one
// effect: reply, register or memory contents, motion.
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

#define HW_JOIN58_(a, b) a##b
#define HW_JOIN58(a, b) HW_JOIN58_(a, b)
// __COUNTER__ and not the line: files may be compiled in batches.
#define VME58_FORM(id) VME58_FORM_(id, __COUNTER__)
#define VME58_FORM_(id, n)                                                                        \
  static void HW_JOIN58(vme58_form_body_, n)(const ::hw::vme58::proof::Form&);                    \
  static const bool HW_JOIN58(vme58_form_registered_, n) =                                        \
      ::hw::vme58::proof::register_form(id, &HW_JOIN58(vme58_form_body_, n), __FILE__, __LINE__); \
  static void HW_JOIN58(vme58_form_body_, n)([[maybe_unused]] const ::hw::vme58::proof::Form& form)

}  // namespace hw::vme58::proof
