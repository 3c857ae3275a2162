# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What Python adds to a call of the library: each call by the package beside the bare calls of C
that it makes, both by the same binding, microseconds, least of several runs (docs/python.md)."""

import timeit

import numpy
import topple
from topple._library import ffi, lib
from topple.options import options_of

OUTLINE = numpy.array([(0, 0), (30, 5), (60, 0), (90, 5), (90, 125), (0, 120)], dtype=float)


def least(calls, runs=40):
    """Microseconds of each call, in turns, so that both have the machine's better moments."""
    timers = [timeit.Timer(call) for call in calls]
    number = max(1, int(0.01 / timers[0].timeit(1)))
    return (min(times) / number * 1e6 for times in zip(*([t.timeit(number) for t in timers]
                                                         for _ in range(runs))))


def bare_solve(scene, options):
    """tp_solve and tp_solution_free."""
    receives = ffi.new("tp_solution **")
    message = ffi.new("tp_message *")

    def call():
        lib.tp_solve(receives, scene, options, message)
        lib.tp_solution_free(receives[0])

    return call


def bare_scene(doubles):
    """The five calls that make a scene, and tp_scene_free."""
    receives = ffi.new("tp_scene **")
    message = ffi.new("tp_message *")
    unit, none = ffi.new("char[]", b"mm"), ffi.NULL

    def call():
        lib.tp_scene_new(receives, unit, message)
        lib.tp_scene_set_outline(receives[0], (6, doubles, none), message)
        lib.tp_scene_set_friction_angle_deg(receives[0], (30.0, none), message)
        lib.tp_scene_set_tilt_angle_deg(receives[0], (12.5, none), message)
        lib.tp_scene_free(receives[0])

    return call


def bare_moments(blocks):
    """tp_outlines_moments into new columns, as the package makes them."""
    outlines = ffi.new("tp_outlines *", (len(blocks), ffi.from_buffer("double[]", blocks),
                                         blocks.shape[1], ffi.NULL))
    summary, message = ffi.new("tp_blocks_summary *"), ffi.new("tp_message *")
    options = options_of("blocks")
    fields = ffi.typeof("tp_moment_columns").fields

    def call():
        columns, held = ffi.new("tp_moment_columns *"), []
        for name, kind in fields:
            is_number = kind.type.item.cname == "double"
            held.append(numpy.empty(len(blocks), dtype="f8" if is_number else "i4"))
            setattr(columns, name, ffi.cast(kind.type, ffi.from_buffer(held[-1])))
        lib.tp_outlines_moments(columns, summary, outlines, options, message)
        return held

    return call


def main():
    blocks = numpy.repeat(OUTLINE[None], 100000, axis=0)
    numbers = {"friction_angle_deg": 30.0, "tilt_angle_deg": 12.5}
    scene = topple.Scene("mm", outline=OUTLINE, **numbers)
    rows = [
        ("a scene of 6 vertices", lambda: topple.Scene("mm", outline=OUTLINE, **numbers),
         bare_scene(ffi.from_buffer("double[]", OUTLINE))),
        ("solved without the limit", lambda: scene.solve(limit=False),
         bare_solve(scene._c, options_of("solve", limit=False))),
        ("solved, and its angle", lambda: float(scene.solve().cases[0].first_angle_deg),
         bare_solve(scene._c, options_of("solve"))),
        ("moments of 100000 blocks", lambda: topple.moments(blocks), bare_moments(blocks)),
    ]
    print(f"{'call':28}{'Python':>9}{'bare':>9}{'added':>9}  µs")
    for name, call, bare in rows:
        python, c = least((call, bare))
        print(f"{name:28}{python:9.2f}{c:9.2f}{python - c:9.2f}")


if __name__ == "__main__":
    main()
