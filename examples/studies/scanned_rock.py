# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A scanned rock from its file to a rose, a section and a probability: docs/scanned_rock.md says what comes out of it.

The mesh, examples/solids/scanned_rock_sp2.obj, says in its head where it comes from. Three questions: which part of the rock's
tilt depends on what is taken to touch; how far off is a section through the centroid, in the direction in which the rock is
tilted; and with what probability does it move at a tilt, if azimuth, contact and friction are not known.

    scanned_rock.py [FIGURE.svg]

What is checked: the area and centroid of the sections are those that the program cuts and integrates, to 1e-8 of the rock."""

import math
import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np

import topple

MESH = Path(__file__).resolve().parent.parent / "solids" / "scanned_rock_sp2.obj"
BANDS = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02)  # metres
SEEN = 0.002  # the band of the sections
STEP = 5  # degrees of azimuth
STUDY = """topple_study: 1
scene: scene.yaml
samples: 2000
sampling: {method: latin_hypercube, seed: 36}
vary:
  friction_angle_deg: {normal: {mean: 32, deviation: 3}, truncated: [20, 45]}
  tilt.azimuth_deg: {uniform: {low: 0, high: 360}}
  solid.bands.1: {uniform: {low: 0.001, high: 0.005}}
tilts_deg: [2, 4, 6, 8, 10, 12, 15, 20]
"""
SCENE = """topple: 1
length_unit: m
solid: {{file: {mesh}, unit: m, unit_weight_kn_m3: 26, bands: [0.002]}}
friction_angle_deg: 32
tilt: {{angle_deg: 5, azimuth_deg: 0}}
"""
SECTION = """topple: 1
length_unit: m
section: {{at: [{x!r}, {y!r}], azimuth_deg: {azimuth!r}}}
block: {{outline: {{mesh: {mesh}, unit: m}}, unit_weight_kn_m3: 26}}
"""

warnings.simplefilter("ignore", topple.Caution)


def read():
    """Points and triangles."""
    words = [line.split() for line in MESH.read_text(encoding="utf-8").splitlines() if line[:2] in ("v ", "f ")]
    points = np.array([line[1:] for line in words if line[0] == "v"], dtype=float)
    return points, np.array([line[1:] for line in words if line[0] == "f"], dtype=int) - 1


def section(points, triangles, centre, azimuth):
    """The segments that a vertical plane through the centre cuts, an array of (from s, from z, to s, to z); s along the azimuth."""
    along = np.array([math.sin(math.radians(azimuth)), math.cos(math.radians(azimuth))])
    s = (points[:, :2] - centre) @ along
    side = (points[:, :2] - centre) @ np.array([along[1], -along[0]])  # to the right of the plane
    segments = []
    right = side[triangles] > 0
    for corners in triangles[right.any(axis=1) & ~right.all(axis=1)]:
        ends = {}
        for a, b in zip(corners, np.roll(corners, -1)):
            if (side[a] > 0) != (side[b] > 0):
                t = side[a] / (side[a] - side[b])
                ends[side[a] > 0] = (s[a] + t * (s[b] - s[a]), points[a, 2] + t * (points[b, 2] - points[a, 2]))
        segments.append(ends[False] + ends[True])  # the surface runs one way round the section
    return np.array(segments)


def moments(segments):
    """Area, and the centroid's s and z."""
    s0, z0, s1, z1 = segments.T
    cross = s0 * z1 - s1 * z0
    area = cross.sum() / 2
    return area, np.sum((s0 + s1) * cross) / (6 * area), np.sum((z0 + z1) * cross) / (6 * area)


def critical(segments, band):
    """Of a section on a level base that touches all within the band over its lowest point: the tilt towards its azimuth, degrees."""
    _, s, z = moments(segments)
    low = segments[:, 1].min()
    toe = segments[segments[:, 1] <= low + band, 0].max()
    return math.degrees(math.atan2(toe - s, z - low))


def largest_difference(points, triangles, centre):
    """Of area and centroid from those that the program finds, over four sections, relative to the rock's size of half a metre."""
    worst = 0.0
    for azimuth in (10.0, 100.0, 190.0, 333.0):
        scene = topple.Scene.from_text(SECTION.format(x=centre[0], y=centre[1], azimuth=azimuth, mesh=MESH), "section")
        block = scene.solve().block
        area, *centroid = moments(section(points, triangles, centre, azimuth))
        theirs = np.array([block.area_m2.value, block.centroid_x_m.value, block.centroid_y_m.value])
        worst = max(worst, np.max(np.abs(np.array([abs(area), *centroid]) - theirs)) / 0.5)
    return worst


def draw(path, rose, sections):
    """A polar figure, north up: the solid's tilt in blue, the sections' in red, rings every 20 degrees."""
    size, scale = 250, 3.6

    def at(azimuth, tilt):
        t = math.radians(azimuth)
        return f"{size + scale * tilt * math.sin(t):.1f},{size - scale * tilt * math.cos(t):.1f}"

    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 680 500" font-family="DejaVu Sans, sans-serif" font-size="13">',
             '<rect width="680" height="500" fill="white"/>']
    for ring in (20, 40, 60):
        parts.append(f'<circle cx="{size}" cy="{size}" r="{scale * ring:g}" fill="none" stroke="#ccc"/>'
                     f'<text x="{size + 3}" y="{size - scale * ring - 3:g}" fill="#777">{ring}°</text>')
    for azimuth, name in ((0, "N"), (90, "E"), (180, "S"), (270, "W")):
        x, y = at(azimuth, 66).split(",")
        parts.append(f'<text x="{x}" y="{y}" text-anchor="middle" dominant-baseline="middle" font-weight="bold">{name}</text>')
    for tilts, colour in ((sections, "#b00"), (rose, "#1b6ca8")):
        line = " ".join(at(azimuth, max(tilt, 0)) for azimuth, tilt in tilts)
        parts.append(f'<polygon points="{line}" fill="{colour}" fill-opacity="0.12" stroke="{colour}" stroke-width="2"/>')
    for k, (words, colour) in enumerate((("the solid", "#1b6ca8"), ("a section through its centroid", "#b00"))):
        y = 40 + 20 * k
        parts.append(f'<path d="M450 {y}h24" stroke="{colour}" stroke-width="3"/><text x="480" y="{y + 4}">{words}</text>')
    parts.append('<text x="450" y="90" fill="#555">tilt at which it topples</text></svg>')
    Path(path).write_text("\n".join(parts) + "\n", encoding="utf-8")


def bands(solid):
    print("| what touches | points | corners | least tilt | towards | over all azimuths, 5, 50 and 95 % |\n| --- | --- | --- | --- | --- | --- |")
    for band in solid.bands:
        if not band.stands:
            print(f"| {1000 * band.band:g} mm | {band.touching} | {len(band.support)} | does not stand | | |")
            continue
        tilts = [towards.toppling_deg.value for towards in band.rose]
        low, middle, high = np.quantile(tilts, (0.05, 0.5, 0.95))
        print(f"| {1000 * band.band:g} mm | {band.touching} | {len(band.support)} | {band.least.tilt_deg.value:.2f}° | "
              f"{band.least.azimuth_deg.value:.0f}° | {low:.1f}°, {middle:.1f}°, {high:.1f}° |")


def compared(rose, sections):
    """Sections against the solid, by the azimuth."""
    solid, cut = (np.array([tilt for _, tilt in tilts]) for tilts in (rose, sections))
    off = cut - solid
    print("\n| the section says | least | 5 % | 50 % | 95 % | greatest | root mean square | more than the solid |\n| --- | --- | --- | --- | --- | --- | --- | --- |")
    low, middle, high = np.quantile(off, (0.05, 0.5, 0.95))
    print(f"| minus the solid | {off.min():.1f}° | {low:.1f}° | {middle:.1f}° | {high:.1f}° | {off.max():.1f}° | "
          f"{math.sqrt(np.mean(off**2)):.1f}° | in {np.sum(off > 0)} of {len(off)} azimuths |")
    worst = int(np.argmin(solid))
    print(f"| towards the rock's worst azimuth, {rose[worst][0]:g}° | {cut[worst]:.1f}° for {solid[worst]:.1f}° | | | | | | |")


def probable(folder):
    (folder / "scene.yaml").write_text(SCENE.format(mesh=MESH), encoding="utf-8")
    (folder / "study.yaml").write_text(STUDY, encoding="utf-8")
    study = topple.study(folder / "study.yaml")
    print("\n| tilt | it moves, probability, 95 % |\n| --- | --- |")
    for tilt in study.tilts:
        if not tilt.of_scene:
            share = tilt.certain_to_move
            print(f"| {tilt.tilt_deg:g}° | {share.share:.3f}, {share.low:.3f} to {share.high:.3f} |")


def main():
    points, triangles = read()
    solid = topple.solid_of_file(MESH, length_unit="m", bands=BANDS, azimuths=360 // STEP)
    centre = np.array([solid.centroid_m[0].value, solid.centroid_m[1].value])
    bands(solid)
    (seen,) = [band for band in solid.bands if band.band == SEEN]
    rose = [(towards.azimuth_deg, towards.toppling_deg.value) for towards in seen.rose]
    sections = [(azimuth, critical(section(points, triangles, centre, azimuth), SEEN)) for azimuth, _ in rose]
    compared(rose, sections)
    with tempfile.TemporaryDirectory() as folder:
        probable(Path(folder))
    if len(sys.argv) > 1:
        draw(sys.argv[1], rose, sections)
    worst = largest_difference(points, triangles, centre)
    print(f"\nsections: off by {worst:.0e} of the rock at most")
    good = worst <= 1e-8
    print("The sections agree." if good else "The sections do NOT agree.")
    return not good


if __name__ == "__main__":
    sys.exit(main())
