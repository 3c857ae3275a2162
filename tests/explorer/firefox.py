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
user_pref("browser.download.alwaysOpenPanel", false);
user_pref("browser.download.viewableInternally.enabledTypes", "");
user_pref("pdfjs.disabled", true);
"""
# What is said here runs in each page before its own scripts do.
BEFORE_PAGES = """addEventListener("DOMWindowCreated", (event) => {
  const text = Services.cpmm.sharedData.get("topple:first");
  const page = event.target.defaultView;
  if (text) Cu.evalInSandbox(text, new Cu.Sandbox(page, {sandboxPrototype: page, wantXrays: false}));
}, true);"""


class Firefox:
    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(prefix="topple_firefox_", ignore_cleanup_errors=True)
        folder = pathlib.Path(self.profile.name)
        (folder / "user.js").write_text(PREFERENCES)
        self.process = subprocess.Popen(
            [PROGRAM, "--headless", "--marionette", "--remote-allow-system-access", "--no-remote", "--profile", folder, "--width", "1280", "--height", "900"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={"HOME": self.profile.name, "PATH": "/usr/bin:/bin"})
        self.socket, self.buffer, self.number = self.connected(folder / "MarionetteActivePort"), b"", 0
        self.read()  # its greeting
        self.ask("WebDriver:NewSession")
        self.inside("Services.mm.loadFrameScript('data:application/javascript,' + encodeURIComponent(arguments[0]), true)", BEFORE_PAGES)

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
            self.ask("Marionette:Quit", flags=["eForceQuit"])
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

    def ask(self, method, **words):
        self.number += 1
        text = json.dumps([0, self.number, method, words]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self.read()
        if error:
            raise RuntimeError((method, error["error"], error["message"]))
        return result

    def script(self, text, *given):
        """The body of a function of the page; a promise is waited for."""
        return self.ask("WebDriver:ExecuteScript", script=text, args=list(given))["value"]

    def inside(self, text, *given):
        """The body of a function of Firefox itself, which may do what a person does in its menus."""
        self.ask("Marionette:SetContext", value="chrome")
        try:
            return self.script(text, *given)
        finally:
            self.ask("Marionette:SetContext", value="content")

    def act(self, device, actions, **words):
        """By mouse, finger, wheel or keys."""
        self.ask("WebDriver:PerformActions", actions=[{"id": device, "actions": actions, **words}])
