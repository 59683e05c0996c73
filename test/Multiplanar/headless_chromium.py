# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives Chromium without a display, by its DevTools protocol through a pipe: nothing but Python is needed for it."""
import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import time

PATIENCE = 400  # seconds for one answer; machines that run tests may be slow and busy

# Drawn by the processor, as machines that run tests have no graphics; root may not use the sandbox.
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--mute-audio", "--no-first-run",
         "--disable-extensions", "--disable-background-networking", "--disable-component-update",
         "--disable-backgrounding-occluded-windows", "--disable-renderer-backgrounding",
         "--disable-background-timer-throttling", "--remote-debugging-pipe"]


def find_chromium():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Page:
    """One page in a browser of its own."""

    def __init__(self, program, work, width, height):
        self.log = open(os.path.join(work, "chromium.log"), "w")
        to_browser, self.to = os.pipe()
        self.back, from_browser = os.pipe()

        def hand_over():  # as 3 and 4, where the protocol looks for them
            ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (to_browser, from_browser)]
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        self.browser = subprocess.Popen(
            [program, *FLAGS, "--user-data-dir=" + os.path.join(work, "browser"), "about:blank"], close_fds=False,
            preexec_fn=hand_over, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)
        os.close(to_browser)
        os.close(from_browser)
        self.text, self.number, self.session = b"", 0, None
        self.events = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "light"}])

    def close(self):
        try:
            os.close(self.to)
            self.browser.wait(30)
        except subprocess.TimeoutExpired:
            self.browser.kill()
            self.browser.wait()
        os.close(self.back)
        self.log.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _message(self):
        deadline = time.monotonic() + PATIENCE
        while b"\0" not in self.text:
            if not select.select([self.back], [], [], max(0, deadline - time.monotonic()))[0]:
                raise TimeoutError("Chromium has not answered for %d s" % PATIENCE)
            got = os.read(self.back, 1 << 20)
            if not got:
                raise ConnectionError("Chromium has ended: see chromium.log")
            self.text += got
        message, self.text = self.text.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        while True:
            message = self._message()
            if message.get("id") == self.number:
                break
            self.events.append(message)
        if "error" in message:
            raise RuntimeError(method + ": " + str(message["error"]))
        return message["result"]

    def open(self, address):
        loads = self._count("Page.loadEventFired")
        self.call("Page.navigate", url=address)
        while self._count("Page.loadEventFired") == loads:
            self.events.append(self._message())

    def _count(self, method):
        return sum(event.get("method") == method for event in self.events)

    def value(self, expression):
        """What an expression comes to in the page, after waiting for it if it is a promise."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(expression + ": " + str(answer["exceptionDetails"]))
        return answer["result"].get("value")

    def wait_for(self, condition):
        """Returns when the condition, an expression, holds in the page and what changed with it is drawn."""
        self.value("new Promise(done => { const look = () => (%s) ? requestAnimationFrame(() => requestAnimationFrame("
                   "() => done(true))) : setTimeout(look, 20); look(); })" % condition)

    def press(self, key):
        code = {" ": "Space", "/": "Slash"}.get(key, key)
        text = {"text": key} if len(key) == 1 else {}
        number = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Home": 36, "End": 35,
                  "Enter": 13, "Escape": 27}.get(key, ord(key[0].upper()))
        if key == "Enter":
            text = {"text": "\r"}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=code, windowsVirtualKeyCode=number,
                      **(text if kind == "keyDown" else {}))

    def type(self, text):
        self.call("Input.insertText", text=text)

    def mouse(self, kind, x, y, held=True):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left" if held else "none",
                  buttons=int(held and kind != "mouseReleased"), clickCount=int(kind != "mouseMoved"))

    def click(self, x, y):
        self.mouse("mouseMoved", x, y, False)
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)

    def drag(self, x0, y0, x1, y1):
        self.mouse("mouseMoved", x0, y0, False)
        self.mouse("mousePressed", x0, y0)
        for i in range(1, 6):
            self.mouse("mouseMoved", x0 + (x1 - x0) * i / 5, y0 + (y1 - y0) * i / 5)
        self.mouse("mouseReleased", x1, y1)

    def screenshot(self, file):
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        with open(file, "wb") as out:
            out.write(data)
        return data

    def print_to(self, file):
        data = self.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)["data"]
        with open(file, "wb") as out:
            out.write(base64.b64decode(data))

    def complaints(self):
        """What the page wrote to its console as errors or warnings, and exceptions."""
        result = []
        for event in self.events:
            details = event.get("params", {})
            if event.get("method") == "Runtime.exceptionThrown":
                result.append(details["exceptionDetails"].get("exception", {}).get("description", "exception"))
            if event.get("method") == "Runtime.consoleAPICalled" and details["type"] in ("error", "warning", "assert"):
                result.append(" ".join(str(a.get("value", a.get("description"))) for a in details["args"]))
            if event.get("method") == "Log.entryAdded" and details["entry"]["level"] == "error":
                result.append(details["entry"]["text"])
        return result

    def requests(self):
        """The addresses of everything that the page asked for."""
        return [event["params"]["request"]["url"] for event in self.events
                if event.get("method") == "Network.requestWillBeSent"]
