// Pages as a browser shows them, where Chromium is installed: nothing in the console, nothing wider than the
// window, everything in reach of the keyboard, contrast and filters as they are really drawn. What can be
// seen without a browser is held by check_page.py in reproduce_page_test.cpp.
#include <string>
#include <tuple>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

bool has_chromium() {
  return shell("command -v chromium").code == 0;
}

/// The page with the probe (page_probe.js) at its end, as the content of a frame.
std::string with_probe(std::string html) {
  const std::string probe = read_file(std::string(RAMIFY_SOURCE) + "/tests/cli/page_probe.js");
  html.insert(html.rfind("</body>"), "<script>" + probe + "</script>");
  std::string quoted;
  for (const char c : html)
    if (c == '"')
      quoted += "&quot;";
    else
      quoted += c == '&' ? "&amp;" : std::string(1, c);
  return quoted;
}

/// What the probe says of a page so wide, in one theme. A frame, for no window is as narrow as a telephone.
Ran probed(const Scratch& scratch, const std::string& page, int width, bool dark) {
  const std::string frame = scratch.file(
      "frame.html",
      "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><meta name=\"color-scheme\" content=\"light "
      "dark\">"
      "</head><body><pre></pre><script>addEventListener('message', (event) => {"
      "document.querySelector('pre').textContent = event.data;"
      "document.querySelector('iframe').remove();});</script>\n<iframe style=\"height:1000px;width:" +
          std::to_string(width) + "px\" srcdoc=\"" + with_probe(read_file(page)) +
          "\"></iframe></body></html>\n");
  return shell("chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir=" +
               (scratch / "browser").string() + " --enable-logging=stderr --virtual-time-budget=10000" +
               " --window-size=1500,1000" + (dark ? " --blink-settings=preferredColorScheme=0" : "") +
               " --dump-dom file://" + frame);
}

void expect_good(const Scratch& scratch, const std::string& page, int width, bool dark) {
  const Ran ran = probed(scratch, page, width, dark);
  const auto begin = ran.out.find("<pre>"), end = ran.out.find("</pre>");
  ASSERT_NE(begin, std::string::npos) << ran.out << ran.err;
  const std::string said = ran.out.substr(begin + 5, end - begin - 5);
  EXPECT_TRUE(said.starts_with(std::string("probed: ") + (dark ? "dark" : "light"))) << page << '\n' << said;
  EXPECT_EQ(ran.err.find("CONSOLE"), std::string::npos) << ran.err;
}

class PageInABrowser : public testing::TestWithParam<std::tuple<int, bool>> {};

// Some seconds: Chromium starts anew for each.
TEST_P(PageInABrowser, IsWholeAndInReach) {
  if (!has_chromium()) GTEST_SKIP() << "chromium is not installed";
  const auto [width, dark] = GetParam();
  const Scratch scratch;
  const std::string out = (scratch / "out").string();
  ASSERT_EQ(ramify("reproduce --claim C3 --out " + out).code, 0);
  expect_good(scratch, out + "/report.html", width, dark);
  const std::string config = scratch.file("small.toml",
                                          "models = [\"bst\", \"catalan\"]\nn = [10, 1000]\nreplicates = 20\n"
                                          "statistics = [\"strahler\", \"nodes\", \"streams_mean_ratio\"]\n");
  ASSERT_EQ(ramify("run " + config + " --out " + out).code, 0);
  expect_good(scratch, out + "/small/report.html", width, dark);
}

INSTANTIATE_TEST_SUITE_P(Windows, PageInABrowser,
                         testing::Combine(testing::Values(400, 1400), testing::Bool()), [](const auto& test) {
                           return std::to_string(std::get<0>(test.param)) +
                                  (std::get<1>(test.param) ? "Dark" : "Light");
                         });

TEST(PageProbe, SeesWhatIsWrong) {
  if (!has_chromium()) GTEST_SKIP() << "chromium is not installed";
  const Scratch scratch;
  const std::string page =
      scratch.file("bad.html",
                   "<!DOCTYPE html><html><body><a href=\"#nowhere\">a</a><p style=\"color:#999\">pale</p>"
                   "<div style=\"width:3000px\">wide</div></body></html>");
  const Ran ran = probed(scratch, page, 400, false);
  for (const char* problem : {"scrolls sideways", "leads nowhere: A a", "contrast 2.85: P pale"})
    EXPECT_NE(ran.out.find(problem), std::string::npos) << problem << '\n' << ran.out;
}

}  // namespace
}  // namespace ramify::test
