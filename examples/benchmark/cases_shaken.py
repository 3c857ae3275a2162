# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cases of the benchmark of slabs that are shaken: whole sines of one frequency, of which stronger ones need not overturn a slab
that weaker ones do.

Asked are the peaks, as shares of gravity, from which on it overturns, is spared again, and overturns again. `near` has each to a thousandth,
by a scan; Topple halves between it and a thousandth to both sides."""

from cases import case, level, rectangle

EDGES = ("overturns_from_g", "spared_from_g", "overturns_again_from_g")
SLABS = (("A slab that is shaken", 2, 5, "1", ("0.811", "1.719", "2.023")),
         ("A column shaken slowly", 1, 4, "0.8", ("0.332", "0.776", "0.795")),
         ("A column shaken more quickly", 1, 4, "1.2", ("0.444", "1.252", "1.326")),
         ("A slender column", "0.5", 3, "1.5", ("0.308", "0.941", "0.967")),
         ("A pillar as high as a man", "0.2", "1.6", "2.5", ("0.320", "0.935", "0.955")),
         ("The pillar shaken more quickly", "0.2", "1.6", "3", ("0.505", "1.225", "1.261")))

def shaken():
    for title, width, height, frequency, near in SLABS:
        block = rectangle(width, height)
        yield case("shaken", title, block, level(block), 75, shaking={"full_sine": {"frequency_hz": frequency}}, near=near)


def let_shake():
    for number, own in enumerate(shaken(), 1):
        yield {"name": f"shaken_{number:02}", "difficulty": number, **own}
