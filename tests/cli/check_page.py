"""Is a page of ramify a good page? Reads it as HTML, without a browser; prints what is wrong, a line each, and ends with 1.

Usage: check_page.py report.html
"""

import re
import sys
from html.parser import HTMLParser

VOID = {"meta", "input", "br", "hr", "link", "img", "use", "path", "rect", "circle", "line", "polyline", "polygon"}


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.problems = []
        self.open = []
        self.ids = []
        self.targets = []
        self.headings = []
        self.seen = []
        self.radios = {}

    def say(self, problem):
        self.problems.append(f"line {self.getpos()[0]}: {problem}")

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.seen.append(tag)
        self.check_names(tag, values)
        self.check_tag(tag, values)
        if tag not in VOID:
            self.open.append(tag)

    def check_names(self, tag, values):
        if "id" in values:
            self.ids.append(values["id"])
        for name in ("href", "xlink:href"):
            if name in values:
                if not values[name].startswith("#"):
                    self.say(f"<{tag}> leads away: {values[name]}")
                self.targets.append(values[name].removeprefix("#"))
        if "aria-labelledby" in values:
            self.targets.append(values["aria-labelledby"])
        for value in values.values():
            self.targets += re.findall(r"url\(#([^)]*)\)", value or "")
        if int(values.get("tabindex", 0)) > 0:
            self.say("tabindex above 0 changes the order of the keyboard")

    def check_tag(self, tag, values):
        if tag in ("script", "link", "iframe", "img", "object") or "src" in values or "onclick" in values:
            self.say(f"<{tag}>: a page has no scripts and needs no other file")
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        if tag == "svg" and "div" not in self.open:
            self.say("a picture without its box")
        if values.get("role") in ("img", "group") and not values.get("aria-label", "").strip():
            self.say(f"role {values['role']} without a label")
        if tag == "th" and values.get("scope") not in ("col", "row"):
            self.say("th without a scope")
        if tag == "input":
            if "label" not in self.open:
                self.say("a choice without its label")
            self.radios.setdefault(values.get("name"), []).append("checked" in values)
        if tag == "input" and "fieldset" not in self.open:
            self.say("a choice that belongs to no group")

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.say(f"</{tag}> closes nothing; open: {self.open[-3:]}")
        else:
            self.open.pop()


def check(text):
    page = Page()
    page.feed(text)
    page.close()
    problems = page.problems
    if not text.startswith('<!DOCTYPE html>\n<html lang="en">'):
        problems.append("no doctype, or no language")
    for tag in ("title", "header", "main", "h1"):
        if page.seen.count(tag) != 1:
            problems.append(f"{page.seen.count(tag)} <{tag}>, not one")
    for once in ("nav", "footer"):
        if page.seen.count(once) > 1:
            problems.append(f"more than one <{once}>")
    for before, after in zip([0, *page.headings], page.headings):
        if after > before + 1:
            problems.append(f"h{after} after h{before}")
    for table, caption in [(page.seen.count("table"), page.seen.count("caption"))]:
        if table != caption:
            problems.append(f"{table} tables, {caption} captions")
    if page.seen.count("fieldset") != page.seen.count("legend"):
        problems.append("a group of choices without a legend")
    if len(set(page.ids)) != len(page.ids):
        problems.append("an id comes twice: " + ", ".join(sorted({i for i in page.ids if page.ids.count(i) > 1})))
    for target in sorted(set(page.targets) - set(page.ids)):
        problems.append(f"nothing has the id '{target}'")
    for name, checked in page.radios.items():
        if checked.count(True) != 1:
            problems.append(f"{checked.count(True)} choices of {name} are made")
    if page.open:
        problems.append(f"never closed: {page.open}")
    if re.search("https?:|@import", text):
        problems.append("it names the network")
    return problems


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        problems = check(file.read())
    print("\n".join(problems))
    sys.exit(1 if problems else 0)


main()
