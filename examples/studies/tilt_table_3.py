# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The numerical column of Table 3 of Alejano et al.: every row as a simulated tilt test by each
engine, on a base that ends with the block and on one that goes on by a tooth, beside the paper's
values and the window of statics. docs/tilt_table_3.md says what comes out of it.

    tilt_table_3.py [--tried] [--cost] [BLOCK …]

BLOCK: A to G, all unless given. --tried: what was tried for E and F, --cost: runs and times."""

import argparse
import sys
import warnings

import topple

# Tables 1 and 3: block, axis, teeth, a, b, c in mm, direction, physical and numerical angles as
# printed; * where it slides
ROWS = (
    ("A", "peak", 3, 15, 94, 5, "left", "23.5", "26.2"),
    ("A", "valley", 3, 15, 94, 5, "left", "19.8", "23.9"),
    ("B", "peak", 3, 14, 135, 5, "left", "15.0", "17.6"),
    ("B", "valley", 3, 14, 135, 5, "left", "12.6", "16.4"),
    ("C", "valley", 4, 20, 158, 7, "left", "21.7", "25.3"),
    ("C", "valley", 4, 20, 158, 7, "right", "21.4", "25.3"),
    ("D", "peak", 4, 20, 242, 7, "left", "15.3", "18.5"),
    ("D", "peak", 4, 20, 242, 7, "right", "15.1", "18.5"),
    ("E", "valley", 3, 30, 120, 5, "left", "26.7*", "27.5*"),
    ("E", "peak", 3, 30, 120, 5, "left", "37.4", "37.4"),
    ("F", "valley", 2, 30, 118, 5, "left", "20.5*", "20.5*"),
    ("F", "valley", 2, 30, 118, 5, "right", "20.5*", "20.5*"),
    ("G", "peak", 2, 30, 123, 5, "left", "23.8", "26.4"),
    ("G", "peak", 2, 30, 123, 5, "right", "23.9", "26.4"),
)
SCENE = """topple: 1
length_unit: mm
block:
  teeth: {{count: {count}, width: {a}, height: {b}, depth: {c}, left_end: {axis}}}
  thickness: 20
  unit_weight_kn_m3: 25.8
base: {{mated: true, beyond: {{left: {beyond}, right: {beyond}}}}}
friction_angle_deg: {friction}
tilt: {{towards: {towards}}}
tilt_test: {{{test}}}
"""
STIFF = "normal_stiffness_gpa_m: {}, shear_stiffness_gpa_m: {}"
PAPER = STIFF.format(1000, 10)
PATH = f"engine: path, {PAPER}"
EVENTS = "engine: dynamics, protocol: steps"
SPRINGS = "engine: dynamics, method: springs, protocol: steps"
ENGINES = {"path": PATH, "events": EVENTS, "springs": f"{SPRINGS}, {PAPER}"}
AGREEMENT_DEG = 0.05
E, F = ROWS[8], ROWS[10]
TRIED = (
    ("path, k_s = k_n/1000", f"engine: path, {STIFF.format(1000, 1)}"),
    ("path, k_s = k_n/100, the paper's", PATH),
    ("path, k_s = k_n/10", f"engine: path, {STIFF.format(1000, 100)}"),
    ("path, k_s = k_n", f"engine: path, {STIFF.format(1000, 1000)}"),
    ("path, set down at each tilt", f"{PATH}, protocol: steps"),
    ("events, set down at each tilt", EVENTS),
    ("events, table raised at 20°/min", "engine: dynamics, protocol: ramp"),
    ("springs, the paper's", ENGINES["springs"]),
    ("springs, stiffness a tenth", f"{SPRINGS}, {STIFF.format(100, 1)}"),
    ("springs, ten times as stiff", f"{SPRINGS}, {STIFF.format(10000, 100)}"),
    ("springs, k_s = k_n", f"{SPRINGS}, {STIFF.format(1000, 1000)}"),
    ("springs, corners of 10⁻⁶ m", f"{SPRINGS}, {PAPER}, rounding: 0.001"),
    ("springs, corners of 10⁻⁸ m", f"{SPRINGS}, {PAPER}, rounding: 0.00001"),
    ("springs, damping 0.2", f"{SPRINGS}, {PAPER}, damping: 0.2"),
    ("springs, steps of 0.5 µs", f"{SPRINGS}, {PAPER}, time_step_s: 0.0000005"),
)

warnings.simplefilter("ignore", topple.Caution)


def scene_of(row, test, goes_on, friction=30):
    _, axis, count, a, b, c, towards, *_ = row
    return topple.Scene.from_text(SCENE.format(
        axis=axis, count=count, a=a, b=b, c=c, towards=towards, friction=friction, test=test,
        beyond=a if goes_on else 0))


def case_of(row, test, goes_on):
    return topple.tilt_test(scene_of(row, test, goes_on), moments=2).cases[0]


def bracket(case):
    """Both ends; one number where they differ by less than its last digit; or that a run was not
    decided."""
    if case.lets_go_at_deg is None:
        return "undecided"
    least, most = f"{case.stands_at_deg:.3f}", f"{case.lets_go_at_deg:.3f}"
    return least if case.lets_go_at_deg - case.stands_at_deg < 1e-4 else f"{least}–{most}"


def agrees(case):
    """Within the window, widened by what is asked; where onset and limit are one, at it. What is
    undecided says nothing."""
    return case.lets_go_at_deg is None or (case.converged and case.lets_go_at_deg >= case.onset_deg - AGREEMENT_DEG
            and case.stands_at_deg <= case.limit_deg + AGREEMENT_DEG)


def starred(angle):
    """As printed, for a page of Markdown."""
    return angle.replace("*", "\\*")


def line(cells):
    print("| " + " | ".join(cells) + " |")


def head(*cells):
    print()
    line(cells)
    line(["---"] * len(cells))


def away(row, case):
    """The paper's number less the middle of the bracket."""
    return f"{float(row[8].rstrip('*')) - (case.stands_at_deg + case.lets_go_at_deg) / 2:+.2f}"


def cost_of(row, test, goes_on, case):
    """Runs of the engine, and milliseconds: of what is short the least of five."""
    times = [case.seconds]
    if times[0] < 0.05:
        times += [case_of(row, test, goes_on).seconds for _ in range(4)]
    return f"{case.runs}, {1000 * min(times):.1f}"


def table(rows, goes_on, cost):
    """The column on one base; whether all of it agrees with statics."""
    head("block", "axis", "physical", "paper's α_num", "window α_s, α_w", *ENGINES,
         "paper less path")
    agree, costs = True, []
    for row in rows:
        cases = [case_of(row, test, goes_on) for test in ENGINES.values()]
        agree &= all(agrees(case) for case in cases)
        statics = f"{cases[0].onset_deg:.3f}, {cases[0].limit_deg:.3f}"
        line([f"{row[0]}, {row[6]}", row[1], starred(row[7]), starred(row[8]), statics,
              *(bracket(case) for case in cases), away(row, cases[0])])
        if cost:
            costs.append([f"{row[0]}, {row[6]}", row[1],
                          *(cost_of(row, test, goes_on, case)
                            for test, case in zip(ENGINES.values(), cases))])
    if costs:
        head("block", "axis", *(f"{name}: runs, ms" for name in ENGINES))
        for cells in costs:
            line(cells)
    return agree


def last_slip(case, facet):
    """The tilt from which a facet slips until the block begins to move."""
    tilts = [event.angle_deg for event in case.events
             if event.what == topple.TiltEventKind.SLIPS and event.facet == facet
             and event.angle_deg < case.stands_at_deg]
    return f"{tilts[-1]:.2f}" if tilts else "–"


def tried():
    head("tried, on the short base", "E moves", "E: facet 2 slips", "facet 1 slips",
         "F moves", "F: facet 2 slips", "facet 1 slips")
    for name, test in TRIED:
        cells = [name]
        for row in (E, F):
            case = case_of(row, test, False)
            cells += [bracket(case), last_slip(case, 2), last_slip(case, 1)]
        line(cells)
    head("friction angle that would explain it, short base", "the paper's physical",
         "the paper's numerical")
    for row in (E, F):
        cells = [f"{row[0]} towards its valley"]
        for angle in row[7:9]:
            found = topple.find(scene_of(row, PATH, False), "friction_angle_deg", "limit_angle",
                                float(angle.rstrip("*")), 10, 40)
            cells.append(f"{starred(angle)}: " + ", ".join(f"{s.value:.2f}°" for s in found.solutions))
        line(cells)


def main():
    words = argparse.ArgumentParser()
    words.add_argument("--tried", action="store_true")
    words.add_argument("--cost", action="store_true")
    words.add_argument("blocks", nargs="*")
    given = words.parse_args()
    rows = [row for row in ROWS if not given.blocks or row[0] in given.blocks]
    agree = [table(rows, goes_on, given.cost) for goes_on in (False, True)]
    if given.tried:
        tried()
    print("\nThe engines agree with statics." if all(agree)
          else "\nThe engines do NOT agree with statics.")
    return not all(agree)


if __name__ == "__main__":
    sys.exit(main())
