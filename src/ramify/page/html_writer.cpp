#include "ramify/page/html_writer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/page/html_style.hpp"
#include "ramify/page/html_table.hpp"
#include "ramify/page/inline_svg.hpp"

namespace ramify {
namespace {

class HtmlWriter {
 public:
  std::string document(const Page& page) {
    add_body(page);  // first: the style says which filters there are
    return fmt::format(
               "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<title>{}</title>\n<style>\n{}</style>\n</head>\n",
               html_text(page.title), detail::page_style(reach_)) +
           text_ + "</html>\n";
  }

  void operator()(const PageParagraph& paragraph) {
    text_ += fmt::format("<p>{}</p>\n", html_text(paragraph.text));
  }

  void operator()(const PageList& list) {
    text_ += "<ul>\n";
    for (const auto& item : list.items) text_ += fmt::format("<li>{}</li>\n", html_text(item));
    text_ += "</ul>\n";
  }

  void operator()(const PageTable& table) {
    const detail::HtmlTable html(table, ++tables_);
    reach_.filters = std::max(reach_.filters, html.reach().filters);
    reach_.values = std::max(reach_.values, html.reach().values);
    text_ += html.text();
  }

  void operator()(const PagePicture& picture) {
    text_ += "<figure>\n" + detail::wide_box(picture.caption);
    text_ += fmt::format("<div role=\"img\" aria-label=\"{}\">\n{}\n</div>\n</div>\n",
                         html_text(picture.alternative),
                         inline_svg(picture.svg, fmt::format("picture{}-", ++pictures_)));
    text_ += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", html_text(picture.caption));
  }

  void operator()(const PageThumbnail& picture) {
    text_ +=
        fmt::format("<figure>\n<a href=\"{}\"><img src=\"{}\" alt=\"{}\"></a>\n", html_text(picture.leads_to),
                    html_text(picture.file), html_text(picture.alternative));
    text_ += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", html_text(picture.caption));
  }

  void operator()(const PageCommands& commands) {
    std::string lines;
    for (const auto& line : commands.lines) lines += line + '\n';
    add_verbatim("Commands", lines);
  }

  void operator()(const PageVerbatim& verbatim) { add_verbatim(verbatim.label, verbatim.text); }

 private:
  void add_body(const Page& page) {
    text_ = fmt::format("<body>\n<header>\n<h1>{}</h1>\n", html_text(page.title));
    add(page.lead);
    text_ += "</header>\n";
    add_contents(page);
    text_ += "<main>\n";
    for (const PageSection& section : page.sections) add(section, 2);
    text_ += "</main>\n";
    if (!page.colophon.empty()) {
      text_ += "<footer>\n";
      add(page.colophon);
      text_ += "</footer>\n";
    }
    text_ += "</body>\n";
  }

  void add_verbatim(std::string_view label, std::string_view text) {
    text_ += detail::wide_box(label) + fmt::format("<pre><code>{}</code></pre>\n</div>\n", html_text(text));
  }

  void add(const std::vector<PageBlock>& blocks) {
    for (const PageBlock& block : blocks) std::visit(*this, block);
  }

  static std::string anchor_of(const PageSection& section, int number) {
    return section.anchor.empty() ? fmt::format("section{}", number) : section.anchor;
  }

  void add(const PageSection& section, int level) {
    RAMIFY_EXPECTS(level <= 5);
    text_ += fmt::format("<section aria-labelledby=\"{0}\">\n<h{1} id=\"{0}\">{2}</h{1}>\n",
                         html_text(anchor_of(section, ++sections_)), level, html_text(section.heading));
    add(section.blocks);
    for (const PageSection& part : section.parts) add(part, level + 1);
    text_ += "</section>\n";
  }

  static int sections_of(const PageSection& section) {
    int count = 1;
    for (const PageSection& part : section.parts) count += sections_of(part);
    return count;
  }

  /// Links to the sections, as they will be numbered.
  void add_contents(const Page& page) {
    if (page.sections.size() < 2) return;
    text_ += "<nav aria-label=\"Contents\">\n<ul>\n";
    int number = 1;
    for (const PageSection& section : page.sections) {
      text_ += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", html_text(anchor_of(section, number)),
                           html_text(section.label.empty() ? section.heading : section.label));
      number += sections_of(section);
    }
    text_ += "</ul>\n</nav>\n";
  }

  std::string text_;
  detail::FilterReach reach_;
  int sections_ = 0, pictures_ = 0, tables_ = 0;
};

}  // namespace

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
          escaped += "\ufffd";
        else
          escaped += c;
    }
  }
  return escaped;
}

std::string write_html(const Page& page) {
  return HtmlWriter().document(page);
}

}  // namespace ramify
