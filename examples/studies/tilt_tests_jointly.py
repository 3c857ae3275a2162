# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The tilt tests of Table 3 of Alejano et al., all together: which friction, which corners, and what they cannot say.
docs/tilt_tests_jointly.md says what comes out of it.

The angle that is measured in a test is the static limit of its block, with its friction and the radius of its toe, and a normal error:

    y = limit(friction, radius) + error      error: normal, deviation s

Friction is one for all blocks, one for each block, or one for each toe; corners are sharp, or worn; or they are sharp, and all
angles are off by the same. Priors, none of which comes
from these tests: friction triangular, 24 to 31 degrees, most likely 30 (section 2.3); each radius exponential, its mean from 0.25 to
16 mm, every factor of two alike; s from 0.1 to 1.6 degrees, likewise; what all angles are off by normal, deviation 2 degrees. The limit is solved on a grid of friction and radius, and
linear in radius between; the evidence of a model is the sum over all grids of prior times likelihood.

    tilt_tests_jointly.py [FIGURE.svg]

What is checked: of 200 sets of data, drawn from the priors and analysed alike, the ranks of the friction that they were
made with are spread evenly (Cook, Gelman and Rubin 2006; Talts et al. 2018)."""

import math
import sys
from pathlib import Path

import numpy as np

import topple
from tilt_test_scatter import TESTS, scene

FRICTIONS = np.arange(20.0, 36.01, 0.5)
SOLVED_RADII = np.arange(0.0, 14.01, 0.5)
RADII = np.arange(0.0, 14.01, 0.1)  # and linear between those solved
MEAN_RADII = 0.25 * 2.0 ** np.arange(7)
ERRORS = 0.1 * 2.0 ** np.arange(0, 4.1, 0.5)
SIMULATED = 200  # sets of data
OFFSETS = np.arange(-6.0, 6.01, 0.25)  # degrees
OFFSET_PRIOR = np.exp(-OFFSETS**2 / 8) / np.exp(-OFFSETS**2 / 8).sum()
GROUPS = {"one for all": lambda test: "", "one a block": lambda test: test[0], "one a toe": lambda test: test[0] + test[1]}


def merged():
    """Rows of a block and a toe with all their angles: repeats on one toe share its radius."""
    rows = {}
    for name, toe, *shape, angles in TESTS:
        rows.setdefault((name, toe), (shape, []))[1].extend(angles)
    return [(name, toe, shape, np.array(angles)) for (name, toe), (shape, angles) in rows.items()]


def limits(toe, shape):
    """The limit in degrees, a row a friction, a column a radius; not a number where no such corner fits between the teeth."""
    grid = np.full((len(FRICTIONS), len(SOLVED_RADII)), np.nan)
    span = f"friction_angle_deg={FRICTIONS[0]:g}:{FRICTIONS[-1]:g}:0.5"
    for column, radius in enumerate(SOLVED_RADII):
        try:
            swept = topple.sweep(topple.Scene.from_text(scene(toe, *shape, 30, radius), "block"), span)
        except topple.BadInput:
            continue
        grid[:, column] = swept.columns["limit_deg"]
    return np.array([np.interp(RADII, SOLVED_RADII, row) for row in grid])


def prior_of_friction():
    weight = np.interp(FRICTIONS, [24, 30, 31], [0, 1, 0])
    return weight / weight.sum()


def prior_of_radius(fits):
    """A row a mean radius: the exponential density on the grid of radii, of those that fit."""
    weight = np.exp(-RADII / MEAN_RADII[:, None]) * fits
    return weight / weight.sum(axis=1, keepdims=True)


def likelihood(angles, grid):
    """Of a toe, by error, friction and radius: the density of its angles."""
    off = angles - grid[..., None]
    square = np.sum(off**2, axis=-1)
    scale = ERRORS[:, None, None]
    density = np.exp(-square / (2 * scale**2)) / (math.sqrt(2 * math.pi) * scale) ** len(angles)
    return np.where(np.isnan(density), 0, density)


def by_friction(rows, grids, worn):
    """Of each toe, by error, mean radius and friction, its radius summed over."""
    found = []
    for (_, _, _, angles), grid in zip(rows, grids):
        density = likelihood(angles, grid)
        if worn:
            found.append(np.einsum("efr,mr->emf", density, prior_of_radius(~np.isnan(grid[0]))))
        else:
            found.append(np.repeat(density[:, None, :, 0], len(MEAN_RADII), axis=1))
    return found


def groups_of(rows, group):
    names = [GROUPS[group]((name, toe)) for name, toe, *_ in rows]
    return [[k for k, own in enumerate(names) if own == name] for name in dict.fromkeys(names)]


def analysed(rows, grids, group, worn):
    """The evidence, and the posterior of friction of each group."""
    toes, prior = by_friction(rows, grids, worn), prior_of_friction()
    parts = [np.prod([toes[k] for k in members], axis=0) * prior for members in groups_of(rows, group)]
    sums = [part.sum(axis=-1) for part in parts]
    together = np.prod(sums, axis=0)  # by error and mean radius
    share = together / together.sum()
    frictions = [np.sum(share[..., None] * part / np.maximum(own, 1e-300)[..., None], axis=(0, 1)) for part, own in zip(parts, sums)]
    return together.mean(), frictions, share


def off_by_the_same(rows, grids, group):
    """The evidence of sharp corners where all angles are off by the same, and the posterior mean of that, in degrees."""
    found = [prior * analysed([(*row[:3], row[3] - offset) for row in rows], grids, group, False)[0]
             for offset, prior in zip(OFFSETS, OFFSET_PRIOR)]
    return sum(found), float(np.sum(OFFSETS * found) / sum(found))


def interval(weights):
    """5, 50 and 95 % of the friction."""
    total = np.cumsum(weights) / np.sum(weights)
    return [float(np.interp(level, total, FRICTIONS)) for level in (0.05, 0.5, 0.95)]


def predicted(rows, grids, left_out):
    """The distribution of the angle of one toe, given the tests of the others, by worn corners and a friction a block."""
    others = [k for k in range(len(rows)) if k != left_out]
    _, _, share = analysed([rows[k] for k in others], [grids[k] for k in others], "one a block", True)
    toes, prior = by_friction(rows, grids, True), prior_of_friction()
    mates = [k for k in others if rows[k][0] == rows[left_out][0]]
    of_friction = np.prod([toes[k] for k in mates], axis=0) * prior if mates else np.broadcast_to(prior, toes[0].shape)
    of_friction = of_friction / of_friction.sum(axis=-1, keepdims=True)
    radius = prior_of_radius(~np.isnan(grids[left_out][0]))
    below = np.array([0.5 * math.erfc(-z / math.sqrt(2)) for z in
                      ((rows[left_out][3][0] - grids[left_out]) / ERRORS[:, None, None]).ravel()]).reshape(len(ERRORS), *grids[left_out].shape)
    below = np.where(np.isnan(below), 0, below)
    return float(np.einsum("em,emf,mr,efr->", share, of_friction, radius, below))


def simulated(rows, grids):
    """Ranks of the friction of block E in its posterior, over data drawn from the priors: even in 0 to 1 if all is right."""
    chance = np.random.default_rng(7)
    prior, ranks = prior_of_friction(), []
    names = list(dict.fromkeys(name for name, *_ in rows))
    for _ in range(SIMULATED):
        own = dict(zip(names, chance.choice(len(FRICTIONS), len(names), p=prior)))
        error, mean = chance.choice(ERRORS), chance.integers(len(MEAN_RADII))
        drawn = []
        for (name, toe, shape, angles), grid in zip(rows, grids):
            radius = chance.choice(len(RADII), p=prior_of_radius(~np.isnan(grid[0]))[mean])
            drawn.append((name, toe, shape, grid[own[name], radius] + error * chance.standard_normal(len(angles))))
        _, frictions, _ = analysed(drawn, grids, "one a block", True)
        of_e = frictions[names.index("E")]
        total = np.cumsum(of_e) / of_e.sum()
        ranks.append(total[own["E"]] - chance.random() * of_e[own["E"]] / of_e.sum())
    return np.array(ranks)


def decided_by(rows, grids):
    """What would be known of block E if the radius of its valley toe were measured: its friction by worn corners, one a block."""
    place = next(k for k, row in enumerate(rows) if row[:2] == ("E", "valley"))
    table = []
    for radius in (0.0, 1.0, 2.0, 4.0, 6.0):
        known = [grid.copy() for grid in grids]
        known[place][:, abs(RADII - radius) > 0.01] = np.nan
        _, frictions, _ = analysed(rows, known, "one a block", True)
        names = list(dict.fromkeys(name for name, *_ in rows))
        table.append((radius, interval(frictions[names.index("E")])))
    return table


def draw(path, rows, grids, offset):
    """What was measured at each toe, beside the limit of a sharp one from the least to the greatest friction of the prior, and that
    limit off by the same for all."""
    likely = (FRICTIONS >= 24) & (FRICTIONS <= 31)

    def y(angle):
        return 320 - 290 * (angle - 10) / 30

    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 390" font-family="DejaVu Sans, sans-serif" font-size="13">',
             '<rect width="720" height="390" fill="white"/>']
    for angle in range(10, 41, 5):
        parts.append(f'<path d="M50 {y(angle):.1f}H560" stroke="#ddd"/><text x="42" y="{y(angle) + 4:.1f}" text-anchor="end">{angle}°</text>')
    for k, ((name, toe, _, angles), grid) in enumerate(zip(rows, grids)):
        x = 75 + 51 * k
        low, high = grid[likely, 0].min(), grid[likely, 0].max()
        for moved, colour in ((0, "#1b6ca8"), (offset, "#c9d9e6")):
            parts.append(f'<rect x="{x - 8}" y="{y(high + moved) - 2:.1f}" width="16" height="{y(low) - y(high) + 4:.1f}" fill="{colour}"/>')
        parts += [f'<circle cx="{x}" cy="{y(angle):.1f}" r="4" fill="#b00"/>' for angle in angles]
        parts.append(f'<text x="{x}" y="345" text-anchor="middle">{name}</text><text x="{x}" y="361" text-anchor="middle" font-size="11">{toe}</text>')
    for k, (mark, words) in enumerate((('<circle cx="585" cy="56" r="4" fill="#b00"/>', "measured"),
                                       ('<rect x="577" y="72" width="16" height="8" fill="#1b6ca8"/>', "sharp, 24° to 31°"),
                                       ('<rect x="577" y="92" width="16" height="8" fill="#c9d9e6"/>', f"the same, {offset:.1f}°"))):
        parts.append(f'{mark}<text x="600" y="{60 + 20 * k}">{words}</text>')
    parts.append('<text x="50" y="20">Tilt at which the block moves</text></svg>')
    Path(path).write_text("\n".join(parts) + "\n", encoding="utf-8")


def main():
    rows = merged()
    grids = [limits(toe, shape) for _, toe, shape, _ in rows]

    models = {(group, worn): analysed(rows, grids, group, worn) for worn in (False, True) for group in GROUPS}
    offset = {group: off_by_the_same(rows, grids, group) for group in GROUPS}
    evidences = {("worn" if worn else "sharp", group): found[0] for (group, worn), found in models.items()}
    evidences |= {("sharp, all angles off by the same", group): found[0] for group, found in offset.items()}
    best = max(evidences.values())
    print("| corners | friction | log10 of the evidence, from the best |\n| --- | --- | --- |")
    for (corners, group), evidence in evidences.items():
        print(f"| {corners} | {group} | {math.log10(evidence / best):.1f} |")
    print(f"\nall angles off by {offset['one a block'][1]:.1f} degrees, in the mean")

    _, frictions, share = models["one a block", True]
    print("\n| block | friction, 5, 50 and 95 % |\n| --- | --- |")
    for name, weights in zip(dict.fromkeys(name for name, *_ in rows), frictions):
        low, middle, high = interval(weights)
        print(f"| {name} | {low:.1f}°, {middle:.1f}°, {high:.1f}° |")
    low, middle, high = interval(prior_of_friction())
    print(f"| before any test | {low:.1f}°, {middle:.1f}°, {high:.1f}° |")

    print("\n| block | toe | measured | probability of an angle no larger, by the other tests |\n| --- | --- | --- | --- |")
    for k, (name, toe, _, angles) in enumerate(rows):
        print(f"| {name} | {toe} | {angles[0]}° | {predicted(rows, grids, k):.2f} |")

    print("\n| if the toe of E in its valley has a radius of | its friction, 5, 50 and 95 % |\n| --- | --- |")
    for radius, (low, middle, high) in decided_by(rows, grids):
        print(f"| {radius:g} mm | {low:.1f}°, {middle:.1f}°, {high:.1f}° |")

    print("\n| error s | share | mean radius | share |\n| --- | --- | --- | --- |")
    for k in range(max(len(ERRORS), len(MEAN_RADII))):
        right = f"{MEAN_RADII[k]:g} mm | {share.sum(axis=0)[k]:.2f}" if k < len(MEAN_RADII) else " | "
        print(f"| {ERRORS[k]:.2f}° | {share.sum(axis=1)[k]:.2f} | {right} |")

    if len(sys.argv) > 1:
        draw(sys.argv[1], rows, grids, offset["one a block"][1])
    ranks = simulated(rows, grids)
    counts = np.histogram(ranks, bins=10, range=(0, 1))[0]
    spread = float(np.sum((counts - SIMULATED / 10) ** 2) / (SIMULATED / 10))  # chi-square of nine degrees of freedom: 27.9 once in 1000
    print(f"\nranks of simulated data, by tenths: {', '.join(map(str, counts))}; chi-square {spread:.1f} of 9")
    good = spread < 27.9
    print("The simulated data agree." if good else "The simulated data do NOT agree.")
    return not good


if __name__ == "__main__":
    sys.exit(main())
