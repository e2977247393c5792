// Pages as HTML and as Markdown.
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/page/html_writer.hpp"
#include "ramify/page/inline_svg.hpp"
#include "ramify/page/markdown_writer.hpp"
#include "ramify/page/palette.hpp"

namespace ramify {
namespace {

constexpr const char* picture_svg =
    "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n"
    "<svg width=\"10\" xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\">"
    "<title>Gnuplot</title><desc>made by</desc><g id=\"a\"/><use xlink:href=\"#a\"/>"
    "<rect id='b' clip-path=\"url(#a)\"/><use href='#b'/><text> id=\"a\" stays</text></svg>\n";

Page small_page() {
  Table table({"order", "what"});
  table.add(Row().whole(1).text("a < b | c"));
  PageSection inner{"Inner", {PagePicture{picture_svg, "one \"picture\"", "First"}}, {}};
  return {"Tom & <Jerry>",
          {PageParagraph{"lead"}},
          {{"One", {PageTable{"Caption", table}, PageCommands{{"ramify x 'a<b'"}}}, {inner}},
           {"Two",
            {PagePicture{picture_svg, "another", "Second"}, PageList{{"* no emphasis *", "snake_case"}}},
            {}}},
          {PageParagraph{"made"}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::vector<std::string> matches(const std::string& text, const char* pattern) {
  std::vector<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

TEST(HtmlPage, HasLandmarksALanguageAndATitle) {
  const std::string html = write_html(small_page());
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  EXPECT_EQ(count(html, "<title>Tom &amp; &lt;Jerry&gt;</title>"), 1u);
  for (const char* landmark : {"header", "nav", "main", "footer", "h1"}) {
    EXPECT_EQ(matches(html, (std::string("<(") + landmark + ")[ >]").c_str()).size(), 1u) << landmark;
    EXPECT_EQ(count(html, std::string("</") + landmark + ">"), 1u) << landmark;
  }
}

TEST(HtmlPage, NeedsNoNetworkAndNoScript) {
  const std::string html = write_html(small_page());
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("<link"), std::string::npos);
  EXPECT_EQ(html.find("@import"), std::string::npos);
}

TEST(HtmlPage, HeadingsDescendOneByOne) {
  int last = 0;
  const auto levels = matches(write_html(small_page()), "<h([1-6])[ >]");
  ASSERT_EQ(levels.size(), 4u);
  for (const auto& level : levels) {
    EXPECT_LE(std::stoi(level), last + 1);
    last = std::stoi(level);
  }
}

TEST(HtmlPage, EveryLinkResolvesAndNoIdComesTwice) {
  const std::string html = write_html(small_page());
  const auto ids = matches(html, "<[^>]* id=\"([^\"]*)\"");
  const std::set<std::string> known(ids.begin(), ids.end());
  EXPECT_EQ(known.size(), ids.size());
  const auto links = matches(html, "(?:href=\"#|url\\(#|aria-labelledby=\")([^\")]*)");
  EXPECT_EQ(links.size(), 9u);  // two of the contents, three of sections, two of each picture
  for (const auto& link : links) EXPECT_TRUE(known.contains(link)) << link;
}

TEST(HtmlPage, EscapesWhatIsMarkup) {
  const std::string html = write_html(small_page());
  EXPECT_NE(html.find("<td class=\"short\">a &lt; b | c</td>"), std::string::npos);
  EXPECT_NE(html.find("ramify x 'a&lt;b'"), std::string::npos);
  EXPECT_NE(html.find("role=\"img\" aria-label=\"one &quot;picture&quot;\""), std::string::npos);
  EXPECT_EQ(html_text("\x01<&>\""), "\ufffd&lt;&amp;&gt;&quot;");
}

TEST(HtmlPage, TablesHaveCaptionsAndScopesAndNumbersStandAtTheRight) {
  const std::string html = write_html(small_page());
  EXPECT_NE(html.find("<caption>Caption</caption>"), std::string::npos);
  EXPECT_NE(
      html.find("<th scope=\"col\" class=\"number\">order</th><th scope=\"col\" class=\"short\">what</th>"),
      std::string::npos);
  EXPECT_NE(html.find("<td class=\"number\">1</td>"), std::string::npos);
}

/// A table of three rows with a filter, links and badges, before the sections that it leads to.
Page filtered_page() {
  Table table({"part", "verdict"});
  table.add(Row().text("P1").text("yes"));
  table.add(Row().text("P2").text("no"));
  table.add(Row().text("P3").text("yes"));
  PageTable filtered{"Caption", table};
  filtered.links = {"P1", "", "P3"};
  filtered.badges = {"verdict", {PageTone::good, PageTone::bad, PageTone::good}};
  filtered.filters = {"verdict"};
  return {"t",
          {},
          {{"Table", {filtered}, {}},
           {"First of all", {PageVerbatim{"a config", "a = 1 < 2\n"}}, {}, "P1", "First"},
           {"Third", {}, {}, "P3"}},
          {}};
}

TEST(HtmlPage, FiltersAreRadioButtonsAndRulesOfTheStyleSheet) {
  const std::string html = write_html(filtered_page());
  EXPECT_NE(
      html.find("<fieldset>\n<legend>verdict</legend>\n"
                "<label><input type=\"radio\" name=\"table1-0\" class=\"f0v0\" checked> all (3)</label>\n"
                "<label><input type=\"radio\" name=\"table1-0\" class=\"f0v1\"> yes (2)</label>\n"
                "<label><input type=\"radio\" name=\"table1-0\" class=\"f0v2\"> no (1)</label>\n"),
      std::string::npos)
      << html;
  EXPECT_EQ(matches(html, "<tr class=\"([^\"]*)\"><td"), (std::vector<std::string>{"f0v1", "f0v2", "f0v1"}));
  for (const char* value : {"f0v1", "f0v2"})
    EXPECT_EQ(count(html, std::string(".filtered:has(input.") + value + ":checked) tbody tr:not(." + value +
                              "){display:none}\n"),
              1u);
  EXPECT_EQ(count(html, "f0v3"), 0u);
  EXPECT_EQ(write_html(small_page()).find("tbody tr:not"), std::string::npos);
}

TEST(HtmlPage, FirstFieldsAreLinksAndVerdictsBadges) {
  const std::string html = write_html(filtered_page());
  EXPECT_NE(html.find("<td class=\"short\"><a href=\"#P1\">P1</a></td>"
                      "<td class=\"short\"><span class=\"badge good\">yes</span></td>"),
            std::string::npos);
  EXPECT_NE(
      html.find("<td class=\"short\">P2</td><td class=\"short\"><span class=\"badge bad\">no</span></td>"),
      std::string::npos);
}

TEST(HtmlPage, SectionsAreFoundByTheirAnchors) {
  const std::string html = write_html(filtered_page());
  EXPECT_NE(html.find("<section aria-labelledby=\"P1\">\n<h2 id=\"P1\">First of all</h2>"),
            std::string::npos);
  EXPECT_NE(html.find("<li><a href=\"#section1\">Table</a></li>\n<li><a href=\"#P1\">First</a></li>\n"
                      "<li><a href=\"#P3\">Third</a></li>"),
            std::string::npos);
  EXPECT_NE(html.find("aria-label=\"a config\">\n<pre><code>a = 1 &lt; 2\n</code></pre>"), std::string::npos);
}

TEST(MarkdownPage, HasTheWordsOfFilteredTablesAndVerbatimTexts) {
  EXPECT_EQ(write_markdown(filtered_page()),
            "# t\n\n## Table\n\nCaption\n\n| part | verdict |\n| --- | --- |\n| P1 | yes |\n| P2 | no |\n| "
            "P3 | yes |\n"
            "\n## First of all\n\na config:\n\n    a = 1 < 2\n    \n\n## Third\n");
}

TEST(InlineSvg, LosesPrologNamespacesAndTitlesAndGetsIdsOfItsOwn) {
  EXPECT_EQ(inline_svg(picture_svg, "p-"),
            "<svg width=\"10\"><g id=\"p-a\"/><use xlink:href=\"#p-a\"/>"
            "<rect id='p-b' clip-path=\"url(#p-a)\"/><use href='#p-b'/>"
            "<text> id=\"a\" stays</text></svg>\n");
}

/// Relative luminance of #rrggbb (WCAG 2.1).
double luminance(std::string_view colour) {
  double sum = 0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
    sum += weights[i] * (c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(std::string_view one, std::string_view other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

TEST(PagePalette, WhatIsReadHasAContrastOfFourAndAHalf) {
  EXPECT_NEAR(contrast("#000000", "#ffffff"), 21, 1e-9);
  EXPECT_NEAR(contrast("#777777", "#ffffff"), 4.478, 1e-3);  // published as just too pale
  for (const PagePalette& palette : {light_palette, dark_palette})
    for (const auto back : {palette.back, palette.soft})
      for (const auto text :
           {palette.text, palette.muted, palette.link, palette.good, palette.bad, palette.open})
        EXPECT_GE(contrast(text, back), 4.5) << text << " on " << back;
  for (const auto text : {light_palette.text, dark_palette.text})
    EXPECT_NE(write_html({"t", {}, {}, {}}).find(text), std::string::npos);
}

TEST(MarkdownPage, IsTheSameInMarkdown) {
  EXPECT_EQ(
      write_markdown(small_page()),
      "# Tom \\& \\<Jerry\\>\n\nlead\n\n## One\n\nCaption\n\n| order | what |\n| --- | --- |\n"
      "| 1 | a \\< b \\| c |\n\n    ramify x 'a<b'\n\n### Inner\n\n*Picture:* First (one \"picture\")\n\n"
      "## Two\n\n*Picture:* Second (another)\n\n- \\* no emphasis \\*\n- snake_case\n\n---\n\nmade\n");
}

}  // namespace
}  // namespace ramify
