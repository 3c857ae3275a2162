# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Formulas, claims, charts, accuracy and back-analysis in Python: what the program prints, and formulas that can be called,
against fractions worked out here."""

import csv
import json
import math
import pathlib
import pickle
import re
import tempfile
import unittest
import xml.dom.minidom
from fractions import Fraction

from harness import ROOT, main, run
from python_case import numpy, topple

BLOCK = ROOT / "examples" / "block_e_valley.yaml"
CLAIMS = ROOT / "examples" / "paper" / "claims.yaml"


def printed(*arguments):
    """What the program prints."""
    status, out, err = run(*arguments)
    if status > 1:
        raise AssertionError(err)
    return out


class Words(unittest.TestCase):
    def test_explained(self):
        """The program's text; a word that there is not names what is nearest."""
        self.assertEqual(topple.explain("α_w"), printed("explain", "α_w"))
        self.assertIn("cases[].limit.fos", topple.explain("limit.fos"))
        with self.assertRaisesRegex(topple.NoAnswer, "nearest: 'safety factor'"):
            topple.explain("saftey factor")
        self.assertIn("factor of safety (FoS)", topple.terms())
        self.assertEqual("".join(term + "\n" for term in topple.terms()), printed("explain"))


class Blocks(unittest.TestCase):
    def test_block_system(self):
        """What the program prints of many blocks, and the same in the records."""
        path = ROOT / "examples" / "blocks" / "toppling_slope.yaml"
        scene = topple.Scene.read(path)
        self.assertEqual(scene.block_count, 17)
        own = scene.solve_block_system()
        self.assertEqual(own.report(), printed("solve", path))
        told = json.loads(printed("solve", "--json", path))
        self.assertEqual(json.loads(own.to_json()), told)
        self.assertEqual(own.to_csv(), printed("solve", "--csv", path))
        self.assertEqual(json.loads(own.to_json_outlines()), json.loads(printed("solve", "--json", "--outlines", path)))
        swept = topple.sweep(scene, "friction_angle_deg=36,38.15").columns
        self.assertEqual(list(swept["verdict"]), ["may move"] * 2)
        self.assertEqual(swept["fos"][1], told["cases"][0]["fos"]["value"])
        self.assertEqual(own.cases[0].fos.value.value, told["cases"][0]["fos"]["value"])
        self.assertEqual(own.cases[0].verdict, topple.SystemVerdict.MAY_MOVE)
        self.assertEqual(own.cases[0].start.divisor, 1)
        moving = own.cases[0].moving_fos  # a motion can begin as they lie, so no factor is met
        self.assertEqual([own.meets(factor * moving) for factor in (0.99, 1.01, 1.5)], [topple.Design.NOT_MET] * 3)
        self.assertEqual([c.state.value for c in own.cases[0].goodman_bray.columns[:4]], ["slides"] * 3 + ["topples"])
        with tempfile.TemporaryDirectory() as folder:
            figure = pathlib.Path(folder) / "figure.svg"
            run("solve", "--figure", figure, path)
            self.assertEqual(own.svg(), figure.read_text(encoding="utf-8"))
            own.write_report(pathlib.Path(folder) / "sheet.md", letterhead={"language": "de"})
            self.assertIn("Annahmen", (pathlib.Path(folder) / "sheet.md").read_text(encoding="utf-8"))
            run("solve", "--animation", figure, path)
            self.assertEqual(own.animation_svg(), figure.read_text(encoding="utf-8"))
            own.write_animation(pathlib.Path(folder) / "moving.svg")
            self.assertEqual((pathlib.Path(folder) / "moving.svg").read_bytes(), figure.read_bytes())
        self.assertEqual(topple.table([own]), printed("solve", "--table", path))
        self.assertEqual(topple.csv([own]), printed("solve", "--csv", path))
        with self.assertRaisesRegex(TypeError, "make two of them"):
            topple.table([own, topple.Scene.read(ROOT / "examples" / "slab.yaml").solve()])
        found = topple.find(scene, "friction_angle_deg", "fos_goodman_bray", 1, 38, 38.3)
        words = "solve", "--find", "friction_angle_deg", "--for", "fos_goodman_bray=1", "--from", "38", "--to", "38.3"
        self.assertEqual(found.report(), printed(*words, path))
        self.assertEqual(json.loads(found.to_json(own)), json.loads(printed(*words, "--json", path)))
        self.assertAlmostEqual(found.blocks[0].fos_goodman_bray, 1, delta=1e-8)
        self.assertIsNone(scene.solve_block_system(strength_reduction=False).cases[0].fos.value)
        with self.assertRaisesRegex(topple.BadInput, "many blocks"):
            scene.solve()


class Formulas(unittest.TestCase):
    def test_derivation(self):
        """The program's JSON, and the same in the records."""
        scene = topple.Scene.read(BLOCK)
        own = topple.derive(scene, elements=True, rounded=True, limit=True)
        told = json.loads(printed("derive", "--json", "--elements", "--rounded", "--limit", BLOCK))
        self.assertEqual(json.loads(own.to_json()), told)
        self.assertEqual(own.report(), printed("derive", "--elements", "--rounded", "--limit", BLOCK))
        self.assertEqual(list(own.symbols), told["symbols"])
        for pivot, mine in zip(told["pivots"], own.pivots, strict=True):
            self.assertEqual(pivot["tan_critical_angle"], {"numerator": mine.tan_critical_angle.numerator,
                                                           "denominator": mine.tan_critical_angle.denominator})
            self.assertEqual((pivot["towards"], pivot["kind"], pivot["governs"]),
                             (mine.towards.value, mine.kind.value, mine.governs))
            self.assertEqual(pivot["critical_angle_deg"]["value"], mine.critical_angle_deg.value)
            self.assertEqual("cot" in pivot["fos_elements"], mine.fos_cot is not None)
        left = topple.Direction.LEFT
        self.assertEqual(told["limit"][0]["conditions"], [str(c) for c in own.limit[left].conditions])
        self.assertEqual([check["condition"] for check in told["limit"][0]["checks"]],
                         [check.condition for check in own.limit[left].checks])
        self.assertEqual(len(own.limit[left].reactions), 2)
        self.assertEqual(told["onset"][0]["same_as_limit"], own.onset[left].same_as_limit)
        self.assertEqual(told["rounded"][0]["corner_radius"]["numerator"], own.rounded[left].corner_radius.numerator)
        self.assertEqual(len(own.elements[left]), 6)
        self.assertEqual(pickle.loads(pickle.dumps(own)), own)

    def test_called(self):
        """(A1.1) of the paper at its numbers, worked out here from the moments of three trapezia; exactly, in doubles, over
        an array, and at symbols that are no names of Python."""
        a, b, c = Fraction(30), Fraction(120), Fraction(5)
        points = [(0, 0), (a, c), (2 * a, 0), (3 * a, c), (3 * a, b + c), (0, b + c)]
        crosses = [(p, q, p[0] * q[1] - q[0] * p[1]) for p, q in zip(points, points[1:] + points[:1])]
        x, y = (sum((p[k] + q[k]) * cross for p, q, cross in crosses) for k in (0, 1))
        derivation = topple.derive(topple.Scene.read(BLOCK), limit=True)
        tangent = derivation.governing("left").tan_critical_angle
        self.assertEqual(tangent(a=30, b=120, c=5), x / y)
        self.assertEqual(tangent({"a": a}, b=b, c=c), x / y)
        self.assertAlmostEqual(tangent(a=30.0, b=120.0, c=5.0), float(x / y), delta=1e-15)
        widths = numpy.linspace(10, 50, 5)
        self.assertEqual(list(tangent(a=widths, b=120, c=5)), [tangent(a=w, b=120, c=5) for w in widths])
        limit = derivation.limit[topple.Direction.LEFT]
        angle = limit.tan_critical_angle({"tan(phi)": math.tan(math.radians(30))}, a=30, b=120, c=5)
        self.assertAlmostEqual(math.degrees(math.atan(angle)), limit.critical_angle_deg.value, delta=1e-12)
        self.assertRaises(KeyError, tangent, a=1, b=2)
        latex = topple.derive(topple.Scene.read(BLOCK), notation="latex").governing("left").tan_critical_angle
        self.assertIn("\\frac", str(latex))
        self.assertRaises(ValueError, latex, a=30, b=120, c=5)

    def test_family(self):
        """One formula for every number of teeth, called for this one."""
        family = topple.derive_family(topple.Scene.read(BLOCK))
        self.assertEqual(json.loads(family.to_json()), json.loads(printed("derive", "--json", "--for-all=count", BLOCK)))
        self.assertEqual(family.report(), printed("derive", "--for-all=count", BLOCK))
        (odd,) = [f for f in family.formulas if f.towards is topple.Direction.LEFT and not f.even]
        self.assertEqual(odd.tan_critical_angle(a=30, b=120, c=5, N=3),
                         topple.derive(topple.Scene.read(BLOCK)).governing("left").tan_critical_angle(a=30, b=120, c=5))


class Claims(unittest.TestCase):
    def test_paper(self):
        own = topple.verify(CLAIMS)
        told = json.loads(printed("verify", "--json", CLAIMS))
        self.assertEqual(json.loads(own.to_json()), told)
        for claim, mine in zip(told["claims"], own.claims, strict=True):
            self.assertEqual((claim["id"], claim["where"], claim["verdict"], claim["mend"]),
                             (mine.id, mine.where, mine.verdict.value, mine.mend))
        self.assertEqual(sum(own.tally.values()), len(own.claims))
        self.assertEqual(own.tally[topple.Verdict.REFUTED], sum(c.verdict is topple.Verdict.REFUTED for c in own.claims))
        self.assertTrue(own.objects)
        self.assertEqual(own.report(), printed("verify", CLAIMS))
        text = topple.verify_text(CLAIMS.read_text(encoding="utf-8"), str(CLAIMS))
        self.assertEqual(text, own)
        self.assertEqual(text.markdown(), own.markdown())
        with self.assertRaisesRegex(topple.BadInput, "^claims:1"):
            topple.verify_text("nonsense: 1\n")


class Charts(unittest.TestCase):
    def test_tables(self):
        """Each kind with its options is the program's table."""
        for chart, options in (
                (topple.chart_fos(inverse_slenderness=[0.2, 0.4], amplitude=[0.1], tilt_deg=(1, 60)),
                 ("fos", "--inverse-slenderness=0.2,0.4", "--amplitude=0.1", "--tilt=1:60")),
                (topple.chart_mechanisms(friction_deg=35), ("mechanisms", "--friction=35")),
                (topple.chart_ranges(), ("ranges",))):
            self.assertEqual(json.loads(chart.to_json()), json.loads(printed("chart", *options, "--json")))
            self.assertEqual(chart.csv(), printed("chart", *options))
        self.assertRaises(topple.BadInput, topple.chart_fos, amplitude=[2])
        self.assertRaises(topple.BadInput, topple.chart_fos, amplitude=[0.1] * 7)

    def test_files(self):
        chart = topple.chart_ranges()
        with tempfile.TemporaryDirectory() as folder:
            chart.write(f"{folder}/own.csv")
            self.assertEqual(open(f"{folder}/own.csv", encoding="utf-8").read(), chart.csv())
        with self.assertRaisesRegex(topple.BadInput, r"\.svg, \.pdf, \.png or \.csv"):
            chart.write("own.txt")
        try:
            drawn = chart._repr_svg_()
        except topple.DependencyFailed as error:
            self.skipTest(str(error))  # no gnuplot
        self.assertEqual(xml.dom.minidom.parseString(drawn).documentElement.tagName, "svg")

    def test_map(self):
        scene = topple.Scene.read(ROOT / "examples" / "slab_left.yaml")
        own = topple.chart_map(scene, ("block.slab.width", 10, 150))
        options = ("chart", "map", ROOT / "examples" / "slab_left.yaml", "--x", "block.slab.width=10:150")
        self.assertEqual(json.loads(own.to_json()), json.loads(printed(*options, "--json")))
        built = topple.Scene("mm", slab=(50, 100), friction_angle_deg=30, tilt_towards="left")
        self.assertGreater(len(topple.chart_map(built, ("block.slab.width", 10, 150), ("tilt", 0, 60)).csv()), 1000)
        self.assertRaises(topple.BadInput, topple.chart_map, scene, ("nonsense", 10, 150))

    def test_tilt(self):
        """Charts of a tilt test and of a spectrum have the bytes that the program writes; a path has no phase portrait."""
        with tempfile.TemporaryDirectory() as folder:
            told = pathlib.Path(folder) / "told.csv"

            def program(*arguments):
                self.assertEqual(run("tilt", "--json", *arguments)[0], 0)
                return told.read_text(encoding="utf-8")

            block, boulder = (ROOT / "examples" / f"{name}.yaml" for name in ("tilt_block_e_valley", "shaken_boulder"))
            test = topple.tilt_test(topple.Scene.read(block))
            self.assertEqual(topple.chart_tilt_reactions(test).csv(), program("--reactions", told, block))
            self.assertEqual([(f.facet, f.contact) for f in test.cases[0].facets], [(1, 1), (2, 2), (3, 3)])
            self.assertRaises(topple.NoAnswer, topple.chart_tilt_phase, test)
            scene = topple.Scene.read(boulder)
            self.assertEqual(topple.chart_tilt_phase(topple.tilt_test(scene)).csv(), program("--phase", told, boulder))
            self.assertEqual(topple.chart_overturning(scene, (1, 1.5), count=2).csv(),
                             program("--spectrum", told, "--frequencies", "1:1.5:2", boulder))
            self.assertRaises(topple.BadInput, topple.chart_overturning, scene, (2, 1))


class Accuracy(unittest.TestCase):
    def test_runs(self):
        own = topple.accuracy_of_scene(topple.Scene.read(BLOCK))
        told, mine = json.loads(printed("accuracy", "--json", BLOCK)), json.loads(own.to_json())
        for key in ("method", "level", "bits", "vertices", "true_error"):
            self.assertEqual([run[key] for run in told["runs"]], [run[key] for run in mine["runs"]])
        for one, record in zip(mine["runs"], own.runs, strict=True):
            self.assertEqual((one["method"], one["level"], one["bound"]), (record.method.value, record.level.value,
                                                                           record.bound))
        self.assertEqual([v["angle_deg"]["value"] for v in mine["values"]], [v.angle_deg.value for v in own.values])
        self.assertEqual(len(own.sources), 1)
        self.assertIn("method", own.chart().csv())
        self.assertEqual({run.vertices for run in topple.accuracy_sweep(10, 100).runs}, {10, 100})


class Solids(unittest.TestCase):
    ROCK = ROOT / "examples" / "solids" / "balanced_rock.obj"

    def test_file(self):
        """What the program prints, and the same numbers in the records."""
        own = topple.solid_of_file(self.ROCK, length_unit="m", unit_weight_kn_m3=26, friction_angle_deg=32, bands=[0, 0.02], azimuths=8)
        words = ("--unit=m", "--unit-weight=26", "--friction=32", "--band=0,0.02", "--azimuths=8", self.ROCK)
        self.assertEqual(own.report(), printed("solid", *words))
        self.assertEqual(own.to_json(), printed("solid", "--json", *words))
        self.assertEqual(own.csv(), printed("solid", "--csv", *words))
        falls, stands = own.bands
        self.assertEqual((falls.stands, falls.least, falls.rose), (False, None, ()))
        self.assertEqual(stands.mechanism, topple.Mechanism.TOPPLES)
        told = json.loads(own.to_json())
        self.assertEqual(told["bands"][1]["least"]["edge_from"], list(stands.least.edge_from))
        self.assertEqual([p["share"]["value"] for p in told["poses"]], [p.share.value for p in own.poses])
        with self.assertWarns(topple.Caution):  # of the unit, which a mesh does not state
            topple.solid_of_file(self.ROCK)
        with self.assertRaisesRegex(topple.BadInput, "no object"):
            topple.solid_of_file(self.ROCK, length_unit="m", object="roof")
        with self.assertRaisesRegex(TypeError, "of a scene"):
            own.write_report("x.md")

    def test_sheet(self):
        """Of a scene, in Spanish; of one that has been changed since it was solved it is refused."""
        scene = topple.Scene.read(ROOT / "examples" / "solids" / "wedge.yaml")
        own = scene.solve_solid()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "sheet.md"
            own.write_report(path, letterhead={"language": "es"})
            self.assertIn("Factor de seguridad", path.read_text(encoding="utf-8"))
        self.assertEqual(own.wedge.sides[0].dip_deg, 45)


class Profiles(unittest.TestCase):
    JOINT = ROOT / "examples" / "joint_profile.csv"

    def test_file(self):
        """What the program prints, and the same numbers in the records."""
        own = topple.profile_of_file(self.JOINT, step=0.5, resampling="spline", detrend="line")
        words = ("profile", "--step", "0.5", "--resample", "spline", "--detrend", "line", self.JOINT)
        self.assertEqual(own.report(), printed(*words))
        self.assertEqual(own.to_json(), printed(*words[:1], "--json", *words[1:]))
        self.assertEqual(own.to_json(every=True), printed(*words[:1], "--json", "--all", *words[1:]))
        self.assertEqual(own.csv(), printed(*words[:1], "--csv", *words[1:]))
        told = json.loads(own.to_json())
        self.assertEqual(told["z2"], {"value": own.z2.value, "error": own.z2.error})
        self.assertEqual(told["sampling"]["detrend"], own.options["detrend"].value)
        self.assertEqual(told["correlation_length"]["value"], own.correlation_length.value)
        self.assertEqual([row["jrc"]["value"] for row in told["jrc"]["correlations"]], [row.jrc.value for row in own.correlations])
        self.assertEqual([row["state"] for row in told["jrc"]["correlations"]], [row.state.value for row in own.correlations])
        self.assertEqual([lag["structure"] for lag in told["lags"]], [lag.structure for lag in own.lags])
        self.assertEqual((len(own.x), len(own.y), len(own.sources)), (201, 201, 1))
        self.assertIn("slope rose", own.chart().csv())

    def test_points_and_scene(self):
        teeth = numpy.array([[0, 0], [30, 5], [60, 0], [90, 5]])
        own, base = topple.profile_of_points(teeth), topple.profile_of_scene(topple.Scene.read(BLOCK), jcs_mpa=120)
        for profile in (own, base):
            self.assertAlmostEqual(profile.z2.value, 1 / 6, delta=profile.z2.error)
            self.assertIs(profile.series, topple.ProfileSeries.SHORT)
            self.assertFalse(profile.correlation_length.found)
        self.assertIsNone(own.jrc_eq_10)
        self.assertAlmostEqual(base.jrc_eq_10.value, 2.0534, delta=0.001)
        self.assertRaises(topple.BadInput, topple.profile_of_points, teeth[::-1])
        self.assertRaises(topple.BadInput, topple.profile_of_points, teeth, "ell")


class Find(unittest.TestCase):
    def test_radius(self):
        """The radius of the worn corner, as the program finds it, and as a solve of the scene with it says."""
        path = ROOT / "examples" / "block_a_worn.yaml"
        scene, key = topple.Scene.read(path), "block.rounded.corners.1.radius"
        found = topple.find(scene, key, "critical_angle", 23.5)
        told = json.loads(printed("solve", "--json", "--find", key, "--for", "critical_angle=23.5", path))["find"]
        self.assertEqual([s["value"] for s in told["solutions"]], [s.value for s in found.solutions])
        self.assertEqual(json.loads(found.to_json(scene.solve()))["find"], told)
        self.assertIn(key, found.report())
        for radius in found.solutions:
            varied = scene.varied({key: radius.value})
            self.assertAlmostEqual(varied.solve(limit=False).cases[0].governing_pivot.critical_angle_deg.value, 23.5,
                                   delta=1e-9)
        self.assertEqual(topple.find(scene, key, topple.FindTarget.CRITICAL_ANGLE, 23.5, low=0, high=0.001).solutions, ())
        self.assertRaises(topple.BadInput, topple.find, scene, "nonsense", "fos", 1)
        self.assertRaises(ValueError, topple.find, scene, key, "nonsense", 1)

    def test_batch(self):
        """What the program prints of a survey; each row's scene is what it was solved of."""
        folder = ROOT / "examples" / "slope"
        own = topple.batch(folder / "survey.csv", scene=folder / "survey_block.yaml", threads=2)
        words = "solve", "--batch", folder / "survey.csv", "--template", folder / "survey_block.yaml"
        self.assertEqual(own.csv(), run(*words, "--csv")[1])
        self.assertEqual(own.to_json(), run(*words, "--json")[1])
        self.assertEqual(own.report(), run(*words)[1])
        self.assertIn("survey.csv", own.markdown())
        self.assertEqual(own.rows[-1].standing, topple.BatchStanding.HOLDS)
        self.assertEqual(sum(own.counts.values()), len(own.rows))
        for row in own.rows:
            fos = topple.Scene.from_text(row.scene, row.scene_name).solve().cases[0].governing_fos.fos
            self.assertEqual(fos.value.value, row.fos.value.value)
        with tempfile.TemporaryDirectory() as name:
            target = pathlib.Path(name)
            own.write(target / "table.csv")
            self.assertEqual((target / "table.csv").read_text(encoding="utf-8"), own.csv())
            own.write_page(target / "page.html", figures=1)
            self.assertEqual((target / "page.html").read_text(encoding="utf-8").count("<figure>"), 1)
            own.write_figures(target / "figures")
            self.assertEqual(len(list((target / "figures").glob("*.svg"))), len(own.rows))
        text = (folder / "survey.csv").read_text(encoding="utf-8")
        again = topple.batch_text(text, "survey.csv", scene=folder / "survey_block.yaml")
        self.assertEqual([row.fos for row in again.rows], [row.fos for row in own.rows])
        self.assertRaises(topple.BadInput, topple.batch, folder / "survey_block.yaml")

    def test_convergence(self):
        """What the program prints over the settings of a test, but for times; a chart of it; and with an account of accuracy."""
        path = ROOT / "examples" / "tilt_block_a_peak.yaml"
        own = topple.tilt_converge(topple.Scene.read(path))

        def timeless(text):
            return re.sub(r'"seconds": [^,}]*', "", text)

        self.assertEqual(timeless(own.to_json()), timeless(printed("tilt", "--converge", "--json", path)))
        self.assertTrue(own.cases[0].converged)
        self.assertEqual({finding.setting for finding in own.cases[0].settings},
                         {topple.ConvergeSetting.STIFFNESS, topple.ConvergeSetting.STIFFNESS_RATIO,
                          topple.ConvergeSetting.TOLERANCE})
        self.assertIn("Converged to the 0.01°", own.report())
        self.assertEqual(len(own.chart().csv().splitlines()), 1 + len(own.cases[0].levels))
        self.assertEqual(topple.accuracy_of_scene(topple.Scene.read(path)).simulated.cases[0].over_settings_least, own.cases[0].over_settings_least)
        with self.assertRaisesRegex(topple.BadInput, "calls for no simulation"):
            topple.tilt_converge(topple.Scene.read(BLOCK))

    def test_of_a_built_scene(self):
        """A slab topples at atan(width / height): the width for 20 degrees."""
        scene = topple.Scene("mm", slab=(50, 100), tilt_towards="left")
        (width,) = topple.find(scene, "block.slab.width", "critical_angle", 20, low=1, high=200).solutions
        self.assertAlmostEqual(width.value, 100 * math.tan(math.radians(20)), delta=1e-9)
        self.assertLessEqual(width.low, 100 * math.tan(math.radians(20)))

    def test_profile(self):
        """The profile of a base comes back with all its digits, and rests the block as it did."""
        scene = topple.Scene.read(ROOT / "examples" / "boulder_on_rough_ground.yaml")
        rows = [line.split(",") for line in scene.profile_csv().splitlines() if line and line[0] in "-.0123456789"]
        self.assertGreater(len(rows), 100)
        self.assertEqual([len(row) for row in rows], [2] * len(rows))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "profile.csv"
            scene.write_profile(path)
            self.assertEqual(path.read_text(encoding="utf-8"), scene.profile_csv())
        with self.assertRaises(topple.BadInput):
            topple.Scene("mm", slab=(1, 2)).profile_csv()

    def test_varied(self):
        """Other scenes with other numbers, exactly; the scene itself stays."""
        scene = topple.Scene.read(BLOCK)
        self.assertEqual(scene.number("friction_angle_deg"), 30)
        other = scene.varied({"a": "100/3", "friction_angle_deg": Fraction(61, 2)})
        self.assertEqual(other.number("a"), Fraction(100, 3))
        self.assertEqual(other.number("friction_angle_deg"), Fraction(61, 2))
        self.assertEqual(scene.number("a"), 30)
        built = topple.Scene("mm", outline=[(0, 0), (50, 0), (50, 100), (0, 100)])
        self.assertEqual(built.varied({"block.outline.3.1": 60}).number("block.outline.3.1"), 60)
        self.assertEqual(built.varied({}).solve(limit=False).block, built.solve(limit=False).block)
        self.assertRaises(topple.BadInput, scene.number, "nonsense")
        self.assertRaises(topple.BadInput, scene.varied, {"nonsense": 1})

    def test_settings(self):
        """Formulas in place of numbers, which the solution tells."""
        scene = topple.Scene.read(BLOCK)
        other = scene.with_settings("a=31", "b=2*a+1/3")
        self.assertEqual(other.number("b"), 62 + Fraction(1, 3))
        told = other.solve(limit=False).settings
        self.assertEqual([(own.key, own.formula, own.unit) for own in told], [("a", "31", "mm"), ("b", "2*a+1/3", "mm")])
        self.assertEqual(float(told[1].value), float(62 + Fraction(1, 3)))
        self.assertEqual(scene.solve(limit=False).settings, ())
        self.assertRaises(topple.BadInput, scene.with_settings, "a")

    def test_sweep(self):
        """Columns in the order of the points; each is what the scene says there."""
        scene = topple.Scene.read(BLOCK)
        own = topple.sweep(scene, "friction_angle_deg=20:95:25", "c=2.5,5", threads=2)
        self.assertEqual(len(own), 8)
        self.assertEqual(list(own.numbers), ["friction_angle_deg", "c_mm"])
        self.assertEqual(own.numbers["c_mm"].tolist(), [2.5] * 4 + [5] * 4)
        for k in range(8):
            angle, depth = own.numbers["friction_angle_deg"][k], own.numbers["c_mm"][k]
            if angle == 95:
                self.assertEqual(own.columns["status"][k], "the input is wrong")
                self.assertTrue(own.columns["moments_deg"][k] != own.columns["moments_deg"][k])
                continue
            case = scene.varied({"friction_angle_deg": angle, "c": depth}).solve().cases[0]
            self.assertEqual(own.columns["moments_deg"][k], float(case.pivots[case.toppling_pivot].critical_angle_deg))
            self.assertEqual(own.columns["first"][k], case.first.value)
        self.assertRaises(topple.BadInput, topple.sweep, scene, "c=1:2")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "sweep.json"
            topple.write_sweep(scene, path, "c=1,2")
            self.assertEqual(len(json.loads(path.read_text(encoding="utf-8"))["points"]), 2)


class Study(unittest.TestCase):
    def check_columns(self, path):
        """Every column is that of the rows, also where these are read back."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "rows.csv"
            for _ in range(2):
                result = topple.study(path, rows=file)
                with open(file, encoding="utf-8", newline="") as text:
                    rows = list(csv.DictReader(text))
                self.assertLess({"fos", "fos_moments", "fos_sliding", "fos_definition"}, set(result.columns))
                for name, values in result.columns.items():
                    if values.dtype == object:
                        self.assertEqual([own.value if own else "" for own in values], [row[name] for row in rows], name)
                    else:
                        own = [float(row[name] or "nan") for row in rows]
                        self.assertTrue(numpy.array_equal(values, own, equal_nan=True), name)

    def test_many_blocks(self):
        """Of columns in a row the quantities of many blocks, which stand in the rows by the same names."""
        with tempfile.TemporaryDirectory() as folder:
            study = pathlib.Path(folder) / "study.yaml"
            slope = (ROOT / "examples" / "blocks" / "toppling_slope.yaml").read_text(encoding="utf-8")
            (pathlib.Path(folder) / "slope.yaml").write_text(slope + "required_fos: 1\n", encoding="utf-8")
            study.write_text("topple_study: 1\nscene: slope.yaml\nvary: {friction_angle_deg: {list: [32, 37, 39]}}\n", encoding="utf-8")
            result = topple.study(study, rows=pathlib.Path(folder) / "rows.csv")
            with open(pathlib.Path(folder) / "rows.csv", encoding="utf-8", newline="") as text:
                rows = list(csv.DictReader(text))
            for name in ("fos", "fos_goodman_bray", "limit_deg", "critical_acceleration_g", "friction_angle_deg"):
                self.assertEqual(list(result.columns[name]), [float(row[name]) for row in rows])
            self.assertEqual([own.value for own in result.columns["outcome"]], ["slides and topples", "may move", "may move"])
            self.assertEqual((result.of_many_blocks, result.below_required.samples), (True, 3))  # a motion can begin with all of it

    def test_result(self):
        """The summary and the rows that the program writes; columns as NumPy has them."""
        path = ROOT / "examples" / "studies" / "slab_study.yaml"
        result = topple.study(path)
        self.assertEqual(result.report(), printed("study", path))
        self.assertEqual(result.to_json(), printed("study", "--json", path))
        self.assertEqual((result.samples, result.end), (200, topple.StudyEnd.COMPLETE))
        phi, outcome = result.columns["friction_angle_deg"], result.columns["outcome_at_30_deg"]
        self.assertEqual(phi.shape, (200,))
        self.assertTrue(((phi < 30) == (outcome == topple.StudyOutcome.SLIDES)).all())
        self.assertEqual(result.tilts[2]["slides"].samples, int((phi < 30).sum()))
        self.assertAlmostEqual(result.spread("limit_deg").quantiles[3].value, 30, delta=0.1)
        self.assertTrue(numpy.array_equal(pickle.loads(pickle.dumps(result)).columns["limit_deg"], result.columns["limit_deg"]))
        self.assertRaises(topple.BadInput, topple.study, BLOCK)
        text = path.read_text(encoding="utf-8")
        self.assertEqual(topple.study_text(text, path).report(), result.report())
        with tempfile.TemporaryDirectory() as folder:  # the same study: its rows are taken as they are
            rows = pathlib.Path(folder) / "rows.csv"
            topple.study(path, rows=rows)
            self.assertEqual(topple.study_text(text, path, rows=rows).report(), result.report())
        with self.assertRaisesRegex(topple.BadInput, "^here/study:1:1: this is not a study"):
            topple.study_text("scene: slab.yaml", "here/study")
        self.check_columns(path)
        with tempfile.TemporaryDirectory() as folder:
            parts = [pathlib.Path(folder) / f"{k}.csv" for k in (1, 2)]
            for k, part in enumerate(parts, 1):
                self.assertEqual(topple.study(path, rows=part, shard=(k, 2)).end, topple.StudyEnd.SHARD)
            rows = pathlib.Path(folder) / "rows.csv"
            self.assertEqual(topple.study(path, rows=rows, merge=parts).report(), result.report())
            self.assertEqual(len(rows.read_text(encoding="utf-8").splitlines()), 201)
            self.assertEqual(topple.study(path, rows=rows).report(), result.report())


if __name__ == "__main__":
    main()
