# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Random contacts whose facets have frictions of their own, and what each contact point has by the
outline and the profile alone: a facet that of its edge of the base; a point in a notch of the base
that of each edge; any other point at a vertex of the base the smaller of both edges, the upright end
faces having the scene's."""

import random
from fractions import Fraction

from limit_oracle import along, corner, cross2, minus, unit
from limit_scenes import mated_polygon, mated_teeth, text_of
from onset_case import degrees_of


def spans(outline, profile, tangents):
    """(p, q, t, tan(phi)) of every facet, from end to end."""
    found = set()
    for a0, a1 in zip(outline, outline[1:] + outline[:1]):
        for (b0, b1), tangent in zip(zip(profile, profile[1:]), tangents[1:]):
            d, e = minus(a1, a0), minus(b1, b0)
            if cross2(d, e) != 0 or d[0] * e[0] + d[1] * e[1] <= 0 or cross2(d, minus(b0, a0)) != 0:
                continue
            ends = {p for p in (a0, a1) if along(p, b0, b1) is not None}
            ends |= {p for p in (b0, b1) if along(p, a0, a1) is not None}
            if len(ends) == 2:
                p, q = sorted(ends, key=lambda end: end[0] * d[0] + end[1] * d[1])
                found.add((p, q, unit(d), tangent))
    return sorted(found)


def single_points(outline, profile, tangents):
    """(p, t, tan(phi)) of every touching point."""
    count = len(outline)
    for k, p in enumerate(outline):
        before, after = outline[k - 1], outline[(k + 1) % count]
        for j, q in enumerate(profile):
            if p == q:
                least = min(tangents[j], tangents[j + 1])
                up, down = corner(profile, j, False), corner(outline, k, True)
                if (up or 0) > 0:
                    yield p, unit(minus(q, profile[j - 1])), tangents[j]
                    yield p, unit(minus(profile[j + 1], q)), tangents[j + 1]
                elif down < 0:
                    yield p, unit(minus(p, before)), least
                    yield p, unit(minus(after, p)), least
                elif up == 0:
                    yield p, unit(minus(profile[j + 1], q)), least
                elif down == 0:
                    yield p, unit(minus(after, p)), least
        for j, (b0, b1) in enumerate(zip(profile, profile[1:])):
            if p not in (b0, b1) and along(p, b0, b1) is not None:
                yield p, unit(minus(b1, b0)), tangents[j + 1]
    for j, q in enumerate(profile):
        for a0, a1 in zip(outline, outline[1:] + outline[:1]):
            if q not in (a0, a1) and along(q, a0, a1) is not None:
                yield q, unit(minus(a1, a0)), min(tangents[j], tangents[j + 1])


def rough_contacts(outline, profile, tangents):
    """((x, y), t, tan(phi)) of every end of a facet and every touching point. `tangents` are those of the left end
    face, of each edge of the profile, and of the right end face."""
    facets = spans(outline, profile, tangents)
    found = {(p, t, tangent) for a, b, t, tangent in facets for p in (a, b)}
    ends = {(p, t) for p, t, _ in found}
    return sorted(found | {own for own in single_points(outline, profile, tangents) if own[:2] not in ends})


def besides(outline, profile, tangents):
    """((x, y), t, tan(phi), sense) where a facet ends at a vertex of the base, other than a notch, beyond which the friction is
    another: what slips towards that, or however it slips where the block's edge goes on, may have either."""
    found = []
    facets = spans(outline, profile, tangents)
    for p, q, t, own in facets:
        for end, sense in ((p, -1), (q, 1)):
            at = profile.index(end) if end in profile else 0
            turn = corner(profile, at, False)
            if turn is None or turn > 0:
                continue
            if turn == 0 and sum(end in facet[:2] for facet in facets) > 1:
                continue
            k = outline.index(end) if end in outline else None
            if k is None or corner(outline, k, True) == 0:
                sense = 0
            beyond = tangents[at + (1 if end == q else 0)]
            if beyond != own:
                found.append((end, t, beyond, sense))
    return found


def pieces():
    """A block on one slope that is written in several pieces, or on steps of that slope."""
    count, rise = random.randint(2, 4), Fraction(random.choice([0, 0, 1, -2]), 10)
    step = random.choice([0, 0, Fraction(1, 2)])
    under = [(Fraction(0), Fraction(0))]
    for k in range(count):
        x, y = under[-1]
        width = random.randint(1, 4)
        under.append((x + width, y + rise * width))
        if k < count - 1 and step:
            under.append((x + width, y + rise * width + random.choice([-step, step])))
    height = max(y for _, y in under) + random.randint(1, 12)
    outline = under + [(under[-1][0], height), (under[0][0], height)]
    return f"outline: {text_of(outline)}", f"profile: {text_of(under)}", outline, under


def draw_tangents(block, base, profile, make, draw):
    """tan(phi) of the scene; for each edge of the profile, framed by the end faces; and the entries of the scene file.
    Of a mated base those of the underside are counted, from the first behind what goes on to the left."""
    scene, others = draw(), [draw() for _ in range(2)]
    edges = len(profile) - 1
    first, count = 0, edges
    if make in (mated_teeth, mated_polygon):
        left, right = (base.split(f"{side}: ")[1].split(",")[0].rstrip("}") for side in ("left", "right"))
        first = int(Fraction(left) > 0)
        count = edges - first - int(Fraction(right) > 0)
    own = [random.choice([None, None, *others]) for _ in range(count)]
    tangents = [scene] + [scene] * edges + [scene]
    entries = []
    for k, tangent in enumerate(own):
        if tangent is None:
            continue
        tangents[1 + first + k] = tangent
        entries.append((k + 1, k + 1, tangent))
    return scene, tangents, joined(entries)


def joined(entries):
    """Neighbours of one friction now and then as one entry."""
    found = []
    for first, last, tangent in entries:
        if found and found[-1][1] == first - 1 and found[-1][2] == tangent and random.random() < 0.5:
            found[-1] = (found[-1][0], last, tangent)
        else:
            found.append((first, last, tangent))
    random.shuffle(found)
    return found


def angle_text(tangent):
    """In degrees to 45 digits."""
    return {0: 0, 1: 45}[tangent] if tangent in (0, 1) else degrees_of(tangent)


def friction_text(entries):
    """The lines of a scene file."""
    if not entries:
        return ""
    return "friction:\n  facets:\n" + "".join(
        f"  - {{facet: {first if first == last else [first, last]}, angle_deg: {angle_text(tangent)}}}\n"
        for first, last, tangent in entries)


def whole_tangent(tangent):
    tangent = Fraction(tangent)
    return tangent.numerator, tangent.denominator
