# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which scatter explains the tilt tests of Alejano et al.? A study (docs/study.md) for every row of
their Table 3, docs/tilt_test_scatter.md says what comes out of it. What varies:

    friction   triangular, 24 to 31 degrees, most likely 30: the range that section 2.3 states
    a, b       normal about Table 1, deviations 0.25 and 0.5 mm: of a sawn block
    radius     of the toe, evenly from 0 to 6 mm: about the range of Table 4; or none

and the angle is the static limit, by contact forces. The critical angle by moments of every sample
with a sharp toe is compared with atan((x_g - x_toe) / (y_g - y_toe)) of its outline.

Then the tests of one block are taken together, as they share its friction: for each friction angle
the radius of the toe that makes the limit the measured angle, and the least friction at which a
sharp toe has it.

    tilt_test_scatter.py [SAMPLES]"""

import pathlib
import sys
import tempfile
import warnings

import numpy as np

import topple

# Tables 1 and 3: block, its toe, teeth, a, b, c in mm, the angles measured
TESTS = (
    ("A", "peak", 3, 15, 94, 5, (23.5,)), ("A", "valley", 3, 15, 94, 5, (19.8,)),
    ("B", "peak", 3, 14, 135, 5, (15.0,)), ("B", "valley", 3, 14, 135, 5, (12.6,)),
    ("C", "valley", 4, 20, 158, 7, (21.7, 21.4)), ("D", "peak", 4, 20, 242, 7, (15.3, 15.1)),
    ("E", "valley", 3, 30, 120, 5, (26.7,)), ("E", "peak", 3, 30, 120, 5, (37.4,)),
    ("F", "valley", 2, 30, 118, 5, (20.5,)), ("G", "peak", 2, 30, 123, 5, (23.8, 23.9)),
)
SCENE = """topple: 1
length_unit: mm
parameters: {{a: {a}, b: {b}, c: {c}}}
block:
  teeth: {{count: {count}, width: a, height: b, depth: c, left_end: {toe}}}
{rounded}base: {{mated: true, beyond: {{left: 0, right: 0}}}}
friction_angle_deg: {friction}
tilt: {{towards: left}}
"""
ROUNDED = "  rounded: {{model: paper, corners: [{{at: left_end, radius: {radius}}}]}}\n"
FRICTIONS = (24, 26, 28, 30, 31)  # degrees, at which the tests of a block are taken together
STUDY = """topple_study: 1
scene: scene.yaml
samples: {samples}
vary:
  friction_angle_deg: {{triangular: {{low: 24, mode: 30, high: 31}}}}
  parameters.a: {{normal: {{mean: {a}, deviation: 0.25}}}}
  parameters.b: {{normal: {{mean: {b}, deviation: 0.5}}}}
{radius}"""
RADIUS = "  block.rounded.corners.1.radius: {uniform: {low: 0, high: 6}}\n"

warnings.simplefilter("ignore", topple.Caution)


def scene(toe, count, a, b, c, friction, radius):
    """Of one test, with a toe of that radius in mm; 0: sharp."""
    rounded = ROUNDED.format(radius=radius) if radius > 0 else ""
    return SCENE.format(a=a, b=b, c=c, count=count, toe=toe, rounded=rounded, friction=friction)


def run(folder, samples, toe, count, a, b, c, rounded):
    """The study of one test."""
    numbers = {"a": a, "b": b, "c": c, "count": count, "toe": toe, "samples": samples}
    (folder / "scene.yaml").write_text(scene(toe, count, a, b, c, 30, 3 if rounded else 0))
    (folder / "study.yaml").write_text(STUDY.format(radius=RADIUS if rounded else "", **numbers))
    return topple.study(folder / "study.yaml")


def by_outline(toe, count, a, b, c):
    """The critical angle by moments about the toe, from the centroid of the outline."""
    low = toe == "valley"  # of the left end, which has the height 0 then
    x = [k * a for k in range(count + 1)] + [count * a, 0]
    y = [c * ((k % 2 == 1) == low) for k in range(count + 1)] + [b + c] * 2
    x, y = np.array(x), np.array(y, dtype=float)
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    centroid = [np.sum((v + np.roll(v, -1)) * cross) / (3 * np.sum(cross)) for v in (x, y)]
    return np.degrees(np.arctan2(centroid[0] - x[0], centroid[1] - y[0]))


def largest_difference(study, toe, count, c):
    columns = study.columns
    formula = [by_outline(toe, count, a, b, c)
               for a, b in zip(columns["parameters.a_mm"], columns["parameters.b_mm"])]
    return np.max(np.abs(columns["moments_deg"] - formula))


def quantiles(angle):
    low, middle, high = np.quantile(angle, (0.05, 0.5, 0.95))
    return f"{middle:.1f}°, {low:.1f}° to {high:.1f}°"


def strongest(study):
    """The number that goes with the limit most, and its rank correlation."""
    place = list(topple.StudyQuantity).index(topple.StudyQuantity.LIMIT_DEG)
    ranks = {variable.key: variable.rank_correlations[place].value for variable in study.variables}
    key = max(ranks, key=lambda name: abs(ranks[name]))
    short = {"friction_angle_deg": "friction", "block.rounded.corners.1.radius": "radius"}
    return f"{short.get(key, key[-1])} {ranks[key]:.2f}"


def limit(block, friction, radius):
    """In degrees; None where so large a radius does not fit between the teeth."""
    try:
        own = topple.Scene.from_text(scene(*block, friction, radius), "block").solve(digits=6)
    except topple.BadInput:
        return None
    return own.cases[0].limit.critical_angle_deg.value


def halved(low, high, is_above):
    """Where `is_above` begins to hold, to a thousandth."""
    while high - low > 1e-3:
        middle = (low + high) / 2
        low, high = (low, middle) if is_above(middle) else (middle, high)
    return (low + high) / 2


def radius_for(block, friction, measured):
    """In words, the radius of the toe that makes the limit what was measured."""
    if limit(block, friction, 0) < measured:
        return "none"

    def is_enough(radius):
        angle = limit(block, friction, radius)
        return angle is None or angle <= measured

    radius = halved(0, 20, is_enough)
    return f"{radius:.1f} mm" if limit(block, friction, radius - 2e-3) is not None else "too large"


def least_friction(block, measured):
    """In words, the friction below which not even a sharp toe stands up to what was measured."""
    if limit(block, 20, 0) >= measured:
        return "below 20°"
    return f"{halved(20, 45, lambda friction: limit(block, friction, 0) >= measured):.2f}°"


def tell_together():
    print("\n| block | toe | measured | friction at least | " +
          " | ".join(f"radius at {friction}°" for friction in FRICTIONS) + " |\n|" +
          " --- |" * (4 + len(FRICTIONS)))
    for name, *block, measured in TESTS:
        for angle in measured:
            cells = [name, block[0], f"{angle}°", least_friction(block, angle)]
            cells += [radius_for(block, friction, angle) for friction in FRICTIONS]
            print("| " + " | ".join(cells) + " |")


def main():
    samples = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    worst = 0.0
    print("| block | toe | measured | sharp: median, 90 % | probability | rounded: median, 90 % | "
          "probability | goes with |\n|" + " --- |" * 8)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for block, toe, count, a, b, c, measured in TESTS:
            sharp = run(folder, samples, toe, count, a, b, c, False)
            worst = max(worst, largest_difference(sharp, toe, count, c))
            rounded = run(folder, samples, toe, count, a, b, c, True)
            cells = [block, toe, ", ".join(f"{angle}°" for angle in measured)]
            for study in (sharp, rounded):
                limit = study.columns["limit_deg"]
                cells.append(quantiles(limit))
                cells.append(", ".join(f"{np.mean(limit <= angle):.2f}" for angle in measured))
            print("| " + " | ".join(cells + [strongest(rounded)]) + " |")
    tell_together()
    print(f"\nmoments of sharp toes: off by {worst:.0e} degrees at most")
    agree = worst <= 2e-9 * 40  # nine digits of angles below 40 degrees
    print("The outlines agree." if agree else "The outlines do NOT agree.")
    return not agree


if __name__ == "__main__":
    sys.exit(main())
