# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Many blocks in arrays of NumPy: moments against fractions worked out here, critical angles and verdicts against a scene of
each block solved by itself; any layout of the arrays; blocks that are bad input."""

import unittest
import warnings
from fractions import Fraction

from harness import main
from python_case import numpy, topple

NUMBERS = numpy.random.default_rng(7)


def stones(count, vertices):
    """Blocks on a rough underside: its heights at random, two corners above; shape (count, vertices, 2)."""
    x = numpy.linspace(0, 100, vertices - 2)
    y = NUMBERS.uniform(0, 4, (count, vertices - 2))
    under = numpy.stack([numpy.broadcast_to(x, y.shape), y], axis=-1)
    height = NUMBERS.uniform(100, 300, (count, 1))
    above = numpy.stack([numpy.concatenate([100 + 0 * height, 0 * height], 1), numpy.concatenate([height, height], 1)], -1)
    return numpy.concatenate([under, above], axis=1)


def exact_moments(outline):
    """Area, centroid and second moments about it, by Green's theorem in fractions."""
    points = [(Fraction(x), Fraction(y)) for x, y in outline]
    edges = [(p, q, p[0] * q[1] - q[0] * p[1]) for p, q in zip(points, points[1:] + points[:1])]
    area = sum(cross for *_, cross in edges) / 2
    first = [sum((p[k] + q[k]) * cross for p, q, cross in edges) / 6 / area for k in (0, 1)]
    second = [sum((p[i] * p[j] + q[i] * q[j] + (p[i] + q[i]) * (p[j] + q[j])) * cross for p, q, cross in edges) / 24
              for i, j in ((0, 0), (1, 1), (0, 1))]
    moved = [own - area * first[i] * first[j] for own, (i, j) in zip(second, ((0, 0), (1, 1), (0, 1)))]
    return [abs(area), *first, *(own * (1 if area > 0 else -1) for own in moved)]


MOMENTS = ("area", "centroid_x", "centroid_y", "second_moment_xx", "second_moment_yy", "second_moment_xy")


class Moments(unittest.TestCase):
    def test_against_fractions(self):
        """Within their bounds, and the bounds small; of one outline by itself the same bits."""
        blocks = stones(50, 9)
        blocks[::2] = blocks[::2, ::-1]  # the other way round
        own = topple.moments(blocks)
        self.assertEqual((len(own), own.summary.done, own.summary.bad), (50, 50, 0))
        for k, block in enumerate(blocks):
            one = topple.outline_moments(block)
            for name, exact in zip(MOMENTS, exact_moments(block)):
                value, error = getattr(own, name)[k], getattr(own, f"{name}_error")[k]
                self.assertLessEqual(abs(Fraction(value) - exact), Fraction(error))
                self.assertLess(error, 1e-10 * max(abs(own.second_moment_yy[k]), 1))
                self.assertEqual((getattr(one, name).value, getattr(one, name).error), (value, error))

    def test_layouts(self):
        """However the outlines lie in memory, and of whatever type that doubles hold."""
        blocks = numpy.round(stones(20, 8))
        meant = topple.moments(blocks)
        wide = numpy.zeros((40, 8, 4))
        wide[::2, :, ::2] = blocks
        for own in (wide[::2, :, ::2], numpy.asfortranarray(blocks), blocks.astype(numpy.int32), blocks.astype(">f8"),
                    blocks.astype(numpy.float32), list(blocks), [block.tolist() for block in blocks],
                    blocks[:, :, ::-1].copy()[:, :, ::-1]):
            found = topple.moments(own, threads=2)
            for name in MOMENTS:
                self.assertEqual(getattr(found, name).tobytes(), getattr(meant, name).tobytes())
        ragged = topple.moments([blocks[0], numpy.vstack([blocks[1], blocks[1][:1]]), [(0, 0), (2, 0), (0, 2)]])
        self.assertEqual(list(ragged.area[:2]), list(meant.area[:2]))
        self.assertEqual(ragged.area[2], 2)
        self.assertEqual(topple.moments(blocks[0]).area.shape, (1,))
        self.assertEqual(len(topple.moments([])), 0)

    def test_what_is_no_outline(self):
        for wrong in (numpy.zeros(4), numpy.zeros((2, 3, 3)), numpy.zeros((1, 2, 3, 2)), [numpy.zeros((3, 3))],
                      [[(Fraction(1, 3), 0), (1, 0), (0, 1)]], numpy.full((1, 3, 2), 2**60 + 1)):
            self.assertRaises(topple.BadInput, topple.moments, wrong)

    def test_masked_and_other_arrays(self):
        """What a mask hides would count as a number, half of a complex number would be lost, an object is anything: refused
        by every call that takes an array, also within a list. NaN of a coordinate is bad input of its block."""
        blocks = stones(4, 7)
        masked, number = numpy.ma.masked_array(blocks, mask=blocks > blocks.max()), numpy.ma.masked_array([1.0, 2, 3, 4], [0, 1, 0, 0])
        points, scene = masked[0], topple.Scene("m", outline=blocks[0])
        self.assertFalse(masked.mask.any())  # none is hidden: the next array of its kind may have one
        for call in (lambda: topple.moments(masked), lambda: topple.moments(list(masked)), lambda: topple.outline_moments(points),
                     lambda: topple.critical_angles(masked), lambda: topple.verdicts(masked), lambda: topple.verdicts(blocks, number),
                     lambda: topple.verdicts(blocks, 30, number), lambda: topple.verdicts(blocks, number[1]),
                     lambda: scene.set_outline(points), lambda: scene.set_outline(list(points)), lambda: scene.set_base_profile(points),
                     lambda: scene.add_hole(points), lambda: scene.set_shaking_record("horizontal", points),
                     lambda: topple.Scene("m", outline=points), lambda: topple.profile_of_points(points),
                     lambda: topple.chart_fos(amplitude=number)):
            with self.assertRaisesRegex(topple.BadInput, "^a masked array is not taken"):
                call()
        for wrong in (numpy.ones(4, complex), numpy.array([30, None, 30, 30]), numpy.array(["30"] * 4), numpy.ones(4, bool),
                      numpy.full(4, 2**53 + 1), numpy.full(4, numpy.longdouble(1) / 3)):
            with self.assertRaisesRegex(topple.BadInput, "^an array of"):
                topple.verdicts(blocks, wrong)
        self.assertRaises(topple.BadInput, topple.moments, blocks.astype(complex))
        self.assertRaises(TypeError, scene.set_outline, blocks[0].astype(complex))

    def test_decimals_as_given(self):
        """A message prints the decimals that a double was given by, not the fraction that it is."""
        scene = topple.Scene("m", outline=[(0, 0), (1.1, 0), (0.1, 0.9), (1.1, 0.7), (0.3, 0.5)])
        with self.assertRaises(topple.BadInput) as caught:
            scene.solve()
        self.assertIn("(0.1, 0.9)", str(caught.exception))
        self.assertNotRegex(str(caught.exception), r"\d/\d|\d{12}")

    def test_bad_blocks(self):
        """They stop nothing, and a caution tells of the first."""
        blocks = stones(5, 7)
        blocks[3, 0, 0] = numpy.nan
        with self.assertWarnsRegex(topple.Caution, "1 of the blocks bad input; block 3"):
            own = topple.moments(blocks)
        self.assertEqual([topple.Status(k) for k in own.status], [topple.Status.OK] * 3 + [topple.Status.BAD_INPUT,
                                                                                         topple.Status.OK])
        self.assertTrue(numpy.isnan(own.area[3]))
        self.assertEqual((own.summary.first_bad, own.summary.bad, own.summary.done), (3, 1, 4))


class Angles(unittest.TestCase):
    def test_against_scenes(self):
        """Each as the scene of its outline says, in both directions; any number of threads gives the same bytes."""
        blocks = stones(40, 8)
        for towards in topple.Direction:
            own = topple.critical_angles(blocks, towards, threads=1)
            same = topple.critical_angles(blocks, towards.value, threads=3)
            self.assertEqual((own.angle_deg.tobytes(), own.error_deg.tobytes()), (same.angle_deg.tobytes(),
                                                                                  same.error_deg.tobytes()))
            for k, block in enumerate(blocks):
                pivot = topple.Scene("mm", outline=block).solve(limit=False).case(towards).governing_pivot
                if pivot is None:
                    self.assertEqual((own.status[k], own.pivot[k]), (topple.Status.NO_ANSWER, -1))
                    continue
                self.assertLessEqual(abs(own.angle_deg[k] - pivot.critical_angle_deg.value),
                                     own.error_deg[k] + pivot.critical_angle_deg.error)
                self.assertAlmostEqual(block[own.pivot[k]][0] / 1000, pivot.x_m.value, delta=1e-12)

    def test_verdicts(self):
        """Friction for all, a tilt for each; and neither."""
        blocks, tilts = stones(12, 7), numpy.linspace(0, 40, 12)
        own = topple.verdicts(blocks, 25, tilts, "right")
        bare = topple.verdicts(blocks)
        self.assertEqual(list(bare.limit_kind), [topple.LimitKind.NOT_ASKED] * 12)
        for k, block in enumerate(blocks):
            scene = topple.Scene("m", outline=block, friction_angle_deg=25, tilt_angle_deg=tilts[k])
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", topple.Caution)
                case = scene.solve().case("right")
            self.assertEqual((own.mechanism[k], own.first[k], own.limit_kind[k], own.onset_kind[k]),
                             (case.mechanism, case.first, case.limit.kind, case.onset.kind))
            for name, number in (("first_angle_deg", case.first_angle_deg), ("limit_angle_deg", case.limit.critical_angle_deg),
                                 ("onset_angle_deg", case.onset.critical_angle_deg), ("fos", case.governing_fos.fos.value)):
                value = getattr(own, name)[k]
                self.assertEqual(numpy.isnan(value), number is None, name)
                if number is not None:
                    self.assertAlmostEqual(value, number.value, delta=1e-9 * max(1, abs(value)))
        self.assertRaises(topple.BadInput, topple.verdicts, blocks, numpy.zeros(3))


if __name__ == "__main__":
    main()
