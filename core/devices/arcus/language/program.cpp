#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {
namespace {

struct OpcodeFacts {
  std::string_view mnemonic;
  Shape shape;
  int lines;
};
constexpr OpcodeFacts opcode_facts[] = {
    {"", Shape::nothing, 1},       // empty
    {"", Shape::nothing, 1},       // continued
    {"+TEST", Shape::nothing, 1},  // test
    {"", Shape::nothing, 1},       // bad
#define OPCODE(name, mnemonic, operands, lines) {mnemonic, Shape::operands, lines},
#include "core/devices/arcus/language/opcodes.def"
#undef OPCODE
};

enum class Index : std::uint8_t { none, axis, number };
constexpr Index quantity_index[] = {
#define QUANTITY(name, index) Index::index,
#include "core/devices/arcus/language/quantities.def"
#undef QUANTITY
};

/// An IF or WHILE whose end has not been seen yet.
struct OpenBlock {
  std::vector<std::uint16_t> heads;  ///< IF, ELSEIF ..., ELSE; or the WHILE
  bool loop = false, has_else = false;
};

class BlockLinker {
 public:
  explicit BlockLinker(std::vector<Instruction>& code) : code_(code) {}

  std::vector<int> run() {
    for (std::size_t i = 0; i < code_.size(); ++i) see(static_cast<std::uint16_t>(i));
    give_up_open_blocks();
    return std::move(loose_);
  }

 private:
  void see(std::uint16_t line) {
    switch (code_[line].op) {
      case Opcode::if_: open_.push_back({{line}, false, false}); break;
      case Opcode::while_: open_.push_back({{line}, true, false}); break;
      case Opcode::elseif: branch(line, line + 1); break;  // to its +TEST
      case Opcode::else_: branch(line, line + 1); break;   // to the statement below
      case Opcode::endif: close_if(line); break;
      case Opcode::endwhile: close_while(line); break;
      case Opcode::prg:
      case Opcode::end:
      case Opcode::sub:
      case Opcode::endsub: give_up_open_blocks(); break;
      default: break;
    }
  }

  void branch(std::uint16_t line, int if_false) {
    if (open_.empty() || open_.back().loop || open_.back().has_else) return loose_.push_back(line);
    OpenBlock& block = open_.back();
    code_[block.heads.back()].if_false = static_cast<std::uint16_t>(if_false);
    block.heads.push_back(line);
    block.has_else = code_[line].op == Opcode::else_;
  }

  void close_if(std::uint16_t line) {
    if (open_.empty() || open_.back().loop) return loose_.push_back(line);
    const OpenBlock& block = open_.back();
    for (const auto head : block.heads) code_[head].link = line;
    if (!block.has_else) code_[block.heads.back()].if_false = line;
    open_.pop_back();
  }

  void close_while(std::uint16_t line) {
    if (open_.empty() || !open_.back().loop) return loose_.push_back(line);
    const auto head = open_.back().heads.front();
    code_[line].link = head;
    code_[head].link = line;
    code_[head].if_false = static_cast<std::uint16_t>(line + 1);
    open_.pop_back();
  }

  void give_up_open_blocks() {
    for (const OpenBlock& block : open_) loose_.insert(loose_.end(), block.heads.begin(), block.heads.end());
    open_.clear();
  }

  std::vector<Instruction>& code_;
  std::vector<OpenBlock> open_;
  std::vector<int> loose_;
};

}  // namespace

Shape shape_of(Opcode op) { return opcode_facts[static_cast<int>(op)].shape; }
std::string_view mnemonic_of(Opcode op) { return opcode_facts[static_cast<int>(op)].mnemonic; }
int lines_of(Opcode op) { return opcode_facts[static_cast<int>(op)].lines; }
bool has_axis(Quantity quantity) { return quantity_index[static_cast<int>(quantity)] == Index::axis; }

std::vector<int> link_blocks(std::vector<Instruction>& code) { return BlockLinker(code).run(); }

std::vector<int> find_heads(Program& program) {
  program.programs = {};
  program.subs = {};
  std::vector<int> repeated;
  const auto note = [&](auto& heads, int number, std::size_t line) {
    if (heads[number])
      repeated.push_back(static_cast<int>(line));
    else
      heads[number] = static_cast<std::uint16_t>(line);
  };
  for (std::size_t line = 0; line < program.code.size(); ++line) {
    const Instruction& i = program.code[line];
    if (i.op == Opcode::prg) note(program.programs, i.values[0].number, line);
    if (i.op == Opcode::sub) note(program.subs, i.values[0].number, line);
  }
  // Text before the first heading is program 0 (AMB-116).
  if (!program.programs[0] && !program.code.empty()) {
    const Opcode first = program.code.front().op;
    if (first != Opcode::prg && first != Opcode::sub && first != Opcode::empty) program.programs[0] = 0;
  }
  return repeated;
}

}  // namespace hw::arcus::language
