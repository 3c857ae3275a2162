# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a base that is irregular does to a block: the study of docs/irregular_bases.md, which says
what comes out of it. Blocks 100 mm wide and 200 mm high, on self-affine profiles with points 1 mm
apart, every one by its seed.

    irregular_bases.py [SEEDS [FIGURE.svg]]

1. The block fits its base. With the mean line of the base at height 0, the block y above it and dx
   wide, h the height of its toe, R the RMS height, b the slope of the line of least squares, above
   0 where it rises away from the toe, the block topples at

       tan alpha = (dx/y - b dx^2 / (6 y^2)) / (1 - 2 h/y - R^2/y^2)

   of which Eqs. (15) and (16) of Alejano et al. are the case of teeth: h = +-A/2, R^2 = A^2/12,
   b = 0. The formula checks every angle, of the profile as it is and of one that leans. By it, how
   many of the angles lie between the two equations where a base is cut from a wider profile.
2. The block is shifted along its base, and set down. That it touches there, and cuts in nowhere, is
   checked by its corners.
3. Contacts that are that near are closed (`contact: {within: ...}`): the match is worn in."""

import subprocess
import sys
import warnings

import numpy as np

import topple

WIDTH, HEIGHT = 100.0, 200.0
HURST, JRC = (0.5, 0.7, 0.9), (4, 8, 12, 16, 20)
SHIFTS, CLOSURES = (0.25, 1.5, 5.5, 20.5), (0.01, 0.02, 0.05, 0.1, 0.2)  # mm
SHIFTED_JRC = (4, 12, 20)
WIDER = (100, 200, 400, 800)  # mm, the profiles that bases are cut from
LEAN = 0.05  # of every other base on which the formula is tried

warnings.simplefilter("ignore", topple.Caution)  # that no scene says how far its base goes on


def rough(length, jrc, hurst, seed):
    """The points of a self-affine profile."""
    scene = topple.Scene.from_text(
        f"""topple: 1
length_unit: mm
block: {{outline: [[0, 0], [1, 0], [0, 1]]}}
base:
  profile:
    self_affine: {{length: {length}, step: 1, hurst: {hurst}, jrc: {jrc}, seed: {seed}}}
""",
        "profile",
    )
    return np.loadtxt(scene.profile_csv().splitlines(), delimiter=",", skiprows=1)


def block_on(underside, top):
    """The outline of a block with this underside."""
    return np.vstack([underside, [underside[-1, 0], top], [underside[0, 0], top]])


def ranks(x):
    return np.argsort(np.argsort(x)).astype(float)


def rank_correlation(x, y):
    """Spearman's."""
    return np.corrcoef(ranks(x), ranks(y))[0, 1]


def by_teeth(amplitude, sign):
    """Eqs. (15), sign 1, and (16), sign -1, in degrees."""
    share = amplitude / HEIGHT
    return np.degrees(np.arctan(WIDTH / HEIGHT / (1 - sign * share - share**2 / 12)))


def formula(base, left):
    """The formula's tan alpha, of a base whose mean line is at height 0."""
    x, dx = base[:-1, 0] - WIDTH / 2, np.diff(base[:, 0])
    y, dy = base[:-1, 1], np.diff(base[:, 1])
    square = np.sum(dx * (y * y + y * dy + dy * dy / 3)) / WIDTH
    slope = 12 / WIDTH**3 * np.sum(dx * (x * (y + dy / 2) + dx * (y / 2 + dy / 3)))
    toe = base[0 if left else -1, 1]
    lean = (slope if left else -slope) * WIDTH**2 / (6 * HEIGHT**2)
    return (WIDTH / HEIGHT - lean) / (1 - 2 * toe / HEIGHT - square / HEIGHT**2)


def mated_angles(base):
    """For either side: (alpha, by how much the formula is off, beyond both their bounds or not)."""
    for case in topple.Scene("mm", outline=block_on(base, HEIGHT), base_mated=True).solve().cases:
        left = case.towards is topple.Direction.LEFT
        angle = case.governing_pivot.critical_angle_deg
        off = abs(angle.value - np.degrees(np.arctan(formula(base, left))))
        # 1e-11: of sums in doubles
        yield angle.value, off, off > angle.error + 1e-11, base[0 if left else -1, 1]


def mated(seeds):
    """A row for each profile and side: JRC, A, RMS height, Z2, i, alpha, off, wrong, h."""
    rows, seed = [], 0
    for hurst in HURST:
        for jrc in JRC:
            for _ in range(seeds):
                seed += 1
                base = rough(100, jrc, hurst, seed)
                dx, y, dy = np.diff(base[:, 0]), base[:-1, 1], np.diff(base[:, 1])
                base[:, 1] -= np.sum(dx * (y + dy / 2)) / WIDTH
                of = topple.profile_of_points(base, "mm")
                numbers = [float(n) for n in (of.amplitude, of.rms_height, of.z2,
                                              of.effective_angle_deg)]
                leaning = base + LEAN * (base[:, :1] - WIDTH / 2) * [0, 1]
                wrong = any(angle[2] for angle in mated_angles(leaning))
                for alpha, off, beyond, toe in mated_angles(base):
                    rows.append((jrc, *numbers, alpha, off, beyond or wrong, toe))
    return np.array(rows).T


def cut(profile, levelled):
    """The middle of a profile as the base of a block, from x = 0, its mean line at height 0."""
    first = (len(profile) - 1 - int(WIDTH)) // 2
    base = profile[first:first + int(WIDTH) + 1].copy()
    base[:, 0] -= base[0, 0]
    if levelled:
        base[:, 1] -= np.polyval(np.polyfit(base[:, 0], base[:, 1], 1), base[:, 0])
    base[:, 1] -= np.sum(np.diff(base[:, 0]) * (base[:-1, 1] + np.diff(base[:, 1]) / 2)) / WIDTH
    return base


def bracketed(seeds, length, levelled):
    """Of bases cut from profiles of that length: A/y, and by how much the angle by the formula lies
    beyond Eqs. (15) and (16), below 0 within them."""
    seed, rows = 0, []
    for hurst in HURST:
        for jrc in JRC:
            for _ in range(seeds):
                seed += 1
                base = cut(rough(length, jrc, hurst, seed), levelled)
                size = np.ptp(base[:, 1])
                for left in (True, False):
                    angle = np.degrees(np.arctan(formula(base, left)))
                    rows.append((size / HEIGHT, max(angle - by_teeth(size, 1),
                                                    by_teeth(size, -1) - angle)))
    return np.array(rows).T


def least_gap(outline, base):
    """How far the underside of an outline lies above its base, along y, at the corners of both."""
    under = outline[:-2][np.argsort(outline[:-2, 0])]
    at = np.union1d(under[:, 0], base[:, 0])
    at = at[(at >= under[0, 0]) & (at <= under[-1, 0])]
    return np.min(np.interp(at, *under.T) - np.interp(at, *base.T))


def shifted_block(base, shift):
    """The outline of a block that fitted the middle of its base of 300 mm, moved along it."""
    return block_on(base[100:201], HEIGHT + np.mean(base[100:201, 1])) + [shift, 0]


def shifted_blocks(seeds, shifts):
    """(JRC, shift, outline, base) of blocks that were parted from their bases."""
    seed = 1000
    for jrc in SHIFTED_JRC:
        for _ in range(seeds):
            seed += 1
            base = rough(300, jrc, 0.8, seed)
            for shift in shifts:
                yield jrc, shift, shifted_block(base, shift), base


def posed(outline, solution):
    """The outline where it came to rest."""
    rest, block = solution.rest, solution.block
    turn = np.radians(rest.turned_deg.value)
    now = 1000 * np.array([block.centroid_x_m.value, block.centroid_y_m.value])
    before = now - 1000 * np.array([rest.moved_x_m.value, rest.moved_y_m.value])
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    return (outline - before) @ rotation.T + now


def shifted(seeds):
    """A row for each profile, shift and side: JRC, shift, turned, share of the width between the
    outermost contacts, alpha, least gap."""
    rows = []
    for jrc, shift, outline, base in shifted_blocks(seeds, SHIFTS):
        solution = topple.Scene("mm", outline=outline, base_profile=base, base_rest=True).solve()
        least = least_gap(posed(outline, solution), base)
        rest = solution.rest
        span = 1000 * (rest.margin_left_m.value + rest.margin_right_m.value) / WIDTH
        for case in solution.cases:
            angle = case.governing_pivot.critical_angle_deg.value
            rows.append((jrc, shift, abs(rest.turned_deg.value), span, angle, least))
    return np.array(rows).T


def closed(seeds):
    """A row for each profile, closure and side: JRC, closure, contact ratio, alpha."""
    rows = []
    for jrc, _, outline, base in shifted_blocks(seeds, SHIFTS[:1]):
        for closure in CLOSURES:
            solution = topple.Scene("mm", outline=outline, base_profile=base, base_rest=True,
                                    contact_within=closure).solve()
            ratio = 1000 * solution.contact.nominal_length_m.value / WIDTH
            for case in solution.cases:
                rows.append((jrc, closure, ratio, case.governing_pivot.critical_angle_deg.value))
    return np.array(rows).T


def table(*heads):
    print("| " + " | ".join(heads) + " |\n|" + " --- |" * len(heads))


def tell_mated(seeds):
    """Prints the first part; whether the formula has every angle."""
    jrc, amplitude, rms, z2, i, angle, off, wrong, toe = mated(seeds)
    plane = np.degrees(np.arctan(WIDTH / HEIGHT))
    above, below = by_teeth(amplitude, 1), by_teeth(amplitude, -1)
    within = (below <= angle) & (angle <= above)
    print(f"1. The block fits: {len(angle)} angles; on a plane {plane:.3f} degrees\n")
    table("JRC", "A, mm", "Eqs. (16) to (15)", "α_crit", "its deviation", "within")
    for one in JRC:
        of = jrc == one
        print(f"| {one} | {np.mean(amplitude[of]):.2f} | "
              f"{np.mean(below[of]):.2f}° to {np.mean(above[of]):.2f}° | "
              f"{np.min(angle[of]):.2f}° to {np.max(angle[of]):.2f}° | "
              f"{np.std(angle[of] - plane):.2f}° | {100 * np.mean(within[of]):.0f} % |")
    beyond = np.max(np.maximum(angle - above, below - angle))
    print(f"\nwithin in all: {100 * np.mean(within):.1f} %; "
          f"beyond by {beyond:.3f} degrees at most\n")
    table("number", "rank correlation with how far α_crit is from a plane's")
    size = np.abs(angle - plane)
    for name, number in (("A", amplitude), ("RMS height", rms), ("Z₂", z2), ("i", i),
                         ("JRC", jrc), ("how far the toe is from the mean line", np.abs(toe))):
        print(f"| {name} | {rank_correlation(number, size):.2f} |")
    by_toe = np.max(np.abs(angle - by_teeth(2 * toe, 1)))
    print(f"\nEq. (15) with 2 h for A: off by {by_toe:.3f} degrees at most")
    print(f"the formula: off by {np.max(off):.0e} degrees at most\n")
    return not np.any(wrong)


def tell_wider(seeds):
    """Prints where the bracket of the first part holds, and where not."""
    table("cut from a profile of, mm", "A/y, 95 %", "within, as it lies", "beyond by at most",
          "within, levelled", "beyond by at most")
    for length in WIDER:
        cells = []
        for levelled in (False, True):
            size, beyond = bracketed(seeds, length, levelled)
            if not levelled:
                cells.append(f"{100 * np.quantile(size, 0.95):.1f} %")
            cells += [f"{100 * np.mean(beyond <= 0):.0f} %", f"{np.max(beyond):.2f}°"]
        print(f"| {length} | " + " | ".join(cells) + " |")
    print()


def quantiles(angle):
    return " | ".join(f"{q:.1f}°" for q in np.quantile(angle, (0.05, 0.5, 0.95)))


def tell_shifted(seeds):
    """Prints the second part; whether every block touches, and cuts in nowhere."""
    jrc, shift, turned, span, angle, least = shifted(seeds)
    print(f"2. The block is shifted: {len(angle)} angles\n")
    table("shift, mm", "JRC", "turned", "between contacts", "α_crit: 5 %", "50 %", "95 %")
    for one in SHIFTS:
        for kind in SHIFTED_JRC:
            of = (jrc == kind) & (shift == one)
            print(f"| {one} | {kind} | {np.median(turned[of]):.2f}° | {np.median(span[of]):.2f} | "
                  f"{quantiles(angle[of])} |")
    print()
    table("number", "rank correlation with α_crit")
    for name, number in (("share between the outermost contacts", span), ("shift", shift),
                         ("JRC", jrc)):
        print(f"| {name} | {rank_correlation(number, angle):.2f} |")
    print(f"\nleast gaps: {np.min(least):.0e} to {np.max(least):.0e} mm\n")
    return np.max(np.abs(least)) <= 1e-9  # some 1e3 mm turned in doubles


def tell_closed(seeds, figure):
    """Prints the third part, and draws it."""
    jrc, closure, ratio, angle = closed(seeds)
    print(f"3. Shifted by {SHIFTS[0]} mm, contacts closed: {len(angle)} angles\n")
    table("closed within, mm", "JRC", "contact ratio", "α_crit: 5 %", "50 %", "95 %")
    for one in CLOSURES:
        for kind in SHIFTED_JRC:
            of = (jrc == kind) & (closure == one)
            print(f"| {one} | {kind} | {np.median(ratio[of]):.2f} | {quantiles(angle[of])} |")
    print()
    table("number", "rank correlation with α_crit")
    for name, number in (("contact ratio", ratio), ("closure", closure), ("JRC", jrc)):
        print(f"| {name} | {rank_correlation(number, angle):.2f} |")
    print()
    if figure:
        draw(figure, jrc, ratio, angle)


def draw(path, jrc, ratio, angle):
    """Angle against contact ratio, by gnuplot."""
    blocks = ["\n".join(f"{r} {a}" for r, a in zip(ratio[jrc == kind], angle[jrc == kind]))
              for kind in SHIFTED_JRC]
    styles = ("pt 5 lc rgb '#0072b2'", "pt 7 lc rgb '#009e73'", "pt 8 lc rgb '#d55e00'")
    plots = ", ".join(f"$data index {k} {style} ps 0.5 title 'JRC {kind}'"
                      for k, (kind, style) in enumerate(zip(SHIFTED_JRC, styles)))
    script = "$data << EOD\n" + "\n\n\n".join(blocks) + f"""
EOD
set terminal svg size 640,400 font 'sans-serif,13' background '#ffffff'
set xlabel 'contact ratio'
set ylabel 'critical angle (degrees)'
set xrange [0:1]
set yrange [0:*]
set key bottom right
plot {plots}
"""
    with open(path, "wb") as file:
        file.write(subprocess.run(["gnuplot"], input=script.encode(), stdout=subprocess.PIPE,
                                  check=True).stdout)


def main():
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    figure = sys.argv[2] if len(sys.argv) > 2 else None
    fits = tell_mated(seeds)
    tell_wider(seeds)
    rests = tell_shifted(seeds)
    tell_closed(seeds, figure)
    print("The formula agrees." if fits else "The formula does NOT agree.")
    print("The blocks touch." if rests else "The blocks do NOT touch.")
    return not (fits and rests)


if __name__ == "__main__":
    sys.exit(main())
