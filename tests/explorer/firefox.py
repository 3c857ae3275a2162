# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Firefox without a window, spoken to by its own protocol for automation (Marionette: JSON over a socket, each message
with its length before it)."""

import base64
import json
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time

PROGRAM = shutil.which("firefox-esr") or shutil.which("firefox")
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
PREFERENCES = """user_pref("marionette.port", 0);
user_pref("app.update.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("toolkit.telemetry.reportingpolicy.firstRun", false);
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
"""


class Firefox:
    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(prefix="topple_firefox_", ignore_cleanup_errors=True)
        folder = pathlib.Path(self.profile.name)
        (folder / "user.js").write_text(PREFERENCES)
        self.process = subprocess.Popen(
            [PROGRAM, "--headless", "--marionette", "--no-remote", "--profile", folder, "--width", "1280", "--height", "900"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={"HOME": self.profile.name, "PATH": "/usr/bin:/bin"})
        self.socket, self.buffer, self.number = self.connected(folder / "MarionetteActivePort"), b"", 0
        self.read()  # its greeting
        self.call("WebDriver:NewSession")

    def connected(self, port):
        end = time.monotonic() + 60
        while time.monotonic() < end and self.process.poll() is None:
            try:
                return socket.create_connection(("127.0.0.1", int(port.read_text())), timeout=120)
            except (OSError, ValueError):
                time.sleep(0.1)
        raise RuntimeError("Firefox did not begin to listen")

    def close(self):
        try:
            self.call("Marionette:Quit", flags=["eForceQuit"])
        except (EOFError, OSError):
            pass
        self.socket.close()
        self.process.wait(timeout=60)
        self.profile.cleanup()

    def more(self):
        received = self.socket.recv(1 << 20)
        if not received:
            raise EOFError("Firefox ended")
        self.buffer += received

    def read(self):
        while b":" not in self.buffer:
            self.more()
        length, self.buffer = self.buffer.split(b":", 1)
        while len(self.buffer) < int(length):
            self.more()
        message, self.buffer = self.buffer[:int(length)], self.buffer[int(length):]
        return json.loads(message)

    def call(self, method, **words):
        self.number += 1
        text = json.dumps([0, self.number, method, words]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self.read()
        if error:
            raise RuntimeError((method, error["error"], error["message"]))
        return result

    def open(self, address):
        self.call("WebDriver:Navigate", url=address)

    def value(self, expression):
        return self.call("WebDriver:ExecuteScript", script=f"return ({expression})", args=[])["value"]

    def picture(self):
        return base64.b64decode(self.call("WebDriver:TakeScreenshot", full=False)["value"])

    def drag(self, x, y, dx, dy):
        """By the mouse, in ten steps."""
        moves = [{"type": "pointerMove", "duration": 20, "x": round(x + dx * i / 10), "y": round(y + dy * i / 10)} for i in range(11)]
        actions = [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:], {"type": "pointerUp", "button": 0}]
        self.call("WebDriver:PerformActions", actions=[
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions}])

    def element(self, selector):
        found = self.call("WebDriver:FindElement", using="css selector", value=selector)
        return found["value"][ELEMENT]

    def type(self, selector, text):
        self.call("WebDriver:ElementSendKeys", id=self.element(selector), text=text)
