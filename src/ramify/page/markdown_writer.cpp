#include "ramify/page/markdown_writer.hpp"

#include <cctype>
#include <string_view>

#include <fmt/format.h>

namespace ramify {
namespace {

/// Whether the character at a place means something to Markdown. An underscore within a word does not.
bool is_markup(std::string_view text, std::size_t at) {
  const auto is_letter = [&](std::size_t place) {
    return place < text.size() && std::isalnum(static_cast<unsigned char>(text[place])) != 0;
  };
  if (text[at] == '_') return at == 0 || !is_letter(at - 1) || !is_letter(at + 1);
  return std::string_view("\\`*[]<>|~&").find(text[at]) != std::string_view::npos ||
         (at == 0 && text[at] == '#');
}

/// A text that Markdown shows as it stands, in one line.
std::string markdown_text(std::string_view text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (is_markup(text, at)) escaped += '\\';
    escaped += static_cast<unsigned char>(text[at]) < 0x20 ? ' ' : text[at];
  }
  return escaped;
}

class MarkdownWriter {
 public:
  std::string document(const Page& page) {
    heading(1, page.title);
    add(page.lead);
    for (const PageSection& section : page.sections) add(section, 2);
    if (!page.colophon.empty()) {
      text_ += "---\n\n";
      add(page.colophon);
    }
    text_.pop_back();  // every block ends with an empty line, the file with none
    return std::move(text_);
  }

  void operator()(const PageParagraph& paragraph) { text_ += markdown_text(paragraph.text) + "\n\n"; }

  void operator()(const PageList& list) {
    for (const auto& item : list.items) text_ += fmt::format("- {}\n", markdown_text(item));
    text_ += '\n';
  }

  void operator()(const PageTable& table) {
    text_ += markdown_text(table.caption) + "\n\n";
    std::string rule = "|";
    text_ += '|';
    for (const auto& column : table.table.columns()) {
      text_ += fmt::format(" {} |", markdown_text(column));
      rule += " --- |";
    }
    text_ += fmt::format("\n{}\n", rule);
    for (std::size_t r = 0; r < table.table.rows(); ++r) {
      text_ += '|';
      for (const Field& field : table.table.row(r))
        text_ += fmt::format(" {} |", markdown_text(to_text(field)));
      text_ += '\n';
    }
    text_ += '\n';
  }

  void operator()(const PagePicture& picture) {
    text_ += fmt::format("*Picture:* {} ({})\n\n", markdown_text(picture.caption),
                         markdown_text(picture.alternative));
  }

  void operator()(const PageThumbnail& picture) {
    text_ += fmt::format("[![{}]({})]({})\n\n{}\n\n", markdown_text(picture.alternative), picture.file,
                         picture.leads_to, markdown_text(picture.caption));
  }

  void operator()(const PageCommands& commands) {
    for (const auto& line : commands.lines) add_indented(line);
    text_ += '\n';
  }

  void operator()(const PageVerbatim& verbatim) {
    text_ += fmt::format("{}:\n\n", markdown_text(verbatim.label));
    add_indented(verbatim.text);
    text_ += '\n';
  }

 private:
  void add_indented(std::string_view lines) {
    text_ += "    ";
    for (const char c : lines) text_ += c == '\n' ? "\n    " : std::string(1, c);
    text_ += '\n';
  }

  void heading(std::size_t level, std::string_view text) {
    text_ += fmt::format("{} {}\n\n", std::string(level, '#'), markdown_text(text));
  }

  void add(const std::vector<PageBlock>& blocks) {
    for (const PageBlock& block : blocks) std::visit(*this, block);
  }

  void add(const PageSection& section, std::size_t level) {
    heading(level, section.heading);
    add(section.blocks);
    for (const PageSection& part : section.parts) add(part, level + 1);
  }

  std::string text_;
};

}  // namespace

std::string write_markdown(const Page& page) {
  return MarkdownWriter().document(page);
}

}  // namespace ramify
