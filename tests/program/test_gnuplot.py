# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""gnuplot as another program: what the user has set for it, and what it does wrong.

`GNUTERM`, a `~/.gnuplot`, POSIXLY_CORRECT and a locale changed or broke the figures."""

import os
import subprocess

from harness import ROOT, main
from stand_ins import CHARTS, StandIns

# A gnuplot that ends in some wrong way, and what the program says of it.
FAILURES = {
    "true; exit 0": "drew nothing and printed no message",
    "cat >/dev/null; exit 0": "drew nothing and printed no message",
    "cat >/dev/null; echo half; echo it broke >&2; exit 3": "it broke",
    "echo half; kill -9 $$": "gnuplot failed",
    "echo half; kill -SEGV $$": "gnuplot failed",
    "exec 0<&- 1>&- 2>&-; exit 1": "gnuplot failed",
    "yes complaint | head -c 3000000 >&2; cat >/dev/null; exit 1": "complaint complaint",
    "exit 127": "gnuplot failed",
}


class Gnuplot(StandIns):
    def test_what_the_user_has_set(self):
        """One byte of difference, and the setting has reached gnuplot."""
        home = self.folder / "home"
        (home / ".config" / "fontconfig").mkdir(parents=True)
        (home / ".gnuplot").write_text("set term dumb\nset grid\nset decimalsign ','\n")
        (home / "gnuplotrc").write_text("exit\n")
        (home / ".config" / "fontconfig" / "fonts.conf").write_text(
            "<fontconfig><match target='pattern'><edit name='family' mode='assign' binding='strong'>"
            "<string>DejaVu Sans Mono</string></edit></match></fontconfig>")
        settings = {
            "HOME": str(home), "XDG_CONFIG_HOME": str(home / ".config"), "GNUTERM": "dumb",
            "GNUPLOT_LIB": str(home), "GNUPLOT_SHARE_DIR": str(home), "GNUPLOT_PS_DIR": str(home),
            "GNUPLOT_DRIVER_DIR": "/nonexistent", "GNUPLOT_DEFAULT_GDFONT": "none", "GNUHELP": "/nonexistent",
            "GDFONTPATH": "/nonexistent", "GNUPLOT_FONTPATH": "/nonexistent", "GNUFITLOG": "/nonexistent",
            "GNUPLOT_PDF_FONT": "none", "FONTCONFIG_FILE": "/nonexistent", "FONTCONFIG_PATH": "/nonexistent",
            "POSIXLY_CORRECT": "1", "LC_ALL": "de_DE.UTF-8", "LC_NUMERIC": "de_DE.UTF-8", "LANG": "ar_EG.UTF-8",
            "LANGUAGE": "de", "TZ": "Asia/Tokyo", "SOURCE_DATE_EPOCH": "1", "COLUMNS": "3", "LINES": "2",
            "GNUPLOT_BROWSER": "false", "SHELL": "/bin/false", "PAGER": "false", "TERM": "none"}
        environments = {"none": {"PATH": os.environ["PATH"]}, "all": {**os.environ, **settings},
                        **{name: {**os.environ, name: value} for name, value in settings.items()
                           if name.startswith(("GNUTERM", "HOME", "POSIX", "LC_ALL", "FONTCONFIG", "SOURCE"))}}
        for chart in CHARTS:
            for kind in ("svg", "pdf", "png"):
                first = None
                for name, environment in environments.items():
                    done = subprocess.run(self.command(f"a.{kind}", chart), cwd=ROOT, env=environment,
                                          check=False, capture_output=True, encoding="utf-8")
                    self.assertEqual((done.returncode, done.stderr), (0, ""), name)
                    data = (self.folder / f"a.{kind}").read_bytes()
                    first = first or data
                    self.assertTrue(data == first, f"{kind} with {name}")

    def test_failures(self):
        """Status 5, what it said, and the file as before."""
        (self.folder / "a.svg").write_text("as before")
        for k, (script, said) in enumerate(FAILURES.items()):
            done = subprocess.run(self.command("a.svg"), cwd=ROOT, env=self.stand_in(f"tools {k}", script),
                                  check=False, capture_output=True, encoding="utf-8")
            self.assertEqual((done.returncode, done.stdout), (5, ""), script)
            self.assertIn(said, done.stderr)
            self.assertIn("gnuplot failed", done.stderr)
            self.assertEqual((self.folder / "a.svg").read_text(), "as before")
        self.assertEqual(list(self.folder.glob("**/*.part")), [])

    def test_cannot_be_started(self):
        environment = self.stand_in("tools", "exit 0")
        (self.folder / "tools" / "gnuplot").write_text("#!/nonexistent/shell\n")
        for path in (environment["PATH"].split(":")[0], "/nonexistent"):
            done = subprocess.run(self.command("a.svg"), cwd=ROOT, env={"PATH": path},
                                  check=False, capture_output=True, encoding="utf-8")
            self.assertEqual((done.returncode, done.stdout), (5, ""))
            self.assertIn("gnuplot", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["tools"])


if __name__ == "__main__":
    main()
