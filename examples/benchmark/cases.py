# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cases of the benchmark of one block on one base, from their parameters and seeds.

A case has its coordinates as exact decimals: `block`, an outline counter-clockwise, and `base`, a profile from left to right
with rock below it. Every group goes from easy to hard. docs/benchmark_cases.md defines what is asked; make.py writes the files."""

import math
import random
from fractions import Fraction

DIGITS = 6  # of a drawn or rounded coordinate, after the point


def decimal(value):
    """The nearest decimal of DIGITS places, exactly."""
    return Fraction(round(Fraction(value) * 10**DIGITS), 10**DIGITS)


def ring(*points):
    return [(Fraction(str(x)), Fraction(str(y))) for x, y in points]


def case(group, title, block, base, friction, towards="left", loads=(), **more):
    return {"group": group, "title": title, "block": block, "base": base, "friction_deg": friction, "towards": towards,
            "loads": list(loads), **more}


def rectangle(width, height):
    return ring((0, 0), (width, 0), (width, height), (0, height))


def level(block, beyond=10):
    """Level rock below a block, and beyond it to both sides."""
    xs = [x for x, _ in block]
    low = min(y for _, y in block)
    return [(min(xs) - beyond, low), (max(xs) + beyond, low)]


def slabs():
    """Slide or topple: tan of the limit is the lesser of tan(friction) and width over height."""
    for title, width, height, friction, towards in (
            ("A slab that slides", 2, 1, 30, "left"),
            ("A slab that topples", 1, 3, 30, "left"),
            ("A slab that topples to the right", "0.8", "1.7", 40, "right"),
            ("A flat slab on a slippery joint", 5, "0.5", "12.5", "left"),
            ("A column, 12 times as high as wide", "0.5", 6, 35, "left"),
            ("A square that slides one degree before it would topple", 1, 1, 44, "left"),
            ("A square that topples one degree before it would slide", 1, 1, 46, "left"),
            ("A slab that slides one ten-thousandth of a degree before it would topple", 3, 3, "44.9999", "left")):
        block = rectangle(width, height)
        yield case("slabs", title, block, level(block), friction, towards)
    for title, outline, friction in (
            ("A leaning block", [(0, 0), (1, 0), ("1.4", 2), ("0.4", 2)], 38),
            ("A block that overhangs its toe", [(0, 0), (1, 0), (1, 2), ("-0.8", 2)], 38)):
        block = ring(*outline)
        yield case("slabs", title, block, level(block), friction)


def underside(count, width, depth, left_end):
    """Teeth from left to right: low where a valley of the block is."""
    low_first = left_end == "valley"
    return [(k * Fraction(width), Fraction(0) if (k % 2 == 0) == low_first else Fraction(depth)) for k in range(count + 1)]


def toothed(count, width, height, depth, left_end, beyond):
    """A toothed block and the base that fits it; `beyond`: by how many teeth the base goes on."""
    width, height, depth = (Fraction(str(v)) for v in (width, height, depth))
    under = underside(count, width, depth, left_end)
    top = height + depth
    other = left_end if beyond % 2 == 0 else ("peak" if left_end == "valley" else "valley")
    base = [(x - beyond * width, y) for x, y in underside(count + 2 * beyond, width, depth, other)]
    return under + [(count * width, top), (Fraction(0), top)], base


def teeth():
    """Regular teeth on the counterpart that fits them; where the base ends decides."""
    for title, friction, numbers in (
            ("Two teeth, peak down-dip", 30, (2, "0.05", "0.1", "0.01", "peak", 0)),
            ("Three teeth, valley down-dip, the base goes on", 30, (3, "0.03", "0.12", "0.005", "valley", 2)),
            ("Three teeth, valley down-dip, the base ends with the block", 30, (3, "0.03", "0.12", "0.005", "valley", 0)),
            ("Three teeth, peak down-dip", 30, (3, "0.03", "0.12", "0.005", "peak", 0)),
            ("Four teeth between valleys", 30, (4, "0.03", "0.2", "0.005", "valley", 0)),
            ("Four teeth between peaks", 30, (4, "0.03", "0.2", "0.005", "peak", 0)),
            ("One tooth", 33, (1, 1, "1.2", "0.2", "valley", 1)),
            ("Steep teeth, 40 degrees, little friction", 15, (2, 1, 2, "0.84", "peak", 2)),
            ("Five teeth on a base that goes on", 28, (5, "0.4", "1.5", "0.12", "valley", 3)),
            ("Seven flat teeth", 33, (7, "0.2", 2, "0.02", "peak", 1)),
            ("Two teeth, friction beyond the flanks", 55, (2, "0.05", "0.15", "0.02", "valley", 0)),
            ("Six teeth between peaks, tilted to the right", 31, (6, "0.1", "1.2", "0.03", "peak", 0))):
        block, base = toothed(*numbers)
        yield case("teeth", title, block, base, friction, "right" if "right" in title else "left")


def worn(width, height, radius, chords, corners="both"):
    """A rectangle whose lower corners are worn to arcs, each of `chords` chords with its vertices on decimals near the arc."""
    width, height, radius = (Fraction(str(v)) for v in (width, height, radius))
    arc = [(decimal(radius * Fraction(math.sin(a))), decimal(radius * Fraction(1 - math.cos(a))))
           for a in (math.pi / 2 * k / chords for k in range(chords + 1))]
    right = [(width - radius + x, y) for x, y in arc]
    left = [(radius - x, y) for x, y in reversed(arc)] if corners == "both" else [(Fraction(0), Fraction(0))]
    return left + right + [(width, height), (Fraction(0), height)]


def worn_corners():
    """Worn corners as chords: the sole is shorter than the block."""
    for title, friction, numbers, towards in (
            ("A slab with bevelled corners", 40, (1, 2, "0.1", 1), "left"),
            ("Corners of two chords", 40, (1, 2, "0.1", 2), "left"),
            ("Corners of eight chords", 40, (1, 2, "0.1", 8), "left"),
            ("Corners worn to three tenths of the width", 45, (1, 3, "0.3", 12), "left"),
            ("One worn corner, up-dip", 40, (1, 2, "0.2", 6, "right"), "left"),
            ("One worn corner, down-dip", 40, (1, 2, "0.2", 6, "right"), "right"),
            ("Worn to a sole of a fiftieth of the width", 40, (1, "1.5", "0.49", 24), "left"),
            ("Corners of sixty chords", 35, (2, 3, "0.4", 60), "left")):
        block = worn(*numbers)
        yield case("worn corners", title, block, level(block), friction, towards)


def mated(under, tops, beyond=0):
    """A block on the counterpart of its underside, which goes on level to both sides if it is asked for."""
    under, tops = ring(*under), ring(*tops)
    base = list(under)
    if beyond:
        base = [(under[0][0] - beyond, under[0][1]), *base, (under[-1][0] + beyond, under[-1][1])]
    return under + tops, base


def notches():
    """Where forces that nothing has put there would hold the block: the onset of motion lies below the limit, or there is no limit."""
    for title, friction, under, tops, beyond in (
            ("Wedged between steep flanks", 60, [(0, "0.5"), ("0.5", 0), (1, "0.5")], [(1, 2), (0, 2)], 0),
            ("A block whose weight passes its toe first", 60, [(0, "0.02"), ("0.05", 0), ("0.1", "0.02")],
             [("0.1", "0.21"), (0, "0.21")], 0),
            ("One steep facet up-dip", "61.36", [("-0.000", "1.123"), ("0.588", "0.901"), ("1.536", "-0.465")],
             [("0.967", "4.599"), ("-0.569", "4.599")], 0),
            ("A step that catches the sole", 40, [(0, 0), (1, 0), (1, "0.3"), (2, "0.3")], [(2, 3), (0, 3)], 0),
            ("A step the other way", 40, [(0, "0.3"), (1, "0.3"), (1, 0), (2, 0)], [(2, 3), (0, 3)], 0),
            ("In a notch of 45 degrees at a friction of 44", 44, [(0, 1), (1, 0), (2, 1)], [(2, 4), (0, 4)], 1),
            ("In a notch of 45 degrees at a friction of 46", 46, [(0, 1), (1, 0), (2, 1)], [(2, 4), (0, 4)], 1),
            ("A trough with walls of two slopes", 35, [(0, "0.8"), ("0.4", 0), ("1.2", 0), (2, "0.5")], [(2, 3), (0, 3)], 0),
            ("Upright flanks hold a peg", 30, [(0, 0), (1, 0), (1, "-0.5"), (2, "-0.5"), (2, 0), (3, 0)], [(3, 2), (0, 2)], 1),
            ("A saw of unequal flanks", 58, [(0, 0), ("0.7", "0.5"), ("0.8", 0), ("1.5", "0.5"), ("1.6", 0)],
             [("1.6", 4), (0, 4)], 0)):
        block, base = mated(under, tops, beyond)
        yield case("notches", title, block, base, friction)


def moved(points, x, y):
    return [(a + x, b + y) for a, b in points]


def far_origins():
    """The same shapes far from the origin: nothing but coordinates changes."""
    for power, make in ((6, lambda: (rectangle(1, 3), None)),
                        (7, lambda: toothed(3, "0.03", "0.12", "0.005", "valley", 0)),
                        (9, lambda: (worn(1, 2, "0.1", 8), None)),
                        (9, lambda: mated([(0, "0.8"), ("0.4", 0), ("1.2", 0), (2, "0.5")], [(2, 3), (0, 3)])),
                        (12, lambda: (rectangle("0.8", "1.7"), None)),
                        (12, lambda: toothed(3, "0.03", "0.12", "0.005", "valley", 2)),
                        (15, lambda: (ring((0, 0), ("1.1", 0), ("1.4", "2.3"), ("0.2", "1.9")), None)),
                        (15, lambda: toothed(4, "0.03", "0.2", "0.005", "peak", 0))):
        block, base = make()
        base = base or level(block)
        x, y = 4 * 10**power + Fraction(1, 8), -7 * 10**(power - 1) + Fraction(3, 10)
        yield case("far origins", f"At 4e{power} m, {len(block)} corners", moved(block, x, y), moved(base, x, y), 30)


def slivers():
    """Lengths that differ by orders: blades, sheets, spikes, facets of a hair."""
    hair = Fraction(1, 10**6)
    spike = ring((0, 0), (1, 0), (1, 2), ("0.500001", 2), ("0.5000005", 30), ("0.5", 2), (0, 2))
    ledge = [*ring((0, 0)), (hair, Fraction(0)), *ring(("0.1", "0.05"), ("0.9", "0.05")), (1 - hair, Fraction(0)),
             *ring((1, 0), (1, 2), (0, 2))]
    kinked = ring((0, 0), ("0.5", "0.0000001"), (1, 0), (1, 2), (0, 2))
    split = ring((0, 0), ("0.999999", 0), (1, "0.000001"), (1, 2), (0, 2))
    blade = ring((0, 0), ("0.001", 0), ("0.001", 1), (0, 1))
    sheet = rectangle(100, "0.001")
    leaning = ring((0, 0), ("0.00001", 0), ("0.00001", 1), (0, 1))
    saw = [(Fraction(k, 100), Fraction(k % 2, 10**6)) for k in range(21)] + ring(("0.2", "0.4"), (0, "0.4"))
    for title, block, base, friction in (
            ("A blade a thousand times as high as thick", blade, None, 30),
            ("A sheet a hundred thousand times as long as high", sheet, None, 41),
            ("A blade of aspect 1e5", leaning, None, 30),
            ("A block with a spike of half a micrometre", spike, None, 35),
            ("Standing on two ledges of a micrometre", ledge, None, 40),
            ("A sole with a kink of 1e-7", kinked, kinked[:3], 30),
            ("A toe bent up by a micrometre", split, split[:3], 50),
            ("Twenty teeth a micrometre deep", saw, saw[:21], 35)):
        yield case("slivers", title, block, base or level(block), friction)


def force(x, y, fx_kn, fy_kn):
    return {"type": "force", "x_m": x, "y_m": y, "fx_kn": fx_kn, "fy_kn": fy_kn}


def pressure(start, end, first_kpa, last_kpa):
    return {"type": "pressure", "from_m": list(start), "to_m": list(end), "kpa": [first_kpa, last_kpa]}


def loads():
    """Forces that turn with gravity, or stay on the block."""
    slab, slim = rectangle(2, 3), rectangle(1, 3)
    e_block, e_base = toothed(3, "0.3", "1.2", "0.05", "valley", 0)
    shake = [{"type": "seismic", "horizontal": "0.15"}]
    for title, block, base, friction, own in (
            ("An earthquake of 0.15 g on a slab", slab, None, 35, shake),
            ("An earthquake of 0.15 g on teeth", e_block, e_base, 30, shake),
            ("An anchor along the base at the top", slab, None, 35, [force("0", "3", "20", "0")]),
            ("An anchor down into the base", slab, None, 25, [force("1", "3", "0", "-60")]),
            ("A push at the top, down-dip", slim, None, 40, [force("1", "2.5", "-6", "0")]),
            ("Water behind the block", slab, None, 35, [pressure(("2", "0"), ("2", "2"), "20", "0")]),
            ("Water behind and below", slab, None, 40, [pressure(("2", "0"), ("2", "2"), "20", "0"),
                                                        pressure(("0", "0"), ("2", "0"), "0", "20")]),
            ("Water behind teeth, and an anchor", e_block, e_base, 30, [pressure(("0.9", "0.05"), ("0.9", "0.85"), "8", "0"),
                                                                      force("0", "1", "1.5", "0")])):
        yield case("loads", title, block, base or level(block), friction, loads=own, unit_weight_kn_m3="25")


def drawn_chain(chance, count, width, height):
    """A chain of irregular facets from left to right."""
    xs = sorted(chance.uniform(0.1, 0.9) for _ in range(count - 1))
    xs = [0.0, *xs, 1.0]
    return [(decimal(width * x), decimal(height * chance.uniform(0, 1))) for x in xs]


def drawn():
    """Irregular undersides on their counterparts, drawn with seeds: roughness and friction grow."""
    for seed, facets, height, friction in ((1, 3, 0.2, 30), (2, 3, 0.4, 35), (3, 3, 0.6, 40), (4, 4, 0.4, 35),
                                           (5, 4, 0.8, 50), (6, 4, 1.0, 58)):
        chance = random.Random(seed)
        while True:
            under = drawn_chain(chance, facets, 2, height)
            if min(b[0] - a[0] for a, b in zip(under, under[1:])) > Fraction(1, 10):
                break
        top = Fraction(4)
        block = under + [(Fraction(2), top), (Fraction(0), top)]
        yield case("drawn", f"Seed {seed}: {facets} facets, relief {height} m", block, under, friction, seed=seed)


def single():
    """All cases of one block, with names."""
    for make in (slabs, teeth, worn_corners, notches, far_origins, slivers, loads, drawn):
        for number, own in enumerate(make(), 1):
            yield {"name": f"{own['group'].replace(' ', '_')}_{number:02}", "difficulty": number, **own}
