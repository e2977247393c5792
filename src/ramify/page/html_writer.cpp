#include "ramify/page/html_writer.hpp"

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/page/inline_svg.hpp"
#include "ramify/page/palette.hpp"

namespace ramify {
namespace {

std::string colours(const PagePalette& palette) {
  return fmt::format("--text:{};--muted:{};--link:{};--back:{};--soft:{};--rule:{}", palette.text,
                     palette.muted, palette.link, palette.back, palette.soft, palette.rule);
}

std::string style() {
  return fmt::format(":root{{color-scheme:light dark;{}}}\n", colours(light_palette)) +
         fmt::format("@media (prefers-color-scheme:dark){{:root{{{}}}}}\n", colours(dark_palette)) +
         // Pictures are drawn on white and stay so.
         R"(*{box-sizing:border-box}
body{margin:0;background:var(--back);color:var(--text);font:1rem/1.55 system-ui,sans-serif}
header,nav,main,footer{max-width:64rem;margin:0 auto;padding:0 1.25rem}
header{padding-top:1.5rem}
h1{font-size:1.7rem;line-height:1.2;margin:0 0 .5rem;overflow-wrap:anywhere}
h2{font-size:1.3rem;margin:2.2rem 0 .6rem;padding-top:.9rem;border-top:1px solid var(--rule);overflow-wrap:anywhere}
h3{font-size:1.08rem;margin:1.6rem 0 .4rem}
h4,h5{font-size:1rem;margin:1.2rem 0 .3rem}
p,ul{margin:.5rem 0;max-width:46rem;overflow-wrap:anywhere}
nav ul{list-style:none;padding:0;display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;max-width:none}
a{color:var(--link)}
.wide{overflow-x:auto;margin:.8rem 0}
:focus-visible{outline:2px solid var(--link);outline-offset:2px}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
caption{text-align:left;color:var(--muted);padding:.2rem 0}
th,td{padding:.28rem .8rem;border-bottom:1px solid var(--rule);text-align:left;vertical-align:top}
th{background:var(--soft);font-weight:600}
.number{text-align:right;white-space:nowrap}
figure{margin:1rem 0}
figure .wide{background:#fff;border:1px solid var(--rule);border-radius:4px;margin:0}
svg{display:block;width:100%;min-width:34rem;max-width:62rem;height:auto}
figcaption,footer{color:var(--muted)}
pre{width:max-content;min-width:100%;margin:0;background:var(--soft);border-radius:4px;padding:.6rem .9rem;font-size:.9rem}
footer{margin-top:2.5rem;padding-top:.8rem;padding-bottom:2rem;border-top:1px solid var(--rule)}
)";
}

class HtmlWriter {
 public:
  std::string document(const Page& page) {
    text_ = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<header>\n<h1>{0}</h1>\n",
        html_text(page.title), style());
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
    return text_ + "</body>\n</html>\n";
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
    open_wide(table.caption);
    text_ += fmt::format("<table>\n<caption>{}</caption>\n<thead><tr>", html_text(table.caption));
    std::vector<std::string_view> kinds;
    for (std::size_t c = 0; c < table.table.columns().size(); ++c) {
      kinds.emplace_back(table.table.holds_numbers(c) ? " class=\"number\"" : "");
      text_ += fmt::format("<th scope=\"col\"{}>{}</th>", kinds[c], html_text(table.table.columns()[c]));
    }
    text_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < table.table.rows(); ++r) {
      text_ += "<tr>";
      for (std::size_t c = 0; c < kinds.size(); ++c)
        text_ += fmt::format("<td{}>{}</td>", kinds[c], html_text(to_text(table.table.row(r)[c])));
      text_ += "</tr>\n";
    }
    text_ += "</tbody>\n</table>\n</div>\n";
  }

  void operator()(const PagePicture& picture) {
    text_ += "<figure>\n";
    open_wide(picture.caption);
    text_ += fmt::format("<div role=\"img\" aria-label=\"{}\">\n{}\n</div>\n</div>\n",
                         html_text(picture.alternative),
                         inline_svg(picture.svg, fmt::format("picture{}-", ++pictures_)));
    text_ += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", html_text(picture.caption));
  }

  void operator()(const PageCommands& commands) {
    open_wide("Commands");
    text_ += "<pre><code>";
    for (const auto& line : commands.lines) text_ += html_text(line) + '\n';
    text_ += "</code></pre>\n</div>\n";
  }

 private:
  /// A box that scrolls by itself where it is too wide, and that the keyboard reaches.
  void open_wide(std::string_view label) {
    text_ += fmt::format("<div class=\"wide\" role=\"group\" tabindex=\"0\" aria-label=\"{}\">\n",
                         html_text(label));
  }

  void add(const std::vector<PageBlock>& blocks) {
    for (const PageBlock& block : blocks) std::visit(*this, block);
  }

  void add(const PageSection& section, int level) {
    RAMIFY_EXPECTS(level <= 5);
    const int number = ++sections_;
    text_ += fmt::format("<section aria-labelledby=\"section{0}\">\n<h{1} id=\"section{0}\">{2}</h{1}>\n",
                         number, level, html_text(section.heading));
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
      text_ += fmt::format("<li><a href=\"#section{}\">{}</a></li>\n", number, html_text(section.heading));
      number += sections_of(section);
    }
    text_ += "</ul>\n</nav>\n";
  }

  std::string text_;
  int sections_ = 0, pictures_ = 0;
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
