# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Reports in the units that a scene asks for: every printed digit is that of the exact number, converted by the definitions
of foot, pound and standard gravity in rationals; JSON and CSV stay as they are."""

import pathlib
import re
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, main, run, solve

FOOT, INCH = Fraction("0.3048"), Fraction("0.0254")
KGF = Fraction("9.80665")
LBF = Fraction("0.45359237") * KGF
EXACT = {
    "length": {"mm": Fraction(1, 1000), "cm": Fraction(1, 100), "m": Fraction(1), "km": Fraction(1000), "in": INCH, "ft": FOOT},
    "force": {"N": Fraction(1), "kN": Fraction(1000), "MN": Fraction(10**6), "kgf": KGF, "tf": 1000 * KGF, "lbf": LBF, "kip": 1000 * LBF},
    "moment": {"N m": Fraction(1), "kN m": Fraction(1000), "MN m": Fraction(10**6), "tf m": 1000 * KGF, "lbf ft": LBF * FOOT,
               "kip ft": 1000 * LBF * FOOT},
    "stress": {"Pa": Fraction(1), "kPa": Fraction(1000), "MPa": Fraction(10**6), "kgf/cm2": KGF * 10**4, "psi": LBF / INCH**2,
               "psf": LBF / FOOT**2, "ksf": 1000 * LBF / FOOT**2},
}
# A slab of 3 m by 7 m and 1.3 m of 26.5 kN/m3, whose weight and mean stress are exact.
SLAB = "topple: 1\ntitle: A slab\nlength_unit: m\nblock: {slab: {width: 3, height: 7}, thickness: 1.3, unit_weight_kn_m3: 26.5}\n" \
       "base: {mated: true}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 10}\n"
WEIGHT = Fraction(3) * 7 * Fraction("1.3") * 26500
STRESS = Fraction(7) * 26500
DEEP = "loads: {seismic: {horizontal: 0.1}}\n"


class Units(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)

    def write(self, text):
        (self.folder / "scene.yaml").write_text(text, encoding="utf-8")

    def report(self, text, *options):
        self.write(text)
        status, out, err = run("solve", *options, "scene.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        return out

    def holds(self, printed, exact):
        """As many digits as were printed are those of the exact number, which may lie half of the last one away."""
        mantissa, _, exponent = printed.partition("e")
        decimals = len(mantissa.partition(".")[2])
        place = Fraction(10) ** (int(exponent or 0) - decimals)
        self.assertLessEqual(abs(Fraction(printed) - exact), place / 2, (printed, float(exact)))
        self.assertGreaterEqual(len(mantissa.replace(".", "").lstrip("0")), 1)

    def test_table(self):
        """Its factors are the definitions, and whole numbers that a double holds."""
        rows = re.findall(r'X\((\w+), "([^"]+)", (\d+), (\d+)\)', (ROOT / "src/input/scene/units_table.h").read_text(encoding="utf-8"))
        self.assertEqual([(kind.lower(), name) for kind, name, _, _ in rows], [(kind, name) for kind in EXACT for name in EXACT[kind]])
        for kind, name, over, under in rows:
            self.assertEqual(Fraction(int(over), int(under)), EXACT[kind.lower()][name], name)
            self.assertLess(max(int(over), int(under)), 2**53)

    def test_every_force_and_stress(self):
        for force, one in EXACT["force"].items():
            out = self.report(SLAB + f"result_units: {{force: {force}}}\n")
            self.assertIn(f"Units    forces in {force}\n", out)
            self.holds(re.search(rf"weight (\S+) {force}\n", out).group(1), WEIGHT / one)
        for stress, one in EXACT["stress"].items():
            out = self.report(SLAB + f"result_units: {{stress: {stress}}}\n")
            found = re.findall(rf"(?:per area|mean plane) (\S+) {re.escape(stress)}", out)
            self.assertEqual(len(found), 2, out)
            for printed in found:
                self.holds(printed, STRESS / one)

    def test_every_length(self):
        """The slab's pivot and contact; a scene in feet asked for in metres."""
        for length, one in EXACT["length"].items():
            out = self.report(SLAB + f"result_units: {{length: {length}}}\n")
            self.holds(re.search(rf"1 facet, (\S+) {length} long", out).group(1), 3 / one)
            self.holds(re.search(rf"area (\S+) {length}²", out).group(1), 21 / one**2)
        out = self.report(SLAB.replace("length_unit: m", "length_unit: ft") + "result_units: {length: m}\n")
        self.holds(re.search(r"1 facet, (\S+) m long", out).group(1), 3 * FOOT)

    def test_moments(self):
        """Of a load: 0.1 of the weight at half of the height, about the toe, as JSON has it in N m; and of elements, whose
        sum about the toe stabilises by the weight times half the width at a tilt of 0."""
        for moment, one in EXACT["moment"].items():
            out = self.report(SLAB + DEEP + f"result_units: {{moment: {moment}}}\n")
            loads = solve("scene.yaml", folder=self.folder)["cases"][0]["loads"]
            self.assertGreaterEqual(len(loads), 2)
            for load in loads:
                found = re.search(rf"    {load['name']} +(\S+) {moment} ", out)
                self.assertIsNotNone(found, out)
                self.holds(found.group(1), Fraction(load["moment_nm"]["value"]) / one)
        level = SLAB.replace("angle_deg: 10", "angle_deg: 0")
        out = self.report(level + "result_units: {moment: kip ft, force: kip}\n", "--elements")
        self.assertIn("weight (kip)", out)
        self.assertIn("(kip ft)", out)
        self.holds(re.search(r"  sum +(\S+) ", out).group(1), WEIGHT * Fraction(3, 2) / EXACT["moment"]["kip ft"])

    def test_sheet(self):
        """A calculation sheet has the same units in its tables and in its formulas, whose quotient stays what it was."""
        sheets = []
        for more in ("", "result_units: {force: kip, moment: kip ft, stress: psf, length: ft}\n"):
            for load in ("", DEEP):
                self.report(SLAB + load + more, "--report", "sheet.md")
                sheets.append((self.folder / "sheet.md").read_text(encoding="utf-8"))
        account, loads = sheets[2], sheets[3]
        for word in ("Weight (kip)", "Stabilising (kip ft)", "lengths and coordinates in ft"):
            self.assertIn(word, account)
        self.assertIn("Moment (kip ft)", loads)
        for sheet in (account, loads):
            body = sheet.split("result_units:")[0]
            self.assertNotRegex(body, r"\d (?:N|kN|N m|Pa|kPa)\b|\((?:N|N m|Pa)\)")
        one, other = (re.search(r"frac\{([^{}]+)\}\{([^{}]+)\} = ([\d.]+)", sheet[sheet.index("table of loads"):]) for sheet in sheets[1::2])
        self.assertEqual(one.group(3), other.group(3))
        self.assertNotEqual(one.group(1), other.group(1))
        over, under = (sum(map(float, part.replace(" ", "").replace("−", " -").replace("+", " ").split())) for part in other.groups()[:2])
        self.assertLess(abs(over / under - float(other.group(3)) - 0.0005), 0.0008)  # rounded down, of rounded moments

    def test_shares_have_no_unit_of_force(self):
        """Without a unit weight the account is in shares of the weight, whatever unit is asked for."""
        text = SLAB.replace(", unit_weight_kn_m3: 26.5", "") + "result_units: {force: kip, moment: kip ft}\n"
        out = self.report(text, "--elements")
        self.assertIn("weight (W)", out)
        self.assertIn("(W m)", out)

    def test_bounds_are_converted_outward(self):
        """A weight of 17 digits: nothing is printed beyond what value and bound tell, in any unit, down to one digit."""
        for thickness in ("1.3", "1/3", "0.123456789012345678"):
            for force, one in EXACT["force"].items():
                out = self.report(SLAB.replace("1.3", thickness) + f"result_units: {{force: {force}}}\n")
                self.holds(re.search(rf"weight (\S+) {force}\n", out).group(1), 21 * Fraction(thickness) * 26500 / one)

    def test_what_stays(self):
        """JSON, CSV and what was not asked for."""
        plain = self.report(SLAB)
        self.write(SLAB)
        json_one, csv_one = solve("scene.yaml", folder=self.folder), run("solve", "--csv", "scene.yaml", folder=self.folder)
        text = SLAB + "result_units: {length: ft, force: kip, moment: kip ft, stress: psf}\n"
        other = self.report(text)
        json_other, csv_other = solve("scene.yaml", folder=self.folder), run("solve", "--csv", "scene.yaml", folder=self.folder)
        for document in (json_one, json_other):
            for case in document["cases"]:
                case.pop("effects")
        self.assertEqual(json_one, json_other)
        self.assertEqual(csv_one, csv_other)
        self.assertNotIn("Units", plain)
        self.assertIn("Units    lengths and coordinates in ft, forces in kip, moments in kip ft,\n         stresses in psf\n", other)
        self.assertLessEqual(max(map(len, other.splitlines())), 80)
        self.assertIn("FoS", other)

    def test_refused(self):
        for asked, column, said in (("{force: stone}", 23, "'stone' is not a unit of force for reports; known are: N, kN, MN, kgf"),
                                    ("{force: kip ft}", 23, "'kip ft' is not a unit of force"), ("{stress: [psf]}", 24, "known are: Pa"),
                                    ("{forces: kip}", 16, "did you mean 'force'?"), ("kip", 15, "result_units")):
            self.write(SLAB + f"result_units: {asked}\n")
            status, out, err = run("solve", "scene.yaml", folder=self.folder)
            self.assertEqual((status, out), (3, ""), asked)
            self.assertIn(f"scene.yaml:8:{column}: ", err)
            self.assertIn(said, err)


if __name__ == "__main__":
    main()
