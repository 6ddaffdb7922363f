// The editor and the file dialog by hand and key.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "gui/widgets/button.h"
#include "gui/widgets/code_editor.h"
#include "gui/widgets/file_dialog.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

struct Bench {
  CodeEditor editor;
  EditorLook look;
  int edits = 0;
  Stage stage{in_window([this](Ui& ui) {
                look.height = 300;
                edits += editor.draw(ui, "program/text", look).edited;
                button(ui, "other", "Other");
              }),
              800, 500};
  explicit Bench(std::string_view text = {}) {
    editor.load(text);
    stage.frames(2);
  }
};

TEST(CodeEditor, TypesAtTheEnd) {
  Bench b;
  ASSERT_TRUE(b.stage.hand.type("program/text", "S1M2000\nI1M400\n"));
  EXPECT_EQ(b.editor.text(), "S1M2000\nI1M400\n");
  EXPECT_EQ(*b.stage.hand.value("program/text"), "S1M2000\nI1M400\n");
  EXPECT_GT(b.edits, 0);
  ASSERT_TRUE(b.stage.hand.type("program/text", "R"));
  EXPECT_EQ(b.editor.text(), "S1M2000\nI1M400\nR");
}

TEST(CodeEditor, KeysEdit) {
  Bench b("one\ntwo");
  ASSERT_TRUE(b.stage.hand.click("program/text"));
  for (const char* key : {"Ctrl+Home", "Shift+Down", "Delete"}) ASSERT_TRUE(b.stage.hand.key(key));
  EXPECT_EQ(b.editor.text(), "two");
  ASSERT_TRUE(b.stage.hand.key("Ctrl+Z"));
  EXPECT_EQ(b.editor.text(), "one\ntwo");
  ASSERT_TRUE(b.stage.hand.key("Ctrl+Y"));
  EXPECT_EQ(b.editor.text(), "two");
  ASSERT_TRUE(b.stage.hand.key("Ctrl+/"));
  EXPECT_EQ(b.editor.text(), "; two");
  for (const char* key : {"Ctrl+A", "Ctrl+X"}) ASSERT_TRUE(b.stage.hand.key(key));
  EXPECT_EQ(b.editor.text(), "");
  for (const char* key : {"Ctrl+V", "Ctrl+V"}) ASSERT_TRUE(b.stage.hand.key(key));
  EXPECT_EQ(b.editor.text(), "; two; two");
  ASSERT_TRUE(b.stage.hand.key("Ctrl+]"));
  EXPECT_EQ(b.editor.text(), "  ; two; two");
  ASSERT_TRUE(b.stage.hand.key("Ctrl+["));
  EXPECT_EQ(b.editor.text(), "; two; two");
}

TEST(CodeEditor, TabLeavesItAndShiftTabComesBack) {
  Bench b("one\ntwo");
  const auto focused = [&](const char* id) { return b.stage.surface.screen().focus().is(id); };
  ASSERT_TRUE(b.stage.hand.click("program/text"));
  ASSERT_TRUE(b.stage.hand.key("Tab"));
  EXPECT_TRUE(focused("other"));
  EXPECT_EQ(b.editor.text(), "one\ntwo");
  ASSERT_TRUE(b.stage.hand.key("Shift+Tab"));
  EXPECT_TRUE(focused("program/text"));
  b.stage.push(InputEvent::text('x', b.stage.now_s));
  b.stage.frames(3);
  EXPECT_NE(b.editor.text().find('x'), std::string::npos) << "and types on";
  ASSERT_TRUE(b.stage.hand.key("Shift+Tab"));
  EXPECT_FALSE(focused("program/text"));
}

TEST(CodeEditor, TabMovesTheLinesThatAreChosen) {
  Bench b("one\ntwo");
  ASSERT_TRUE(b.stage.hand.click("program/text"));
  for (const char* key : {"Ctrl+A", "Tab"}) ASSERT_TRUE(b.stage.hand.key(key));
  EXPECT_EQ(b.editor.text(), "  one\n  two");
  ASSERT_TRUE(b.stage.hand.key("Shift+Tab"));
  EXPECT_EQ(b.editor.text(), "one\ntwo");
  EXPECT_TRUE(b.stage.surface.screen().focus().is("program/text"));
  b.look.read_only = "It runs.";
  b.stage.frames(1);
  ASSERT_TRUE(b.stage.hand.key("Tab"));
  EXPECT_EQ(b.editor.text(), "one\ntwo");
  EXPECT_TRUE(b.stage.surface.screen().focus().is("other")) << "there is nothing to move";
}

TEST(CodeEditor, ArrowsMoveTheCaretAndJogNothing) {
  Bench b("abc");
  int jogs = 0;
  b.stage.surface.screen().keyboard().on_edge = [&](const CommandEdge&) { ++jogs; };
  ASSERT_TRUE(b.stage.hand.click("program/text"));
  ASSERT_TRUE(b.stage.hand.key("Ctrl+Home"));
  ASSERT_TRUE(b.stage.hand.key("Right"));
  EXPECT_EQ(b.editor.model().caret(), (TextPlace{0, 1}));
  EXPECT_EQ(jogs, 0);
  ASSERT_TRUE(b.stage.hand.click("other"));
  ASSERT_TRUE(b.stage.hand.key("Right"));
  EXPECT_EQ(b.editor.model().caret(), (TextPlace{0, 1}));
  EXPECT_EQ(jogs, 2) << "down and up of a jog key";
}

TEST(CodeEditor, MouseSelects) {
  Bench b("I1M400\nI2M800");
  const Rect r = b.stage.find("program/text")->rect;
  const float advance = 8.4f;
  const ImVec2 begin(r.min.x + 64 + 2 * advance, r.min.y + 14), end(r.min.x + 64 + 4 * advance, r.min.y + 38);
  b.stage.push(InputEvent::mouse_move(begin.x, begin.y, 0));
  b.stage.frames(2);
  b.stage.push(InputEvent::mouse_button(0, true, begin, 0));
  b.stage.frames(1);
  b.stage.push(InputEvent::mouse_move(end.x, end.y, 0));
  b.stage.frames(2);
  b.stage.push(InputEvent::mouse_button(0, false, end, 0));
  b.stage.frames(2);
  EXPECT_EQ(b.editor.model().selected(), "M400\nI2M8");
}

TEST(CodeEditor, ReadOnlyStaysAsItIs) {
  Bench b("I1M400");
  b.look.read_only = "It runs.";
  ASSERT_TRUE(b.stage.hand.type("program/text", "x\n"));
  for (const char* key : {"Backspace", "Delete", "Ctrl+X", "Ctrl+/"}) ASSERT_TRUE(b.stage.hand.key(key));
  EXPECT_EQ(b.editor.text(), "I1M400");
}

TEST(CodeEditor, AProblemShowsItsSentenceAndItsMend) {
  ProgramReport report;
  report.lines.resize(2);
  Problem p;
  p.line = 1;
  p.column = 3;
  p.length = 4;
  p.sentence = "8000 is too fast.";
  p.fix_label = "Use 6000";
  p.fix_text = "6000";
  report.problems.push_back(p);
  Bench b("S1M2000\nS2M8000");
  b.look.report = &report;
  b.stage.frames(2);
  EXPECT_EQ(*b.stage.hand.value("program/problem/1"), "8000 is too fast.");
  ASSERT_TRUE(b.stage.hand.click("program/problem/1/fix"));
  EXPECT_EQ(b.editor.text(), "S1M2000\nS2M6000");
  EXPECT_EQ(b.edits, 1);
}

TEST(CodeEditor, Finds) {
  Bench b("one\ntwo one\nthree");
  ASSERT_TRUE(b.stage.hand.click("program/text"));
  ASSERT_TRUE(b.stage.hand.key("Ctrl+F"));
  ASSERT_TRUE(b.stage.hand.exists("program/text/find"));
  ASSERT_TRUE(b.stage.hand.type("program/text/find", "one"));
  EXPECT_EQ(b.editor.model().selected(), "one");
  const TextPlace first = b.editor.model().selection().begin;
  ASSERT_TRUE(b.stage.hand.key("Enter"));
  EXPECT_NE(b.editor.model().selection().begin, first);
  ASSERT_TRUE(b.stage.hand.key("Escape"));
  EXPECT_FALSE(b.stage.hand.exists("program/text/find"));
  EXPECT_EQ(b.editor.text(), "one\ntwo one\nthree");
}

class Folder {
 public:
  Folder() : path(std::filesystem::path(HW_BINARY_DIR) / ("file-dialog-test-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path / "sub");
    for (const char* name : {"a.vxm", "b.vxm", "notes.txt", "sub/c.vxm"}) std::ofstream(path / name) << "R\n";
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

struct Asked {
  Folder folder;
  FileDialog dialog;
  std::optional<std::filesystem::path> chosen;
  Stage stage{in_window([this](Ui& ui) {
    if (auto path = dialog.draw(ui)) chosen = path;
  })};
};

TEST(FileDialog, OpensByClickAndShowsItsSuffixOnly) {
  Asked a;
  a.dialog.ask_open("Open a program", a.folder.path, {".vxm"});
  a.stage.frames(4);
  EXPECT_FALSE(a.stage.hand.exists("file/notes.txt"));
  ASSERT_TRUE(a.stage.hand.click("file/all"));
  EXPECT_TRUE(a.stage.hand.exists("file/notes.txt"));
  ASSERT_TRUE(a.stage.hand.click("file/b.vxm"));
  ASSERT_TRUE(a.stage.hand.click("file/open"));
  ASSERT_TRUE(a.chosen);
  EXPECT_EQ(*a.chosen, a.folder.path / "b.vxm");
  EXPECT_FALSE(a.dialog.is_open());
}

TEST(FileDialog, OpensByPathAndReportsAMissingFile) {
  Asked a;
  a.dialog.ask_open("Open a program", a.folder.path);
  a.stage.frames(4);
  ASSERT_TRUE(a.stage.hand.type("file/path", (a.folder.path / "none.vxm").string() + "\n"));
  EXPECT_FALSE(a.chosen);
  EXPECT_NE(a.stage.hand.value("file/sentence")->find("There is no file"), std::string::npos);
  ASSERT_TRUE(a.stage.hand.type("file/path", (a.folder.path / "sub").string() + "\n"));
  EXPECT_TRUE(a.stage.hand.exists("file/c.vxm")) << "a folder is entered";
  ASSERT_TRUE(a.stage.hand.type("file/path", (a.folder.path / "a.v").string()));
  ASSERT_TRUE(a.stage.hand.key("Tab"));
  EXPECT_EQ(*a.stage.hand.value("file/path"), (a.folder.path / "a.vxm").string()) << "Tab completes";
  ASSERT_TRUE(a.stage.hand.key("Enter"));
  ASSERT_TRUE(a.chosen);
}

TEST(FileDialog, SavingOverAFileAsksOnce) {
  Asked a;
  a.dialog.ask_save("Save the program", a.folder.path / "a", {".vxm"});
  a.stage.frames(4);
  ASSERT_TRUE(a.stage.hand.click("file/save"));
  EXPECT_FALSE(a.chosen);
  EXPECT_NE(a.stage.hand.value("file/sentence")->find("exists already"), std::string::npos);
  ASSERT_TRUE(a.stage.hand.click("file/save"));
  ASSERT_TRUE(a.chosen);
  EXPECT_EQ(*a.chosen, a.folder.path / "a.vxm");
}

TEST(FileDialog, EscCloses) {
  Asked a;
  a.dialog.ask_open("Open", a.folder.path);
  a.stage.frames(4);
  ASSERT_TRUE(a.stage.hand.key("Escape"));
  EXPECT_FALSE(a.dialog.is_open());
  EXPECT_FALSE(a.chosen);
}

}  // namespace
}  // namespace hw::gui
