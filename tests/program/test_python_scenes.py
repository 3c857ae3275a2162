# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A scene that Python builds by every call is what the file that says the same is."""

import copy
import inspect
import re
import unittest
from decimal import Decimal
from fractions import Fraction

from harness import main
from python_case import BLOCK, SOURCES, SQUARE, lib, said, topple

SQUARE_TEXT = "[[0, 0], [50, 0], [50, 100], [0, 100]]"
SMALL = [(40, 30), (60, 30), (60, 50), (40, 50)]
HOLE, PART = [(20, 40), (30, 40), (30, 50), (20, 50)], [(0, 80), (50, 80), (50, 100), (0, 100)]
WEIGHED = {"outline": SQUARE, "unit_weight_kn_m3": 26, "base_beyond": (10, 20), "tilt_angle_deg": 10,
           "tilt_towards": "left", "friction_angle_deg": 30}
WEIGHED_TEXT = f"""topple: 1
length_unit: mm
block: {{outline: {SQUARE_TEXT}, unit_weight_kn_m3: 26}}
base: {{mated: true, beyond: {{left: 10, right: 20}}}}
friction_angle_deg: 30
tilt: {{towards: left, angle_deg: 10}}
"""
#: What a scene is given, and the lines of a file that say the same.
SAID = [
    ({"slab": (50, 100), "title": "A slab"}, "title: A slab\nblock: {slab: {width: 50, height: 100}}"),
    ({"slab": {"width": "1/3", "height": Decimal("1.25")}}, "block: {slab: {width: 1/3, height: 1.25}}"),
    ({"teeth": (3, 30, 120, 5, "valley")},
     "block: {teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: valley}}"),
    ({"teeth_over": (4, 80, 100, 4, topple.LeftEnd.PEAK), "rounded_ends": [("left_end", "0.5")], "rounding_keeps_mass": True},
     "block: {teeth: {block_width: 80, mean_height: 100, amplitude: 4, wavelength: 40, left_end: peak},"
     " rounded: {model: paper, corners: [{at: left_end, radius: 0.5}]}}"),
    ({"ellipse": (100, 60, 20)}, "block: {ellipse: {width: 100, height: 60, flat: 20}}"),
    ({"outline": SQUARE, "holes": [HOLE], "parts": [(PART, 20)], "unit_weight_kn_m3": 26, "thickness": 20},
     f"block: {{outline: {SQUARE_TEXT}, holes: [{[list(p) for p in HOLE]}],"
     f" parts: [{{outline: {[list(p) for p in PART]}, unit_weight_kn_m3: 20}}], unit_weight_kn_m3: 26, thickness: 20}}"),
    ({"outline": SQUARE, "arcs_through": [(50, 100, 25, 120)], "arcs_bulge": [(50, 0, Fraction(1, 8))],
      "rounded_vertices": [(0, 0, 2)]},
     f"block: {{outline: {SQUARE_TEXT}, arcs: [{{from: [50, 100], through: [25, 120]}}, {{from: [50, 0], bulge: 1/8}}],"
     " rounded: {corners: [{at: [0, 0], radius: 2}]}}"),
    ({"outline": BLOCK, "repair": True, "base_mated": True, "tilt_towards": "right"},
     f"block: {{outline: {[list(p) for p in BLOCK]}, repair: true}}\nbase: {{mated: whole}}\ntilt: {{towards: right}}"),
    ({"outline": BLOCK, "base_between": [(0, 0), (60, 0)]},
     f"block: {{outline: {[list(p) for p in BLOCK]}}}\nbase: {{mated: true, between: [[0, 0], [60, 0]]}}"),
    ({"outline": SQUARE, "base_bound": ("below", 1), "frame": "world"},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{mated: true, between: {{below: 1}}}}\nframe: world"),
    ({"outline": SQUARE, "base_profile": [(-100, 10), (0, -5), (200, 0)], "base_rest": True},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{profile: [[-100, 10], [0, -5], [200, 0]], place: rest}}"),
    ({"outline": SQUARE, "base_profile": [(-100, 10), (0, -5), (200, 0)], "base_poses": True},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{profile: [[-100, 10], [0, -5], [200, 0]], place: all}}"),
    ({"outline": SQUARE, "base_profile": [(-100, -1), (0, 0.5), (200, 0)], "contact_within": 2},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{profile: [[-100, -1], [0, 0.5], [200, 0]]}}\ncontact: {{within: 2}}"),
    ({"outline": SQUARE, "unit_weight_kn_m3": 26, "friction_barton": (28, 6, 80), "contact_width": 2},
     f"block: {{outline: {SQUARE_TEXT}, unit_weight_kn_m3: 26}}\n"
     "friction: {law: barton, residual_angle_deg: 28, jrc: 6, jcs_mpa: 80}\ncontact: {width: 2}"),
    ({"outline": SQUARE, "joint_shift": -3, "joint_closure": "0.5"},
     f"block: {{outline: {SQUARE_TEXT}}}\njoint: {{shift: -3, closure: 0.5}}"),
    ({"outline": SQUARE, "joint_matching": ("0.75", True), "joint_closure": 1},
     f"block: {{outline: {SQUARE_TEXT}}}\njoint: {{matching: 0.75, closure: 1, towards: left}}"),
    ({"outline": SQUARE, "base_rest": True,
      "base_teeth": {"count": 40, "wavelength": "20.5", "amplitude": 4, "skew": 0.25, "amplitude_scatter": 0.5,
                     "start_x": -150, "start_y": -9, "seed": 3}},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{place: rest, profile: {{teeth: {{count: 40, wavelength: 20.5,"
     " amplitude: 4, left_end: valley, skew: 0.25, scatter: {amplitude: 0.5}, start: [-150, -9], seed: 3}}}"),
    ({"outline": SQUARE, "base_rest": True, "base_worn": (topple.Wear.ROUNDED, "0.1"), "base_noise": ("0.05", 2),
      "base_self_affine": {"length": 200, "step": "0.5", "hurst": "0.8", "by": "z2", "roughness": "0.3", "seed": 9,
                           "longest": 50, "start_x": -80, "start_y": -20}},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{place: rest, profile: {{self_affine: {{length: 200, step: 0.5,"
     " hurst: 0.8, z2: 0.3, longest: 50, start: [-80, -20], seed: 9}, noise: {deviation: 0.05, seed: 2},"
     " worn: {rounded: 0.1}}}"),
    ({"outline": SMALL, "base_rest": True, "base_jrc_profile": 7, "base_scaled": ("rms_height", 2)},
     f"block: {{outline: {[list(p) for p in SMALL]}}}\n"
     "base: {place: rest, profile: {jrc_profile: 7, scaled: {rms_height: 2}}}"),
    ({"outline": SQUARE, "base_profile": [(-100, 0), (200, 0)], "mean_plane": [(0, 0), (100, 5)]},
     f"block: {{outline: {SQUARE_TEXT}}}\nbase: {{profile: [[-100, 0], [200, 0]]}}\n"
     "frame: {mean_plane: [[0, 0], [100, 5]]}"),
    ({"outline": SQUARE, "slope": {"dip_deg": "12.5", "towards": "left", "dip_direction_deg": 135}},
     f"block: {{outline: {SQUARE_TEXT}}}\nslope: {{dip_deg: 12.5, towards: left, dip_direction_deg: 135}}"),
    ({"outline": SQUARE, "frame": topple.Along.BASE, "friction_patton": (25, 5)},
     f"block: {{outline: {SQUARE_TEXT}}}\nframe: base\n"
     "friction: {law: patton, basic_angle_deg: 25, roughness_angle_deg: 5}"),
    ({"outline": SQUARE, "friction_angle_deg": 30, "friction_facets": [(1, 1, 20)]},
     f"block: {{outline: {SQUARE_TEXT}}}\nfriction_angle_deg: 30\nfriction: {{facets: [{{facet: 1, angle_deg: 20}}]}}"),
    ({"outline": SQUARE, "friction_angle_deg": 30, "friction_between": [{"x0": -10, "x1": 500, "angle_deg": "20.5"}]},
     f"block: {{outline: {SQUARE_TEXT}}}\nfriction_angle_deg: 30\n"
     "friction: {facets: [{x: [-10, 500], angle_deg: 20.5}]}"),
    ({"slab": (50, 100), "friction_angle_deg": 30, "tilt_test": ("dynamics by springs", "steps", True),
      "tilt_test_until_deg": 80, "tilt_test_tolerance_deg": "0.1", "tilt_test_duration_s": 3, "tilt_test_damping": "0.7",
      "tilt_test_stiffness_gpa_m": (1000, 10), "tilt_test_rounding": "0.01", "tilt_test_time_step_s": "1e-6"},
     "block: {slab: {width: 50, height: 100}}\nfriction_angle_deg: 30\ntilt_test: {engine: dynamics, method: springs,"
     " protocol: steps, start: set_down, until_deg: 80, tolerance_deg: 0.1, duration_s: 3, damping: 0.7,"
     " normal_stiffness_gpa_m: 1000, shear_stiffness_gpa_m: 10, rounding: 0.01, time_step_s: 1e-6}"),
    ({"slab": (50, 100), "friction_angle_deg": 30, "tilt_test": ("dynamics by events",), "tilt_test_speed_deg_min": 30,
      "tilt_test_restitution": "0.5"},
     "block: {slab: {width: 50, height: 100}}\nfriction_angle_deg: 30\ntilt_test: {engine: dynamics, speed_deg_min: 30,"
     " restitution: 0.5}"),
    ({"slab": (50, 100), "friction_angle_deg": 30, "friction_is": "apparent"},
     "block: {slab: {width: 50, height: 100}}\nfriction_angle_deg: 30\nfriction_is: apparent"),
    ({"slab": (50, 100), "friction_angle_deg": 30, "tilt_test": ("path",), "tilt_test_tractions": [(1, 20, "10.5", -3)]},
     "block: {slab: {width: 50, height: 100}}\nfriction_angle_deg: 30\ntilt_test: {engine: path,"
     " tractions: [{facet: 1, normal_kpa: [20, 10.5], shear_kpa: -3}]}"),
    ({"slab": (50, 100), "friction_angle_deg": 30, "shaking_pulses": [("horizontally", "half sine", "0.4", 2)],
      "shaking_records": [("vertically", [(0, 0), (0.5, 0.1), (1, 0)], 2)]},
     "block: {slab: {width: 50, height: 100}}\nfriction_angle_deg: 30\n"
     "shaking: {horizontal: {half_sine: {peak_g: 0.4, frequency_hz: 2}}}"),
]
LAWS = [
    ({"friction_barton": (28, 6, 80)}, "{law: barton, residual_angle_deg: 28, jrc: 6, jcs_mpa: 80}"),
    ({"friction_barton_test": (28, 60, "0.5", 80)},
     "{law: barton, residual_angle_deg: 28, tilt_test: {angle_deg: 60, normal_stress_kpa: 0.5}, jcs_mpa: 80}"),
    ({"friction_barton_roughness": (28, 10, 80)},
     "{law: barton, residual_angle_deg: 28, roughness_angle_deg: 10, jcs_mpa: 80}"),
]
LOADS = [
    ({"seismic_horizontal": "0.1", "seismic_vertical": "0.05"}, "{seismic: {horizontal: 0.1, vertical: 0.05}}"),
    ({"seismic_horizontal": "0.1", "seismic_direction": "down_dip"}, "{seismic: {horizontal: 0.1, direction: down_dip}}"),
    ({"water": (40,)}, "{water: {height: 40}}"),
    ({"water": {"height": 30, "unit_weight_kn_m3": 10, "stays_level": True, "uplift": True}},
     "{water: {height: 30, unit_weight_kn_m3: 10, stays_level: true, uplift: true}}"),
    ({"water_level": {"level": 40, "faces": "both", "uplift": "triangular"}, "ice": (10, 5)},
     "{water: {level: 40, faces: both, uplift: triangular, ice_kpa: 10, ice_thickness: 5}}"),
    ({"water_surface": ([(-20, 30), (90, "60.5")], 10, "behind", "full"), "tension_crack_level": 50},
     "{water: {surface: [[-20, 30], [90, 60.5]], unit_weight_kn_m3: 10, faces: behind, uplift: full, tension_crack: {level: 50}}}"),
    ({"tension_crack_height": (30, 5)}, "{water: {tension_crack: {height: 30, distance: 5}}}"),
    ({"pressures": [(50, 20, 50, 40, 1, 2)]}, "{pressures: [{from: [50, 20], to: [50, 40], kpa: [1, 2]}]}"),
    ({"bolts": [(0, 60, 10, 0.5, True)]}, "{anchors: [{at: [0, 60], dip_deg: 10, force_kn: 0.5, passive: true}]}"),
    ({"support_pressures": [(0, 60, 0, 20, 2, 1)]}, "{support_pressures: [{from: [0, 60], to: [0, 20], kpa: [2, 1]}]}"),
    ({"surcharges": [(0, 100, 50, 100, 3)]}, "{surcharges: [{from: [0, 100], to: [50, 100], kpa: 3}]}"),
    ({"anchors": [(50, 50, -10, "0.001"), {"x": 0, "y": 50, "direction_deg": 0, "force_kn": "0.002", "passive": True}]},
     "{anchors: [{at: [50, 50], direction_deg: -10, force_kn: 0.001},"
     " {at: [0, 50], direction_deg: 0, force_kn: 0.002, passive: true}]}"),
    ({"bond_kpa": "0.1", "cohesion_kpa": "0.2"}, "{bond_kpa: 0.1, cohesion_kpa: 0.2}"),
]


#: A column beside a low block, with all that many blocks can be given, and the file that says the same.
BOX = {"ground": [(-9, -1), (9, -1), (9, 0), (-9, 0)], "low": [(0, 0), (2, 0), (2, 1), (0, 1)],
       "column": [(2, 0), (3, 0), (3, 5), (2, 5)]}
HOLE_OF_LOW, PART_OF_COLUMN = [(0.5, 0.25), (1, 0.25), (1, 0.75)], [(2.25, 1), (2.75, 1), (2.5, 2)]
BLOCKS = {
    "blocks": [(BOX["ground"], "ground", True), {"outline": BOX["low"]}, (BOX["column"], "column")],
    "unit_weight_kn_m3": 25, "friction_angle_deg": 31, "tilt_towards": "left", "block_unit_weights_kn_m3": [(2, "20.5")],
    "block_holes": [(2, HOLE_OF_LOW)], "block_parts": [(3, PART_OF_COLUMN, 19)], "joints": [(2, 3)],
    "joint_friction_angles_deg": [(1, 17)], "joint_cohesions_kpa": [(1, 4)], "joint_tensions_kpa": [(1, 1)],
    "bolts": [(0, "0.5", 20, 5, True)], "bolts_to": [(2, 4, 8, "-0.5", 30)], "bolts_into": [(1, 1)],
    "forces": [(0, "0.75", 0, 3)], "load_blocks": [("force", 1, 2), (topple.PlacedLoad.BOLT, 1, 2)],
    "support": (2, 0, "0.5"), "support_direction_deg": 10, "support_fos": "1.3"}
BLOCKS_TEXT = f"""topple: 1
length_unit: m
block: {{unit_weight_kn_m3: 25}}
friction_angle_deg: 31
tilt: {{towards: left}}
blocks:
  - {{name: ground, ground: true, outline: {[list(p) for p in BOX["ground"]]}}}
  - {{outline: {[list(p) for p in BOX["low"]]}, unit_weight_kn_m3: 20.5, holes: [{[list(p) for p in HOLE_OF_LOW]}]}}
  - {{name: column, outline: {[list(p) for p in BOX["column"]]},
     parts: [{{outline: {[list(p) for p in PART_OF_COLUMN]}, unit_weight_kn_m3: 19}}]}}
joints: [{{between: [2, column], friction_angle_deg: 17, cohesion_kpa: 4, tension_kpa: 1}}]
loads:
  anchors: [{{at: [0, 0.5], block: 2, dip_deg: 20, force_kn: 5, passive: true, into: ground}},
            {{at: [2, 4], to: [8, -0.5], force_kn: 30}}]
  forces: [{{block: 2, at: [0, 0.75], direction_deg: 0, force_kn: 3}}]
support: {{block: 2, at: [0, 0.5], direction_deg: 10, fos: 1.3}}
"""


class Scenes(unittest.TestCase):
    def check(self, given, text):
        with self.subTest(text):
            self.assertEqual(said(topple.Scene("mm", **given)), said(topple.Scene.from_text(text)))

    def test_every_call(self):
        """By its name given to Scene, which calls the method of that name."""
        for given, text in SAID:
            self.check(given, f"topple: 1\nlength_unit: mm\n{text}\n")
        for given, text in LAWS:
            self.check({**{k: v for k, v in WEIGHED.items() if k != "friction_angle_deg"}, **given},
                       WEIGHED_TEXT.replace("friction_angle_deg: 30", f"friction: {text}"))
        for given, text in LOADS:
            self.check({**WEIGHED, **given}, f"{WEIGHED_TEXT}loads: {text}\n")
        blocks = topple.Scene("m", **BLOCKS)
        self.assertEqual(said(blocks), said(topple.Scene.from_text(BLOCKS_TEXT)))
        self.assertEqual(said(copy.copy(blocks)), said(blocks))
        tried = {name for given, _ in SAID + LAWS + LOADS for name in given} | set(WEIGHED) | set(BLOCKS) | {"length_unit"}
        self.assertEqual(set(inspect.signature(topple.Scene).parameters) - tried, set())

    def test_every_call_of_the_library(self):
        """Each function of the headers is called somewhere in the package, or need not be."""
        text = "".join(path.read_text(encoding="utf-8") for path in SOURCES.glob("*.py"))
        needless = {
            "tp_exact_of", "tp_exact_text", "tp_coordinates_of", "tp_coordinates_text",  # structs made by cffi
            "tp_numbers_of", "tp_numbers_each", "tp_outlines_of", "tp_outlines_ragged",  # likewise
            "tp_solve_outline", "tp_report_json",  # said by Scene.solve, tp_report_json_pivots
            "tp_sweep",  # said by tp_sweep_write
            "tp_solution_case",  # of structs that a C program was compiled with
            "tp_scene_number", "tp_scene_with",  # said by tp_scene_number_text, tp_scene_with_numbers
            "tp_status_exit", "tp_version_number", "tp_plain_text",  # for programs and terminals
            "tp_figure_is_file_name", "tp_sheet_is_file_name", "tp_sheet_is_language", "tp_sheet_languages",
            "tp_batch_is_file_name", "tp_batch_standing_name",
            "tp_level_read", "tp_level_name", "tp_mechanism_name", "tp_find_target_read", "tp_find_target_name",
            "tp_accuracy_method_name", "tp_fos_definition_name", "tp_factor_standing_name", "tp_verdict_name", "tp_note_kind_name",
            "tp_profile_resampling_read", "tp_profile_resampling_name", "tp_profile_detrend_read", "tp_profile_detrend_name",
            "tp_profile_window_read", "tp_profile_window_name", "tp_jrc_state_name", "tp_settling_end_name",  # Word
            "tp_study_outcome_name", "tp_study_quantity_name",
            "tp_system_verdict_name", "tp_solid_outlook_name", "tp_solid_safety_of", "tp_joint_state_name", "tp_touch_state_name", "tp_column_state_name", "tp_system_load_kind_name",
            "tp_converge_quantity_name", "tp_converge_setting_name", "tp_converge_verdict_name", "tp_fault_name",
            "tp_tilt_engine_name", "tp_tilt_protocol_name", "tp_tilt_event_name", "tp_tilt_end_name",
        }
        for name in dir(lib):
            if name.startswith("tp_") and not re.search(r"_options_(default|init)$", name) and name not in needless:
                self.assertTrue(re.search(rf"lib\.{name}\b", text), name)

    def test_a_set_call_replaces(self):
        """A sweep sets one number again and again."""
        scene = topple.Scene("mm", outline=SQUARE)
        for angle in (20, "30", Fraction(81, 2)):
            scene.set_friction_angle_deg(angle)
            self.assertEqual(said(scene), said(topple.Scene("mm", outline=SQUARE, friction_angle_deg=angle)))


if __name__ == "__main__":
    main()
