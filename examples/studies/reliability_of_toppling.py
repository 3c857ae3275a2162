# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How reliable is a block that a partial factor calls safe? docs/reliability_of_toppling.md says what comes out of it.

First a benchmark: slabs that slide or topple, whichever comes first, so that failure has two design points and a probability
in closed form, or as one integral. The first-order method, samples around the design points and subset simulation are held
against it.

Then a family of slabs whose width and dip are known with an error: which factor of safety against toppling reaches the
reliability indices 3.1, 3.8 and 4.3, and which index the factors of EN 1997-1, EQU, reach.

    reliability_of_toppling.py [FIGURE.svg]

What is checked: the truth lies within three half widths of each interval, in the logarithm; the first-order index lies
within 0.1 of that of the integral."""

import math
import sys
import tempfile
import warnings
from pathlib import Path
from statistics import NormalDist

import numpy as np

import topple

NORMAL = NormalDist()
HEIGHT = 2.0  # metres
TARGETS = (3.1, 3.8, 4.3)
SLENDERNESS = (1.5, 2, 3, 4, 5)
WIDTH_ERRORS = (0.02, 0.05, 0.10)  # coefficient of variation
DIP_ERRORS = (0.5, 1, 2)  # degrees, standard deviation
EQU = 1.1 / 0.9  # EN 1997-1, Table A.1: unfavourable over favourable permanent action

SCENE = """topple: 1
length_unit: m
block: {{slab: {{width: {width!r}, height: {height!r}}}, unit_weight_kn_m3: 26}}
base: {{mated: true}}
friction_angle_deg: {friction!r}
loads: {{seismic: {{horizontal: 0.05}}}}
tilt: {{towards: left, angle_deg: {tilt!r}}}
"""
STUDY = """topple_study: 1
scene: scene.yaml
samples: 8
vary: {vary}
{more}reliability: {{quantity: limit_deg{sampled}}}
"""

warnings.simplefilter("ignore", topple.Caution)


def cumulative(score):
    """The standard normal distribution of an array of scores, to the last digits in its lower tail."""
    return np.array([0.5 * math.erfc(-s / math.sqrt(2)) for s in np.ravel(score)])


def weighed(low, high):
    """Scores of the variable that is integrated over, and their weights: the trapezoidal rule, to 1e-5 of the sum."""
    scores = np.linspace(low, high, 4001)
    weights = np.exp(-scores**2 / 2) / math.sqrt(2 * math.pi) * (scores[1] - scores[0])
    weights[[0, -1]] /= 2
    return scores, weights


SCORES, WEIGHTS = weighed(-9, 9)


def log_moments(mean, variation):
    """Mean and deviation of the logarithm of a lognormal number."""
    spread = math.sqrt(math.log(1 + variation**2))
    return math.log(mean) - spread**2 / 2, spread


def reliability(width, tilt, vary, *, friction=35.0, shaken=False, sampled="", more=""):
    """The estimates of the program for a slab: it fails where its limit does not lie above its tilt."""
    text = SCENE.format(width=width, height=HEIGHT, friction=friction, tilt=tilt)
    if not shaken:
        text = "".join(line for line in text.splitlines(True) if not line.startswith("loads"))
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.yaml").write_text(text, encoding="utf-8")
        study = STUDY.format(vary="{" + ", ".join(f"{key}: {how}" for key, how in vary.items()) + "}", sampled=sampled, more=more)
        return topple.study_text(study, str(Path(folder) / "study.yaml")).reliability


# The benchmark. Each case: its name, the truth, and the study. A slab slides beyond its friction angle, and topples beyond
# atan(width/height).


def lognormal(mean, variation):
    return f"{{lognormal: {{mean: {mean!r}, deviation: {mean * variation!r}}}}}"


def normal(mean, deviation):
    return f"{{normal: {{mean: {mean!r}, deviation: {deviation!r}}}}}"


def width_for(index, variation, tilt):
    """The mean width at which toppling alone has this reliability index."""
    _, spread = log_moments(1, variation)
    return HEIGHT * math.tan(math.radians(tilt)) * math.exp(index * spread + spread**2 / 2)


def two_modes(slide, topples, correlation=0.0):
    """A slab at 20 degrees with these indices of sliding and toppling: of its friction angle and of its width."""
    tilt, deviation, variation = 20.0, 3.0, 0.08
    friction, width = tilt + slide * deviation, width_for(topples, variation, tilt)
    if correlation == 0:
        truth = -math.expm1(sum(math.log1p(-p) for p in cumulative([-slide, -topples])))
    else:  # one or the other: the bivariate normal distribution as an integral over the score of friction
        rest = math.sqrt(1 - correlation**2)
        scores, weights = weighed(-slide, 9)  # at which it does not slide
        falls = cumulative(-(topples + correlation * scores) / rest)
        truth = float(cumulative(-slide)[0] + np.sum(weights * falls))
    vary = {"friction_angle_deg": normal(friction, deviation), "block.slab.width": lognormal(width, variation)}
    more = f"correlations: [[friction_angle_deg, block.slab.width, {correlation!r}]]\n" if correlation else ""
    return truth, {"width": width, "tilt": tilt, "vary": vary, "friction": friction, "more": more}


def shaken():
    """The same on a plane at 12 degrees in an earthquake that drives both modes: a lognormal coefficient of 0.1 in the mean."""
    tilt, friction, deviation, width, variation = 12.0, 38.0, 3.0, 1.7, 0.05
    middle, spread = log_moments(0.1, 0.4)
    turned = tilt + np.degrees(np.arctan(np.exp(middle + spread * SCORES)))  # by so much the resultant leans
    log_width, width_spread = log_moments(width, variation)
    slides = cumulative((turned - friction) / deviation)
    falls = np.where(turned < 89, cumulative((np.log(HEIGHT * np.tan(np.radians(np.minimum(turned, 89)))) - log_width) / width_spread), 1)
    truth = float(np.sum(WEIGHTS * (slides + falls - slides * falls)))
    vary = {"friction_angle_deg": normal(friction, deviation), "block.slab.width": lognormal(width, variation),
            "loads.seismic.horizontal": lognormal(0.1, 0.4)}
    return truth, {"width": width, "tilt": tilt, "vary": vary, "friction": friction, "shaken": True}


def benchmark():
    cases = [("equal modes", *two_modes(3, 3)), ("sliding governs", *two_modes(2.5, 3.5)),
             ("correlated by 0.5", *two_modes(3, 3, 0.5)), ("correlated by -0.5", *two_modes(3, 3, -0.5)),
             ("rare", *two_modes(4.3, 4.5)), ("earthquake", *shaken())]
    good = True
    print("| case | truth | first order | both points | samples around them | subset simulation |\n| --- | --- | --- | --- | --- | --- |")
    for name, truth, arguments in cases:
        found = reliability(sampled=", importance: {samples: 4000}, subset: {samples: 2000}", **arguments)
        around, subset = found.importance, found.subset
        points = sum(point.probability for point in found.design_points)
        print(f"| {name} | {truth:.3e} | {found.probability:.3e} | {points:.3e} | {span(around)} | {span(subset)} |")
        for estimate in (around, subset):
            half = math.log(estimate.high / estimate.low) / 2
            good = good and abs(math.log(estimate.probability / truth)) < 3 * half
    return good


def span(estimate):
    return f"{estimate.probability:.2e}, {estimate.low:.2e} to {estimate.high:.2e}"


# The family.


def exact_index(slenderness, factor, width_error, dip_error):
    """The index of toppling of a slab whose mean factor of safety this is: an integral over the error of its dip."""
    dip = math.degrees(math.atan(1 / (slenderness * factor)))
    log_width, spread = log_moments(HEIGHT / slenderness, width_error)
    dips = dip + dip_error * SCORES
    needed = HEIGHT * np.tan(np.radians(np.clip(dips, 1e-6, 89)))
    topples = float(np.sum(WEIGHTS * cumulative((np.log(needed) - log_width) / spread)))
    return -NORMAL.inv_cdf(min(max(topples, 1e-300), 1 - 1e-16))


def factor_for(index, *of):
    """The factor that reaches an index, by bisection: the index rises with it."""
    low, high = 1.0, 20.0
    while high - low > 1e-9:
        middle = (low + high) / 2
        low, high = (middle, high) if exact_index(of[0], middle, *of[1:]) < index else (low, middle)
    return high


def first_order_index(slenderness, factor, width_error, dip_error):
    """The same by the program, on the rock with friction that no slab here slides at."""
    width, dip = HEIGHT / slenderness, math.degrees(math.atan(1 / (slenderness * factor)))
    vary = {"block.slab.width": lognormal(width, width_error), "tilt.angle_deg": normal(dip, dip_error)}
    return reliability(width, dip, vary, friction=80.0).beta


def family():
    rows, good = [], True
    print("\n| height to width | width ± | dip ± | β 3.1 | β 3.8 | β 4.3 | β of EQU | by the program |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- |")
    for slenderness in SLENDERNESS:
        for width_error in WIDTH_ERRORS:
            for dip_error in DIP_ERRORS:
                of = (slenderness, width_error, dip_error)
                factors = [factor_for(index, *of) for index in TARGETS]
                reached = exact_index(slenderness, EQU, width_error, dip_error)
                first = first_order_index(slenderness, EQU, width_error, dip_error)
                good = good and abs(first - reached) < 0.1
                rows.append((*of, factors, reached))
                numbers = " | ".join(f"{factor:.2f}" for factor in factors)
                print(f"| {slenderness:g} | {100 * width_error:g} % | {dip_error:g}° | {numbers} | {reached:.2f} | {first:.2f} |")
    return rows, good


def by_design_values(rows):
    """Instead of one factor on moments, a design width and a design dip (EN 1990, C.7): the dominant error counts with its
    full index, the other with 0.4 of it. Which indices slabs have that are just right by that."""
    print("\n| β wanted | least of the family | median | greatest | slabs that have no dip to stand on |\n| --- | --- | --- | --- | --- |")
    for index in TARGETS:
        reached, refused = [], 0
        for slenderness, width_error, dip_error in (row[:3] for row in rows):
            _, spread = log_moments(1, width_error)
            dips = []
            for of_width, of_dip in ((1, 0.4), (0.4, 1)):
                width = HEIGHT / slenderness * math.exp(-of_width * index * spread)
                dips.append(math.degrees(math.atan(width / HEIGHT)) - of_dip * index * dip_error)
            if min(dips) <= 0:
                refused += 1
                continue
            factor = 1 / (slenderness * math.tan(math.radians(min(dips))))
            reached.append(exact_index(slenderness, factor, width_error, dip_error))
        print(f"| {index} | {min(reached):.2f} | {np.median(reached):.2f} | {max(reached):.2f} | {refused} of {len(rows)} |")


def summary(rows):
    """Of the whole family: the factor that reaches each index in every member, and in the median."""
    print("\n| β | greatest factor of the family | median | members that EQU brings there |\n| --- | --- | --- | --- |")
    for k, index in enumerate(TARGETS):
        factors = [row[3][k] for row in rows]
        reached = sum(row[4] >= index for row in rows)
        print(f"| {index} | {max(factors):.2f} | {np.median(factors):.2f} | {reached} of {len(rows)} |")


def draw(path, rows):
    """The index that EQU reaches against slenderness: one line for each pair of errors, the targets beside them."""
    left, bottom, across, high = 60, 330, 460, 290

    def x(slenderness):
        return left + across * (slenderness - SLENDERNESS[0]) / (SLENDERNESS[-1] - SLENDERNESS[0])

    def y(index):
        return bottom - high * index / 8

    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 730 390" font-family="DejaVu Sans, sans-serif" font-size="13">',
             '<rect width="730" height="390" fill="white"/>']
    for index in range(9):
        parts.append(f'<path d="M{left} {y(index):.1f}H{left + across}" stroke="#ddd"/>'
                     f'<text x="{left - 8}" y="{y(index) + 4:.1f}" text-anchor="end">{index}</text>')
    for slenderness in SLENDERNESS:
        parts.append(f'<text x="{x(slenderness):.1f}" y="{bottom + 20}" text-anchor="middle">{slenderness:g}</text>')
    for index in TARGETS:
        parts.append(f'<path d="M{left} {y(index):.1f}H{left + across}" stroke="#b00" stroke-dasharray="5 4"/>'
                     f'<text x="{left + across + 8}" y="{y(index) + 4:.1f}" fill="#b00">β {index}</text>')
    for width_error, dash in zip(WIDTH_ERRORS, ("", "7 4", "2 3")):
        for dip_error, colour in zip(DIP_ERRORS, ("#1b6ca8", "#3a8f4d", "#8a4fa3")):
            line = [(x(row[0]), y(row[4])) for row in rows if row[1:3] == (width_error, dip_error)]
            points = " ".join(f"{u:.1f},{v:.1f}" for u, v in line)
            parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{dash}"/>')
    keys = [("dip ± 0.5°", "#1b6ca8", ""), ("dip ± 1°", "#3a8f4d", ""), ("dip ± 2°", "#8a4fa3", ""),
            ("width ± 2 %", "#444", ""), ("width ± 5 %", "#444", "7 4"), ("width ± 10 %", "#444", "2 3")]
    for k, (name, colour, dash) in enumerate(keys):
        v = 60 + 20 * k
        parts.append(f'<path d="M580 {v}h30" stroke="{colour}" stroke-width="2" stroke-dasharray="{dash}"/><text x="616" y="{v + 4}">{name}</text>')
    parts.append(f'<text x="{left + across / 2}" y="{bottom + 44}" text-anchor="middle">height to width</text>'
                 f'<text x="{left}" y="24">Reliability index of slabs with the factor of EQU against toppling, 1.1/0.9</text></svg>')
    Path(path).write_text("\n".join(parts) + "\n", encoding="utf-8")


def main():
    good = benchmark()
    rows, agrees = family()
    summary(rows)
    by_design_values(rows)
    if len(sys.argv) > 1:
        draw(sys.argv[1], rows)
    good = good and agrees
    print("\nThe program and the integrals agree." if good else "\nThe program and the integrals do NOT agree.")
    return not good


if __name__ == "__main__":
    sys.exit(main())
