# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Three tilts of a block that no longer fits its base: it begins to move, lies still again on other
contacts, begins anew, and overturns: the study of docs/three_thresholds.md, which says what comes
out of it. Blocks 100 mm wide on the middle of self-affine profiles of 300 mm (points 1 mm apart),
shifted and set down at rest; what each is made of is drawn from the seed of its own number.

    three_thresholds.py [BLOCKS [RELEASED [FIGURE.svg]]]

RELEASED 0: the first part alone.

1. A table raised to the left at 20 degrees per minute until the block has left its base, by rigid
   contacts with impacts (docs/rigid_contact.md). What is checked: the first motion is where statics
   with friction has it, and the tilts come in their order.
2. The first RELEASED blocks whose friction exceeds what a block on a plane topples at, set down and
   released at tilts a quarter of a degree apart from that of first motion on.
3. Where motion can begin below the tilt up to which forces can hold the block: blocks that fit.
4. The order by JRC (Tse and Cruden) where A/y is fixed: profiles scaled to one A."""

import subprocess
import sys
import warnings

import numpy as np

import topple
from irregular_bases import block_on, rank_correlation, rough, table
from irregular_bases_overturning import listed

WIDTH = 100.0  # mm
JRC, HURST = (4, 8, 12, 16, 20), (0.5, 0.6, 0.7, 0.8, 0.9)
SLENDERNESS, FRICTION = (1, 1.5, 2, 3, 5), (25, 30, 35, 40, 45, 50, 55, 60)
SHIFTS = (0.25, 1.5, 5.5, 20.5)  # mm
FIRST_SEED = 40001
BRACKET = 0.02  # degrees: of the first motion on the table, twice
FALLEN = 45  # degrees, by which a block has turned that does not stand on its sole any more
ALIKE = 1e-6  # degrees: far above the bounds of onset and limit
FITTING_FRICTION = (25, 35, 45, 60)
STEP = 0.25  # degrees, between two tilts of release
AMPLITUDE = 6.0  # mm: of every profile of the fourth part

warnings.simplefilter("ignore", topple.Caution)  # that no scene says how far its base goes on


class Block:
    """One of the family, by its number."""

    def __init__(self, number):
        self.seed = FIRST_SEED + number
        draw = np.random.default_rng(self.seed)
        self.jrc, self.hurst, self.slenderness, self.friction, self.shift = (
            draw.choice(values) for values in (JRC, HURST, SLENDERNESS, FRICTION, SHIFTS))
        self.base = rough(300, self.jrc, self.hurst, self.seed)
        under = self.base[100:201]
        self.outline = block_on(under, WIDTH * self.slenderness + np.mean(under[:, 1])) + [
            self.shift, 0]
        self.plane = np.degrees(np.arctan(1 / self.slenderness))  # it topples there on a plane

    def scene(self, test, tilt=0):
        return topple.Scene.from_text(
            f"""topple: 1
length_unit: mm
block: {{outline: {listed(self.outline)}, unit_weight_kn_m3: 26}}
base: {{profile: {listed(self.base)}, place: rest}}
friction_angle_deg: {self.friction}
tilt: {{towards: left, angle_deg: {tilt}}}
tilt_test: {{engine: dynamics, {test}}}
""",
            "block",
        )


def stood(number):
    """What the block did; None: it fell over as it was set down."""
    try:
        row = Raised(Block(number))
    except topple.BadInput:  # it rolled off the end of its base
        return None
    return row if row.turned < FALLEN else None


class Raised:
    """What a block did on the table, in degrees."""

    def __init__(self, block):
        kind = topple.TiltEventKind
        scene = block.scene("protocol: ramp, until_deg: 80, duration_s: 300")
        (case,) = topple.tilt_test(scene, moments=2).cases
        rest = scene.solve().rest
        tilts = {what: [event.angle_deg for event in case.events if event.what is what]
                 for what in (kind.COLLAPSES, kind.RESTS, kind.OVERTURNS)}
        self.block = block
        held = case.onset_deg is not None and case.limit_deg is not None
        self.onset, self.limit = (case.onset_deg, case.limit_deg) if held else (0.0, 0.0)
        self.overturned = tilts[kind.OVERTURNS][0] if tilts[kind.OVERTURNS] else np.nan
        # what it does on its side is no more of interest
        self.begins, self.rests = ([tilt for tilt in tilts[what] if not tilt > self.overturned]
                                   for what in (kind.COLLAPSES, kind.RESTS))
        self.lower = 1000 * rest.margin_left_m.value / WIDTH
        self.span = self.lower + 1000 * rest.margin_right_m.value / WIDTH
        self.turned = abs(rest.turned_deg.value)
        # begins and rests take turns, and the end is behind them
        course = [tilt for pair in zip(self.begins, self.rests) for tilt in pair]
        course += self.begins[-1:] + [self.overturned]
        self.sound = (case.end is topple.TiltEnd.LEFT_BASE
                      and max(self.onset, 0) - BRACKET <= self.begins[0] <= max(self.limit, 0) + BRACKET
                      and len(self.begins) == len(self.rests) + 1 and not np.any(np.diff(course) < 0))


def percentiles(values):
    return " | ".join(f"{q:.2f}" for q in np.quantile(values, (0.05, 0.5, 0.95)))


def tell_seats(rows):
    """Prints the tilts at which blocks lie still again, and begin anew, and how far apart the first
    and the last are."""
    print()
    table("lies still again", "blocks", "at: 5 %", "50 %", "95 %", "begins anew at: 5 %", "50 %", "95 %",
          "after: 5 %", "50 %", "95 %")
    for k, name in enumerate(("for the first time", "the second", "the third")):
        own = [row for row in rows if len(row.rests) > k]
        if own:
            plane = np.array([row.block.plane for row in own])
            still = np.array([row.rests[k] for row in own]) / plane
            anew = np.array([row.begins[k + 1] for row in own]) / plane
            print(f"| {name} | {len(own)} | {percentiles(still)} | {percentiles(anew)} | "
                  f"{percentiles(anew - still)} |")
    apart = np.array([(row.overturned - row.begins[0]) / row.block.plane for row in rows])
    print(f"\nfrom the first motion to overturning, over α₀: {percentiles(apart[~np.isnan(apart)])}\n")


def tell_raised(rows):
    """Prints the first part; whether every course is sound."""
    blocks = [row.block for row in rows]
    plane = np.array([block.plane for block in blocks])
    slides = np.array([block.friction for block in blocks]) < plane
    first = np.array([row.begins[0] for row in rows]) / plane
    last = np.array([row.begins[-1] for row in rows]) / plane
    overturned = np.array([row.overturned for row in rows]) / plane
    seats = np.array([len(row.rests) for row in rows])
    print(f"1. {len(rows)} blocks, {np.sum(slides)} of them steeper than their friction on a plane, "
          f"{np.sum(np.isnan(overturned))} slid off without overturning\n")
    table("blocks", "number", "first motion: 5 %", "50 %", "95 %", "last begin: 5 %", "50 %", "95 %",
          "overturned: 5 %", "50 %", "95 %", "lay still again: never", "once", "more")
    groups = [("all", np.full(len(rows), True)), ("φ below α₀", slides), ("φ above α₀", ~slides)]
    for name, values in (("JRC", JRC), ("hurst", HURST), ("slenderness", SLENDERNESS),
                         ("shift", SHIFTS)):
        own = np.array([getattr(block, name.lower()) for block in blocks])
        unit = " mm" if name == "shift" else ""
        label = {"hurst": "Hurst", "slenderness": "y/Δx"}.get(name, name)
        groups += [(f"{label} {value:g}{unit}", (own == value) & ~slides) for value in values]
    for name, of in groups:
        over = of & ~np.isnan(overturned)
        if not np.any(over):
            continue
        again = [np.mean(seats[of] == 0), np.mean(seats[of] == 1), np.mean(seats[of] > 1)]
        print(f"| {name} | {np.sum(of)} | {percentiles(first[of])} | {percentiles(last[of])} | "
              f"{percentiles(overturned[over])} | "
              + " | ".join(f"{100 * share:.0f} %" for share in again) + " |")
    print()
    table("number", "first motion", "last begin", "overturned")
    of = ~slides & ~np.isnan(overturned)
    for name, number in (("weight to the lowest contact, over Δx", [row.lower for row in rows]),
                         ("share between the contacts", [row.span for row in rows]),
                         ("turned as it was set down", [row.turned for row in rows]),
                         ("shift", [block.shift for block in blocks]),
                         ("JRC", [block.jrc for block in blocks]),
                         ("Hurst exponent", [block.hurst for block in blocks]),
                         ("y/Δx", [block.slenderness for block in blocks]),
                         ("φ", [block.friction for block in blocks])):
        number = np.array(number)[of]
        print(f"| {name} | " + " | ".join(f"{rank_correlation(number, tilt[of]):.2f}"
                                          for tilt in (first, last, overturned)) + " |")
    print()
    table("of the blocks with φ above α₀", "first motion", "last begin", "overturned")
    for name, test in (("within 5 % of α₀", lambda tilt: np.abs(tilt - 1) < 0.05),
                       ("below 0.95 α₀", lambda tilt: tilt <= 0.95),
                       ("below 0.8 α₀", lambda tilt: tilt <= 0.8),
                       ("below 0.5 α₀", lambda tilt: tilt <= 0.5)):
        print(f"| {name} | " + " | ".join(f"{100 * np.mean(test(tilt[of])):.0f} %"
                                          for tilt in (first, last, overturned)) + " |")
    tell_seats([row for row, own in zip(rows, slides) if not own])
    apart = [row.limit - row.onset for row in rows]
    print(f"\nα_s below α_w in {np.sum(np.array(apart) > ALIKE)} of them\n")
    return slides, first, last, overturned


def outcomes(row):
    """(tilts at which it is set down and released, whether it overturns)."""
    tilts = np.arange(np.floor(max(row.onset, 0) / STEP), (row.block.plane + 4) / STEP) * STEP
    over = []
    for tilt in tilts:
        (case,) = topple.tilt_test(row.block.scene("protocol: release", tilt), moments=2).cases
        over.append(any(e.what is topple.TiltEventKind.OVERTURNS for e in case.events))
    return tilts, np.array(over)


def ranges(tilts, over):
    """The tilts at which it overturns, as text."""
    ends = np.flatnonzero(np.diff(np.concatenate([[0], over.astype(int), [0]])))
    return ", ".join(f"{tilts[a]:g}° to {tilts[b - 1]:g}°" for a, b in zip(ends[::2], ends[1::2]))


def tell_released(raised, most):
    """Prints the second part; its blocks and what they did, for the figure."""
    rows = [row for row in raised if row.block.friction > row.block.plane][:most]
    seen = [outcomes(row) for row in rows]
    changes = np.array([np.sum(np.diff(over.astype(int)) != 0) for _, over in seen])
    print(f"2. {len(rows)} blocks, released at {sum(len(tilts) for tilts, _ in seen)} tilts\n")
    table("changes of outcome along the tilt", "blocks")
    for count in sorted(set(changes)):
        print(f"| {count} | {np.sum(changes == count)} |")
    print()
    plane = np.array([row.block.plane for row in rows])
    least = np.array([tilts[over][0] if np.any(over) else np.nan for tilts, over in seen]) / plane
    most_of = np.array([tilts[~over][-1] if not np.all(over) else np.nan
                        for tilts, over in seen]) / plane
    last, table_of = (np.array(tilt) / plane for tilt in (
        [row.begins[-1] for row in rows], [row.overturned for row in rows]))
    table("tilt over α₀", "5 %", "50 %", "95 %")
    for name, share in (("first motion", np.array([row.begins[0] for row in rows]) / plane),
                        ("least at which it overturns, released", least),
                        ("most at which it does not", most_of),
                        ("last begin on the table", last),
                        ("overturned on the table", table_of)):
        print(f"| {name} | {percentiles(share[~np.isnan(share)])} |")
    sooner = (last - least) * plane
    print(f"\n{np.sum(sooner > STEP)} overturn when released more than {STEP:g}° below the last begin of "
          f"a motion on the table, by {np.nanmedian(sooner[sooner > STEP]):.1f}° in the median, "
          f"{np.nanmax(sooner):.1f}° at most\n")
    table("seed", "JRC", "y/Δx", "shift, mm", "φ", "overturns if released at", "on the table at")
    for row, (tilts, over), count in zip(rows, seen, changes):
        block = row.block
        if count > 1:
            print(f"| {block.seed} | {block.jrc} | {block.slenderness:g} | {block.shift:g} | "
                  f"{block.friction}° | {ranges(tilts, over)} | {row.overturned:.1f}° |")
    print()


def tell_friction(seeds):
    """Prints the third part."""
    print(f"3. Blocks that fit, 100 mm by 200 mm, {2 * seeds} angles each: α_s below α_w; "
          "no α_w at all\n")
    table("JRC", *(f"φ {phi}°" for phi in FITTING_FRICTION))
    for jrc in JRC:
        cells = []
        for phi in FITTING_FRICTION:
            apart = []
            for number in range(seeds):
                base = rough(100, jrc, HURST[number % len(HURST)], FIRST_SEED + number)
                outline = block_on(base, 2 * WIDTH + np.mean(base[:, 1]))
                for case in topple.Scene("mm", outline=outline, base_mated=True,
                                         friction_angle_deg=phi).solve().cases:
                    onset, limit = (half.critical_angle_deg.value if half.critical_angle_deg else np.inf
                                    for half in (case.onset, case.limit))
                    apart.append(0 if np.isinf(onset) else limit - onset)
            apart = np.array(apart)
            cells.append(f"{100 * np.mean(apart > ALIKE):.0f} %, {100 * np.mean(np.isinf(apart)):.0f} %")
        print(f"| {jrc} | " + " | ".join(cells) + " |")
    print()


def tell_order(seeds):
    """Prints the fourth part."""
    print(f"4. Profiles scaled to A = {AMPLITUDE:g} mm\n")
    jrc, angle, moved = [], [], []
    for hurst in HURST:
        for number in range(seeds):
            base = rough(300, 10, hurst, FIRST_SEED + number)
            base[:, 1] -= np.mean(base[100:201, 1])
            base[:, 1] *= AMPLITUDE / np.ptp(base[100:201, 1])
            under = base[100:201] - [100, 0]
            of = 32.2 + 32.47 * np.log10(float(topple.profile_of_points(under, "mm").z2))
            for k, case in enumerate(topple.Scene("mm", outline=block_on(under, 2 * WIDTH),
                                                  base_mated=True).solve().cases):
                shifted = topple.Scene("mm", outline=block_on(under, 2 * WIDTH) + [101.5, 0],
                                       base_profile=base, base_rest=True).solve().cases[k]
                jrc.append(of)
                angle.append(case.governing_pivot.critical_angle_deg.value)
                moved.append(shifted.governing_pivot.critical_angle_deg.value)
    jrc, angle, moved = np.array(jrc), np.array(angle), np.array(moved)
    plane = np.degrees(np.arctan(0.5))
    table("JRC, thirds", "fits: α_crit 5 %", "50 %", "95 %", "shifted: 5 %", "50 %", "95 %")
    for third in np.array_split(np.argsort(jrc, kind="stable"), 3):
        print(f"| {jrc[third].min():.1f} to {jrc[third].max():.1f} | {percentiles(angle[third])} | "
              f"{percentiles(moved[third])} |")
    print(f"\nrank correlation of JRC with how far it is from a plane's, fits: "
          f"{rank_correlation(jrc, np.abs(angle - plane)):.2f}; with the first rocking, shifted: "
          f"{rank_correlation(jrc, moved):.2f}\n")


def draw(path, of, first, last, overturned):
    """The three tilts as cumulative shares of the blocks, by gnuplot."""
    curves = []
    for tilt in (first, last, overturned):
        own = np.sort(tilt[of & ~np.isnan(tilt)])
        curves.append("\n".join(f"{t:.4f} {(k + 0.5) / len(own):.4f}" for k, t in enumerate(own)))
    titles = ("first motion", "last begin of a motion", "overturned")
    colours = ("#0072b2", "#d55e00", "#000000")
    plots = ", ".join(f"$data index {k} with lines lw 2 lc rgb '{colour}' title '{title}'"
                      for k, (colour, title) in enumerate(zip(colours, titles)))
    script = "$data << EOD\n" + "\n\n\n".join(curves) + f"""
EOD
set terminal svg size 640,400 font 'sans-serif,13' background '#ffffff'
set xlabel 'tilt over that at which a block on a plane topples'
set ylabel 'share of the blocks'
set xrange [0:1.15]
set yrange [0:1]
set key top left
set arrow from 1,0 to 1,1 nohead dt 2 lc rgb '#888888'
plot {plots}
"""
    with open(path, "wb") as file:
        file.write(subprocess.run(["gnuplot"], input=script.encode(), stdout=subprocess.PIPE,
                                  check=True).stdout)


def main():
    blocks = int(sys.argv[1]) if len(sys.argv) > 1 else 400
    released = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    rows = [row for row in map(stood, range(blocks)) if row is not None]
    print(f"of {blocks} blocks {blocks - len(rows)} fell over as they were set down\n")
    slides, first, last, overturned = tell_raised(rows)
    if released > 0:
        tell_released(rows, released)
        tell_friction(min(20, released))
        tell_order(min(20, released))
    if len(sys.argv) > 3:
        draw(sys.argv[3], ~slides, first, last, overturned)
    good = all(row.sound for row in rows)
    print("The table and statics agree." if good else "The table and statics do NOT agree.")
    return not good


if __name__ == "__main__":
    sys.exit(main())
