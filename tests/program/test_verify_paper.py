# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The verdicts on the claims of the paper (examples/paper), by a second route that shares no code with Topple."""

import json
import random
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
import notation
from harness import ROOT, main, run, table
from verify_case import Block, TEETH

CLAIMS = ROOT / "examples" / "paper" / "claims.yaml"


class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        status, out, err = run("verify", "--json", CLAIMS)
        assert (status, err) == (1, ""), err
        cls.claims = json.loads(out)["claims"]

    def test_verdicts(self):
        """The verdict and the mend of every claim, against the reviewed table."""
        golden = {row["id"]: row for row in table("paper_verdicts.csv")}
        found = {c["id"]: (c["verdict"], c["change"] or "") for c in self.claims}
        self.assertEqual(found, {k: (row["verdict"], row["change"]) for k, row in golden.items()})

    def test_page(self):
        """docs/paper_verdicts.md is the report as it is printed."""
        page = (ROOT / "docs" / "paper_verdicts.md").read_text(encoding="utf-8")
        self.assertEqual(run("verify", "--markdown", CLAIMS)[1], page)

    def test_every_equation(self):
        """Every numbered equation of the issue has a claim."""
        places = {c["where"] for c in self.claims}
        wanted = [f"Eq. ({k})" for k in (2, 3, 4, 5, 7, 10, 13, 15, 16, 17)]
        wanted += [f"(A1.{k})" for k in range(1, 25)] + [f"(A2.{k})" for k in range(1, 27)]
        wanted += ["Fig. 8", "Fig. 10", "Fig. 15", "Fig. 16", "Fig. 18", "Eqs. (11), (12)", "section 4.4", "section 5.3"]
        wanted += [f"Table {k}" for k in range(1, 8)]
        self.assertEqual([w for w in wanted if w not in places], [])
        self.assertIn("T2.A.JRC Eq. (14)", {c["id"] for c in self.claims})

    def test_second_route(self):
        """Every formula about a toothed block, read by another reader and evaluated in Python's
        rationals at random blocks: what is proven equals the moments of that block exactly, what is
        refuted does not, and its mend does."""
        random.seed(41)
        seen = 0
        for claim in self.claims:
            name = (claim["geometry"] or "").removesuffix("_round")
            known = ("critical_angle", "fos", "fos_elements", "stabilising_moment",
                     "overturning_moment", "rounding_length", "corner_radius")
            if name not in TEETH or claim["quantity"] not in known:
                continue
            if claim["verdict"] not in ("proven", "refuted") or claim["id"] in ("1", "A2.5"):
                continue  # these are printed in terms of other quantities
            for _ in range(4):
                block = Block(claim["geometry"])
                expected = block.quantity(claim["quantity"])
                printed = notation.evaluate(claim["printed"], block.values())
                self.assertEqual(printed == expected, claim["verdict"] == "proven", claim["id"])
                if claim["mend"]:
                    mended = notation.evaluate(claim["mend"], block.values())
                    self.assertEqual(mended, expected, claim["id"])
            seen += 1
        self.assertGreaterEqual(seen, 60)

    def test_numbers(self):
        """Critical angles, radii and factors of safety of Tables 3 and 4 by the decimals of exact.py,
        within the bounds that the program states."""
        blocks = {"a": (15, 94, 5), "b": (14, 135, 5), "c": (20, 158, 7), "d": (20, 242, 7),
                  "e": (30, 120, 5), "f": (30, 118, 5), "g": (30, 123, 5)}
        measured = {"A peak": "23.5", "A valley": "19.8", "B peak": "15.0", "B valley": "12.6",
                    "C 1": "21.7", "C 2": "21.4", "D 1": "15.3", "D 2": "15.1", "E peak": "37.4",
                    "G 1": "23.8", "G 2": "23.9"}
        checked = 0
        for claim in self.claims:
            part = claim["id"].split(".")
            if part[0] != "T4" or part[2] not in ("ana", "r_c", "FoS"):
                continue
            a, b, c = blocks[part[1][0].lower()]
            count, end = TEETH[claim["geometry"]]
            ring = exact.teeth(count, a, b, c, end)
            m = exact.block_moments(ring)
            if part[2] == "ana":
                truth = exact.critical_angle(m, ring[0])
            elif part[2] == "FoS":
                truth = exact.factor_of_safety(m, ring[0], Fraction(measured[part[1]]))
            else:
                gx, gy = exact.centroid(m)
                sine, cosine = exact.sin_cos(Fraction(measured[part[1]]))
                slope = 1 if end == "valley" else -1
                hypotenuse = (Decimal(a) ** 2 + Decimal(c) ** 2).sqrt()
                sin_i, cos_i = Decimal(c) / hypotenuse, Decimal(a) / hypotenuse
                x, y = exact.decimal(gx), exact.decimal(gy - ring[0][1])
                length = (x * cosine - y * sine) / (cos_i * cosine - slope * sin_i * sine)
                truth = length * (1 - slope * sin_i) / cos_i
            found = claim["computed"]
            self.assertLessEqual(abs(Decimal(found["value"]) - truth),
                                 Decimal(found["error"]) + Decimal("1e-50"), claim["id"])
            checked += 1
        self.assertEqual(checked, 33)


if __name__ == "__main__":
    main()
