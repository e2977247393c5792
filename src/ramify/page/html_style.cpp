#include "ramify/page/html_style.hpp"

#include <fmt/format.h>

#include "ramify/page/palette.hpp"

namespace ramify::detail {
namespace {

std::string colours(const PagePalette& palette) {
  return fmt::format(
      "--text:{};--muted:{};--link:{};--back:{};--soft:{};--rule:{};--good:{};--bad:{};--open:{}",
      palette.text, palette.muted, palette.link, palette.back, palette.soft, palette.rule, palette.good,
      palette.bad, palette.open);
}

// Pictures are drawn on white and stay so.
constexpr const char* rules = R"(*{box-sizing:border-box}
body{margin:0;background:var(--back);color:var(--text);font:1rem/1.55 system-ui,sans-serif}
header,nav,main,footer{max-width:80rem;margin:0 auto;padding:0 1.25rem}
header{padding-top:1.5rem}
h1{font-size:1.7rem;line-height:1.2;margin:0 0 .5rem;overflow-wrap:anywhere}
h2{font-size:1.3rem;margin:2.2rem 0 .6rem;padding-top:.9rem;border-top:1px solid var(--rule);overflow-wrap:anywhere}
h3{font-size:1.08rem;margin:1.6rem 0 .4rem;overflow-wrap:anywhere}
h4,h5{font-size:1rem;margin:1.2rem 0 .3rem;overflow-wrap:anywhere}
p,ul{margin:.5rem 0;max-width:46rem;overflow-wrap:anywhere}
nav ul{list-style:none;padding:0;display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;max-width:none}
a{color:var(--link)}
.wide{overflow-x:auto;margin:.8rem 0}
:focus-visible{outline:2px solid var(--link);outline-offset:2px}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
caption{text-align:left;color:var(--muted);padding:.2rem 0}
th,td{padding:.28rem .6rem;border-bottom:1px solid var(--rule);text-align:left;vertical-align:top}
th{background:var(--soft);font-weight:600}
.number{text-align:right;white-space:nowrap}
.long{min-width:17rem}
.long:last-child{min-width:24rem}
.short{white-space:nowrap}
.badge{display:inline-block;border:1px solid;border-radius:1rem;padding:0 .55rem;font-weight:600;font-size:.88rem}
.good{color:var(--good)}
.bad{color:var(--bad)}
.open{color:var(--open)}
figure{margin:1rem 0;max-width:62rem}
figure img{max-width:100%;height:auto;background:#fff;border:1px solid var(--rule);border-radius:4px}
figure .wide{background:#fff;border:1px solid var(--rule);border-radius:4px;margin:0}
svg{display:block;width:100%;min-width:34rem;height:auto}
figcaption,footer{color:var(--muted)}
pre{width:max-content;min-width:100%;margin:0;background:var(--soft);border-radius:4px;padding:.6rem .9rem;font-size:.9rem}
footer{margin-top:2.5rem;padding-top:.8rem;padding-bottom:2rem;border-top:1px solid var(--rule)}
.filters{display:none}
@supports selector(:has(a)){.filters{display:flex;flex-wrap:wrap;gap:.6rem 1rem}}
fieldset{border:1px solid var(--rule);border-radius:4px;margin:0;padding:.1rem .8rem .4rem;min-width:0}
legend{color:var(--muted);padding:0 .3rem}
label{display:inline-block;margin-right:1rem;white-space:nowrap}
@media (max-width:40rem){th,td{padding:.28rem .45rem}.long:not(:last-child){min-width:12rem}}
)";

}  // namespace

std::string filter_class(std::size_t filter, std::size_t value) {
  return fmt::format("f{}v{}", filter, value);
}

std::string page_style(const FilterReach& reach) {
  std::string style =
      fmt::format(":root{{color-scheme:light dark;{}}}\n", colours(light_palette)) +
      fmt::format("@media (prefers-color-scheme:dark){{:root{{{}}}}}\n", colours(dark_palette)) + rules;
  for (std::size_t filter = 0; filter < reach.filters; ++filter)
    for (std::size_t value = 1; value <= reach.values; ++value)
      style += fmt::format(".filtered:has(input.{0}:checked) tbody tr:not(.{0}){{display:none}}\n",
                           filter_class(filter, value));
  return style;
}

}  // namespace ramify::detail
