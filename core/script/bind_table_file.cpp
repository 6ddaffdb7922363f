// `hw.write_csv`: writes a script's results as a table for spreadsheets.
#include <cmath>

#include <fmt/core.h>

#include "core/script/bind.h"
#include "core/script/sandbox.h"
#include "core/script/script_files.h"
#include "core/session/user_files.h"

namespace hw::script {
namespace {

constexpr std::size_t most_rows = 1'000'000, most_cells = 10'000;

std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? std::string("\"\"") : std::string(1, c);
  return all + '"';
}

/// The value on top. Pops it.
std::string cell_of(lua_State* L, std::size_t row) {
  std::string cell;
  switch (lua_type(L, -1)) {
    case LUA_TNIL: break;
    case LUA_TBOOLEAN: cell = lua_toboolean(L, -1) ? "true" : "false"; break;
    case LUA_TNUMBER:
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* text = lua_tolstring(L, -1, &length);
      cell = quoted({text, length});
      break;
    }
    default: throw Misuse(fmt::format("hw.write_csv: row {} holds a {}", row, luaL_typename(L, -1)));
  }
  lua_pop(L, 1);
  return cell;
}

/// Converts the list on top of the stack, up to its length, and pops it.
std::string line_of(lua_State* L, std::size_t row) {
  if (!lua_istable(L, -1))
    throw Misuse(fmt::format("hw.write_csv: row {} must be a list like {{1, 2}}", row));
  const std::size_t cells = lua_rawlen(L, -1);
  if (cells > most_cells) throw Misuse(fmt::format("hw.write_csv: row {} is too long", row));
  std::string line;
  for (std::size_t i = 1; i <= cells; ++i) {
    lua_rawgeti(L, -1, static_cast<lua_Integer>(i));
    line += (i > 1 ? "," : "") + cell_of(L, row);
  }
  lua_pop(L, 1);
  return line + "\n";
}

int write_csv(Call& call) {
  const std::string folder = folder_of(call.runner().options().path);
  const auto path = file_of_script(folder, call.text(1, "file"), ".csv");
  const int rows = call.place(2);
  if (!lua_istable(call.L, rows))
    throw Misuse("hw.write_csv: argument 2 must be a list of rows like {{1, 2}}");
  const std::size_t count = lua_rawlen(call.L, rows);
  if (count > most_rows) throw Misuse("hw.write_csv: too many rows");
  std::string text;
  for (std::size_t row = 1; row <= count; ++row) {
    lua_rawgeti(call.L, rows, static_cast<lua_Integer>(row));
    text += line_of(call.L, row);
  }
  if (!path) return push_refusal(call.L, refusal_of(path.error()));
  if (const auto written = write_file(*path, text); !written)
    return push_refusal(call.L, refusal_of(not_written_beside(folder, written.error())));
  call.runner().notes().written.note(*path, fmt::format("{} row{}", count, count == 1 ? "" : "s"));
  return call.yes();
}

constexpr Function file_table[] = {{"write_csv", write_csv}};

}  // namespace

std::span<const Function> file_functions() { return file_table; }

}  // namespace hw::script
