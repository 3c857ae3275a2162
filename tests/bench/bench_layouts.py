# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a second thread, or a second rank of MPI, adds to a study.

    bench_layouts.py TOPPLE STUDY

Measured: the study with FEW and with MANY samples, by one thread, by two, and by two ranks of one thread each, in turn, on the
clock, medians of ROUNDS. What MANY take beyond FEW is computing alone, without the start of a process or of mpirun, which
stands beside it. To be read: the share of twice the speed of one thread; the aim is 95 %. On a machine that other work keeps
busy it is less, and what the machine gives stands in the last row: two processes that know nothing of each other, each with
half the samples. What all compute together, beside what one thread computes, is what sharing itself costs."""

import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROUNDS, FEW, MANY = 3, 500, 5500


def study_of(path, samples, folder):
    """The study with other samples, beside a copy of its scene."""
    lines = path.read_text(encoding="utf-8").splitlines()
    scene = next(line.split(":", 1)[1].strip() for line in lines if line.startswith("scene:"))
    shutil.copy(path.parent / scene, folder)
    own = folder / f"{samples}.yaml"
    own.write_text("\n".join(f"samples: {samples}" if line.startswith("samples:") else line
                             for line in lines if not line.startswith("design_values:")), encoding="utf-8")
    return own


def seconds(commands):
    """All at once, to the end of the last: on the clock, and computed by all together."""
    began, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    running = [subprocess.Popen(command, stdout=subprocess.DEVNULL) for command in commands]
    if any([process.wait() for process in running]):
        sys.exit(5)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (time.monotonic() - began,
            after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def measure(program, path, folder):
    ranks = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2"]
    layouts = {"one thread": lambda own: [[program, "study", own, "--threads", "1"]],
               "two threads": lambda own: [[program, "study", own, "--threads", "2"]]}
    if shutil.which("mpirun"):
        layouts["two ranks"] = lambda own: [[*ranks, program, "study", own, "--threads", "1"]]
    layouts["two processes"] = lambda own: [[program, "study", own, "--threads", "1", "--shard", f"{k}/2", "--csv",
                                             folder / f"{k}.csv", "--restart"] for k in (1, 2)]
    few, many = (study_of(path, samples, folder) for samples in (FEW, MANY))
    times = {name: {few: [], many: []} for name in layouts}
    for _ in range(ROUNDS):
        for name, commands in layouts.items():
            for own in (few, many):
                times[name][own].append(seconds(commands(own)))
    return {name: [[statistics.median(kind) for kind in zip(*own[which])] for which in (few, many)]
            for name, own in times.items()}


def main():
    program, path = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        times = measure(program, path, pathlib.Path(name))
    one, work = (after - before for before, after in zip(*times["one thread"]))
    print(f"{path.name}: {MANY - FEW} samples beyond {FEW}")
    for name, (few, many) in times.items():
        clock, computed = (after - before for before, after in zip(few, many))
        share = "" if name == "one thread" else f", {one / clock / 2:6.1%} of twice the speed"
        print(f"{name:14} {1e6 * clock / (MANY - FEW):7.1f} us a sample, computed {computed / work:5.3f} of one's, "
              f"{FEW} samples in {few[0]:6.3f} s{share}")


if __name__ == "__main__":
    main()
