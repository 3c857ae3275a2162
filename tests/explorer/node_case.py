# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Modules of the explorer's page in node, without a browser."""

import json
import shutil
import subprocess

NODE = shutil.which("node")


def node(module, body, given):
    """What `body` returns, made of `given`, with the names of a module of the page as `it`."""
    script = f"""import {{ readFileSync }} from "node:fs";
      const it = await import({json.dumps(module.as_uri())});
      const given = JSON.parse(readFileSync(0, "utf8"));
      console.log(JSON.stringify(await (async () => {{ {body} }})()));"""
    done = subprocess.run([NODE, "--input-type=module", "-e", script], input=json.dumps(given), capture_output=True,
                          encoding="utf-8", timeout=120)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)
