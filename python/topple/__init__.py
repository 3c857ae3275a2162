# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Does a rock block stand, slide or topple on its base, and at which tilt?

    import topple

    points = [(0, 0), (50, 0), (50, 100), (0, 100)]
    scene = topple.Scene("mm", outline=points, friction_angle_deg=30)
    print(scene.solve().report())

Every computed number is a `Bounded`, a value and a proven error. SI units and degrees, as the names
of fields say. Failures raise a `ToppleError`. docs/python.md has more."""

from ._library import ffi as _ffi, lib as _lib
from .accuracy import Accuracy, AccuracyRun, AccuracyValue, accuracy_of_scene, accuracy_sweep
from .base_builder import BaseBound, LeftEnd, RoughnessBy, Wear
from .blocks import (AreaMoments, CriticalAngles, Moments, Status, Summary, Verdicts,
                     critical_angles, moments, outline_moments, verdicts)
from .builder import Along, SeismicDirection, Towards, UndersideEnd
from .case import Case, Factor, GoverningFos, LoadResult, Pivot, Sliding, Toe
from .chart import (Chart, chart_fos, chart_map, chart_mechanisms, chart_overturning, chart_ranges,
                    chart_study, chart_study_scatter, chart_tilt_phase, chart_tilt_reactions)
from .contact import (Account, Block, Contact, Earthquake, Effect, Element, FacetFriction, Fos, Frame,
                      Joint, Note, Rest, ResultUnit, ResultUnits, Setting, Teeth, Within)
from .converge import (Convergence, ConvergenceCase, ConvergeFinding, ConvergeLevel,
                        tilt_converge)
from .derivation import (DerivedCheck, DerivedElement, DerivedLimit, DerivedOnset, DerivedPivot,
                         DerivedReaction, DerivedRounding, DerivedRow)
from .derive import Derivation, Family, FamilyFormula, derive, derive_family
from .errors import (BadInput, Caution, DependencyFailed, FileNotFound, NoAnswer, OutOfMemory,
                     PermissionDenied, SystemFailed, ToppleError, Undecided)
from .explain import explain, terms
from .find import Found, FoundInterval, find
from .formula import Fraction
from .limit import (Limit, Motion, MotionContact, MotionRange, MotionResistance, Onset, Reaction,
                    Window)
from .poses import Basin, Poses, PoseVerdict, RestingPose
from .profile import (Profile, ProfileDensity, ProfileEstimate, ProfileFacing, ProfileJrc,
                      ProfileLag, profile_of_file, profile_of_points, profile_of_scene)
from .record import Bounded
from .scene import Scene
from .solution import Solution, csv, table
from .study import (StudyBad, StudyCorrelation, StudyDesign, StudyDesignPoint, StudyFactor,
                    StudyIndex, StudyMeasure, StudyQuantile, StudyRank, StudyRare,
                    StudyReliability, StudyResult, StudyShare, StudySpread, StudyStep, StudyTilt,
                    StudyVariable, study)
from .sweep import Sweep, sweep, write_sweep
from .tilt import (OverturningGrid, OverturningRange, TiltCase, TiltEvent, TiltFacet, TiltMoment, TiltPoint, TiltReaction,
                   TiltSettings, TiltShaking, TiltTest, tilt_test)
from .verify import ClaimResult, Verification, verify, verify_text
from .words import (AccuracyMethod, CheckVerdict, ContactEnd, ContactState, ConvergeQuantity,
                    ConvergeSetting, ConvergeVerdict, Design, Direction,
                    ElementKind, FactorStanding, FindTarget, FosDefinition, FosState, JrcState, Level,
                    LimitKind,
                    LoadSide, Mechanism, Notation, NoteKind, OnsetKind, PivotKind, PivotsListed,
                    ProfileDetrend, ProfileOrigin, ProfileResampling, ProfileSeries, ProfileWindow,
                    PulseShape, Rolls, SettlingEnd, ShakingAxis, StudyEnd, StudyOutcome,
                    StudyQuantity, TiltEnd, TiltEngine, TiltEventKind, TiltPlace, TiltProtocol,
                    Verdict)

__version__ = _ffi.string(_lib.tp_version()).decode()
