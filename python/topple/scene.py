# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A scene: built in memory, or read from a file or a text."""

from __future__ import annotations

import copy
import fractions
import functools
import os
import threading
import warnings
from collections.abc import Mapping
from typing import Any, Iterable, Sequence

from ._library import ffi, lib
from .builder import Along, Builder, FrictionIs, SeismicDirection, Towards
from .errors import BadInput, Caution, checked
from .given import File, Number, Points, c_number, c_path, c_text
from .options import options_of
from .record import record, text as text_of
from .records import BlockSystem, LoadCases, Note, Solid, Solution
from .report import taken, written
from .word import number_of
from .words import Level, NoteKind, PivotsListed

RECEIVES_SCENE = ffi.typeof("tp_scene **")
RECEIVES_SOLUTION = ffi.typeof("tp_solution **")
DEFAULTS = options_of("solve")
#: What a call of several arguments is given: by their order, or by their names.
Given = Mapping[str, Any] | Sequence[Any]


class Scene(Builder):
    """A block on its base.

        scene = topple.Scene("mm", outline=points, friction_angle_deg=30)

    What is given by name means what the call `set_…` of that name means: `outline`,
    `friction_angle_deg`, or a number that `set_number` takes by its key: `joint_shift` is
    "joint.shift", `bond_kpa` "loads.bond_kpa". A call of several arguments takes a sequence or a mapping of them,
    slab=(50, 100), water={"height": 40, "uplift": True}; what is added (`holes`, `anchors`), a list
    of such. What is not given is as in a scene file without the key: a mated base, tilt both ways,
    no friction. `length_unit` is mm, cm, m, km, in or ft.

    A scene may be solved by several threads at once; changed while another thread uses it, it
    raises RuntimeError."""

    def __init__(self, length_unit: str, *, title: str | None = None, outline: Points | None = None,
                 slab: Given | None = None, teeth: Given | None = None,
                 teeth_over: Given | None = None, ellipse: Given | None = None,
                 holes: Iterable[Points] = (), parts: Iterable[Given] = (),
                 arcs_through: Iterable[Given] = (), arcs_bulge: Iterable[Given] = (),
                 rounded_ends: Iterable[Given] = (), rounded_vertices: Iterable[Given] = (),
                 rounding_keeps_mass: bool | None = None, repair: bool | None = None,
                 thickness: Number | None = None, unit_weight_kn_m3: Number | None = None,
                 base_mated: bool | None = None, base_profile: Points | None = None,
                 base_teeth: Given | None = None, base_self_affine: Given | None = None,
                 base_jrc_profile: int | None = None, base_noise: Given | None = None,
                 base_scaled: Given | None = None, base_worn: Given | None = None,
                 base_beyond: Given | None = None, base_between: Points | None = None,
                 base_bound: Given | None = None, base_rest: bool | None = None,
                 base_poses: bool | None = None, contact_within: Number | None = None,
                 contact_width: Number | None = None, joint_shift: Number | None = None, joint_matching: Given | None = None,
                 joint_closure: Number | None = None,
                 friction_angle_deg: Number | None = None, friction_patton: Given | None = None,
                 friction_barton: Given | None = None, friction_barton_test: Given | None = None,
                 friction_barton_roughness: Given | None = None,
                 friction_is: FrictionIs | str | None = None,
                 friction_facets: Iterable[Given] = (), friction_between: Iterable[Given] = (),
                 tilt_towards: Towards | str | None = None, tilt_angle_deg: Number | None = None,
                 frame: Along | str | None = None, slope: Given | None = None,
                 mean_plane: Points | None = None,
                 seismic_horizontal: Number | None = None, seismic_vertical: Number | None = None,
                 seismic_direction: SeismicDirection | str | None = None,
                 water: Given | None = None, water_level: Given | None = None,
                 water_surface: Given | None = None, tension_crack_level: Number | None = None,
                 tension_crack_height: Given | None = None, ice: Given | None = None,
                 blocks: Iterable[Given] = (), block_unit_weights_kn_m3: Iterable[Given] = (),
                 block_holes: Iterable[Given] = (), block_parts: Iterable[Given] = (),
                 joints: Iterable[Given] = (), joint_friction_angles_deg: Iterable[Given] = (),
                 joint_cohesions_kpa: Iterable[Given] = (), joint_tensions_kpa: Iterable[Given] = (),
                 pressures: Iterable[Given] = (),
                 surcharges: Iterable[Given] = (), anchors: Iterable[Given] = (),
                 bolts: Iterable[Given] = (), support_pressures: Iterable[Given] = (),
                 bolts_to: Iterable[Given] = (), forces: Iterable[Given] = (),
                 bolts_into: Iterable[Given] = (), load_blocks: Iterable[Given] = (),
                 support: Given | None = None, support_direction_deg: Number | None = None, support_fos: Number | None = None,
                 bond_kpa: Number | None = None, cohesion_kpa: Number | None = None,
                 tilt_test: Given | None = None, tilt_test_speed_deg_min: Number | None = None,
                 tilt_test_until_deg: Number | None = None,
                 tilt_test_tolerance_deg: Number | None = None,
                 tilt_test_duration_s: Number | None = None,
                 tilt_test_stiffness_gpa_m: Given | None = None,
                 tilt_test_damping: Number | None = None,
                 tilt_test_rounding: Number | None = None,
                 tilt_test_time_step_s: Number | None = None,
                 tilt_test_restitution: Number | None = None,
                 tilt_test_tractions: Iterable[Given] = (),
                 shaking_pulses: Iterable[Given] = (),
                 shaking_records: Iterable[Given] = ()) -> None:
        given = locals()
        receives = ffi.new(RECEIVES_SCENE)
        checked(lib.tp_scene_new, receives, c_text(length_unit))
        self._own(receives, "new", length_unit)
        for name, call in ADD.items():
            for value in given[name]:
                call(self, value)
        for name, call in SET.items():
            value = given[name]
            if value is not None:
                call(self, value)

    @classmethod
    def read(cls, path: File) -> Scene:
        """The scene in a file. Files that it names are looked for beside it."""
        receives = ffi.new(RECEIVES_SCENE)
        checked(lib.tp_scene_read, receives, c_path(path))
        return cls._made(receives, "read", os.path.abspath(path))

    @classmethod
    def read_with(cls, path: File, *settings: str, unit: str | None = None) -> Scene:
        """The same with settings KEY=FORMULA. In place of a scene a drawing may be given, DXF, SVG,
        WKT, GeoJSON, CSV, Shapefile or GeoPackage, or a mesh, STL, PLY or OBJ: `unit` is then that of its lengths, where its file does not say it:
        Scene.read_with("section.dxf", "friction_angle_deg=30", unit="mm")."""
        receives = ffi.new(RECEIVES_SCENE)
        texts = [c_text(setting) for setting in settings]
        checked(lib.tp_scene_read_with, receives, c_path(path),
                c_text("" if unit is None else unit), ffi.new("const char *[]", texts),
                len(texts))
        return cls._made(receives, "read_with", os.path.abspath(path), settings, unit)

    def report_drawing(self) -> str:
        """The role of each object of its drawing; empty without a drawing."""
        return written(lib.tp_report_drawing, self._c)

    @classmethod
    def from_text(cls, text: str, name: str = "scene") -> Scene:
        """The same from text; `name` is what messages call it, and files are looked for beside a
        file of that name."""
        receives = ffi.new(RECEIVES_SCENE)
        checked(lib.tp_scene_read_text, receives, c_text(text), c_path(name))
        return cls._made(receives, "from_text", text, os.path.abspath(name))

    @classmethod
    def _made(cls, receives: Any, *made_by: Any) -> Scene:
        scene = cls.__new__(cls)
        scene._own(receives, *made_by)
        return scene

    def __reduce__(self) -> Any:
        """A copy, in this or in another process, is made as this one was: files are read again."""
        return _remade, (*self._made_by, self._calls)

    def _own(self, receives: Any, *made_by: Any) -> None:
        self._made_by: tuple[Any, ...] = made_by
        self._calls: list[tuple[str, Any, Any]] = []
        self._c = ffi.gc(receives[0], lib.tp_scene_free)
        self._lock = threading.Lock()
        self._users = 0
        self._version = 0

    def _change(self, call: Any, *arguments: Any) -> None:
        with self._lock:
            if self._users:
                raise RuntimeError("the scene is being used by another thread")
            checked(call, self._c, *arguments)
            self._version += 1

    def _use(self, call: Any, *arguments: Any, of: int | None = None) -> int:
        """A call that reads the scene, during which no thread may change it; `of` the version of
        its numbers that is meant. The version that was read."""
        with self._lock:
            if of not in (None, self._version):
                raise BadInput("the scene was changed since it was solved: solve it again")
            self._users += 1
        try:
            checked(call, *arguments)
            return self._version
        finally:
            with self._lock:
                self._users -= 1

    def number(self, key: str) -> fractions.Fraction:
        """The number at a key, exactly: the way to it in a scene file, as block.outline.3.1, or the
        name of a parameter."""
        receives = ffi.new("char **")
        self._use(lib.tp_scene_number_text, receives, self._c, c_text(key))
        top, _, bottom = taken(receives[0]).partition("/")
        return fractions.Fraction(top) / fractions.Fraction(bottom or 1)

    def profile_csv(self) -> str:
        """The profile of the base, given, read or generated, as CSV of x, y with all its digits."""
        receives = ffi.new("char **")
        self._use(lib.tp_scene_profile_csv, receives, self._c)
        return taken(receives[0])

    def write_profile(self, path: File) -> None:
        """The same into a file, which appears whole or not at all."""
        self._use(lib.tp_scene_write_profile, c_path(path), self._c)

    def varied(self, numbers: Mapping[str, Number]) -> Scene:
        """Another scene, in which the numbers at some keys are others, exactly, and all else is as
        in this one: scene.varied({"friction_angle_deg": 35, "block.outline.3.1": "60.5"})."""
        keys = [c_text(key) for key in numbers]
        values = [c_number(value) for value in numbers.values()]
        receives = ffi.new(RECEIVES_SCENE)
        self._use(lib.tp_scene_with_numbers, receives, self._c, ffi.new("const char *[]", keys),
                  ffi.new("tp_exact[]", values), len(keys))
        return self._made(receives, "varied", self.__reduce__()[1], dict(numbers))

    def with_settings(self, *settings: str) -> Scene:
        """Another scene by settings KEY=FORMULA, as `topple solve --set` takes them: each number is
        what its formula says as if it stood there in the file. Its solution has them in `settings`:
        scene.with_settings("a=40", "b=2*a+1/3")."""
        receives = ffi.new(RECEIVES_SCENE)
        texts = [c_text(setting) for setting in settings]
        self._use(lib.tp_scene_with_settings, receives, self._c,
                  ffi.new("const char *[]", texts), len(texts))
        return self._made(receives, "with_settings", self.__reduce__()[1], settings)

    @property
    def cases(self) -> tuple[str, ...]:
        """The names of its load cases, in their order; empty where it has none (docs/cases.md)."""
        return tuple(text_of(lib.tp_scene_load_case_name(self._c, k)) or ""
                     for k in range(lib.tp_scene_load_case_count(self._c)))

    def load_case(self, name: str) -> Scene:
        """The scene of a load case by its name, which has no cases:
        scene.load_case("wet").solve()."""
        receives = ffi.new(RECEIVES_SCENE)
        self._use(lib.tp_scene_load_case, receives, self._c, c_text(name))
        return self._made(receives, "load_case", self.__reduce__()[1], name)

    def solve_load_cases(self, *settings: str, digits: int | None = None,
                         elements: bool | None = None, limit: bool | None = None,
                         strength_reduction: bool | None = None, motion_ranges: bool | None = None,
                         level: Level | str | None = None, pivots: PivotsListed | str | None = None,
                         threads: int | None = None) -> LoadCases:
        """All load cases of the scene, the one that governs first. `settings` KEY=FORMULA are
        numbers that hold in every case; the rest is as of `solve`."""
        options = solve_options(digits, elements, limit, strength_reduction, motion_ranges, level,
                                pivots, threads)
        receives = ffi.new("tp_load_cases **")
        texts = [c_text(setting) for setting in settings]
        self._use(lib.tp_solve_load_cases, receives, self._c, ffi.new("const char *[]", texts),
                  len(texts), options)
        owner = ffi.gc(receives[0], lib.tp_load_cases_free)
        return record(LoadCases, owner[0], owner)

    @property
    def block_count(self) -> int:
        """How many blocks the scene lists, with those that are ground; 0: it is of one block."""
        return int(lib.tp_scene_block_count(self._c))

    def solve_block_system(self, *, strength_reduction: bool | None = None) -> BlockSystem:
        """The stability of a scene of many blocks. `strength_reduction`: its factor of safety."""
        options = solve_options(None, None, None, strength_reduction, None, None, None, None)
        receives = ffi.new("tp_block_system **")
        version = self._use(lib.tp_solve_block_system, receives, self._c, options)
        owner = ffi.gc(receives[0], lib.tp_block_system_free)
        system = record(BlockSystem, owner[0], owner)
        system.__dict__.update(_scene=self, _version=version)
        return system

    @property
    def is_solid(self) -> bool:
        """Is the scene one of a solid?"""
        return bool(lib.tp_scene_is_solid(self._c))

    def solve_solid(self) -> Solid:
        """The solid of such a scene, as it lies at the scene's tilt."""
        receives = ffi.new("tp_solid **")
        version = self._use(lib.tp_solve_solid, receives, self._c)
        owner = ffi.gc(receives[0], lib.tp_solid_free)
        solid = record(Solid, owner[0], owner)
        solid.__dict__.update(_scene=self, _version=version)
        if owner.notes.count:
            warn(solid.notes, 3)
        return solid

    def solve(self, *, digits: int | None = None, elements: bool | None = None,
              limit: bool | None = None, strength_reduction: bool | None = None,
              motion_ranges: bool | None = None, level: Level | str | None = None,
              pivots: PivotsListed | str | None = None, threads: int | None = None) -> Solution:
        """The stability of the block in each direction of tilt that the scene asks for.

        `digits`: relative accuracy 10^-digits asked of every number, 1 to 1000. `elements`: the
        account of moments by elements. `limit`: the static limit and the onset of motion, where the
        scene gives friction. `strength_reduction`: its factor of safety. `motion_ranges`: which
        motions can begin at every tilt. `level`: the costliest arithmetic allowed. `pivots`: which
        get their numbers. `threads` compute; 0: as many as the process may run on.
        None: as `topple solve` does.

        A caution is issued as a warning, `topple.Caution`; all notes are in `notes` of the
        solution."""
        options = solve_options(digits, elements, limit, strength_reduction, motion_ranges, level,
                                pivots, threads)
        receives = ffi.new(RECEIVES_SOLUTION)
        version = self._use(lib.tp_solve, receives, self._c, options)
        owner = ffi.gc(receives[0], lib.tp_solution_free)
        solution = record(Solution, owner[0], owner)
        solution.__dict__.update(_scene=self, _version=version)
        if owner.notes.count:
            warn(solution.notes, 3)
        return solution


def _remade(how: str, of: Any, *more: Any) -> Scene:
    """A scene as another one was made: how, of what, and by which calls since then."""
    *given, calls = more
    if how == "new":
        scene = Scene(of)
    elif how == "load_case":
        scene = _remade(*of).load_case(*given)
    elif how in ("varied", "with_settings"):
        (settings,) = given
        first = _remade(*of)
        scene = first.varied(settings) if how == "varied" else first.with_settings(*settings)
    elif how == "read_with":
        settings, unit = given
        scene = Scene.read_with(of, *settings, unit=unit)
    else:
        scene = Scene.read(of) if how == "read" else Scene.from_text(of, *given)
    for name, arguments, named in calls:
        getattr(scene, name)(*arguments, **named)
    return scene


def _copied(value: Any) -> Any:
    """An argument that no caller can change any more."""
    if isinstance(value, (str, float, int, type(None))):
        return value
    return value.copy() if hasattr(value, "__array__") else copy.deepcopy(value)


def _kept(name: str) -> Any:
    """A call that changes a scene, kept for copies of it."""
    method = getattr(Builder, name)

    @functools.wraps(method)
    def call(self: Scene, *arguments: Any, **named: Any) -> None:
        method(self, *arguments, **named)
        self._calls.append((name, tuple(map(_copied, arguments)), {key: _copied(value) for key, value in named.items()}))

    return call


for _name in dir(Builder):
    if _name.startswith(("set_", "add_")):
        setattr(Scene, _name, _kept(_name))


def solve_options(digits: Any, elements: Any, limit: Any, strength_reduction: Any, motion_ranges: Any, level: Any, pivots: Any,
                  threads: Any) -> Any:
    """The defaults, but for what is not None."""
    if (digits is None and elements is None and limit is None and strength_reduction is None
            and motion_ranges is None and level is None and pivots is None and threads is None):
        return DEFAULTS
    return options_of("solve", digits=digits, elements=elements, limit=limit,
                      strength_reduction=strength_reduction, motion_ranges=motion_ranges,
                      level=None if level is None else number_of(Level, level),
                      pivots=None if pivots is None else number_of(PivotsListed, pivots),
                      threads=threads)


def warn(notes: Iterable[Note], depth: int) -> None:
    """Issue the cautions as warnings, at the caller's caller and so on."""
    for note in notes:
        if note.kind is NoteKind.CAUTION:
            warnings.warn(f"{note.place}: {note.text}" if note.place else note.text, Caution,
                          stacklevel=depth)


def _spread(call: Any) -> Any:
    """A call of several arguments as one of a sequence or a mapping."""

    def spread(scene: Scene, value: Given) -> None:
        if isinstance(value, Mapping):
            call(scene, **value)
        else:
            call(scene, *value)

    return spread


def _by_key(key: str) -> Any:
    """A number that stands by itself."""
    def put(scene: Scene, value: Number) -> None:
        scene.set_number(key, value)

    return put


SET = {
    "title": Scene.set_title,
    "outline": Scene.set_outline,
    "slab": _spread(Scene.set_slab),
    "teeth": _spread(Scene.set_teeth),
    "teeth_over": _spread(Scene.set_teeth_over),
    "ellipse": _spread(Scene.set_ellipse),
    "rounding_keeps_mass": Scene.set_rounding_keeps_mass,
    "repair": Scene.set_repair,
    "thickness": Scene.set_thickness,
    "unit_weight_kn_m3": Scene.set_unit_weight_kn_m3,
    "base_mated": Scene.set_base_mated,
    "base_profile": Scene.set_base_profile,
    "base_teeth": _spread(Scene.set_base_teeth),
    "base_self_affine": _spread(Scene.set_base_self_affine),
    "base_jrc_profile": Scene.set_base_jrc_profile,
    "base_noise": _spread(Scene.set_base_noise),
    "base_scaled": _spread(Scene.set_base_scaled),
    "base_worn": _spread(Scene.set_base_worn),
    "base_beyond": _spread(Scene.set_base_beyond),
    "base_between": Scene.set_base_between,
    "base_bound": _spread(Scene.set_base_bound),
    "base_rest": Scene.set_base_rest,
    "base_poses": Scene.set_base_poses,
    "contact_within": _by_key("contact.within"),
    "contact_width": _by_key("contact.width"),
    "joint_shift": _by_key("joint.shift"),
    "joint_matching": _spread(Scene.set_joint_matching),
    "joint_closure": _by_key("joint.closure"),
    "friction_angle_deg": Scene.set_friction_angle_deg,
    "friction_patton": _spread(Scene.set_friction_patton),
    "friction_barton": _spread(Scene.set_friction_barton),
    "friction_barton_test": _spread(Scene.set_friction_barton_test),
    "friction_barton_roughness": _spread(Scene.set_friction_barton_roughness),
    "friction_is": Scene.set_friction_is,
    "tilt_towards": Scene.set_tilt_towards,
    "tilt_angle_deg": Scene.set_tilt_angle_deg,
    "frame": Scene.set_frame,
    "slope": _spread(Scene.set_slope),
    "mean_plane": Scene.set_mean_plane,
    "seismic_horizontal": _by_key("loads.seismic.horizontal"),
    "seismic_vertical": _by_key("loads.seismic.vertical"),
    "seismic_direction": Scene.set_seismic_direction,
    "water": _spread(Scene.set_water),
    "water_level": _spread(Scene.set_water_level),
    "water_surface": _spread(Scene.set_water_surface),
    "tension_crack_level": Scene.set_tension_crack_level,
    "tension_crack_height": _spread(Scene.set_tension_crack_height),
    "ice": _spread(Scene.set_ice),
    "support": _spread(Scene.set_support),
    "support_direction_deg": _by_key("support.direction_deg"),
    "support_fos": _by_key("support.fos"),
    "bond_kpa": _by_key("loads.bond_kpa"),
    "cohesion_kpa": _by_key("loads.cohesion_kpa"),
    "tilt_test": _spread(Scene.set_tilt_test),
    "tilt_test_speed_deg_min": _by_key("tilt_test.speed_deg_min"),
    "tilt_test_until_deg": _by_key("tilt_test.until_deg"),
    "tilt_test_tolerance_deg": _by_key("tilt_test.tolerance_deg"),
    "tilt_test_duration_s": _by_key("tilt_test.duration_s"),
    "tilt_test_stiffness_gpa_m": _spread(Scene.set_tilt_test_stiffness_gpa_m),
    "tilt_test_damping": _by_key("tilt_test.damping"),
    "tilt_test_rounding": _by_key("tilt_test.rounding"),
    "tilt_test_time_step_s": _by_key("tilt_test.time_step_s"),
    "tilt_test_restitution": _by_key("tilt_test.restitution"),
}
ADD = {
    "blocks": _spread(Scene.add_block),
    "block_unit_weights_kn_m3": _spread(Scene.set_block_unit_weight_kn_m3),
    "block_holes": _spread(Scene.add_block_hole),
    "block_parts": _spread(Scene.add_block_part),
    "joints": _spread(Scene.add_joint),
    "joint_friction_angles_deg": _spread(Scene.set_joint_friction_angle_deg),
    "joint_cohesions_kpa": _spread(Scene.set_joint_cohesion_kpa),
    "joint_tensions_kpa": _spread(Scene.set_joint_tension_kpa),
    "holes": Scene.add_hole,
    "parts": _spread(Scene.add_part),
    "arcs_through": _spread(Scene.add_arc_through),
    "arcs_bulge": _spread(Scene.add_arc_bulge),
    "rounded_ends": _spread(Scene.add_rounded_end),
    "rounded_vertices": _spread(Scene.add_rounded_vertex),
    "friction_facets": _spread(Scene.add_friction_facets),
    "friction_between": _spread(Scene.add_friction_between),
    "pressures": _spread(Scene.add_pressure),
    "surcharges": _spread(Scene.add_surcharge),
    "anchors": _spread(Scene.add_anchor),
    "bolts": _spread(Scene.add_bolt),
    "bolts_to": _spread(Scene.add_bolt_to),
    "bolts_into": _spread(Scene.set_bolt_into),
    "support_pressures": _spread(Scene.add_support_pressure),
    "forces": _spread(Scene.add_force),
    "load_blocks": _spread(Scene.set_load_block),
    "tilt_test_tractions": _spread(Scene.add_tilt_test_traction),
    "shaking_pulses": _spread(Scene.set_shaking_pulse),
    "shaking_records": _spread(Scene.set_shaking_record),
}
