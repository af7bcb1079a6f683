#!/usr/bin/python3
"""Opens a report in headless Chromium and follows every link of every page.

  browser.py DIRECTORY [--screenshots DIRECTORY]

Fails when a link, an anchor or a picture leads nowhere, when anything is fetched that is not a local file, when the
console has an error, when a formula is left as source, when a page is wider than a telephone or a formula than its
page, or when something keeps a reader from it (accessibility.js), in light and dark, or when a filter shows what it
should not. Needs Debian's chromium-driver and python3-selenium.
A page has at most two million bytes, for it is read on a telephone, too.
"""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile
from urllib.parse import urldefrag, urljoin, urlsplit

WIDTHS = {"phone": 360, "desktop": 1400}
SCHEMES = ("light", "dark")
MOST_BYTES = 2_000_000

ACCESSIBILITY = pathlib.Path(__file__).with_name("accessibility.js").read_text()

# What a page refers to, and what is wrong with it, found by the browser itself.
INSPECT = r"""
const attributes = (selector, name) => [...document.querySelectorAll(selector)].map((e) => e.getAttribute(name));
const body = document.body.cloneNode(true);
body.querySelectorAll(".katex-mathml, code, svg, .tex-source").forEach((e) => e.remove());
const source = body.textContent.match(/\\[a-zA-Z]+|\{\{|<<|\$[^ ]/);
const anchors = {};
for (const id of attributes("[id]", "id")) anchors[id] = (anchors[id] || 0) + 1;
return {
  links: [...document.querySelectorAll("a")].map((a) => a.getAttribute("href") || a.getAttribute("xlink:href") || ""),
  pictures: [...document.querySelectorAll("source")].map((s) => s.getAttribute("srcset")),
  broken: [...document.images].filter((i) => !i.complete || i.naturalWidth === 0).map((i) => i.src),
  fetched: performance.getEntriesByType("resource").map((r) => r.name),
  anchors: anchors,
  formulas: document.querySelectorAll("math").length,
  silent: [...document.querySelectorAll(".katex")].filter((k) => !k.querySelector("math")).length,
  wrong: document.querySelectorAll("tex, tex-display, .katex-error, katex-version").length,
  source: source ? source[0] + " in: " + body.textContent.substr(Math.max(0, source.index - 40), 90) : "",
};
"""

# For every choice that the page's form offers: what is shown, and what should be. None where there is no form.
SIFT = r"""
const form = document.querySelector("form.filter");
if (!form) return null;
const entries = [...document.querySelectorAll("article[data-status]")];
const wrong = [];
for (const control of [...form.elements].filter((one) => one.name)) {
  const choices = control.tagName === "SELECT" ? [...control.options].map((one) => one.value) : ["no such words"];
  for (const choice of choices) {
    form.reset();
    for (const other of form.elements) if (other.name) other.value = "";
    control.value = choice;
    form.dispatchEvent(new Event("input"));
    const shown = entries.filter((entry) => entry.getClientRects().length > 0);
    const due = entries.filter((entry) => !choice || entry.dataset[control.name] === choice);
    if (shown.length !== due.length || due.some((entry) => !shown.includes(entry)) || (control.tagName === "SELECT" && !due.length)) {
      wrong.push(`${control.name} ${choice}: ${shown.length} shown, ${due.length} due`);
    }
  }
}
form.reset();
form.dispatchEvent(new Event("input"));
return wrong;
"""

# What does not fit.
SCROLLED = r"""
return [...document.querySelectorAll(".formula, .wide, pre")]
  .filter((part) => part.scrollWidth > part.clientWidth + 1)
  .map((part) => `${part.className} in ${(part.closest("[id]") || document.body).id}`);
"""

LANDS = r"""
return arguments[0].filter((fragment) => {
  const part = document.getElementById(decodeURIComponent(fragment));
  if (part && part.getClientRects().length > 0) return false;  // it needs nothing to be opened for it
  location.hash = "#" + fragment;
  const target = document.querySelector(":target");
  return !target || target.id !== decodeURIComponent(fragment) || target.getClientRects().length === 0;
});
"""


def browser(profile):
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars",
                 "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-ipc-flooding-protection",
                 "--disable-dev-shm-usage", f"--user-data-dir={profile}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    driver.set_script_timeout(300)  # a long page on a busy machine
    return driver


def show(driver, width, height=900):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})


class Check:
    def __init__(self, driver, directory):
        self.driver = driver
        self.directory = directory
        self.faults = []
        self.pages = {}
        self.fragments = {}  # of each page, by whom each is referred to

    def fault(self, page, text):
        self.faults.append(f"{page.name}: {text}")

    def open(self, page, width="desktop"):
        show(self.driver, WIDTHS[width])
        self.driver.get(page.as_uri())

    def inspect(self, page):
        self.open(page)
        found = self.pages[page] = self.driver.execute_script(INSPECT)
        for entry in self.driver.get_log("browser"):
            self.fault(page, f"the console says: {entry['message']}")
        for name in found["broken"]:
            self.fault(page, f"a picture does not load: {name}")
        for name in found["fetched"]:
            if not name.startswith(("file:", "data:")):
                self.fault(page, f"it fetches {name}")
        for name, count in found["anchors"].items():
            if count > 1:
                self.fault(page, f"{count} elements have the id {name}")
        if page.stat().st_size > MOST_BYTES:
            self.fault(page, f"it has {page.stat().st_size} bytes")
        if found["formulas"] == 0:
            self.fault(page, "it has no formula")
        if found["silent"]:
            self.fault(page, f"{found['silent']} formulas have no MathML")
        if found["wrong"]:
            self.fault(page, f"{found['wrong']} formulas are not set")
        if found["source"]:
            self.fault(page, f"source is left: {found['source']}")
        for sentence in self.driver.execute_script(SIFT) or []:
            self.fault(page, f"the filter: {sentence}")
        # Each colour and each width once, in the window that it is open in: a long page takes its time.
        for scheme, name in zip(SCHEMES, reversed(WIDTHS)):
            self.paint(scheme)
            show(self.driver, WIDTHS[name])
            self.read(page, f"{name}, {scheme}")
        self.paint("light")

    def paint(self, scheme):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": scheme}]})

    def read(self, page, where):
        # All of the page, however far below.
        self.driver.execute_script(
            "document.head.insertAdjacentHTML('beforeend', '<style>* { content-visibility: visible !important }</style>');"
            "document.querySelectorAll('details').forEach((part) => { part.open = true; });")
        # What a page is laid out for: innerWidth grows with a page that is too wide.
        wide = self.driver.execute_script("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
        if wide > 0:
            self.fault(page, f"{where}: it is {wide} pixels wider than the window")
        for name in self.driver.execute_script(SCROLLED):
            self.fault(page, f"{where}: {name} has to be scrolled for")
        for sentence in self.driver.execute_script(ACCESSIBILITY):
            self.fault(page, f"{where}: {sentence}")

    def follow(self, page):
        for link in self.pages[page]["links"] + self.pages[page]["pictures"]:
            target, fragment = urldefrag(urljoin(page.as_uri(), link))
            if not link:
                self.fault(page, "a link without target")
            elif target.startswith("file:"):
                path = pathlib.Path(urlsplit(target).path)  # what is asked of a page is not its name
                if not path.is_file() or path.parent != self.directory:
                    self.fault(page, f"{link} leads to no file of the report")
                elif fragment:
                    self.fragments.setdefault(path, {}).setdefault(fragment, set()).add(page)
                    if path not in self.pages:
                        self.walk(path)
                elif path.suffix == ".html" and path not in self.pages:
                    self.walk(path)
            elif not target.startswith("https://doi.org/"):
                self.fault(page, f"{link} leads out of the report")

    def land(self):
        """Each page once, for all that refer to a part of it."""
        for path, names in self.fragments.items():
            self.open(path)
            for name in self.driver.execute_script(LANDS, sorted(names)):
                for page in names[name]:
                    self.fault(page, f"{path.name}#{name} leads nowhere")

    def walk(self, page):
        self.inspect(page)
        self.follow(page)

    def photograph(self, directory):
        directory.mkdir(exist_ok=True)
        for page in self.pages:
            for scheme in SCHEMES:
                self.paint(scheme)
                for name, width in WIDTHS.items():
                    self.open(page, name)
                    height = self.driver.execute_script("return document.documentElement.scrollHeight")
                    show(self.driver, width, min(height, 12000))
                    self.driver.save_screenshot(str(directory / f"{page.stem}-{name}-{scheme}.png"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path)
    arguments = parser.parse_args()
    directory = arguments.directory.resolve()
    with tempfile.TemporaryDirectory() as profile:
        os.environ["HOME"] = profile
        driver = browser(profile)
        try:
            check = Check(driver, directory)
            check.walk(directory / "index.html")
            check.land()
            if arguments.screenshots:
                check.photograph(arguments.screenshots)
        finally:
            driver.quit()
    for fault in check.faults:
        print(fault, file=sys.stderr)
    links = sum(len(found["links"]) for found in check.pages.values())
    formulas = sum(found["formulas"] for found in check.pages.values())
    print(f"{len(check.pages)} pages, {links} links, {formulas} formulas, {len(check.faults)} faults")
    sys.exit(1 if check.faults else 0)


if __name__ == "__main__":
    main()
