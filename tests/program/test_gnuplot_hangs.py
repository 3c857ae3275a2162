# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A gnuplot, or an ffmpeg, that hung hung the program: it is ended after a minute of nothing."""

import subprocess

from harness import PROGRAM, ROOT, main
from stand_ins import StandIns

# A gnuplot that does not end.
HANGS = ("exec sleep 100", "cat >/dev/null; echo half; exec sleep 100",
         "exec 0<&- 1>&- 2>&-; exec sleep 100", "sleep 100 & cat >/dev/null; echo half; exit 0",
         "trap '' TERM INT HUP; sleep 100; sleep 100")


class Hangs(StandIns):
    def test_hangs(self):
        """Every kind of hanging ends after a minute, all at the same time here."""
        processes = []
        for k, script in enumerate(HANGS):
            (self.folder / f"{k}.svg").write_text("as before")
            processes.append(subprocess.Popen(  # pylint: disable=consider-using-with
                self.command(f"{k}.svg"), cwd=ROOT, env=self.stand_in(f"tools {k}", script),
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"))
        animation = [PROGRAM, "tilt", "--json", "--animation", self.folder / "a.webm", "examples/tilt_block_f.yaml"]
        with subprocess.Popen(animation, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8",
                              env=self.stand_in("moving", "cat >/dev/null; exec sleep 100", "ffmpeg")) as film:
            self.assertIn("ffmpeg failed: it did not respond for 60 seconds", film.communicate(timeout=300)[1])
            self.assertEqual(film.returncode, 5)
        self.assertFalse((self.folder / "a.webm").exists())
        for k, process in enumerate(processes):
            out, err = process.communicate(timeout=300)
            self.assertEqual((process.returncode, out), (5, ""), HANGS[k])
            self.assertIn("did not respond for 60 seconds", err)
            self.assertEqual((self.folder / f"{k}.svg").read_text(), "as before")
        self.assertEqual(list(self.folder.glob("**/*.part")), [])


if __name__ == "__main__":
    main()
