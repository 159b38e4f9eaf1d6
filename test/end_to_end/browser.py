# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium, driven through the WebDriver protocol (https://www.w3.org/TR/webdriver2)."""

import base64
import contextlib
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

# Straight to the driver, whatever proxy the machine has.
_OPENER = urllib.request.build_opener(urllib.request.ProxyHandler({}))


def missing():
    """Which of the two programs is not installed, or None."""
    for program in ("chromium", "chromedriver"):
        if shutil.which(program) is None:
            return program
    return None


def opened():
    """A browser for a `with` block."""
    return contextlib.closing(Browser())


class Browser:
    """One window. Always close()."""

    def __init__(self, width=1280, height=900):
        self.directory = tempfile.mkdtemp(prefix="semantic_kiss_browser_")
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
        self.session = f"http://127.0.0.1:{self._port()}/session"
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
                            "--disable-dev-shm-usage", "--hide-scrollbars",
                            f"--user-data-dir={self.directory}",
                            f"--window-size={width},{height}"]}
        capabilities = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        answer = self._post("", {"capabilities": {"alwaysMatch": capabilities}})
        self.session += "/" + answer["sessionId"]

    def _port(self):
        for line in self.driver.stdout:
            started = re.search(r"started successfully on port (\d+)", line)
            if started:
                return started.group(1)
        raise RuntimeError("chromedriver did not start")

    def _post(self, path, content):
        request = urllib.request.Request(self.session + path, json.dumps(content).encode(),
                                         {"Content-Type": "application/json"})
        try:
            with _OPENER.open(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def close(self):
        try:
            request = urllib.request.Request(self.session, method="DELETE")
            _OPENER.open(request, timeout=20).close()
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.driver.stdout.close()
            shutil.rmtree(self.directory, ignore_errors=True)

    def open(self, path):
        self.visit(pathlib.Path(path).resolve().as_uri())

    def visit(self, url):
        self._post("/url", {"url": url})

    def run(self, script):
        """What the function body `script` returns in the page."""
        return self._post("/execute/sync", {"script": script, "args": []})

    def wait_until(self, expression, within_s=10):
        """Until the expression is true in the page, for a few seconds."""
        end = time.monotonic() + within_s
        while not self.run(f"return Boolean({expression})"):
            if time.monotonic() > end:
                raise AssertionError(f"never true: {expression}")
            time.sleep(0.02)

    def emulate(self, scheme="light", width=1280, height=900):
        """The reader's theme and window; nothing moves by itself."""
        features = [{"name": "prefers-color-scheme", "value": scheme},
                    {"name": "prefers-reduced-motion", "value": "reduce"}]
        self._command("Emulation.setEmulatedMedia", {"features": features})
        self._command("Emulation.setDeviceMetricsOverride",
                      {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def _command(self, name, parameters):
        return self._post("/goog/cdp/execute", {"cmd": name, "params": parameters})

    def press(self, *keys):
        """Presses keys, one after another, wherever the focus is."""
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self._post("/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": actions}]})

    def click_at(self, x, y):
        """Clicks into the window, with coordinates in pixels."""
        actions = [{"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)},
                   {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self._post("/actions", {"actions": [{"type": "pointer", "id": "mouse",
                                             "actions": actions}]})

    def screenshot(self, selector=None):
        """The window, or what an element covers of it, as the bytes of a PNG file."""
        parameters = {"format": "png"}
        if selector is not None:
            box = self.box(selector)
            left, top = self.run("return [scrollX, scrollY]")  # the command counts from the page's
            parameters["clip"] = {**box, "x": box["x"] + left, "y": box["y"] + top, "scale": 1}
        return base64.b64decode(self._command("Page.captureScreenshot", parameters)["data"])

    def box(self, selector):
        """Where an element is in the window, in whole pixels: x, y, width, height."""
        box = self.run(f"return document.querySelector('{selector}').getBoundingClientRect()")
        return {name: round(box[name]) for name in ("x", "y", "width", "height")}

    def log(self):
        """What the browser logged since the last call: errors, warnings, messages of scripts."""
        return self._post("/se/log", {"type": "browser"})
