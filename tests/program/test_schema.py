# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The JSON of every command against its schema (JSON Schema draft 2020-12), by a validator of others.

A key that no schema explains fails here, and so does one that is explained and never printed by all that runs below:
whoever adds a key to an output describes it in the schema and has it printed by a scene."""

import copy
import json
import pathlib
import tempfile
import unittest

try:
    import jsonschema
except ImportError as missing:
    raise SystemExit("python3-jsonschema is missing: apt-get install python3-jsonschema") from missing

import hard_case
from harness import PROGRAM, ROOT, example_scenes, main, rounds, run, schemas

SCHEMAS = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in schemas()}
EXAMPLES = example_scenes()
E = ROOT / "examples" / "block_e_valley.yaml"
LOADED = ("rounded:", "ellipse:", "loads:", "arcs:")

# What the examples and the hard cases do not bring forth.
SCENES = {
    "cases": "block: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\nslope: {dip_deg: 20, towards: left}\nfriction_angle_deg: 35\n"
             "cases:\n- {name: DA1-2, partial_factors: DA1-2}\n- {name: level, set: {slope.dip_deg: 0}}\n",
    "a case": "block: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\nslope: {dip_deg: 20, towards: left}\nfriction_angle_deg: 35\n"
              "partial_factors: DA3\n",
    "fails against": "block: {slab: {width: 1.2, height: 4}, unit_weight_kn_m3: 26}\nslope: {dip_deg: 30, towards: left}\n"
                     "friction_angle_deg: 25\nloads: {seismic: {horizontal: 0.1}}\n",
    "within": "block: {outline: [[0, 0.01], [2, -0.01], [2, 3], [0, 3]]}\nbase: {profile: [[-1, 0], [3, 0]]}\n"
              "contact: {within: 0.02}\n",
    "joint": "block: {teeth: {count: 4, width: 30, height: 120, depth: 5, left_end: valley}}\n"
             "joint: {matching: 0.6, closure: 0.3}\n",
    "barton": "block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}\n"
              "friction: {law: barton, residual_angle_deg: 24, jrc: 8, jcs_mpa: 50}\ntilt: {angle_deg: 20}\n",
    "required": "block: {slab: {width: 1, height: 2}}\nfriction_angle_deg: 40\ntilt: {angle_deg: 10}\nrequired_fos: 1.2\n",
    "rolls": "block: {slab: {width: 10, height: 20}, rounded: {corners: [{at: left_end, radius: 2}]}}\n"
             "tilt: {towards: left, angle_deg: 22}\n",
    "cautions": "block: {slab: {width: 1000, height: 2000}, unit_weight_kn_m3: 2600}\ntilt: {towards: left}\n",
    "slides at every tilt": "block: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 30\n"
                            "loads: {anchors: [{at: [0, 0], direction_deg: 180, force_kn: 2000}]}\n"
                            "tilt: {towards: left, angle_deg: 10}\n",
    "overcomes cohesion": "block: {slab: {width: 6, height: 2}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 20\n"
                          "loads: {cohesion_kpa: 8, bond_kpa: 3}\ntilt: {towards: left, angle_deg: 40}\n",
    "water overtops": "block: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 30\n"
                      "loads: {water: {height: 3, stays_level: true}}\ntilt: {towards: left, angle_deg: 5}\n",
    "frame of the world": "block: {outline: [[0, 0], [2, 1], [1, 3], [-1, 2]]}\nframe: world\nfriction_angle_deg: 30\n",
    "on a slope": "block: {slab: {width: 1, height: 3}}\nslope: {dip_deg: 9, towards: left, strike_deg: 330}\nfriction_angle_deg: 30\n",
    "earthquakes": "block: {outline: [[0, 0], [2, 0.01], [3, 4], [1, 4]], unit_weight_kn_m3: 26}\nframe: world\n"
                   "friction_angle_deg: 30\nloads: {seismic: {horizontal: 0.2, vertical: 0.1}}\n",
    "earthquakes that lift": "block: {outline: [[0, 0], [2, 0.01], [3, 4], [1, 4]], unit_weight_kn_m3: 26}\nframe: world\n"
                             "friction_angle_deg: 30\nloads: {seismic: {horizontal: 0.2, vertical: 1.1}}\n",
    "support": "block: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 26}\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 30\n"
               "loads: {anchors: [{at: [0, 1], dip_deg: 15, force_kn: 5, capacity_kn: 900, length: 4, spacing: 2, rows: 2, "
               "row_step: [0, 1]}], support_pressures: [{from: [0, 2], to: [0, 1], kpa: 3}]}\n",
    "mean plane": "block: {outline: [[0, 0], [2, 1], [1, 3], [-1, 2]]}\nframe: {mean_plane: [[0, 0], [2, 1]]}\n"
                  "base: {mated: true, between: [[0, 0], [2, 1]]}\n",
    "factor between bounds": "block: {outline: [[0, 0], [1, 0.3], [2, 0], [2, 2], [0, 2]], unit_weight_kn_m3: 26}\n"
                             "base: {mated: true, beyond: {left: 0, right: 0}}\ntilt: {towards: left, angle_deg: 17}\n"
                             "friction: {law: barton, residual_angle_deg: 20, jrc: 12, jcs_mpa: 50}\nloads: {cohesion_kpa: 3, bond_kpa: 3}\n",
    "upright toe": "block: {outline: [[0, 0], [1, 0], [1, 1], [3, 1], [3, 4], [0, 4]]}\nfriction_angle_deg: 30\n"
                   "tilt: {towards: right}\n",
}


TRACES = (pathlib.Path(PROGRAM).parent / "libtopple-trace.so").exists()
# What an undecided factor of a block that stands has, of which these scenes have none.
UNSEEN = ["solve/$defs/governing_fos: at_least"]


def properties_of(schema, place=""):
    """Every set of properties of a schema with where it stands; sub-schemas too."""
    if isinstance(schema, list):
        for k, part in enumerate(schema):
            yield from properties_of(part, f"{place}[{k}]")
    elif isinstance(schema, dict):
        if isinstance(schema.get("properties"), dict) and schema.get("type") in ("object", ["object", "null"]):
            yield place, schema
        for key, part in schema.items():
            yield from properties_of(part, f"{place}/{key}")


def shortened(value):
    """The same with the middle of long lists left out, whose entries are printed by the same code: it would take most of the time."""
    ends = 12
    if isinstance(value, dict):
        return {key: shortened(own) for key, own in value.items()}
    if isinstance(value, list):
        return [shortened(own) for own in (value if len(value) <= 2 * ends else value[:ends] + value[-ends:])]
    return value


class Schema(unittest.TestCase):
    seen = set()

    @classmethod
    def setUpClass(cls):
        own = jsonschema.Draft202012Validator.VALIDATORS["properties"]

        def properties(validator, value, instance, schema):
            if isinstance(instance, dict):
                cls.seen.update((id(value), key) for key in instance if key in value)
            yield from own(validator, value, instance, schema)

        recording = jsonschema.validators.extend(jsonschema.Draft202012Validator, {"properties": properties})
        cls.validators = {name: recording(schema) for name, schema in SCHEMAS.items()}

    def fits(self, name, out):
        document = json.loads(out)
        wrong = [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}"
                 for error in self.validators[name].iter_errors(shortened(document))]
        self.assertEqual(wrong[:5], [])
        return document

    def prints(self, *words, statuses=(0,), folder=ROOT):
        with self.subTest(words=" ".join(map(str, words))):
            status, out, err = run(*words, folder=folder)
            self.assertIn(status, statuses, err)
            return self.fits(words[0], out) if out or status != 4 else None  # a number is left open

    def test_1_schemas(self):
        """They are schemas, closed to keys that they do not describe, and describe each that they know."""
        self.assertEqual(set(SCHEMAS), {"accuracy", "batch", "block_system", "chart", "converge", "derive", "family", "profile", "solid", "solve", "study", "sweep", "tilt", "trace", "verify"})
        for name, schema in SCHEMAS.items():
            jsonschema.Draft202012Validator.check_schema(schema)
            self.assertEqual(schema["$schema"], "https://json-schema.org/draft/2020-12/schema")
            count = 0
            for place, part in properties_of(schema, name):
                self.assertIs(part.get("additionalProperties"), False, place)
                self.assertLessEqual(set(part.get("required", ())), set(part["properties"]), place)
                for key, own in part["properties"].items():
                    count += 1
                    self.assertGreater(len(own.get("description", "")), 5, f"{place}: {key} is not explained")
            self.assertGreater(count, 10, name)

    def test_2_solve_examples(self):
        for scene in EXAMPLES:
            self.prints("solve", "--json", scene)
            self.prints("solve", "--json", "--digits", "40", scene)
            self.prints("solve", "--json", "--pivots=governing", scene)
            self.prints("solve", "--json", "--outlines", scene)
            if not any(word in scene.read_text(encoding="utf-8") for word in LOADED):
                self.prints("solve", "--json", "--elements", scene)

    def test_2_solve_hard_cases(self):
        count = 0
        for path in sorted((ROOT / "tests" / "hard").glob("*.yaml")):
            case = hard_case.Case(path)
            if case.big or case.refusal:
                continue
            count += 1
            with tempfile.TemporaryDirectory() as folder:
                case.write(pathlib.Path(folder))
                self.prints("solve", "--json", *case.options, path.name, statuses=(0, 4), folder=folder)
        self.assertGreater(count, 60)

    def test_2_solve_further(self):
        for name, text in SCENES.items():
            with tempfile.TemporaryDirectory() as folder, self.subTest(name):
                (pathlib.Path(folder) / "scene.yaml").write_text(
                    f"topple: 1\ntitle: {name}\nlength_unit: m\n{text}")
                self.prints("solve", "--json", "scene.yaml", folder=folder, statuses=(4,) if name == "factor between bounds" else (0,))

    def test_2_find(self):
        self.prints("solve", "--json", "--set", "a=40", "--set", "b=2*a+1/3", E)
        found = [self.prints("solve", "--json", "--find", key, "--for", target, scene)["find"] for key, target, scene in (
            ("a", "critical_angle=20", E), ("friction_angle_deg", "limit_fos=1.3", E), ("block.teeth.count", "sliding_angle=89", E),
            ("loads.seismic.horizontal", "fos=1", ROOT / "examples" / "block_seismic.yaml"))]
        self.assertTrue(any(own["solutions"] for own in found) and not all(own["solutions"] for own in found))
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(
                "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 1}}\nbase: {mated: true}\n"
                "friction_angle_deg: 30\ntilt: {towards: left}\n")
            found = self.prints("solve", "--json", "--find", "block.slab.height", "--for", "limit_angle=30", "scene.yaml",
                                folder=folder)["find"]
            self.assertEqual(len(found["intervals"]), 1)
            (pathlib.Path(folder) / "scene.yaml").write_text("topple: 1\nlength_unit: m\n" + SCENES["support"])
            found = self.prints("solve", "--json", "--find", "loads.anchors.1.force_kn", "--for", "governing_fos=1.5", "--least-force",
                                "scene.yaml", folder=folder)["find"]
            self.assertEqual(len(found["per_metre_kn"]), len(found["solutions"]))

    def test_2_derive(self):
        rounded = [scene for scene in EXAMPLES if "teeth:" in scene.read_text(encoding="utf-8")]
        count = 0
        for scene in EXAMPLES:
            for words in ((), ("--elements",), ("--limit",)):
                status, out, _ = run("derive", "--json", *words, scene)
                if status == 0:
                    count += 1
                    self.fits("derive", out)
        self.assertGreater(count, 30)
        with tempfile.TemporaryDirectory() as folder:  # a motion begins on level ground: no formula, and why
            (pathlib.Path(folder) / "scene.yaml").write_text(
                "topple: 1\nlength_unit: m\nblock: {teeth: {count: 1, width: 30, height: 20, depth: 12, left_end: peak}, "
                "unit_weight_kn_m3: 2600}\n"
                "base: {mated: true}\nfriction_angle_deg: 5\ntilt: {towards: left}\n")
            found = self.prints("derive", "--json", "--limit", "scene.yaml", folder=folder)
            self.assertIn("level ground", found["onset"][0]["why"])
            self.assertEqual(found["notes"][0]["kind"], "caution")
        for scene in rounded:
            for words in (("--rounded",), ("--for-all", "count")):
                status, out, _ = run("derive", "--json", *words, scene)
                if status == 0:
                    self.fits("family" if "--for-all" in words else "derive", out)

    def test_2_verify(self):
        document = self.prints("verify", "--json", ROOT / "examples" / "paper" / "claims.yaml", statuses=(1,))
        self.assertGreater(len(document["claims"]), 400)

    def test_2_accuracy(self):
        for scene in rounds(("block_a_worn",), ("block_e_valley", "block_a_worn", "boulder")):
            self.prints("accuracy", "--json", ROOT / "examples" / f"{scene}.yaml")
        self.prints("accuracy", "--json", f"--sweep=10:{rounds(10, 100)}")
        self.prints("accuracy", "--json", ROOT / "examples" / "tilt_block_a_peak.yaml")

    def test_2_chart(self):
        for kind in ("fos", "mechanisms", "ranges"):
            self.prints("chart", "--json", kind)
        slab = ROOT / "examples" / "slab_left.yaml"
        self.prints("chart", "--json", "map", slab, "--x", "block.slab.width=10:150")
        self.prints("chart", "--json", "map", slab, "--x", "block.slab.width=10:150", "--y", "block.slab.height=10:150")

    def test_2_batch(self):
        with tempfile.TemporaryDirectory() as name:
            table = pathlib.Path(name) / "survey.csv"
            table.write_text("name,width (m),height (m),dip (deg),friction (deg),required_fos\n"
                             "a,1,2,20,30,1.3\nb,-1,2,20,30,1\nc,3,1,20,45,\nd,3,1,0,45,\n,1,2,20,30,\n", encoding="utf-8")
            status, out, err = run("solve", "--batch", "--json", table)
            self.assertEqual(status, 3, err)
            self.fits("batch", out)

    def test_2_block_system(self):
        example = ROOT / "examples" / "blocks" / "toppling_slope.yaml"
        with tempfile.TemporaryDirectory() as name:
            scene = pathlib.Path(name) / "scene.yaml"
            # of no weight, held by friction alone, which no divisor spends
            scene.write_text("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nrequired_fos: 1.3\nblocks:\n"
                             "- {ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n"
                             "- {slab: {width: 2, height: 1}}\n", encoding="utf-8")
            slot = pathlib.Path(name) / "slot.yaml"  # in which no tilt moves the block; of a weight that no rock has; by the factors of a code
            slot.write_text("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nblock: {unit_weight_kn_m3: 2}\nblocks:\n"
                            "- {ground: true, outline: [[0, 0], [0, 1], [-1, 1], [-1, -1], [2, -1], [2, 1], [1, 1], [1, 0]]}\n"
                            "- {slab: {width: 1, height: 1}}\npartial_factors: DA1-2\n", encoding="utf-8")
            row = pathlib.Path(name) / "row.yaml"  # of columns that nothing moves
            row.write_text("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nslope: {dip_deg: 0.01, towards: left}\n"
                           "required_fos: 1\ncolumns: {width: 1, heights: [1, 1]}\n", encoding="utf-8")
            wet = pathlib.Path(name) / "wet.yaml"  # that needs a support
            wet.write_text("topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {unit_weight_kn_m3: 25}\nblocks:\n"
                           "- {name: g, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n"
                           "- {name: b, slab: {width: 2, height: 4}}\ntilt: {towards: left, angle_deg: 33}\n"
                           "support: {block: b, at: [0, 1]}\nloads: {water: {level: 1}}\n", encoding="utf-8")
            asked = pathlib.Path(name) / "asked.yaml"  # of columns, for the toe of which a support is asked
            asked.write_text("topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nslope: {dip_deg: 33, towards: left}\n"
                             "block: {unit_weight_kn_m3: 25}\ncolumns: {width: 1, heights: [1, 1]}\n"
                             "support: {block: column 1, at: [0, 0.5]}\n", encoding="utf-8")
            self.prints("sweep", "--json", "--x", "friction_angle_deg=35,95", example, statuses=(3,))
            study = pathlib.Path(name) / "study.yaml"
            study.write_text("topple_study: 1\nscene: row.yaml\nvary: {friction_angle_deg: {list: [0, 40]}}\n",
                             encoding="utf-8")
            self.prints("study", "--json", study)
            many = pathlib.Path(name) / "many.yaml"  # too many for motions to be looked for
            many.write_text(row.read_text(encoding="utf-8").replace("[1, 1]", f"{[1] * 49}"), encoding="utf-8")
            pinched = pathlib.Path(name) / "pinched.yaml"  # between two others, which falls at every friction
            pinched.write_text(scene.read_text(encoding="utf-8") + "- {slab: {width: 2, height: 1}, at: [3, 0]}\n"
                               "- {slab: {width: 1, height: 0.25}, at: [2, 0.5]}\n", encoding="utf-8")
            lifted = pathlib.Path(name) / "lifted.yaml"  # held by cohesion the better as it weighs less
            lifted.write_text(row.read_text(encoding="utf-8").split("slope")[0] + "slope: {dip_deg: 50, towards: left}\n"
                              "block: {unit_weight_kn_m3: 25}\nloads: {cohesion_kpa: 30, seismic: {horizontal: 0.05, vertical: 0.2}}\n"
                              "blocks:\n- {ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n- {slab: {width: 4, height: 1}}\n",
                              encoding="utf-8")
            falls = pathlib.Path(name) / "falls.yaml"  # but for the earthquake
            falls.write_text("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nslope: {dip_deg: 25, towards: left}\n"
                             "block: {unit_weight_kn_m3: 25}\nloads: {seismic: {horizontal: 0.3, direction: up_dip}}\nblocks:\n"
                             "- {ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n- {slab: {width: 1, height: 3}}\n",
                             encoding="utf-8")
            files = ((scene, ()), (lifted, ()), (falls, ()), (slot, ()), (row, ()), (wet, ()), (asked, ()), (wet, ("--set", "tilt.angle_deg=1")), (many, ()), (pinched, ()))
            drawn = (example.with_name("wet_columns.yaml"), ("--outlines",))
            for path, more in ((example, ("--set", "friction_angle_deg=36")), drawn, *files):
                status, out, err = run("solve", "--json", *more, path)
                self.assertIn(status, (0, 1, 4), err)
                self.fits("block_system", out)
            slab = pathlib.Path(name) / "slab.yaml"
            slab.write_text("topple: 1\nlength_unit: m\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 35\n"
                            "block: {unit_weight_kn_m3: 25}\nblocks:\n"
                            "- {ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n- {slab: {width: 2, height: 1}}\n",
                            encoding="utf-8")
            for scene, key, target, low, high in ((slab, "friction_angle_deg", "fos=1.2", "34", "35"),
                                                  (ROOT / "examples" / "blocks" / "wet_columns.yaml", "loads.anchors.1.force_kn", "limit_fos=1.3", "200", "240"),
                                                  (ROOT / "examples" / "blocks" / "wet_columns.yaml", "loads.anchors.1.force_kn", "fos=1.3", "200", "240"),
                                                  (example, "slope.dip_deg", "fos_goodman_bray=1", "29.9", "30.1")):
                status, out, err = run("solve", "--json", "--find", key, "--for", target, "--from", low, "--to", high, scene)
                self.assertEqual(status, 0, err)
                self.fits("block_system", out)

    def test_2_sweep(self):
        """With points that are wrong, and at more digits than a double has."""
        self.prints("sweep", "--json", "--x", "friction_angle_deg=20:90:10", "--set", "b=2*a+1/3", E, statuses=(3,))
        self.prints("sweep", "--json", "--digits", "20", "--x", "friction_angle_deg=20,30", "--y", "c=0,5", E)

    def test_2_profile(self):
        joint = ROOT / "examples" / "joint_profile.csv"
        for words in ((), ("--all",), ("--step", "0.5", "--detrend", "line", "--mirror"), ("--step", "30")):
            self.prints("profile", "--json", *words, joint)
        self.prints("profile", "--json", "--jcs", "120", E)
        with tempfile.TemporaryDirectory() as folder:  # nothing rough in it; and one that leans
            (pathlib.Path(folder) / "flat.csv").write_text("".join(f"{k},0\n" for k in range(200)))
            self.prints("profile", "--json", "flat.csv", folder=folder)
            (pathlib.Path(folder) / "steep.csv").write_text("".join(f"{k},{k}\n" for k in range(20)))
            self.prints("profile", "--json", "steep.csv", folder=folder)

    def test_2_tilt(self):
        """Each engine and protocol, shaking, and a block that stands to the end."""
        slab = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 3}}\nfriction_angle_deg: 40\ntilt: {towards: left}\n"
        for test in ("tilt_test: {engine: path}", "tilt_test: {engine: path, until_deg: 10}",
                     "tilt_test: {engine: dynamics, duration_s: 0.2}",
                     "tilt_test: {engine: dynamics, method: springs, protocol: steps, until_deg: 10, duration_s: 0.01,"
                     " normal_stiffness_gpa_m: 1, shear_stiffness_gpa_m: 1}",
                     "tilt_test: {duration_s: 0.01}\nshaking: {vertical: {full_sine: {peak_g: 0.1, frequency_hz: 99}}}"):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "scene.yaml").write_text(slab + test + "\n")
                self.prints("tilt", "--json", "scene.yaml", folder=folder, statuses=(0, 4))
        text = (ROOT / "examples" / "tilt_block_f.yaml").read_text()  # with k_s = k_n it gives way, and rests again
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(
                text + "  normal_stiffness_gpa_m: 1000\n  shear_stiffness_gpa_m: 1000\n")
            self.prints("tilt", "--json", "scene.yaml", folder=folder)
        self.prints("tilt", "--json", ROOT / "examples" / "tilt_locked_stress.yaml")
        self.prints("tilt", "--json", "--overturning", "--factors", "1:1.2:3", ROOT / "examples" / "shaken_boulder.yaml")

    def test_2_converge(self):
        """A critical angle by the path, with a caution, and the least shaking that overturns by events within a third of a
        second, of a slab that slides before it rocks, whose runs are shorter, and under `./check --long` of one that rocks."""
        slab = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 2600}\n" \
               f"friction_angle_deg: {rounds(3, 40)}\ntilt: {{towards: left}}\n"
        for test in ("tilt_test: {engine: path}", "tilt_test: {engine: path, until_deg: 10}",
                     "tilt_test: {duration_s: 0.3}\nshaking: {horizontal: {half_sine: {peak_g: 0.5, frequency_hz: 2}}}"):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "scene.yaml").write_text(slab + test + "\n")
                status, out, err = run("tilt", "--converge", "--json", "scene.yaml", folder=folder)
                self.assertIn(status, (0, 4), err)
                self.fits("converge", out)

    def test_2_solid(self):
        self.prints("solid", "--json", "--unit-weight=26", "--friction=30", "--band=0,0.1", ROOT / "examples" / "meshes" / "scanned_boulder.obj",
                    "--object=boulder")
        rock = ROOT / "examples" / "solids" / "balanced_rock.yaml"
        for words in ((), ("--set", "tilt.angle_deg=40")):  # forces hold it; a motion begins
            status, out, err = run("solve", "--json", *words, rock.with_name("rock_on_contacts.yaml"))
            self.assertEqual((status, err), (0, ""))
            self.fits("solid", out)
        with tempfile.TemporaryDirectory() as folder:  # an earthquake towards its azimuth
            text = rock.with_name("rock_on_contacts.yaml").read_text(encoding="utf-8").replace("file: ", f"file: {rock.parent}/")
            (pathlib.Path(folder) / "rock.yaml").write_text(text + "loads: {seismic: {horizontal: 0.05, azimuth_deg: 30}}\n")
            status, out, err = run("solve", "--json", "rock.yaml", folder=folder)
            self.assertEqual((status, err), (0, ""))
            self.fits("solid", out)
        with tempfile.TemporaryDirectory() as folder:  # one object of a ground
            text = rock.with_name("rock_on_ground.yaml").read_text(encoding="utf-8").replace("file: ", f"file: {rock.parent}/")
            (pathlib.Path(folder) / "rock.yaml").write_text(text.replace("ground.obj}", "ground.obj, object: ground}"))
            status, out, err = run("solve", "--json", "rock.yaml", folder=folder)
            self.assertEqual((status, err), (0, ""))
            self.fits("solid", out)
        with tempfile.TemporaryDirectory() as folder:  # a corner is cut off a cube, a face is given twice, one is flat, one turned
            corners = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for y in (0, 1) for x in (0, 1)) + "v 0.5 0 0\nv 9 9 9\nv 9 9 9.1\nv 9 9.1 9\nv 9.1 9 9\n"
            square = ((0, 2, 3, 1), (4, 5, 7, 6), (1, 3, 7, 5), (3, 2, 6, 7))
            faces = [t for a, b, c, d in square for t in ((a, b, c), (a, c, d))]
            faces += [(0, 8, 4), (8, 5, 4), (8, 1, 5), (0, 1, 8), (2, 0, 4), (2, 6, 4), (4, 6, 2), (9, 10, 11), (10, 9, 12), (11, 10, 12), (9, 11, 12)]
            (pathlib.Path(folder) / "rock.obj").write_text(corners + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces[1:]))
            self.prints("solid", "--json", "--repair", "--thin=0.1", "--merge-within=1e-6", "--drop-below=0.01", "rock.obj", folder=folder)
        self.prints("sweep", "--json", "--x", "tilt.angle_deg=0,20", rock)
        for name in ("rock_in_the_ground.yaml", "rock_on_ground.yaml"):
            status, out, err = run("solve", "--json", rock.with_name(name))
            self.assertEqual((status, err), (0, ""))
            self.fits("solid", out)
        with tempfile.TemporaryDirectory() as folder:
            wedge = rock.with_name("wedge.yaml").read_text(encoding="utf-8")
            crack = "    crack: {dip_deg: 70, dip_direction_deg: 165, distance: 40}\nrequired_fos: 1.2\n" \
                    "loads: {seismic: {horizontal: 0.05, azimuth_deg: 30}}"
            bolted = wedge.replace("required_fos: 1.3", "required_fos: 1.6\nloads: {anchors: [{force_kn: 9, capacity_kn: 10, dip_deg: 3, azimuth_deg: 340}]}")
            (pathlib.Path(folder) / "bolted.yaml").write_text(bolted, encoding="utf-8")
            status, out, err = run("solve", "--json", "bolted.yaml", folder=folder)
            self.assertEqual(status, 1, err)
            self.fits("solid", out)
            (pathlib.Path(folder) / "wedge.yaml").write_text(wedge.replace("required_fos: 1.3", crack), encoding="utf-8")
            status, out, err = run("solve", "--json", "wedge.yaml", folder=folder)
            self.assertEqual((status, err), (0, ""))
            self.fits("solid", out)
        with tempfile.TemporaryDirectory() as folder:
            text = rock.read_text(encoding="utf-8").replace("file: ", f"file: {rock.parent}/")
            inside = "".join(f"o {name}\nv {x} 0 0.9\nv {x + 0.1} 0 0.9\nv {x} 0.1 0.9\nv {x} 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n"
                             for name, x in (("hollow", 0.3), ("vein", 0.1)))
            (pathlib.Path(folder) / "inside.obj").write_text(inside, encoding="utf-8")
            text = text.replace("  unit: m\n", "  unit: m\n  holes: [{file: inside.obj, object: hollow}]\n"
                                "  parts: [{file: inside.obj, object: vein, unit_weight_kn_m3: 30}]\n")
            (pathlib.Path(folder) / "rock.yaml").write_text(text.replace("horizontal: 0.05", "horizontal: 0.05, azimuth_deg: 3")
                                                            + "required_fos: 1.2\n")
            for words in ((), ("--set", "tilt.angle_deg=4")):
                status, out, err = run("solve", "--json", *words, "rock.yaml", folder=folder)
                self.assertEqual(status, 0, err)
                self.fits("solid", out)
            self.prints("sweep", "--json", "--x", "tilt.angle_deg=0,20", "rock.yaml", folder=folder)

    def test_2_solid_factors(self):
        """A box on its corners, tilted and level; the same on a ground; a prism in a groove, along which its motions are decided."""
        box = "".join(f"v {2 * (k & 1)} {k >> 1 & 1} {3 * (k >> 2)}\n" for k in range(8)) + \
            "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
        sole = [(0, 0), (1, -0.5), (2, 0), (2, 2), (0, 2)]
        prism = "".join(f"v {x} {y} {z}\n" for y in (0, 1) for x, z in sole)
        prism += "".join(f"f {b} {a} {a + 5} {b + 5}\n" for a, b in ((1, 2), (2, 3), (3, 4), (4, 5), (5, 1)))
        prism += "f 1 2 3 4 5\nf 10 9 8 7 6\n"
        ground = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n"
        corners = ", ".join(f"{{at: [{x}, {y}, 0], normal: [0, 0, 1]}}" for y in (0, 1) for x in (0, 2))
        groove = ", ".join(f"{{at: [{x}, {y}, {z}], normal: [{side}, 0, 2]}}" for y in (0, 1)
                           for x, z, side in ((0, 0, 1), (1, -0.5, 1), (1, -0.5, -1), (2, 0, -1)))
        scenes = (("box.obj", f"contacts: [{corners}]", 15), ("box.obj", f"contacts: [{corners}]", 0),
                  ("box.obj", "base: {file: ground.obj}, bands: [0.001]", 15), ("prism.obj", f"contacts: [{groove}]", 5))
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file, text in (("box.obj", box), ("prism.obj", prism), ("ground.obj", ground)):
                (folder / file).write_text(text, encoding="utf-8")
            for mesh, more, tilt in scenes:
                (folder / "scene.yaml").write_text(
                    f"topple: 1\nlength_unit: m\nsolid: {{file: {mesh}, unit: m, unit_weight_kn_m3: 26, {more}}}\n"
                    f"friction_angle_deg: 30\ntilt: {{angle_deg: {tilt}, azimuth_deg: 270}}\n", encoding="utf-8")
                status, out, err = run("solve", "--json", "scene.yaml", folder=folder)
                self.assertEqual((status, err), (0, ""))
                self.fits("solid", out)

    @unittest.skipUnless(TRACES, "topple trace was not built")
    def test_2_trace(self):
        with tempfile.TemporaryDirectory() as folder:
            self.prints("trace", "--json", ROOT / "examples" / "pictures" / "painted_boulder.png", "--around=70,70,420,300",
                        "--scale=30.7,306.7,190.3,317.9,2", "--between=131,254,322,266", "-o", f"{folder}/boulder.yaml")

    def test_2_study(self):
        for name in ("slab", "block_above_road", "rough_base"):
            self.prints("study", "--json", ROOT / "examples" / "studies" / f"{name}_study.yaml")
        with tempfile.TemporaryDirectory() as folder:  # a scene without a tilt, some samples of which there is none
            (pathlib.Path(folder) / "scene.yaml").write_text(
                "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 1}}\nfriction_angle_deg: 30\n"
                "tilt: {towards: left}\n")
            (pathlib.Path(folder) / "study.yaml").write_text(
                "topple_study: 1\nscene: scene.yaml\nvary: {block.slab.height: {list: [-1, 0.1, 1, 2, 1e-200]}}\n")
            (pathlib.Path(folder) / "analyses.yaml").write_text(
                "topple_study: 1\nscene: tilted.yaml\nsamples: 20\nsensitivity: {samples: 20}\n\n"
                "reliability: {quantity: fos, importance: {samples: 400}, subset: {samples: 100}}\n"
                "vary: {friction_angle_deg: {uniform: {low: 20, high: 30}}}\n")
            (pathlib.Path(folder) / "tilted.yaml").write_text(
                "topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\n"
                "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 22}\n")
            self.prints("study", "--json", "analyses.yaml", folder=folder)
            (pathlib.Path(folder) / "never.yaml").write_text(  # no design point
                "topple_study: 1\nscene: tilted.yaml\nsamples: 20\n\n"
                "reliability: {quantity: limit_deg, importance: {samples: 20}, subset: {samples: 100}}\n"
                "design_values: [{of: block.unit_weight_kn_m3, probability: 0.2}]\n"
                "vary: {block.unit_weight_kn_m3: {uniform: {low: 20, high: 30}}}\n")
            self.prints("study", "--json", "never.yaml", folder=folder)
            found = self.prints("study", "--json", "study.yaml", folder=folder)
            self.assertEqual([own["sample"] for own in found["invalid"]], [0])

    def test_3_strange_keys_are_found(self):
        """The schema refuses a key that it does not know, one that is missing, and another kind of value, wherever
        they are put: at every object of a solution in turn."""
        solution = self.prints("solve", "--json", "--find", "a", "--for", "critical_angle=20", E)
        validator = jsonschema.Draft202012Validator(SCHEMAS["solve"])

        def objects(tree):
            if isinstance(tree, dict):
                yield tree
            for part in tree.values() if isinstance(tree, dict) else tree if isinstance(tree, list) else ():
                yield from objects(part)

        count = len(list(objects(solution)))
        self.assertGreater(count, 60)
        for k in range(count):
            strange, lacking, other = (copy.deepcopy(solution) for _ in range(3))
            list(objects(strange))[k]["unheard_of"] = 1
            self.assertFalse(validator.is_valid(strange))
            own = list(objects(lacking))[k]
            del own["value" if "value" in own else next(iter(own))]
            self.assertFalse(validator.is_valid(lacking))
            own = list(objects(other))[k]
            own[next(iter(own))] = {"text": "no number, text or list of these"}
            self.assertFalse(validator.is_valid(other))

    def test_4_nothing_is_explained_that_is_not_printed(self):
        """Runs last: every key of every schema was printed by a command above, but for those of UNSEEN, of commands that
        were not built, and the digits of numbers where the command has no --digits."""
        never = [f"{place}: {key}" for name, validator in self.validators.items() if name != "trace" or TRACES
                 for place, part in properties_of(validator.schema, name)
                 for key in part["properties"] if (id(part["properties"]), key) not in self.seen
                 and (key != "digits" or name in ("solve", "sweep"))]
        self.assertEqual(never, UNSEEN)


if __name__ == "__main__":
    main()
