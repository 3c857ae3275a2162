# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A gnuplot, or an ffmpeg, that hung hung the program: it is ended after a minute of nothing. The minute passes in three seconds: in the
program a clock runs, and waits end, 20 times as fast; under `./check --long` it is a minute."""

import pathlib
import subprocess
import tempfile
import time

from harness import LONG, PROGRAM, ROOT, compiled, main
from stand_ins import StandIns

# A gnuplot that does not end.
HANGS = ("exec sleep 100", "cat >/dev/null; echo half; exec sleep 100",
         "exec 0<&- 1>&- 2>&-; exec sleep 100", "sleep 100 & cat >/dev/null; echo half; exit 0",
         "trap '' TERM INT HUP; sleep 100; sleep 100")

FASTER = 1 if LONG else 20
CLOCK = """
#define _GNU_SOURCE
#include <poll.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
enum { FASTER = 20, NANO = 1000000000 };
int clock_gettime(clockid_t clock, struct timespec *now) {
  const int ended = (int)syscall(SYS_clock_gettime, clock, now);
  if (clock != CLOCK_MONOTONIC || ended != 0) return ended;
  const long long nano = now->tv_nsec * (long long)FASTER;
  now->tv_sec = now->tv_sec * FASTER + nano / NANO;
  now->tv_nsec = nano % NANO;
  return 0;
}
int poll(struct pollfd *ends, nfds_t count, int milliseconds) {
  const struct timespec most = {milliseconds / FASTER / 1000, milliseconds / FASTER % 1000 * 1000000L};
  return ppoll(ends, count, milliseconds < 0 ? NULL : &most, NULL);
}
"""


class Hangs(StandIns):
    def hurried(self, environment):
        """With the clock, and waits, of the program as fast as is said above."""
        if FASTER == 1:
            return environment
        folder = tempfile.TemporaryDirectory(prefix="topple-clock-")  # LD_PRELOAD separates by spaces, which self.folder has
        self.addCleanup(folder.cleanup)
        compiled(CLOCK, pathlib.Path(folder.name) / "clock.so")
        return environment | {"LD_PRELOAD": f"{folder.name}/clock.so"}

    def test_hangs(self):
        """Every kind of hanging ends after a minute, all at the same time here."""
        began = time.monotonic()
        processes = []
        for k, script in enumerate(HANGS):
            (self.folder / f"{k}.svg").write_text("as before")
            processes.append(subprocess.Popen(  # pylint: disable=consider-using-with
                self.command(f"{k}.svg"), cwd=ROOT, env=self.hurried(self.stand_in(f"tools {k}", script)),
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"))
        animation = [PROGRAM, "tilt", "--json", "--animation", self.folder / "a.webm", "examples/tilt_block_f.yaml"]
        with subprocess.Popen(animation, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8",
                              env=self.hurried(self.stand_in("moving", "cat >/dev/null; exec sleep 100", "ffmpeg"))) as film:
            self.assertIn("ffmpeg failed: it did not respond for 60 seconds", film.communicate(timeout=300)[1])
            self.assertEqual(film.returncode, 5)
        self.assertFalse((self.folder / "a.webm").exists())
        for k, process in enumerate(processes):
            out, err = process.communicate(timeout=300)
            self.assertEqual((process.returncode, out), (5, ""), HANGS[k])
            self.assertIn("did not respond for 60 seconds", err)
            self.assertEqual((self.folder / f"{k}.svg").read_text(), "as before")
        self.assertEqual(list(self.folder.glob("**/*.part")), [])
        self.assertGreaterEqual(time.monotonic() - began, 60 / FASTER)


if __name__ == "__main__":
    main()
