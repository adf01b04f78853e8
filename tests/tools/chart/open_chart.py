#!/usr/bin/env python3
"""Opens a page of charts in Chromium as a reader does, in a light and in a dark browser: stays on a point, clicks it,
chooses another axis, uses the legend and the keyboard.

usage: open_chart.py PAGE.html [--screenshots DIR]
       exit code 0 when all is right, 1 with a sentence when not, 77 with a reason when there is no Chromium

Chromium is spoken to over two pipes, in its DevTools protocol: JSON, each message ended by a zero byte.
"""

import argparse
import base64
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

WAIT_S = 60
LEAST_CONTRAST = 3.0  # of marks and large text: WCAG 2.1, 1.4.11


class Browser:
    """One headless Chromium with one tab."""

    def __init__(self, program, profile):
        to_browser, self.into = os.pipe()
        self.out, from_browser = os.pipe()

        def place_pipes():  # in the child: what it reads is 3, what it writes is 4
            first, second = os.dup(to_browser), os.dup(from_browser)
            os.dup2(first, 3)
            os.dup2(second, 4)

        command = [program, "--headless", "--remote-debugging-pipe", f"--user-data-dir={profile}", "--no-first-run",
                   "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--window-size=1280,900"]
        if os.geteuid() == 0:
            command.append("--no-sandbox")
        self.process = subprocess.Popen(command + ["about:blank"], preexec_fn=place_pipes, close_fds=False,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.events = []
        self.next_id = 0
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def message(self, deadline):
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.out], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                raise TimeoutError(f"the browser said nothing for {WAIT_S} s")
            more = os.read(self.out, 1 << 20)
            if not more:
                raise EOFError("the browser ended")
            self.buffer += more
        text, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(text)

    def call(self, method, **parameters):
        self.next_id += 1
        request = {"id": self.next_id, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.into, json.dumps(request).encode() + b"\0")
        deadline = time.monotonic() + WAIT_S
        while True:
            answer = self.message(deadline)
            if answer.get("id") == self.next_id:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, event):
        deadline = time.monotonic() + WAIT_S
        while not any(one.get("method") == event for one in self.events):
            self.events.append(self.message(deadline))

    def ask(self, expression):
        """The value of an expression in the page; promises are awaited."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def mouse(self, kind, x, y):
        pressed = {} if kind == "mouseMoved" else {"button": "left", "clickCount": 1}
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **pressed)

    def click(self, x, y):
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.mouse(kind, x, y)

    def screenshot(self, file):
        file.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))

    def end(self):
        self.process.kill()
        self.process.wait()
        os.close(self.into)
        os.close(self.out)


# Points that can be seen, have pictures and are not covered by another: name, place on the screen.
POINTS = """[...document.querySelectorAll(".view:not([hidden]) .p")].map(mark => {
  mark.scrollIntoView({ block: "center" });
  const box = mark.getBoundingClientRect();
  const x = box.x + box.width / 2, y = box.y + box.height / 2;
  const point = charts[mark.closest("section").dataset.chart].points[mark.dataset.point];
  const shown = ["picture", "mask", "error"].every(kind => point.pictures[kind]);
  return shown && document.elementFromPoint(x, y)?.closest(".p") === mark ? { name: point.name, index: mark.dataset.point,
    chart: mark.closest("section").dataset.chart } : null;
}).filter(point => point)"""

# Where a point is now; the page may have been scrolled to it.
PLACE = """(() => { const mark = document.querySelector(
  `section[data-chart="%s"] .view:not([hidden]) .p[data-point="%s"]`);
  mark.scrollIntoView({ block: "center" });
  const box = mark.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()"""

CENTRE = """(() => { const one = document.querySelector(%s); one.scrollIntoView({ block: "center" });
  const box = one.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()"""

PANEL = """(async () => { const panel = document.getElementById("panel");
  const images = [...panel.querySelectorAll("img")];
  await Promise.all(images.map(image => image.decode()));
  return { hidden: getComputedStyle(panel).display === "none", name: panel.querySelector("h2").textContent,
    widths: images.map(image => image.naturalWidth), alone: new Set(images.map(image => image.src)).size }; })()"""

# The least contrast of any mark, name or text with the page's own paper. Source: WCAG 2.1, relative luminance.
CONTRAST = """(() => {
  const numbers = color => (color.match(/[\\d.]+/g) || []).map(Number);
  const luminance = color => numbers(color).slice(0, 3).map(part => part / 255)
    .map(part => part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
    .reduce((sum, part, i) => sum + part * [0.2126, 0.7152, 0.0722][i], 0);
  const paper = luminance(getComputedStyle(document.body).backgroundColor);
  let least = [100, "nothing"];
  for (const one of document.querySelectorAll(".view:not([hidden]) :is(.p path, .key path, text, .floor), p, h1, label")) {
    const style = getComputedStyle(one);
    const ink = luminance(one.matches("path, line") ? style.stroke : one.matches("text") ? style.fill : style.color);
    const contrast = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
    if (contrast < least[0]) least = [contrast, one.outerHTML.slice(0, 80)];
  }
  return { least: least[0], what: least[1], paper };
})()"""


def check(is_right, sentence):
    if not is_right:
        raise AssertionError(sentence)


def use_points(browser):
    points = browser.ask(POINTS)
    check(points, "no point with three pictures can be seen and clicked")
    first, last = points[0], points[-1]
    check(browser.ask(PANEL)["hidden"], "the panel is open before anything was clicked")
    place = browser.ask(PLACE % (first["chart"], first["index"]))
    browser.mouse("mouseMoved", *place)
    tip = browser.ask('document.getElementById("tip").hidden ? "" : document.getElementById("tip").textContent')
    check(first["name"] in tip and "wrong pixels, %" in tip, f"staying on {first['name']} shows '{tip}'")
    browser.click(*place)
    panel = browser.ask(PANEL)
    check(not panel["hidden"], f"clicking {first['name']} opens no panel")
    check(panel["name"] == first["name"], f"clicking {first['name']} shows {panel['name']}")
    check(len(panel["widths"]) == 4, f"the panel has {len(panel['widths'])} pictures, not three and the truth")
    check(all(width > 0 for width in panel["widths"]), f"a picture does not decode: widths {panel['widths']}")
    check(panel["alone"] >= 3, "the panel shows the same picture again")
    browser.ask(f"""document.querySelector(`section[data-chart="{last['chart']}"] .view:not([hidden]) """
                f""".p[data-point="{last['index']}"]`).focus()""")
    for kind in ("keyDown", "keyUp"):
        browser.call("Input.dispatchKeyEvent", type=kind, key="Enter", code="Enter", windowsVirtualKeyCode=13)
    panel = browser.ask(PANEL)
    check(panel["name"] == last["name"], f"Enter on {last['name']} shows {panel['name']}")


def use_axes(browser):
    shown = """[...document.querySelectorAll(".view:not([hidden])")].map(view => view.dataset.up)"""
    first = browser.ask(shown)[0]
    for up in ("error_px", "eps_px" if first == "wrong_percent" else "wrong_percent", first):
        browser.click(*browser.ask(CENTRE % json.dumps(f'input[value="{up}"]')))
        check(set(browser.ask(shown)) == {up}, f"choosing {up} shows {browser.ask(shown)}")


def use_legend(browser):
    key = '.view:not([hidden]) .key'
    series = browser.ask(f"document.querySelector({json.dumps(key)}).dataset.series")
    seen = (f"""[...document.querySelectorAll(".view:not([hidden]) .p")].filter(mark => mark.dataset.series === """
            f"""{json.dumps(series)} && getComputedStyle(mark).display !== "none").length""")
    before = browser.ask(seen)
    check(before > 0, f"series {series} has a line in the legend and no point")
    browser.click(*browser.ask(CENTRE % json.dumps(key)))
    check(browser.ask(seen) == 0, f"{series} is still there after its line in the legend was clicked")
    browser.click(*browser.ask(CENTRE % json.dumps(key)))
    check(browser.ask(seen) == before, f"{series} does not come back")


def check_quiet(browser, address):
    for event in browser.events:
        method, told = event.get("method"), event.get("params", {})
        check(method != "Runtime.exceptionThrown", f"the script failed: {told.get('exceptionDetails')}")
        check(method != "Runtime.consoleAPICalled" or told["type"] not in ("error", "warning", "assert"),
              f"the console says {told.get('args')}")
        check(method != "Log.entryAdded" or told["entry"]["level"] != "error", f"the log says {told.get('entry')}")
        if method == "Network.requestWillBeSent":
            asked = told["request"]["url"]
            check(asked == address or asked.startswith("data:") or asked == "about:blank", f"the page asks for {asked}")


def read_as(browser, page, scheme, screenshots):
    browser.events.clear()
    browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    browser.call("Page.navigate", url=page.as_uri())
    browser.wait_for("Page.loadEventFired")
    found = browser.ask(CONTRAST)
    check((found["paper"] < 0.2) == (scheme == "dark"), f"the paper of a {scheme} page is {found['paper']}")
    check(found["least"] >= LEAST_CONTRAST, f"{scheme}: a contrast of {found['least']:.2f} to 1: {found['what']}")
    if screenshots:
        browser.screenshot(screenshots / f"{page.stem}_{scheme}.png")
    use_axes(browser)
    use_legend(browser)
    use_points(browser)
    if screenshots:
        browser.ask('document.getElementById("panel").scrollIntoView({ block: "end" })')
        browser.screenshot(screenshots / f"{page.stem}_{scheme}_panel.png")
    check_quiet(browser, page.as_uri())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("--screenshots", type=Path)
    arguments = parser.parse_args()
    program = shutil.which("chromium")
    if program is None:
        print("no chromium here: the page was not opened")
        return 77
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(program, profile)
        try:
            for scheme in ("light", "dark"):
                read_as(browser, arguments.page.resolve(), scheme, arguments.screenshots)
        except (AssertionError, RuntimeError, TimeoutError, EOFError) as problem:
            print(f"{arguments.page}: {problem}")
            return 1
        finally:
            browser.end()
    return 0


if __name__ == "__main__":
    sys.exit(main())
