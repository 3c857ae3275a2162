# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Load cases and partial factors (docs/cases.md), against hand sums that share no code with Topple.

A slab of the length L and the thickness t lies on a plane that dips α, with water to the height h along its upper face and below
it. Per metre W = γ L t, V = γ_w h² cos α / 2 along the plane at h/3, U = γ_w h L cos α / 2 normal to it at 2L/3 from the toe, so

    sliding:  FoS = (c L + (W cos α − U) tan φ) / (W sin α + V)
    toppling: FoS = W cos α L/2 / (W sin α t/2 + V h/3 + U 2L/3)
    driving loads, sliding: FoS = (c L + W cos α tan φ) / (W sin α + V + U tan φ)

The last multiplies all that drives, uplift included; it is the lesser one where the block holds, and governs.

The design values follow from these with the values of EN 1997-1:2004, Annex A, typed here again from Tables A.1 to A.5; the worked
sums are our own, no published example."""

import csv
import io
import itertools
import json
import math

from governing_case import GoverningCase
from harness import ROOT, main, run
from report_case import Page

L, T, ALPHA, PHI, C, GAMMA, H = 6, 3, 30, 38, 20, 26, 1.5
EXAMPLE = ROOT / "examples" / "slope" / "design_cases.yaml"
WATER = f"loads: {{water: {{height: {H}, uplift: true}}}}"


def slab(cases, towards="left", more="", unit="m", per_metre=1, water=""):
    return (f"topple: 1\nlength_unit: {unit}\nblock: {{slab: {{width: {L * per_metre}, height: {T * per_metre}}}, thickness: {per_metre}, "
            f"unit_weight_kn_m3: {GAMMA}}}\nfriction_angle_deg: {PHI}\ntilt: {{towards: {towards}, angle_deg: {ALPHA}}}\n"
            f"loads: {{cohesion_kpa: {C}{water}}}\n{more}" + (f"cases:\n{cases}" if cases else ""))


def sums(weight=1, water=1, tangent=1, cohesion=1, shaken=0.0, wet=True):
    """The three factors with the weight and the water times, and tan φ and c over, a factor; k_h of an earthquake towards down-dip."""
    sine, cosine = math.sin(math.radians(ALPHA)), math.cos(math.radians(ALPHA))
    w = GAMMA * L * T
    v = water * 9.81 * H * H * cosine / 2 * wet
    u = water * 9.81 * H * L * cosine / 2 * wet
    e = shaken * w
    w *= weight
    sliding = (C * L / cohesion + (w * cosine - u - e * sine) * math.tan(math.radians(PHI)) / tangent) / (w * sine + v + e * cosine)
    toppling = w * cosine * L / 2 / (w * sine * T / 2 + v * H / 3 + u * 2 * L / 3)
    friction = math.tan(math.radians(PHI)) / tangent
    driving = (C * L / cohesion + w * cosine * friction) / (w * sine + v + e * cosine + (u + e * sine) * friction)
    return sliding, toppling, driving


def case(name, *more):
    return f"  - name: {name}\n" + "".join(f"    {line}\n" for line in more)


def numbers(own):
    """All of a direction but its times and places."""
    if isinstance(own, dict):
        return {key: numbers(value) for key, value in own.items() if key not in ("seconds", "called_for_by", "effects", "place")}
    return [numbers(item) for item in own] if isinstance(own, list) else own


class Cases(GoverningCase):
    def json(self, text, *options, status=0):
        done, out, err = run("solve", "--json", *options, self.scene(text))
        self.assertEqual(done, status, err)
        return json.loads(out)

    def factors(self, text, status=0):
        return {own["name"]: own for own in self.json(text, status=status)["load_cases"]}

    def close(self, told, truth):
        self.assertLessEqual(abs(told["value"] - truth), told["error"] + 1e-13 * truth)

    def test_design_approaches(self):
        """Each approach by hand: DA1-1 and DA2 over the combinations of favourable and unfavourable weight and water, of which the
        least counts; DA1-2 and DA3 with tan φ and c over 1.25; EQU by moments, 0.9 of what holds against 1.1 of what drives."""
        names = ("DA1-1", "DA1-2", "DA2", "DA3", "EQU")
        own = self.factors(slab("".join(case(name, f"partial_factors: {name}", WATER) for name in names)))
        least = min(sums(*pair)[2] for pair in itertools.product((1, 1.35), repeat=2))
        weak = sums(tangent=1.25, cohesion=1.25)[2]
        self.assertLess(least, sums()[2])
        for name, factor, required in (("DA1-1", least, 1), ("DA1-2", weak, 1), ("DA2", least, 1.1), ("DA3", weak, 1),
                                       ("EQU", sums()[1], 1.1 / 0.9)):
            self.close(own[name]["fos"], factor)
            self.assertAlmostEqual(own[name]["required_fos"]["value"], required, 14)
            self.close(own[name]["design_utilisation"], required / factor)
            self.assertEqual(own[name]["meets_required"], "met")
        self.assertEqual(own["EQU"]["against"], "topples")
        pairs = {words: sums(*pair)[2] for words, pair in (
            ("weight unfavourable, water unfavourable", (1.35, 1.35)), ("weight favourable, water unfavourable", (1, 1.35)),
            ("weight unfavourable, water favourable", (1.35, 1)), ("weight favourable, water favourable", (1, 1)))}
        self.assertIn(f"; the worst of 4 combinations: {min(pairs, key=pairs.get)}", own["DA1-1"]["partial_factors"])
        self.assertIn("weight × 1.35, water × 1.35", own["DA1-1"]["partial_factors"])
        self.assertNotIn("worst", own["DA1-2"]["partial_factors"])

    def test_where_the_weight_is_better_light(self):
        """Without water more weight lowers the factor of a slab that cohesion holds; with an earthquake, whose force is k W of the
        weight as it is, the weight that is lighter. Both ways the worse one is taken, whichever it is."""
        own = self.factors(slab(case("dry", "partial_factors: {permanent_unfavourable: 1.35, permanent_favourable: 0.9}") +
                                case("shaken", "partial_factors: {permanent_unfavourable: 1.35, permanent_favourable: 0.9, earthquake: 1.2}",
                                     "loads: {seismic: {horizontal: 0.15}}")))
        self.close(own["dry"]["fos"], min(sums(w, wet=False)[0] for w in (1.35, 0.9)))
        worse = "weight unfavourable" if sums(1.35, wet=False)[0] < sums(0.9, wet=False)[0] else "weight favourable"
        self.assertIn(f"; the worst of 2 combinations: {worse}", own["dry"]["partial_factors"])
        self.close(own["shaken"]["fos"], min(sums(w, shaken=0.18, wet=False)[2] for w in (1.35, 0.9)))

    def test_published_example(self):
        """Example 9.2 of Bond and Harris, Decoding Eurocode 7, section 9.8.2, as printed there per m² of the rock's surface: in the
        accidental situation u = 46.2 kPa, σ'_n = 48 kPa, τ = 23.5 kPa and a resistance of 24.4 kPa, and by the factors of material
        before it 22.9 kPa. The sums of H, β, γ, c and φ are made again here."""
        _, out, _ = run("solve", "--json", ROOT / "examples" / "slope" / "eurocode_slope.yaml")
        own = {case["name"]: case for case in json.loads(out)["load_cases"]}
        cosine, sine, area = 4 / math.sqrt(17), 1 / math.sqrt(17), 10e3 * math.sqrt(17)
        for name, height, factor, printed in (("accidental", 5, 1, 24.4), ("DA1-2", 4, 1.25, 22.9)):
            told = own[name]["cases"][0]["sliding"]
            pore = 9.81 * height * cosine**2
            normal = 20 * 5 * cosine**2 - pore
            resistance = (2 + normal * math.tan(math.radians(25))) / factor
            self.assertAlmostEqual(told["normal_n"]["value"] / area, normal, 9)
            self.assertAlmostEqual(told["driving_n"]["value"] / area, 100 * sine * cosine, 9)
            shear = next(f["fos"] for f in own[name]["cases"][0]["factors"] if f["definition"] == "shear strength")
            self.close(shear, resistance / (100 * sine * cosine))
            self.assertEqual(round(told["driving_n"]["value"] / area, 1), 23.5)
            self.assertEqual(round(shear["value"] * told["driving_n"]["value"] / area, 1), printed)
            # what governs multiplies the pore pressure, too
            friction = math.tan(math.radians(25)) / factor
            driving = (2 / factor + 100 * cosine**2 * friction) / (100 * sine * cosine + pore * friction)
            self.close(own[name]["fos"], min(driving, resistance / (100 * sine * cosine)))
            if name == "accidental":
                self.assertEqual((round(pore, 1), round(normal, 1)), (46.2, 48.0))
        self.assertEqual([case["meets_required"] for case in own.values()], ["not met", "met"])

    def test_sheet(self):
        """The first page has a row a case, the one that governs first, with the numbers of JSON; of many cases the first twelve, and
        all in the appendix. A sheet of a case with partial factors is drawn of the factored scene."""
        path = self.folder / "r.html"
        many = [case(f"case {k}", f"required_fos: {1 + k / 100}") for k in range(15)]
        for text in (EXAMPLE.read_text(encoding="utf-8"), slab("".join(many))):
            scene = self.scene(text)
            status, out, err = run("solve", "--json", "--report", path, scene)
            self.assertEqual((status, err), (0, ""))
            told = json.loads(out)["load_cases"]
            page = Page(path.read_text(encoding="utf-8"))
            rows = page.tables("Load cases, the one that governs first")[0]
            self.assertEqual(rows[0], ["Case", "FoS", "Against", "Required", "Utilisation", "Requirement", "Block"])
            self.assertEqual(len(rows) - 1, min(12, len(told)))
            for own, row in zip(told, rows[1:]):
                self.assertEqual(row[0], own["name"])
                self.assertAlmostEqual(float(row[1]), own["fos"]["value"], delta=1.01e-3)  # rounded down
                self.assertAlmostEqual(float(row[3]), own["required_fos"]["value"], delta=5.1e-5)
                self.assertAlmostEqual(float(row[4]), own["design_utilisation"]["value"], delta=1.01e-3)  # rounded up
                self.assertEqual((row[5], row[6]), (own["meets_required"], own["mechanism"]))
            appendix = page.tables("All load cases")
            self.assertEqual([len(table) - 1 for table in appendix], [15] if len(told) == 15 else [])
        for name in ("DA1-2", "EQU"):
            status, _, err = run("solve", "--case", name, "--report", path, EXAMPLE)
            self.assertEqual((status, err), (0, ""))
            facts = Page(path.read_text(encoding="utf-8")).facts("Inputs")
            self.assertEqual(facts["Load case"], name)
            self.assertIn("tan φ / 1.25", facts["Partial factors"])
            self.assertEqual(facts["Loads"], "water 1.5 m high behind the block, triangular uplift; cohesion 20 kPa")

    def test_tangent_exactly(self):
        """The slab alone slides at atan(tan φ / 1.25), by the formula and by contact forces."""
        text = slab(None, more="partial_factors: {friction: 1.25}\n").replace(f"loads: {{cohesion_kpa: {C}}}\n", "")
        own = self.json(text)["cases"][0]
        angle = math.degrees(math.atan(math.tan(math.radians(PHI)) / 1.25))
        for told in (own["limit"], own["onset"], own["sliding"]):
            self.close(told["critical_angle_deg"], angle)
        self.close(own["governing_fos"]["fos"], math.tan(math.radians(angle)) / math.tan(math.radians(ALPHA)))

    def test_surcharge_and_anchors(self):
        """A surcharge q is left out where it helps, × 1.5 where not; an active anchor keeps its pull, a passive one has it over
        1.1: sliding by hand."""
        sine, cosine, tangent = math.sin(math.radians(ALPHA)), math.cos(math.radians(ALPHA)), math.tan(math.radians(PHI))
        for passive in (False, True):
            anchor = f"anchors: [{{at: [3, 3], direction_deg: -90, force_kn: 110, passive: {str(passive).lower()}}}]"
            load = f", surcharges: [{{from: [0, 3], to: [6, 3], kpa: 10}}], {anchor}"
            text = slab(None, more="partial_factors: DA1-1\n", water=load)
            own = self.json(text)["cases"][0]["governing_fos"]
            truth = min((C * L + ((w * GAMMA * L * T + q * 60) * cosine + 110 / (1.1 if passive else 1)) * tangent) /
                        ((w * GAMMA * L * T + q * 60) * sine) for w in (1, 1.35) for q in (0, 1.5))
            self.close(own["fos"], truth)

    def test_resistance_factor(self):
        """LRFD: the factor must reach 1/0.75 or 1/0.65; exit status 1 where it does not."""
        for name, share in (("LRFD-slope", 0.75), ("LRFD-slope-limited", 0.65)):
            own = self.factors(slab(case("a", f"partial_factors: {name}", WATER)))["a"]
            self.close(own["required_fos"], 1 / share)
            self.close(own["design_utilisation"], 1 / share / sums()[2])
        self.assertEqual(run("solve", self.scene(slab(case("a", "partial_factors: {resistance: 1.7}", WATER))))[0], 1)

    def test_as_scenes_of_their_own(self):
        """A case has the numbers of a scene that says all of it at once, in JSON of all cases and chosen by --case; in C and
        Python the same scene."""
        cases = [("static", 1.5, ""), ("wet", 1.3, f", water: {{height: {H}, uplift: true}}"), ("shaken", 1.1, ", seismic: {horizontal: 0.1}")]
        text = slab("".join(case(name, f"required_fos: {fos}", f"loads: {{{load[2:]}}}" if load else "set: {friction_angle_deg: 38}")
                            for name, fos, load in cases))
        own = self.factors(text)
        for name, fos, load in cases:
            alone = self.json(slab(None, more=f"required_fos: {fos}\n", water=load))
            self.assertEqual(numbers(own[name]["cases"]), numbers(alone["cases"]))
            chosen = self.json(text, "--case", name)
            self.assertEqual(numbers(chosen["cases"]), numbers(alone["cases"]))
            self.assertEqual(chosen["load_case"], name)

    def test_order_mirror_and_units(self):
        """The order of the cases, the side and the unit change nothing; the one that governs comes first."""
        parts = [case("wet", "required_fos: 1.3", WATER), case("static", "required_fos: 1.5"), case("DA2", "partial_factors: DA2", WATER)]
        first = self.json(slab("".join(parts)))
        names = [own["name"] for own in first["load_cases"]]
        shares = [own["design_utilisation"]["value"] for own in first["load_cases"]]
        self.assertEqual(shares, sorted(shares, reverse=True))
        self.assertEqual(numbers(first["cases"]), numbers(first["load_cases"][0]["cases"]))
        for order in itertools.permutations(parts):
            self.assertEqual(numbers(self.json(slab("".join(order)))), numbers(first))
        for other in (slab("".join(parts), "right"), slab("".join(parts).replace("height: 1.5", "height: 1500"), unit="mm", per_metre=1000)):
            own = self.json(other)
            self.assertEqual([one["name"] for one in own["load_cases"]], names)
            for one, two in zip(own["load_cases"], first["load_cases"]):
                self.assertLessEqual(abs(one["fos"]["value"] - two["fos"]["value"]), one["fos"]["error"] + two["fos"]["error"])

    def test_not_met(self):
        """One case short of its factor: exit status 1, its name on stderr, in the table, in a row of CSV."""
        scene = self.scene(slab(case("good", "required_fos: 1.5") + case("bad", "required_fos: 1.8", WATER)))
        status, out, err = run("solve", scene)
        self.assertEqual(status, 1)
        self.assertIn("case bad", err)
        self.assertNotIn("case good", err)
        self.assertRegex(out, r"(?s)^Load cases.*\n  bad .*NOT MET.*\n  good .* met .*, case bad|case bad")
        status, out, _ = run("solve", "--csv", scene)
        rows = list(csv.DictReader(io.StringIO(out)))
        self.assertEqual((status, [row["scene"] for row in rows]), (1, ["case bad", "case good"]))
        self.assertEqual([row["meets_required"] for row in rows], ["not met", "met"])
        self.assertEqual([float(row["required_fos"]) for row in rows], [1.8, 1.5])
        self.assertEqual(run("solve", "--case", "good", scene)[0], 0)
        self.assertIn("case bad", run("solve", "--table", scene)[1])

    def test_set_holds_in_every_case(self):
        """--set is stronger than a case; a key that one of them alone has is asked of that one."""
        text = slab(case("static") + case("wet", WATER))
        own = {one["name"]: one for one in self.json(text, "--set", "loads.cohesion_kpa=0")["load_cases"]}
        for name, wet in (("static", False), ("wet", True)):
            self.close(own[name]["fos"], sums(cohesion=math.inf, wet=wet)[2])
        scene = self.scene(text)
        self.assertEqual(run("solve", "--set", "loads.water.height=2", "--case", "wet", scene)[0], 0)
        status, _, err = run("solve", "--set", "loads.water.height=2", scene)
        self.assertEqual(status, 3)
        self.assertIn("case 'static'", err)

    def test_one_case_elsewhere(self):
        """What is of one case says so, and never takes the base: sweeps, simulations, formulas, studies."""
        scene = self.scene(slab(case("static") + case("wet", WATER) + case("DA1-2", "partial_factors: DA1-2", WATER)))
        x = ("--x=friction_angle_deg=38:39:1",)
        shaken = self.scene(slab(case("static") + case("wet", WATER)) + "tilt_test: {engine: path}\n", "shaken.yaml")
        self.assertRegex(run("tilt", shaken)[2], r"--case NAME")
        plain = self.scene("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\nfriction_angle_deg: 30\ncases:\n- {name: a}\n",
                           "plain.yaml")
        self.assertRegex(run("derive", plain)[2], r"--case NAME")
        for command in (("sweep", *x), ("solve", "--find", "friction_angle_deg", "--for", "governing_fos=1.2")):
            status, _, err = run(*command, scene)
            self.assertEqual(status, 3, command)
            self.assertRegex(err, r"--case NAME", command)
        study = self.folder / "study.yaml"
        head = f"topple_study: 1\nscene: {scene.name}\nsamples: 4\nvary: {{friction_angle_deg: {{uniform: {{low: 38, high: 38.000001}}}}}}\n"
        study.write_text(head, encoding="utf-8")
        status, _, err = run("study", study)
        self.assertEqual(status, 3)
        self.assertRegex(err, "'case: NAME' in a study.*they are static, wet, DA1-2")
        study.write_text(head + "case: dry\n", encoding="utf-8")
        self.assertRegex(run("study", study)[2], "no case 'dry'; its cases are static, wet, DA1-2")
        for name, truth in (("static", sums(wet=False)[0]), ("wet", sums()[2]), ("DA1-2", sums(tangent=1.25, cohesion=1.25)[2])):
            status, out, err = run("sweep", "--case", name, *x, scene)
            self.assertEqual(status, 0, err)
            self.assertAlmostEqual(float(next(csv.DictReader(io.StringIO(out)))["fos"]), truth, 12)
            study.write_text(head + f"case: {name}\n", encoding="utf-8")
            rows = self.folder / f"{name}.csv"
            status, out, err = run("study", "--rows", rows, study)
            self.assertEqual(status, 0, err)
            for row in csv.DictReader(line for line in rows.read_text(encoding="utf-8").splitlines() if not line.startswith("#")):
                self.assertAlmostEqual(float(row["fos"]), truth, 6)

    def test_refused(self):
        """Each complaint says where it is and what to do."""
        for cases, where, words in (
                (case("a") + case("a"), r":9:11", "two cases are named 'a'.*a name of its own"),
                (case("a", "set: {friction_angel_deg: 3}"), r":9:11", "does not have.*did you mean 'friction_angle_deg'"),
                (case("a", "set: {block.slab.width: 3}"), r":8:11", "changes the outline.*second scene"),
                (case("a", "block: {slab: {width: 3, height: 3}}"), r":9:12", "cases are of one block"),
                (case("a", "partial_factors: DA1-3"), r":9:22", "no set of partial factors 'DA1-3'; did you mean 'DA1-"),
                (case("a", "partial_factors: {friction: 0.8}"), r":9:33", "'friction' must be 1 or more"),
                (case("a", "partial_factors: {permanent_favourable: 1.2}"), r":9:45", "between 0 and 1"),
                (case("a", "partial_factors: DA2", "required_fos: 2"), r":10:19", "not both"),
                ("  - {required_fos: 2}\n", r":8:5", "name"),
                (case("a", "lods: {}"), r":9:5", "did you mean 'loads'"),
                ("  {}\n", r":8:3", "cases are a list")):
            status, out, err = run("solve", self.scene(slab(cases)))
            self.assertEqual((status, out), (3, ""), err)
            self.assertRegex(err, words)
            self.assertRegex(err, where)
        free = slab(case("a", "partial_factors: {friction: 1.25}")).replace(f"friction_angle_deg: {PHI}\n", "")
        status, _, err = run("solve", self.scene(free))
        self.assertEqual(status, 3)
        self.assertRegex(err, r":8:\d+: .*give friction_angle_deg")
        self.assertRegex(run("solve", "--case", "b", self.scene(slab(case("a"))))[2], "no case 'b'; its cases are a")

    def test_values_of_the_sets(self):
        """The table against Annex A, typed here again: A.3 A1 1.35, 1.0, 1.5, 0 and A2 1.0, 1.0, 1.3, 0; A.4 M2 1.25; A.5 and A.14
        R2 1.1; A.1 1.1, 0.9, 1.5, 0; A.12 1.1, R3 1.0. Every value has a source."""
        lines = (ROOT / "src/core/terms/partial_factors.csv").read_text(encoding="utf-8").splitlines()
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        own = {(row["set"], row["on"]): float(row["value"]) for row in rows}
        self.assertTrue(all(row["source"] for row in rows))
        self.assertEqual(len(own), len(rows))
        actions = ("permanent_unfavourable", "permanent_favourable", "variable_unfavourable", "variable_favourable")
        for name, values, material, resistance, anchor in (
                ("DA1-1", (1.35, 1, 1.5, 0), 1, 1, 1.1), ("DA1-2", (1, 1, 1.3, 0), 1.25, 1, 1.1), ("DA2", (1.35, 1, 1.5, 0), 1, 1.1, 1.1),
                ("DA3", (1, 1, 1.3, 0), 1.25, 1, 1), ("EQU", (1.1, 0.9, 1.5, 0), 1.25, 1, 1.1)):
            self.assertEqual(tuple(own[name, action] for action in actions), values)
            self.assertEqual((own[name, "water_unfavourable"], own[name, "water_favourable"]), values[:2])
            self.assertEqual((own[name, "friction"], own[name, "cohesion"], own[name, "resistance"], own[name, "anchor"]),
                             (material, material, resistance, anchor))

    def test_figure_and_sheet(self):
        """Figure and sheet are of the case that governs, and name it."""
        figure, sheet = self.folder / "a.svg", self.folder / "a.md"
        status, out, err = run("solve", "--figure", figure, "--report", sheet, EXAMPLE)
        self.assertEqual(status, 0, err)
        self.assertIn("case wet", sheet.read_text(encoding="utf-8"))
        self.assertTrue(figure.stat().st_size > 1000)
        self.assertIn("Slab over the access road, case wet", out)

    def test_of_many_blocks(self):
        """Each case of a slope of columns is the scene that says the same, in one table or by itself; what is of one case asks for it."""
        scene = ("topple: 1\ntitle: Columns\nlength_unit: m\nslope: {dip_deg: 20, towards: left}\nblock: {unit_weight_kn_m3: 25}\n"
                 "columns: {width: 3, step: 1, rise: 3, fall: 2, below_crest: 2, above_crest: 1}\nfriction_angle_deg: ")
        loads = ("", "loads: {water: {level: 4, faces: behind, uplift: full}}", "loads: {seismic: {horizontal: 0.08}}")
        cases = "".join(case(name, *([load] if load else [])) for name, load in zip(("static", "wet", "shaken"), loads)) \
            + case("weak", "set: {friction_angle_deg: 30}", "required_fos: 9")
        path = self.scene(scene + "35\nrequired_fos: 0.5\ncases:\n" + cases)
        self.assertEqual(run("solve", "--json", path)[0], 3)
        self.assertIn("static, wet, shaken, weak", run("sweep", path, "--x", "friction_angle_deg=30:36:3")[2])
        self.assertEqual(run("solve", "--case", "wet", path)[1].splitlines()[0], "Columns, case wet")
        status, out, err = run("solve", "--csv", path)
        self.assertEqual(status, 1)
        self.assertIn("weak: the required factor of safety 9 is not met", err)
        rows = {}
        for row in csv.DictReader(io.StringIO(out)):
            rows.setdefault(row["scene"], []).append(row)
        self.assertEqual(list(rows), [f"Columns, case {name}" for name in ("static", "wet", "shaken", "weak")])
        for name, load in zip(("static", "wet", "shaken"), loads):
            alone = list(csv.DictReader(io.StringIO(run("solve", "--csv", self.scene(f"{scene}35\nrequired_fos: 0.5\n{load}\n"))[1])))
            self.assertEqual([row["fos"] for row in rows[f"Columns, case {name}"]], [row["fos"] for row in alone])
        equilibrium = self.scene(scene + "35\ncases:\n" + case("design", "partial_factors: EQU"))
        self.assertIn("EQU compares moments about the pivots of one block", run("solve", equilibrium)[2])

    #: A column beside a low block, with every load that a factor is of.
    MANY = """topple: 1
length_unit: m
block: {{unit_weight_kn_m3: {weight}}}
blocks:
  - {{name: ground, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}}
  - {{name: low, slab: {{width: 2, height: 1}}, unit_weight_kn_m3: {low}}}
  - {{name: column, slab: {{width: 1, height: 4}}, at: [2, 0]}}
friction_angle_deg: {friction}
joints: [{{between: [low, column], friction_angle_deg: {side}, cohesion_kpa: {cohesion}, tension_kpa: {tension}}}]
tilt: {{towards: left, angle_deg: 5}}
loads:
  cohesion_kpa: {base}
  seismic: {{horizontal: {seismic}}}
  water: {{level: 1, unit_weight_kn_m3: {water}, faces: behind, uplift: full}}
  surcharges: [{{from: [3, 4], to: [2, 4], kpa: {surcharge}}}]
  forces: [{{block: column, at: [3, 3], direction_deg: 180, force_kn: {force}}}]
  anchors: [{{at: [2, 3], to: [8, -0.5], force_kn: {active}}},
            {{at: [0, 0.5], dip_deg: 20, into: ground, force_kn: {passive}, passive: true}}]
{more}
"""
    GIVEN = {"weight": 25, "low": 22, "friction": 35, "side": 20, "cohesion": 7, "tension": 3.5, "base": 1.4, "seismic": 0.2,
             "water": 10, "surcharge": 8, "force": 4, "active": 10, "passive": 11}

    def test_factors_of_many_blocks(self):
        """The scene with partial factors is the worst of those whose numbers are multiplied here, one for each combination: the factor
        of the earthquake is on the weight without its own, and tan(phi) is divided, not phi."""
        factors = ("{permanent_unfavourable: 1.35, permanent_favourable: 0.9, variable_unfavourable: 1.5, variable_favourable: 0, "
                   "water_unfavourable: 1.2, water_favourable: 1, earthquake: 1.1, friction: 1.25, cohesion: 1.4, anchor: 1.1, "
                   "resistance: 1.02}")
        path = self.scene(self.MANY.format(**self.GIVEN, more=f"partial_factors: {factors}"))
        status, out, err = run("solve", "--json", path)
        self.assertEqual(status, 1, err)
        own, given = json.loads(out), self.GIVEN
        self.assertIn("with partial factors own: weight × 0.9, water × 1.2, forces × 1.35,", run("solve", path)[1])

        def divided(degrees):
            return math.degrees(math.atan(math.tan(math.radians(degrees)) / 1.25))

        alone = []
        for weight, water, force, surcharge in itertools.product((1.35, 0.9), (1.2, 1), (1.35, 0.9), (1.5, 0)):
            scaled = {"weight": given["weight"] * weight, "low": given["low"] * weight, "friction": divided(given["friction"]),
                      "side": divided(given["side"]), "cohesion": 5, "tension": 2.5, "base": 1, "seismic": given["seismic"] * 1.1 / weight,
                      "water": given["water"] * water, "surcharge": given["surcharge"] * surcharge, "force": given["force"] * force,
                      "active": given["active"] * 0.9, "passive": 10}
            text = self.MANY.format(**scaled, more="required_fos: 1.02")
            alone.append(json.loads(run("solve", "--json", self.scene(text))[1]))
        worst = min(alone, key=lambda system: system["cases"][0]["fos"]["value"])
        for key in ("fos", "critical_angle_deg"):
            self.assertAlmostEqual(own["cases"][0][key]["value"], worst["cases"][0][key]["value"], delta=3e-6, msg=key)
        self.assertEqual(own["cases"][0]["verdict"], worst["cases"][0]["verdict"])
        self.assertEqual([one["cases"][0]["meets_required"] for one in (own, worst)], ["not met"] * 2)
        for one, other in zip(own["contacts"], worst["contacts"]):
            for key in ("friction_angle_deg", "cohesion_kpa", "tension_kpa"):
                self.assertAlmostEqual(one[key]["value"], other[key]["value"], delta=1e-12)
        for one, other in zip(own["blocks"][1:], worst["blocks"][1:]):
            self.assertAlmostEqual(one["weight_n_m"]["value"], other["weight_n_m"]["value"], delta=1e-9)
        self.assertIn("cohesion and bond / 1.4; the worst of 16 combinations: weight", own["partial_factors"])


if __name__ == "__main__":
    main()
