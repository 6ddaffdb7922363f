#include "core/devices/arcus/language/compiler.h"

#include <algorithm>

#include "core/devices/arcus/language/codegen.h"
#include "core/devices/arcus/language/complaints.h"
#include "core/devices/arcus/language/lexer.h"
#include "core/devices/arcus/language/listing.h"
#include "core/devices/arcus/language/listing_check.h"
#include "core/devices/arcus/language/parser.h"
#include "core/devices/arcus/language/structure.h"
#include "core/devices/arcus/language/text_lines.h"

namespace hw::arcus::language {
namespace {

TokenKind kind_of(const Statement& s) {
  const Opcode op = s.instruction.op;
  if (op == Opcode::bad) return TokenKind::bad;
  if (op >= Opcode::move && op <= Opcode::abort) return TokenKind::moves;
  if (op <= Opcode::endwhile || op == Opcode::delay || op == Opcode::wait || op == Opcode::run)
    return TokenKind::flow;
  return TokenKind::plain;
}

std::vector<Token> tokens_of(const std::optional<Statement>& s, const LexedLine& lexed) {
  std::vector<Token> tokens;
  if (s) {
    const TokenKind kind = kind_of(*s);
    const Lexeme& word = lexed.lexemes().front();
    const int end = s->column + s->length;
    const int split = kind == TokenKind::flow ? word.end : end;  // IF is coloured, its condition is plain
    tokens.push_back({s->column, split, kind});
    if (split < end) tokens.push_back({split, end, TokenKind::plain});
  }
  if (lexed.comment() >= 0) tokens.push_back({lexed.comment(), lexed.length(), TokenKind::comment});
  return tokens;
}

void warn_of_stars(const LexedLine& lexed, int line, std::vector<Problem>& problems) {
  if (!lexed.star_comment()) return;
  Problem& problem = problems.emplace_back();
  problem.error = false;
  problem.line = line;
  problem.column = lexed.comment();
  problem.sentence = "Begin a comment with ;. This was taken as a comment.";
  problem.fix_label = "Use ;";
  problem.fix_text = ";";
}

std::vector<Statement> read_statements(std::string_view text, const Dialect& dialect, Compilation& out) {
  std::vector<Statement> statements;
  LexedLine lexed;
  LineParser parser(dialect, out.problems);
  for_each_line(text, [&](std::string_view line, int number) {
    lexed.read(line);
    const auto statement = parser.parse(lexed, number);
    out.text.push_back({tokens_of(statement, lexed), -1, 0});
    warn_of_stars(lexed, number, out.problems);
    if (statement) statements.push_back(*statement);
  });
  return statements;
}

void report_too_long(const Generated& generated, std::vector<Problem>& problems) {
  const Statement* beyond = generated.first_beyond;
  if (!beyond) return;
  Problem& problem = problems.emplace_back();
  problem.line = beyond->line;
  problem.column = beyond->column;
  problem.length = beyond->length;
  problem.sentence = "The text does not fit from here on: it needs " + grouped(generated.needed) +
                     " low-level lines, and the controller has " + grouped(program_lines) + ".";
}

/// Finds the low-level lines that each line of the text has become.
void map_lines(Compilation& out) {
  for (std::size_t low = 0; low < out.source_line.size(); ++low) {
    SourceLine& line = out.text[static_cast<std::size_t>(out.source_line[low])];
    if (line.first < 0) line.first = static_cast<int>(low);
    ++line.count;
  }
}

Compilation compile_source(std::string_view text, const Dialect& dialect) {
  Compilation out;
  const std::vector<Statement> statements = read_statements(text, dialect, out);
  check_structure(statements, out.problems);
  check_calls(statements, out.problems);
  Generated generated = generate(statements);
  report_too_long(generated, out.problems);
  out.needed = generated.needed;
  out.program = std::move(generated.program);
  out.source_line = std::move(generated.source_line);
  out.lines = encode(out.program, dialect);
  return out;
}

Compilation compile_listing(std::string_view text, const Dialect& dialect) {
  Compilation out;
  ReadListing listing = read_listing(text, dialect);
  out.program = decode(listing.lines, dialect);
  out.problems = std::move(listing.problems);
  for (const BadLine& bad : out.program.bad_lines) {
    Problem& problem = out.problems.emplace_back();
    problem.line = listing.source_line[static_cast<std::size_t>(bad.line)];
    problem.sentence = "Line " + std::to_string(bad.line) + " " + bad.why + ".";
  }
  check_listing(out.program, listing.source_line, dialect, out.problems);
  for_each_line(text, [&](std::string_view line, int) {
    out.text.push_back({{{0, static_cast<int>(line.size()), TokenKind::plain}}, -1, 0});
  });
  out.needed = static_cast<int>(listing.lines.size());
  out.lines = std::move(listing.lines);
  out.source_line = std::move(listing.source_line);
  return out;
}

}  // namespace

Compilation compile(std::string_view text, const Dialect& dialect) {
  Compilation out = is_listing(text) ? compile_listing(text, dialect) : compile_source(text, dialect);
  map_lines(out);
  std::stable_sort(out.problems.begin(), out.problems.end(), [](const Problem& a, const Problem& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  return out;
}

}  // namespace hw::arcus::language
