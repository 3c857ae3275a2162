# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Makes balanced_rock.obj: a rock that stands on a foot of its own, as a scanner gives it, in metres.

No scan of a real rock: a sphere of triangles, drawn out to the half-axes of a rock, leaned and roughened by waves of falling
height; what lies below its foot is raised to it, and up to 12 mm beyond, as the noise and the moss of a survey would have it.
Coordinates are written to the millimetre. `python3 balanced_rock.py` writes the file anew, to the byte."""

import pathlib
import random

from scanned_boulder import sphere, waves

HALF_AXES = (0.75, 0.6, 1.2)
LEAN, FOOT, NOISE = 0.12, -1.0, 0.012  # of x over z; the height of the foot, and how uneven it is, in metres


def main():
    lines = ["# A rock on its foot: made by balanced_rock.py, no scan of a real rock; GPL-3.0-or-later", "o rock"]
    points, faces = sphere(3)
    rough, chance = waves(5, 7, 1.6), random.Random(2)
    for p in points:
        swell = 1 + 0.05 * rough(*p)
        x, y, z = (a * c * swell for a, c in zip(HALF_AXES, p))
        z = max(z, FOOT + chance.uniform(0, NOISE))
        lines.append(f"v {x + LEAN * z:.3f} {y:.3f} {z - FOOT:.3f}")
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces]
    pathlib.Path(__file__).with_name("balanced_rock.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
