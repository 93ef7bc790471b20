"""A browser without a window, driven over two pipes by the DevTools protocol: messages of JSON, each ended by a zero byte."""
import base64
import json
import os
import shutil
import subprocess
import zlib

NAMES = ("chromium-headless-shell", "chromium", "chrome-headless-shell", "google-chrome")


class Browser:
    """One page, which loads files one after the other; what it complains of is in `said`."""

    def __init__(self):
        path = next((found for found in map(shutil.which, NAMES) if found), None)
        if path is None:
            raise FileNotFoundError("no Chromium; install it with: apt-get install chromium-headless-shell")
        from_us, self.to_browser = os.pipe()
        self.from_browser, to_us = os.pipe()

        def give_pipes():
            # The browser reads from descriptor 3 and writes to 4. First out of the way of one another.
            reads, writes = os.dup(from_us), os.dup(to_us)
            os.dup2(reads, 103)
            os.dup2(writes, 104)
            os.dup2(103, 3)
            os.dup2(104, 4)

        self.process = subprocess.Popen(
            [path, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--hide-scrollbars",
             "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions", "--single-process"],
            preexec_fn=give_pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(from_us)
        os.close(to_us)
        self.last = 0
        self.rest = b""
        self.said = []
        self.session = None
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.ask(domain + ".enable")

    def message(self):
        """The next message of the browser."""
        while b"\0" not in self.rest:
            more = os.read(self.from_browser, 1 << 20)
            if not more:
                raise ConnectionError("the browser ended")
            self.rest += more
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def note(self, message):
        """Keeps what the page complains of."""
        method, given = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = given["exceptionDetails"]
            self.said.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and given["type"] in ("error", "warning", "assert"):
            self.said.append(" ".join(str(one.get("value", one.get("description"))) for one in given["args"]))
        elif method == "Log.entryAdded" and given["entry"]["level"] in ("error", "warning"):
            self.said.append(given["entry"]["text"])

    def ask(self, method, **given):
        """Sends a command; the result."""
        self.last += 1
        command = {"id": self.last, "method": method, "params": given}
        if self.session:
            command["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(command).encode() + b"\0")
        while True:
            message = self.message()
            self.note(message)
            if message.get("id") == self.last:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]

    def look(self, width, height, scheme, is_touch=False):
        """The window: its size in pixels, and light or dark."""
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=is_touch)
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, path):
        """Loads a file, and waits until it is there."""
        self.ask("Page.navigate", url="file://" + os.path.abspath(path))
        while True:
            message = self.message()
            self.note(message)
            if message.get("method") == "Page.loadEventFired":
                return

    def run(self, script):
        """The value of an expression of the page, awaited where it is a promise."""
        result = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"].get("exception", {}).get("description", "failed") + " in " + script)
        return result["result"].get("value")

    def click(self, selector):
        """A click of the mouse into the middle of an element."""
        x, y = self.run(f"""(() => {{
            const element = document.querySelector({json.dumps(selector)});
            element.scrollIntoView({{block: "center"}});
            const box = element.getBoundingClientRect();
            return [box.x + box.width / 2, box.y + box.height / 2];
        }})()""")
        self.drag([(x, y)])

    def drag(self, places):
        """The mouse pressed at the first place, moved over all, let go at the last."""
        for kind, (x, y) in [("mousePressed", places[0])] + [("mouseMoved", p) for p in places[1:]] + [
                ("mouseReleased", places[-1])]:
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1, buttons=1)

    def shot(self, path=None):
        """A picture of the window: (width, height, rows of red, green, blue); also as a file of PNG."""
        data = base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])
        if path:
            with open(path, "wb") as file:
                file.write(data)
        return pixels(data)

    def close(self):
        self.process.kill()
        self.process.wait()


def pixels(png):
    """The pixels of a PNG of 8 bits in true colour (ISO 15948)."""
    at, packed, width, height, channels = 8, b"", 0, 0, 3
    while at < len(png):
        size = int.from_bytes(png[at:at + 4], "big")
        kind, body = png[at + 4:at + 8], png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height = int.from_bytes(body[:4], "big"), int.from_bytes(body[4:8], "big")
            channels = {2: 3, 6: 4}[body[9]]
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride = zlib.decompress(packed), width * channels
    rows, before = [], bytearray(stride)
    for y in range(height):
        line = y * (stride + 1)
        before = unfiltered(raw[line], bytearray(raw[line + 1:line + 1 + stride]), before, channels)
        rows.append(before)
    return width, height, channels, rows


def unfiltered(kind, row, above, channels):
    """A row of a PNG without its filter."""
    if kind == 1:
        for i in range(channels, len(row)):
            row[i] = (row[i] + row[i - channels]) & 255
    elif kind == 2:
        for i, up in enumerate(above):
            row[i] = (row[i] + up) & 255
    elif kind == 3:
        for i in range(len(row)):
            left = row[i - channels] if i >= channels else 0
            row[i] = (row[i] + (left + above[i]) // 2) & 255
    elif kind == 4:
        for i in range(len(row)):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            up = above[i]
            guess = left + up - corner
            a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
            row[i] = (row[i] + (left if a <= b and a <= c else up if b <= c else corner)) & 255
    return row
