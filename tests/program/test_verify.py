# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Verdicts on claims: every class of verdict by small claims, about block E towards its peak."""

import json

from harness import main, run
from verify_case import A1_4, ClaimsCase


class Small(ClaimsCase):
    def test_classes(self):
        """Each verdict by a claim: tan(alpha_crit) = 99300/129525, alpha_crit = 37.47548 degrees."""
        for quantity, printed, verdict in (
                ("critical_angle", A1_4, "proven"),
                ("critical_angle", A1_4.replace("14", "13"), "refuted"),
                ("critical_angle", "37.475", "agrees"), ("critical_angle", "37.48", "agrees"),
                ("critical_angle", "37.47", "truncated"), ("critical_angle", "37.46", "disagrees"),
                ("critical_angle", "37.49", "disagrees"), ("-critical_angle", "-37.47", "truncated"),
                ("critical_angle", "< 37.48", "agrees"), ("critical_angle", ">= 37.48", "disagrees"),
                ("2*critical_angle", "2*atan((27ab + 14ac)/(9b^2 - 3c^2))", "agrees"),
                ("2*critical_angle", "2*atan((27ab + 14ac)/(9b^2 - 4c^2))", "refuted"),
                ("log10(b - 121)", "log10(b - 121)", "agrees"),
                ("log10(b - 500)", "log10(b - 501)", "undecided"),
                ("sqrt(2)^2/4", "< 0.5", "undecided")):
            self.assertEqual(self.claim(quantity, printed)["verdict"], verdict, (quantity, printed))

    def test_ties(self):
        """Half-way is the rounding of both its neighbours; a bound that is met exactly is known."""
        for printed, verdict in (("0.12", "agrees"), ("0.13", "agrees"), ("0.11", "disagrees"),
                                 ("< 0.125", "disagrees"), ("<= 0.125", "agrees"),
                                 ("> 0.125", "disagrees"), (">= 0.125", "agrees")):
            self.assertEqual(self.claim("1/8", printed)["verdict"], verdict, printed)
        self.assertEqual(self.claim("sin(30)*b/a", "2", "geometry: e")["verdict"], "agrees")

    def test_points_are_never_a_proof(self):
        """What is not rational agrees to digits at points."""
        result = self.claim("log10(a*b)", "log10(a) + log10(b)")
        self.assertEqual(result["verdict"], "agrees")
        self.assertGreaterEqual(result["digits"], 60)
        self.assertGreaterEqual(result["points"], 20)
        self.assertIsNone(result["difference"])

    def test_trigonometry(self):
        """Identities of angles are proven through sin^2 + cos^2 = 1."""
        for quantity, printed, verdict in (
                ("sin(alpha)^2 + cos(alpha)^2", "1.0*a/a", "proven"),
                ("sin(3*alpha)", "3*sin(alpha) - 4*sin(alpha)^3", "proven"),
                ("tan((i + 90)/2)", "(1 + sin(i))/cos(i)", "proven"),
                ("tan(alpha/2)", "(1 - cos(alpha))/sin(alpha)", "proven"),
                ("cos(alpha + i)", "cosα·cos i - sinα·sin i", "proven"),
                ("cos(alpha + i)", "cosα·cos i + sinα·sin i", "refuted"),
                ("cot(alpha)", "tan^-1 α", "proven"), ("sqrt(a^2*b^4/c^2)", "ab^2/c", "proven"),
                ("sqrt((a - b)^2)", "b - a", "agrees"), ("1/(1 + tan(i)^2)", "cos(i)^2", "proven")):
            self.assertEqual(self.claim(quantity, printed)["verdict"], verdict, (quantity, printed))

    def test_paper_notation(self):
        """The same formula in the paper's writing and in a program's."""
        for printed in (A1_4, "tan^{-1}((27ab+14ac)/(9b^2−3c^2))", "atan((27*a*b + 14*a*c)/(9*b^2 - 3*c^2))",
                        "tan^-1(27a·b/(9b^2 - 3c^2) + 14ac/(9b^2 - 3c^2))",
                        "atan(a(27b + 14c)/(3(3b^2 - c^2)))"):
            self.assertEqual(self.claim("critical_angle", printed)["verdict"], "proven", printed)

    def test_tables(self):
        """A row's cells are claims of their own, with the row's values."""
        status, out, _ = self.verify(
            "- id: T\n  where: Table\n  columns: {ana: {quantity: critical_angle, unit: °}, "
            "fos: {quantity: fos}}\n  rows:\n  - {row: E, geometry: e, at: {alpha: 20}, ana: 37.48, "
            "fos: 2.11}\n  - {row: F, geometry: e, at: {alpha: 30}, fos: 1.35}\n")
        found = {c["id"]: c["verdict"] for c in json.loads(out)["claims"]}
        self.assertEqual((status, found), (1, {"T.E.ana": "agrees", "T.E.fos": "agrees",
                                               "T.F.fos": "disagrees"}))

    def test_reports(self):
        """Text and Markdown hold the verdict, the mend and the tally."""
        self.verify(f"- {{id: x, where: here, geometry: e, quantity: critical_angle, printed: '{A1_4}'}}\n"
                    f"- {{id: y, where: there, geometry: e, quantity: critical_angle, printed: "
                    f"'{A1_4.replace('14', '13')}'}}\n")
        for options in ((), ("--markdown",)):
            status, out, err = run("verify", *options, "claims.yaml", folder=self.path)
            self.assertEqual((status, err), (1, ""))
            for wanted in ("2 claims: 1 proven, 1 refuted", A1_4, "number 13 at column 16 is 14"):
                self.assertIn(wanted, out)


if __name__ == "__main__":
    main()
