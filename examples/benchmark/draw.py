# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The figure of docs/benchmark_cases.md, from the files of the benchmark alone: some of the cases, and of each engine and group the
shares of the answers by how far they are from the truth.

    python3 draw.py FIGURE.svg"""

import csv
import html
import sys

import score

DRAWN = ("teeth_11", "worn_corners_06", "notches_08", "islands_05", "drawn_06", "unfitting_profiles_04", "many_blocks_08",
         "many_blocks_10")
CLASSES = (("within 0.1°, 0.1 %", "#0072b2"), ("within 1°, 1 %", "#8ec6e6"), ("moves too soon", "#f0c35a"), ("stands too long", "#d55e00"),
           ("no answer", "#c8c8c8"))
WIDTH, LEFT, ROW, PICTURE = 860, 118, 22, 100


def place(quantity, bracket, value):
    """Which of the classes an answer is in."""
    if not value:
        return 4
    by = score.judged(quantity, bracket, value)
    if by is None:
        return 3 if value == "never" else 2
    late = (by > 0) != quantity.startswith("spared")
    return 0 if abs(by) <= 0.1 else 1 if abs(by) <= 1 else 3 if late else 2


def tables():
    """By engine: {(case, quantity): value}."""
    for path in sorted((score.HERE / "scores").glob("*.csv")):
        with open(path, encoding="utf-8", newline="") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            yield path.stem.replace("_", ", "), {(row["case"], row["quantity"]): row["value"].strip() for row in rows}


def text(x, y, words, anchor="start", size=12):
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}" font-size="{size}">{html.escape(words)}</text>'


def bars(manifest, answers, top):
    """The shares, a row a group, a column an engine; where the column of an engine without answers is empty."""
    engines = sorted(tables(), key=lambda own: all(name.startswith("solids") for name, _ in own[1]))
    groups = [group for group in dict.fromkeys(own["group"] for own in manifest.values())
              if any(score.is_of_motion(quantity) for name in manifest if manifest[name]["group"] == group
                     for quantity in answers[name])]
    step = (WIDTH - LEFT) / len(engines)
    for column, (engine, _) in enumerate(engines):
        yield text(LEFT + (column + 0.5) * step, top + 12, engine, "middle")
    for row, group in enumerate(groups):
        y = top + 20 + row * ROW
        asked = [(name, quantity) for name in manifest if manifest[name]["group"] == group
                 for quantity in answers[name] if score.is_of_motion(quantity)]
        yield text(LEFT - 8, y + 14, f"{group}, {len(asked)}", "end")
        for column, (_, given) in enumerate(engines):
            if not any(given.get(key) for key in asked):
                continue
            found = [place(quantity, answers[name][quantity], given.get((name, quantity), "")) for name, quantity in asked]
            x, wide = LEFT + column * step + 4, (step - 8) / len(asked)
            for kind, (_, colour) in enumerate(CLASSES):
                share = found.count(kind) * wide
                if share:
                    yield f'<rect x="{x:.1f}" y="{y}" width="{share:.1f}" height="{ROW - 5}" fill="{colour}"/>'
                x += share
    y, x = top + 20 + len(groups) * ROW + 8, LEFT + 4
    for words, colour in CLASSES:
        yield f'<rect x="{x}" y="{y}" width="14" height="12" fill="{colour}"/>' + text(x + 20, y + 11, words)
        x += 40 + 7.2 * len(words)


def shapes(own):
    """The polygons of a case, and lines; what lies on the ground first."""
    def rows(name):
        with open(score.HERE / name, encoding="utf-8", newline="") as file:
            return [(row.get("block"), float(row["x_m"]), float(row["y_m"])) for row in csv.DictReader(file)]
    if "blocks" in own:
        named = {}
        for block, x, y in rows(own["blocks"]):
            named.setdefault(block, []).append((x, y))
        return [ring for block, ring in named.items() if block != "ground"], named["ground"], True
    return [[(x, y) for _, x, y in rows(own["block"])]], [(x, y) for _, x, y in rows(own["base"])], False


def picture(name, own, left, top, wide):
    """A case in a frame of its own, the ground cut off a little beyond the blocks."""
    rings, ground, closed = shapes(own)
    points = [p for ring in rings for p in ring]
    x0, x1 = min(p[0] for p in points), max(p[0] for p in points)
    points += [p for p in ground if x0 <= p[0] <= x1 and not closed]
    y0, y1 = min(p[1] for p in points), max(p[1] for p in points)
    scale = min((wide - 24) / (x1 - x0), (PICTURE - 16) / (y1 - y0))

    def path(ring):
        return " ".join(f"{(wide - 6) / 2 + scale * (x - (x0 + x1) / 2):.1f},{PICTURE - 8 - scale * (y - y0):.1f}" for x, y in ring)

    inset = f'<svg x="{left:.1f}" y="{top}" width="{wide - 6:.1f}" height="{PICTURE + 10}">'
    drawn = "".join(f'<polygon points="{path(ring)}" fill="#e8e2d8" stroke="#444"/>' for ring in rings)
    kind = "polygon" if closed else "polyline"
    rock = f'<{kind} points="{path(ground)}" fill="{"#d9d9d9" if closed else "none"}" stroke="#a05a2c" stroke-width="2"/>'
    return inset + (rock + drawn if closed else drawn + rock) + "</svg>" + text(left + wide / 2 - 3, top + PICTURE + 22, name, "middle", 11)


def main(path):
    manifest, answers = score.load()
    wide = WIDTH / 4
    lines = [picture(name, manifest[name], 3 + k % 4 * wide, 4 + k // 4 * (PICTURE + 30), wide) for k, name in enumerate(DRAWN)]
    top = 2 * (PICTURE + 30) + 14
    lines += bars(manifest, answers, top)
    groups = {own["group"] for name, own in manifest.items() if any(score.is_of_motion(q) for q in answers[name])}
    high = top + 20 + len(groups) * ROW + 30
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{high}" viewBox="0 0 {WIDTH} {high}" '
                   'font-family="sans-serif">\n<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(lines) + "\n</svg>\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    main(sys.argv[1])
