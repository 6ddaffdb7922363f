#include "core/device/text_remarks.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace hw {

std::size_t TextRemarks::go_to(std::size_t place) { return std::exchange(from_, place); }

template <class Take>
void TextRemarks::each_before(std::size_t place, Take take) {
  const auto first = std::lower_bound(all_.begin(), all_.end(), from_,
                                      [](const Remark& r, std::size_t from) { return r.at.begin < from; });
  for (auto remark = first; remark != all_.end() && remark->at.begin < place; ++remark)
    if (!std::exchange(remark->seen, true)) take(*remark);
  from_ = std::max(from_, place);
}

void TextRemarks::read_before(std::size_t place, ReadSteps& list) {
  each_before(place, [&](const Remark& remark) {
    if (remark.behind) {
      ++unshown_;
      return;
    }
    std::string_view words = text_.substr(remark.at.begin, remark.at.end - remark.at.begin);
    words.remove_prefix(1);
    if (words.starts_with(' ')) words.remove_prefix(1);
    while (words.ends_with('\r') || words.ends_with(' ')) words.remove_suffix(1);
    auto* before = list.empty() ? nullptr : std::get_if<sequence::Comment>(&list.back().body);
    if (before && line_of(text_, list.back().at.end) + 1 == line_of(text_, remark.at.begin))
      before->text.append("\n").append(words), list.back().at.end = remark.at.end;
    else if (!words.empty())
      list.push_back({sequence::Comment{std::string(words)}, remark.at});
  });
}

void TextRemarks::pass(const ReadStep& step) {
  const bool own = std::holds_alternative<sequence::Custom>(step.body);
  each_before(step.at.end, [&](const Remark&) { unshown_ += own ? 0 : 1; });
}

void TextRemarks::finish(ReadText& read) {
  from_ = 0;
  read_before(text_.size() + 1, read.steps);
  if (unshown_ > 0)
    read.remarks.push_back(unshown_ == 1 ? "A remark after a command is not shown."
                                         : fmt::format("{} remarks after commands are not shown.", unshown_));
}

}  // namespace hw
