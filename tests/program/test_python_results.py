# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What Python is told is what the program prints: each record beside the JSON of the program, key by key, over all examples
and what they show; and nothing of the structs is forgotten: every field and every word of C has its place in Python."""

import copy
import dataclasses
import json
import pickle
import re
import unittest
import warnings

from harness import ROOT, example_scenes, main, run
from python_case import ffi, lib, topple
from topple.words import Word

EXAMPLES = example_scenes()
#: Keys of JSON by the record that they stand in, and where Python has them.
ELSEWHERE = {
    "Contact": {"left_end": lambda c: (c.left_end, c.left_end_x_m, c.left_end_y_m),
                "right_end": lambda c: (c.right_end, c.right_end_x_m, c.right_end_y_m)},
    "Frame": {"turned_about": lambda f: (f.turned_about_x_m, f.turned_about_y_m)},
    "Sliding": {"facet": lambda s: ((s.facet_x0_m, s.facet_y0_m), (s.facet_x1_m, s.facet_y1_m))},
    "GoverningFos": {key: (lambda name: lambda g: getattr(g.factors[g.factor], name) if g.factor is not None else None)(key)
                     for key in ("mechanism", "definition", "pivot")},
    "Motion": {"centre_x_m": lambda m: m.centre_x_m},
    "MotionContact": {"end": lambda c: "right" if c.at_right_end else "left"},
}
#: Keys that say in words what other keys, or None, say as well, or that are the program's.
WORDS = {"index", "critical_angle_is", "method", "tie_is", "fos_is", "fos_elements_is", "fos_strength_is", "fos_driving_is", "is",
         "cut_by_default", "weight_unit", "limit_angle_is", "too_dear", "mean_plane"}
CHECKED_APART = {"Limit": {"otherwise", "holds_from", "holds_from_deg", "holds_from_is", "base_matters", "slides_sooner",
                           "facet", "fos_mechanism"},
                 "Frame": {"turned_about_x_m", "turned_about_y_m", "dip_deg", "dips_towards", "stated"},
                 "Onset": {"ranges"}, "MotionContact": {"facet"}, "Motion": {"strength"}}


class Told:
    """A value of JSON beside one of Python; counts what it compared."""

    def __init__(self, test):
        self.test, self.count = test, 0

    def same(self, told, own, way):
        if isinstance(own, topple.Fos):
            own = own.value
        self.count += 1
        if isinstance(own, topple.Bounded):
            self.test.assertEqual(told, {"value": own.value, "error": own.error}, way)
        elif isinstance(told, dict) and isinstance(own, tuple):  # an end: why, x and y
            for (key, value), mine in zip(told.items(), own):
                self.same(value, mine, f"{way}.{key}")
        elif isinstance(told, dict):
            self.record(told, own, way)
        elif isinstance(told, list):
            self.test.assertEqual(len(told), len(own), way)
            for k, (value, mine) in enumerate(zip(told, own)):
                if isinstance(mine, tuple):  # a point
                    value = list(value.values())
                self.same(value, mine, f"{way}[{k}]")
        else:
            self.test.assertEqual(told, own.value if isinstance(own, Word) else own, way)

    def record(self, told, own, way):
        kind = type(own).__name__
        for key, value in told.items():
            if key in WORDS or key in CHECKED_APART.get(kind, ()):
                continue
            if kind == "Pivot" and key.startswith("fos") and not own.admissible:
                continue  # the program has words for it
            if key in ELSEWHERE.get(kind, {}):
                self.same(value, ELSEWHERE[kind][key](own), f"{way}.{key}")
            else:
                self.same(value, getattr(own, key), f"{way}.{key}")


class Solutions(unittest.TestCase):
    def compare(self, told, solution, case, way):
        same = Told(self)
        for key in ("towards", "mechanism", "falls_backwards"):
            same.same(told[key], getattr(case, key), f"{way}.{key}")
        for key in ("tilt_angle_deg", "friction_angle_deg", "block", "frame", "contact", "teeth", "rest"):
            if key in told:
                same.same(told[key], getattr(solution, key), f"{way}.{key}")
        same.same([{**effect, "seconds": 0} for effect in told["effects"]],
                  [dataclasses.replace(effect, seconds=0) for effect in solution.effects], f"{way}.effects")
        for pivot in told["pivots"]:
            same.same(pivot, case.pivots[pivot["index"]], f"{way}.pivots")
        if told["toppling"] is not None:
            self.assertEqual(told["toppling"]["pivot"], case.toppling_pivot, way)
            same.same(told["toppling"]["critical_angle_deg"], case.governing_pivot.critical_angle_deg, way)
        for key in ("sliding", "toe", "elements"):
            if told.get(key) is not None:
                same.same(told[key], getattr(case, key), f"{way}.{key}")
        if told.get("limit") is not None and told["limit"]["mechanism"] != "holds nowhere":
            limit = dict(told["limit"])
            balance = limit.pop("balance", None)
            same.same(limit, case.limit, f"{way}.limit")
            if balance is not None:
                same.same(balance, case.balance, f"{way}.balance")
            same.same(told["limit"]["base_matters"], case.base_matters, f"{way}.base_matters")
        if told.get("onset") is not None:
            same.same(told["onset"], case.onset, f"{way}.onset")
            same.same(told["can_begin"], case.onset.beginnings, f"{way}.can_begin")
        if told.get("motions") is not None:
            same.same(told["motions"], case.onset.motions, f"{way}.motions")
        same.same(told["governing_fos"], case.governing_fos, f"{way}.governing_fos")
        same.same(told["factors"], case.governing_fos.factors, f"{way}.factors")
        same.same(told.get("loads", []), case.loads, f"{way}.loads")
        first = told["first"]
        for key, own in (("mechanism", case.first), ("critical_angle_deg", case.first_angle_deg), ("margin_deg", case.margin_deg),
                         ("margin_to_first_deg", case.margin_to_first_deg), ("steepen_by_deg", case.steepen_by_deg),
                         ("steepen_to_deg", case.steepen_to_deg)):
            if key in first:
                same.same(first[key], own, f"{way}.first.{key}")
        return same.count

    def test_examples(self):
        """Every scene, with its account by elements where it has one."""
        count = 0
        for path in EXAMPLES:
            with self.subTest(path.name), warnings.catch_warnings():
                warnings.simplefilter("ignore", topple.Caution)
                solution = topple.Scene.read(path).solve()
                told = json.loads(run("solve", "--json", path)[1])
                self.assertEqual(told.get("title"), solution.title)
                self.assertEqual([n["text"] for n in told["notes"]], [n.text for n in solution.notes])
                self.assertEqual(len(told["cases"]), len(solution.cases))
                for one, case in zip(told["cases"], solution.cases):
                    count += self.compare(one, solution, case, f"{path.name} {one['towards']}")
                timeless = [re.sub(r'"seconds": [^,]*', "", text) for text in
                            (solution.to_json(), run("solve", "--json", path)[1])]
                self.assertEqual(*timeless)
                self.assertEqual(*[re.sub(r"[\d.]+ m?s \(", "", text) for text in (solution.report(), run("solve", path)[1])])
        self.assertGreater(count, 2000)

    def test_copies(self):
        """A solution is data: it can be pickled, copied, compared and made a dictionary; what needs the library's own result
        says so."""
        scene = topple.Scene.read(EXAMPLES[0])
        solution = scene.solve(elements=True)
        for own in (pickle.loads(pickle.dumps(solution)), copy.deepcopy(solution)):
            self.assertEqual(own, solution)
            self.assertEqual(hash(own.cases[0]), hash(solution.cases[0]))
            with self.assertRaisesRegex(ValueError, "copy"):
                own.report()
        self.assertEqual(dataclasses.asdict(solution)["block"]["vertices"], solution.block.vertices)
        with self.assertRaises(dataclasses.FrozenInstanceError):
            solution.title = "another"
        with self.assertRaises(AttributeError):
            solution.nonsense  # noqa: B018

    def test_digits(self):
        """A hundred digits are told, all those of the program."""
        path = ROOT / "examples" / "block_e_valley.yaml"
        angle = topple.Scene.read(path).solve(digits=100).case("left").first_angle_deg
        told = run("solve", "--json", "--digits", "100", path)[1]
        self.assertGreater(len(angle.digits), 100)
        self.assertIn(angle.digits, told)
        self.assertTrue(angle.low < angle.value < angle.high)
        self.assertEqual(float(angle), angle.value)

    def test_words_about(self):
        scene = topple.Scene.read(ROOT / "examples" / "block_e_valley.yaml")
        solution = scene.solve()
        self.assertEqual(repr(solution), "<topple.Solution towards left: stands at 20°, slides and topples at 28.7346°>")
        self.assertEqual(solution.csv(), topple.csv([solution]))
        self.assertEqual(len(topple.table([solution, solution]).splitlines()), 4)
        self.assertIs(solution.meets(1.2), solution.cases[0].meets(1.2))
        self.assertFalse(solution.is_undecided)
        self.assertRaises(KeyError, solution.case, "right")


#: Structs whose records are not called as they are.
NAMED = {"tp_load_result": "LoadResult", "tp_claim_result": "ClaimResult", "tp_study_result": "StudyResult",
         "tp_tilt_convergence": "Convergence", "tp_tilt_convergence_case": "ConvergenceCase", "tp_blocks_summary": "Summary",
         "tp_moment_columns": "Moments", "tp_critical_columns": "CriticalAngles", "tp_verdict_columns": "Verdicts"}
#: What goes in, and messages, lists, charts and columns, which Python has in ways of its own.
GIVEN = {"tp_message", "tp_notes", "tp_settings", "tp_sweep_point", "tp_sweep_sink", "tp_sweep_summary", "tp_text_sink",
         "tp_exact", "tp_coordinates", "tp_chart_list", "tp_chart_range", "tp_chart_axis", "tp_derived_checks", "tp_numbers",
         "tp_outlines", "tp_study_column", "tp_study_ranks", "tp_figure_consent", "topple_run"}
#: Fields that say whether, or how many, of others there are, which in Python are None, or a tuple; that own memory; or that
#: another field says in words (the standing of a surveyed block).
FLAGS = {"known", "limits", "decimals", "size", "case_size", "status"}


class Mirrors(unittest.TestCase):
    def test_fields(self):
        """Every struct that a result is made of has its record, and every member its field, but what only counts or flags."""
        structs = [name for name in ffi.list_types()[0] if ffi.typeof(name).kind == "struct" and ffi.typeof(name).fields
                   and name not in GIVEN and not name.endswith("_options")]
        self.assertGreater(len(structs), 70)
        for struct in structs:
            name = NAMED.get(struct) or "".join(map(str.capitalize, struct[3:].removesuffix("_result").split("_")))
            fields = {field.name for field in dataclasses.fields(getattr(topple, name))}
            for own, kind in ffi.typeof(struct).fields:
                flag = own in FLAGS or own.startswith("has_") or own == "count" or own.endswith("_count")
                if own not in fields and not (flag and kind.type.cname in ("_Bool", "size_t") or own in FLAGS):
                    self.fail(f"{name} has no {own} of {struct}")

    def test_words(self):
        """Members stand in the order of C and are called as there, and their words are the library's."""
        names = {"Mechanism": lib.tp_mechanism_name, "Level": lib.tp_level_name, "FindTarget": lib.tp_find_target_name,
                 "AccuracyMethod": lib.tp_accuracy_method_name, "FosDefinition": lib.tp_fos_definition_name,
                 "BatchStanding": lib.tp_batch_standing_name, "SettlingEnd": lib.tp_settling_end_name,
                 "Verdict": lib.tp_verdict_name, "NoteKind": lib.tp_note_kind_name, "Fault": lib.tp_fault_name,
                 "ProfileResampling": lib.tp_profile_resampling_name, "ProfileDetrend": lib.tp_profile_detrend_name,
                 "ProfileWindow": lib.tp_profile_window_name, "JrcState": lib.tp_jrc_state_name,
                 "StudyOutcome": lib.tp_study_outcome_name, "StudyQuantity": lib.tp_study_quantity_name,
                 "TiltEngine": lib.tp_tilt_engine_name, "TiltProtocol": lib.tp_tilt_protocol_name,
                 "TiltEventKind": lib.tp_tilt_event_name, "TiltEnd": lib.tp_tilt_end_name,
                 "ConvergeSetting": lib.tp_converge_setting_name, "ConvergeQuantity": lib.tp_converge_quantity_name,
                 "ConvergeVerdict": lib.tp_converge_verdict_name}
        found = set()
        for kind in Word.__subclasses__():
            struct = "tp_" + re.sub(r"(?<!^)(?=[A-Z])", "_", kind.__name__).lower()
            if struct not in ffi.list_types()[0]:
                self.assertIn(kind.__name__, ("Towards", "Along", "FrictionIs", "WaterFaces", "WaterUplift"))
                continue
            found.add(struct)
            elements = ffi.typeof(struct).elements
            self.assertEqual(sorted(elements), list(range(len(kind))), struct)
            for k, member in enumerate(kind):
                self.assertTrue(elements[k].endswith(member.name), elements[k])
                if kind.__name__ in names:
                    self.assertEqual(ffi.string(names[kind.__name__](k)).decode(), member.value)
        for status in topple.Status:
            self.assertEqual(ffi.typeof("tp_status").elements[status], f"TP_{status.name}")
        enums = {name for name in ffi.list_types()[0] if ffi.typeof(name).kind == "enum"}
        self.assertEqual(enums - found, {"tp_status", "tp_chart_format", "tp_sweep_format"})


if __name__ == "__main__":
    main()
