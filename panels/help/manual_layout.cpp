#include "panels/help/manual_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;

namespace {

/// The default style of a line.
struct ManualType {
  Face plain = Face::body, strong = Face::body_bold;
  Tone tone = Tone::ink2;
};
constexpr ManualType of_words, of_cells{Face::small, Face::small_bold, Tone::ink2},
    of_titles{Face::small_bold, Face::small_bold, Tone::ink};

/// A word, or the part of it in one style.
struct ManualWord {
  std::string_view text;
  Face face;
  Tone tone;
  int link;
  float width, space;  ///< before it; 0: joined to the previous word
};

class ManualSetter {
 public:
  ManualSetter(const Ui& ui, ManualLayout& out) : ui_(ui), out_(out) {}

  void set(const ManualBlock& block) {
    switch (block.kind) {
      case BlockKind::heading: return set_heading(block);
      case BlockKind::paragraph: space(8); return set_line(block.line, of_words, 0, out_.width);
      case BlockKind::item: return set_item(block);
      case BlockKind::code: return set_code(block);
      case BlockKind::table: return set_table(block);
      case BlockKind::picture: space(8); return set_line(block.line, of_cells, 0, out_.width);
    }
  }
  [[nodiscard]] float end() const { return y_; }

 private:
  void space(float logical) { y_ += y_ > 0 ? ui_.px(logical) : 0; }

  void set_heading(const ManualBlock& block) {
    const bool first = block.level == 1;
    space(first ? 8 : 20);
    if (block.level == 2 && y_ > 0) {
      out_.hairlines.push_back(y_);
      y_ += ui_.px(12);
    }
    out_.marks.push_back({block.mark, block.line.empty() ? std::string_view() : block.line[0].text, y_});
    const Face face = block.level <= 2 ? Face::title_bold : Face::body_bold;
    set_line(block.line, {face, face, Tone::ink}, 0, out_.width);
    if (first) y_ += ui_.px(4);
  }

  void set_item(const ManualBlock& block) {
    const float left = ui_.px(20 * static_cast<float>(block.level));
    const float words = left + ui_.px(20);
    space(4);
    out_.runs.push_back({left, y_, 0, Face::body, Tone::ink3, block.mark});
    set_line(block.line, of_words, words, out_.width);
  }

  void set_code(const ManualBlock& block) {
    constexpr Face face = Face::code_time;
    space(8);
    const float inset = ui_.px(8), row = ui_.px(18), top = y_;
    y_ += ui_.px(6);
    for (const std::string& line : block.code) {
      std::string_view rest = line;
      float x = inset;
      do {  // a longer line continues in the next row, indented
        const std::size_t fits = code_fit(rest, face, out_.width - inset - x);
        out_.runs.push_back({x, y_, 0, face, Tone::ink, rest.substr(0, fits)});
        rest = rest.substr(fits);
        x = inset + ui_.px(16);
        y_ += row;
      } while (!rest.empty());
    }
    y_ += ui_.px(6);
    out_.wells.push_back({ImVec2(0, top), ImVec2(out_.width, y_)});
  }

  /// Length of a line of code that fits; breaks at a blank if one is near.
  std::size_t code_fit(std::string_view line, Face face, float room) const {
    const std::size_t fits = std::max<std::size_t>(text_fit(ui_, face, line, room), 1);
    if (fits >= line.size()) return line.size();
    const std::size_t blank = line.rfind(' ', fits);
    return blank != line.npos && blank > fits / 2 ? blank + 1 : fits;
  }

  // ---- tables

  void set_table(const ManualBlock& block) {
    if (block.rows.empty()) return;
    space(8);
    const std::vector<float> widths = widths_of(block);
    if (widths.empty()) return set_stacked(block);
    for (const auto& row : block.rows) {
      const float top = y_;
      float x = 0, bottom = y_;
      for (std::size_t c = 0; c < row.size() && c < widths.size(); ++c) {
        y_ = top + ui_.px(4);
        set_line(row[c], &row == &block.rows.front() ? of_titles : of_cells, x, x + widths[c]);
        bottom = std::max(bottom, y_);
        x += widths[c] + gutter();
      }
      y_ = bottom + ui_.px(4);
      out_.hairlines.push_back(y_);
    }
    std::stable_sort(out_.runs.begin(), out_.runs.end(),
                     [](const ManualRun& a, const ManualRun& b) { return a.y < b.y; });
  }

  /// Sets each row of the table as a paragraph, because the columns do not fit side by side.
  void set_stacked(const ManualBlock& block) {
    for (std::size_t r = 1; r < block.rows.size(); ++r) {
      const auto& row = block.rows[r];
      out_.hairlines.push_back(y_);
      y_ += ui_.px(4);
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (row[c].empty()) continue;
        const ManualType type{Face::small, Face::small_bold, c == 0 ? Tone::ink : Tone::ink2};
        set_line(row[c], type, c == 0 ? 0 : ui_.px(12), out_.width);
      }
      y_ += ui_.px(4);
    }
  }

  [[nodiscard]] float gutter() const { return ui_.px(12); }

  /// Column widths in pixels: each at least its longest word, the rest in proportion to the text. Empty: the
  /// columns do not fit.
  std::vector<float> widths_of(const ManualBlock& block) {
    std::vector<float> least, wanted;
    for (const auto& row : block.rows)
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (c >= least.size()) least.push_back(0), wanted.push_back(0);
        const auto [longest, all] = measure(row[c], &row == &block.rows.front() ? of_titles : of_cells);
        least[c] = std::max(least[c], longest);
        wanted[c] = std::max(wanted[c], all);
      }
    const float room = out_.width - gutter() * static_cast<float>(least.size() - 1);
    const float taken = std::accumulate(least.begin(), least.end(), 0.0f);
    if (taken > room) return {};
    float request = 0;
    for (std::size_t c = 0; c < least.size(); ++c) request += wanted[c] - least[c];
    const float share = request > 0 ? std::min(1.0f, (room - taken) / request) : 0;
    for (std::size_t c = 0; c < least.size(); ++c)
      least[c] = std::floor(least[c] + share * (wanted[c] - least[c])) + 1;
    return least;
  }

  struct Measure {
    float longest = 0, all = 0;
  };
  Measure measure(const ManualLine& line, const ManualType& type) {
    Measure m;
    float word = 0;
    const std::size_t links = out_.links.size();
    const std::vector<ManualWord>& words = words_of(line, type);
    out_.links.resize(links);  // links are numbered when they are set
    for (const ManualWord& w : words) {
      word = w.space > 0 ? w.width : word + w.width;
      m.longest = std::max(m.longest, word);
      m.all += w.space + w.width;
    }
    m.longest = std::ceil(m.longest), m.all = std::ceil(m.all);
    return m;
  }

  // ---- lines

  void set_line(const ManualLine& line, const ManualType& type, float left, float right) {
    const std::vector<ManualWord>& words = words_of(line, type);
    const float row = ui_.line(type.plain);
    row_ = row;
    float x = left;
    for (std::size_t i = 0; i < words.size();) {
      std::size_t end = i + 1;  // end of the words that must stay together
      float width = words[i].width;
      while (end < words.size() && words[end].space == 0) width += words[end++].width;
      if (x > left && x + words[i].space + width > right) x = left, y_ += row;
      if (x > left) x += words[i].space;
      for (; i < end; ++i) x = put(words[i], x, left, right, row);
    }
    y_ += row;
  }

  /// Places a word. A word that is too long for a line continues on the next line. Returns its right end.
  float put(const ManualWord& word, float x, float left, float right, float row) {
    std::string_view rest = word.text;
    float width = word.width;
    while (x + width > right + 0.5f && rest.size() > 1) {
      if (x > left && width <= right - left) {
        x = left, y_ += row;
        break;
      }
      const std::size_t fits =
          std::clamp<std::size_t>(text_fit(ui_, word.face, rest, right - x), 1, rest.size());
      add(word, x, text_width(ui_, word.face, rest.substr(0, fits)), rest.substr(0, fits));
      rest = rest.substr(fits);
      width = text_width(ui_, word.face, rest);
      x = left, y_ += row;
    }
    if (rest.empty()) return x;
    if (!goes_on(word, x, rest)) add(word, x, width, rest);
    return x + width;
  }

  /// Top of a face in the row. Faces of different height are centred.
  [[nodiscard]] float top_of(Face face) const { return y_ + std::floor((row_ - ui_.line(face)) / 2); }

  void add(const ManualWord& word, float x, float width, std::string_view text) {
    const bool begins = word.link >= 0 && word.link != last_link_;
    out_.runs.push_back({x, top_of(word.face), width, word.face, word.tone, text, word.link, begins});
    last_link_ = word.link;
  }

  /// Whether the word continues the last run: adjacent words in the same style form one run.
  bool goes_on(const ManualWord& word, float x, std::string_view rest) {
    if (out_.runs.empty()) return false;
    ManualRun& last = out_.runs.back();
    const char* end = last.text.data() + last.text.size();
    if (last.y != top_of(word.face) || last.face != word.face || last.tone != word.tone ||
        last.link != word.link || end + 1 != rest.data() || *end != ' ')
      return false;
    last.text = {last.text.data(), last.text.size() + 1 + rest.size()};
    last.width = x + text_width(ui_, word.face, rest) - last.x;
    return true;
  }

  const std::vector<ManualWord>& words_of(const ManualLine& line, const ManualType& type) {
    words_.clear();
    float space = 0;  // as wide as in the span that contains it
    for (const ManualSpan& span : line) {
      const bool code = span.kind == SpanKind::code, link = span.kind == SpanKind::link;
      const bool strong = span.kind == SpanKind::strong;
      const bool small = type.plain == Face::small;
      const Face face = code     ? (small ? Face::code_time : Face::code_field)
                        : strong ? type.strong
                                 : type.plain;
      const Tone tone = code || link || strong ? Tone::ink : type.tone;
      const int number = link ? link_number(span.target) : -1;
      std::string_view rest = span.text;
      while (!rest.empty()) {
        const std::size_t blank = rest.find(' ');
        if (blank == 0) {
          space = text_width(ui_, face, " ");
          rest.remove_prefix(1);
          continue;
        }
        const std::string_view word = rest.substr(0, blank);
        words_.push_back({word, face, tone, number, text_width(ui_, face, word), space});
        space = 0;
        rest.remove_prefix(word.size());
      }
    }
    return words_;
  }

  /// The number of a link. Each link of the page has a number of its own.
  int link_number(std::string_view target) {
    out_.links.push_back(target);
    return static_cast<int>(out_.links.size()) - 1;
  }

  const Ui& ui_;
  ManualLayout& out_;
  std::vector<ManualWord> words_;
  float y_ = 0, row_ = 0;
  int last_link_ = -1;
};

}  // namespace

ManualLayout lay_out_manual(const Ui& ui, const ManualText& text, float width_px) {
  ManualLayout out;
  out.width = width_px;
  out.scale = ui.scale;
  ManualSetter setter(ui, out);
  for (const ManualBlock& block : text.blocks) setter.set(block);
  out.height = setter.end();
  return out;
}

}  // namespace hw::panels
