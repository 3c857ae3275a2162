# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Does a rock block stand, slide or topple on its base, and at which tilt?

    import topple

    points = [(0, 0), (50, 0), (50, 100), (0, 100)]
    scene = topple.Scene("mm", outline=points, friction_angle_deg=30)
    print(scene.solve().report())

Every solved number is a `Bounded`, a value and a proven error; numbers of simulations and what samples
estimate have no proven error and are floats. SI units and degrees, as the names of fields say. Failures
raise a `ToppleError`. docs/python.md has more."""

import sys as _sys

try:
    from . import records as _records, words as _words
    from ._library import ffi as _ffi, lib as _lib
except ImportError as _error:
    raise ImportError(
        f"topple is not built for this Python, {_sys.version.split()[0]}: './run --with python --setup' in Topple's folder "
        "installs what it needs and builds it for the Python that it finds, which then has it by PYTHONPATH=build/python"
    ) from _error
from .accuracy import accuracy_of_scene, accuracy_sweep
from .base_builder import BaseBound, LeftEnd, RoughnessBy, Wear
from .blocks_builder import PlacedLoad
from .batch import batch, batch_text
from .blocks import (AreaMoments, CriticalAngles, Moments, Status, Summary, Verdicts,
                     critical_angles, moments, outline_moments, verdicts)
from .builder import (Along, FrictionIs, SeismicDirection, Towards, UndersideEnd, WaterFaces,
                      WaterUplift)
from .chart import (Chart, chart_fos, chart_map, chart_mechanisms, chart_overturning, chart_ranges,
                    chart_study, chart_study_scatter, chart_tilt_phase, chart_tilt_reactions)
from .converge import tilt_converge
from .derive import derive, derive_family
from .errors import (BadInput, Caution, DependencyFailed, FileNotFound, NoAnswer, OutOfMemory,
                     PermissionDenied, SystemFailed, ToppleError, Undecided)
from .explain import explain, terms
from .find import find
from .profile import profile_of_file, profile_of_points, profile_of_scene
from .record import Bounded
from .records import *  # noqa: F403
from .running import Interrupted
from .scene import Scene
from .solid import solid_of_file
from .solution import csv, table
from .study import study, study_text
from .sweep import Sweep, sweep, write_sweep
from .tilt import tilt_test
from .verify import verify, verify_text
from .words import *  # noqa: F403

__version__ = _ffi.string(_lib.tp_version()).decode()
if (_built := _ffi.string(_lib.built_version()).decode()) != __version__:
    raise ImportError(f"this package was built for libtopple {_built}, and loads libtopple {__version__}: install both of the "
                      "same version")

__all__ = ["Along", "AreaMoments", "BadInput", "BaseBound", "Bounded", "Caution", "Chart", "CriticalAngles",
           "DependencyFailed", "FileNotFound", "FrictionIs", "Interrupted", "LeftEnd", "Moments", "NoAnswer", "OutOfMemory",
           "PermissionDenied", "PlacedLoad", "RoughnessBy", "Scene", "SeismicDirection", "Status", "Summary", "Sweep",
           "SystemFailed", "ToppleError", "Towards", "Undecided", "UndersideEnd", "Verdicts", "WaterFaces", "WaterUplift", "Wear",
           "accuracy_of_scene", "accuracy_sweep", "batch", "batch_text", "chart_fos", "chart_map", "chart_mechanisms",
           "chart_overturning", "chart_ranges", "chart_study", "chart_study_scatter", "chart_tilt_phase",
           "chart_tilt_reactions", "critical_angles", "csv", "derive", "derive_family", "explain", "find",
           "moments", "outline_moments", "profile_of_file", "profile_of_points", "profile_of_scene", "solid_of_file", "study",
           "study_text", "sweep", "table", "terms", "tilt_converge", "tilt_test", "verdicts", "verify",
           "verify_text", "write_sweep"]
__all__ += _records.__all__ + _words.__all__
