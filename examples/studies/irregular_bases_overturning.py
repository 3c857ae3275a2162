# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Rocking, seating anew, overturning: the outcomes of the shifted blocks of irregular_bases.py
(docs/irregular_bases.md) on a table that is raised to the left at 20 degrees per minute until they
fall, by rigid contacts with impacts (docs/rigid_contact.md), with a friction angle of 35 degrees.

    irregular_bases_overturning.py [SEEDS [SHIFT...]]

For each block: the critical angle by moments, alpha_s and alpha_w of statics with friction, the
tilt at which it first moves, and the one at which it has turned by a quarter. What is checked: it
first moves between alpha_s and alpha_w, but for the width of the bracket, and falls no sooner."""

import sys
import warnings

import numpy as np

import topple
from irregular_bases import SHIFTED_JRC, SHIFTS, rough, shifted_block

FRICTION = 35
PER_JRC = 20  # seeds of irregular_bases.py for each JRC
BRACKET = 0.02  # degrees

warnings.simplefilter("ignore", topple.Caution)


def blocks(seeds, shifts):
    """(shift, outline, base), the first of each JRC."""
    for place, jrc in enumerate(SHIFTED_JRC):
        for number in range(seeds):
            base = rough(300, jrc, 0.8, 1001 + PER_JRC * place + number)
            for shift in shifts:
                yield shift, shifted_block(base, shift), base


def listed(points):
    return "[" + ", ".join(f"[{float(x)!r}, {float(y)!r}]" for x, y in points) + "]"


def raised(outline, base):
    """(by moments, alpha_s, alpha_w, first motion, overturned), degrees."""
    scene = topple.Scene.from_text(
        f"""topple: 1
length_unit: mm
block: {{outline: {listed(outline)}, unit_weight_kn_m3: 26}}
base: {{profile: {listed(base)}, place: rest}}
friction_angle_deg: {FRICTION}
tilt: {{towards: left}}
tilt_test: {{engine: dynamics, protocol: ramp, until_deg: 60, duration_s: 300}}
""",
        "block",
    )
    (case,) = topple.tilt_test(scene, moments=2).cases
    (moments,) = scene.solve().cases
    fell = [event.angle_deg for event in case.events
            if event.what is topple.TiltEventKind.OVERTURNS]
    first = 0.0 if case.lets_go_at_deg is None or case.onset_deg < 0 else case.lets_go_at_deg
    return (moments.governing_pivot.critical_angle_deg.value, max(case.onset_deg, 0.0),
            max(case.limit_deg, 0.0), first, fell[0] if fell else np.nan)


def quantiles(angle):
    return " | ".join(f"{q:.1f}°" for q in np.quantile(angle, (0.05, 0.5, 0.95)))


def main():
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 6
    shifts = [float(word) for word in sys.argv[2:]] or SHIFTS
    rows = [(shift, *raised(outline, base)) for shift, outline, base in blocks(seeds, shifts)]
    shift, moments, onset, limit, first, fell = np.array(rows).T
    print(f"{len(rows)} blocks, {np.sum(np.isnan(fell))} of them not overturned; alpha_s and alpha_w "
          f"apart by {np.max(limit - onset):.3f} degrees at most\n")
    print("| what | 5 % | 50 % | 95 % |\n| --- | --- | --- | --- |")
    for name, angle in (("first rocking, by moments", moments), ("α_s, certain to stand", onset),
                        ("α_w, certain to move", limit), ("first motion on the table", first),
                        ("overturned", fell)):
        print(f"| {name} | {quantiles(angle[~np.isnan(angle)])} |")
    for one in shifts:
        print(f"| overturned, shifted by {one:g} mm | "
              f"{quantiles(fell[(shift == one) & ~np.isnan(fell)])} |")
    good = np.all((first >= onset - BRACKET) & (first <= limit + BRACKET))
    good = good and not np.any(fell < first)
    print("\nThe table and statics agree." if good else "\nThe table and statics do NOT agree.")
    return not good


if __name__ == "__main__":
    sys.exit(main())
