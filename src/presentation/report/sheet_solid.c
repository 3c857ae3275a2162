/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Order of the sheet of a solid: page 1, then its account, what that assumes, and an appendix of
 * moments, poses and files. */

#include "report/sheet_solid.h"

#include "terms/names.h"

static void add_front(tp_solid_sheet *s, const tp_sheet_head *head, tp_picture picture) {
  tp_document *d = &s->document;
  const char *caption =
      s->solid->has_wedge
          ? "The wedge from its face; and its planes, the friction cones about their poles and the "
            "resultant R in the lower hemisphere, equal-angle: with friction alone it slides where "
            "R is beyond the line between the cones."
      : s->solid->has_ground
          ? "The rock at its tilt and the ground about it, which may go on farther, with the "
            "forces "
            "of its contacts or the motion that begins; its contacts from above; the tilt up to "
            "which forces hold it, towards every azimuth."
      : s->solid->has_contacts
          ? "The rock at its tilt, with the forces of its contacts or the motion that begins; its "
            "contacts from above; the tilt up to which forces hold it, towards every azimuth."
          : "The rock at its tilt, which goes to the right, and what touches, from above; the tilt "
            "at which it topples, as a distance from the middle, towards every azimuth.";
  tp_sheet_add_persons(d, head);
  tp_document_sketch(
      d, picture, caption,
      "Drawing of the solid. Its verdict, tilts and forces are given in the text and "
      "the tables of this report.");
  tp_solid_sheet_add_inputs(s);
  tp_solid_sheet_add_governing(s);
  tp_solid_sheet_add_conclusion(s);
  tp_sheet_count_cautions(d, &s->solid->notes,
                          s->scene->letterhead.brief
                              ? "Cautions on the input: %zu. They stand below the account."
                              : "Cautions on the input: %zu. They stand at the head of the "
                                "appendix.");
  tp_sheet_add_signatures(d, head);
}

static void add_assumptions(tp_solid_sheet *s) {
  tp_document *d = &s->document;
  tp_document_heading(d, 2, "Assumptions");
  if (s->solid->has_wedge) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "A rigid wedge that does not turn (Hoek and Bray, Rock Slope Engineering, "
        "1981): friction and cohesion act against its sliding alone, and no joint is in "
        "tension. Where a joint would pull, the wedge leaves it and slides down the "
        "other. Water rises from zero pressure at the surface to half its head midway.");
    return;
  }
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "A rigid solid within the surface of its mesh; earthquakes act as a static force "
                  "through its centroid.");
  if (s->solid->has_ground) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "The ground is rigid, as its mesh has it. Corners and edges of both meshes that are "
        "no farther from the other than the band are taken to touch, by forces in true cones "
        "of Coulomb about the normals there; a part of how these differ may be noise of the "
        "survey. The least band governs, as with a wider one more is held. That forces can "
        "hold it does not exclude that it moves where contacts face different ways.");
    return;
  }
  if (s->solid->has_contacts) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "The ground touches it at the points given, by forces in true cones of Coulomb. "
        "That forces can hold it does not exclude that it moves where contacts face "
        "different ways.");
    return;
  }
  if (s->solid->has_below) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "A plane cuts the rock: what lies below is ground, and volume, weight and centroid "
        "are of what lies above. It rests on the convex hull of the section; the ground does "
        "not pull at it there, and does not hold its sides.");
  } else {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "The base is a rigid plane. All that is no higher than the band over the lowest "
        "point is taken to touch; which points do is not known better than the survey. "
        "The least band governs, as a support grows with it.");
  }
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "The rock topples about an edge of the support or slides by Coulomb's law; it "
                  "does not turn on its base, and the ground does not yield.");
}

static void add_proof(tp_solid_sheet *s) {
  tp_document *d = &s->document;
  tp_document_heading(d, 2, "Proof and computing cost");
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      "Every printed digit of a volume, a tilt, a factor and an acceleration is certain: "
      "each has a proven bound. The mesh is taken exactly, and decisions on it are exact; "
      "its moments were summed in arithmetic of the level %s.",
      tp_document_say(d, tp_level_name(s->solid->level)));
}

static void add_appendix(tp_solid_sheet *s, const tp_sheet_files *files) {
  tp_document *d = &s->document;
  tp_document_page(d);
  tp_document_heading(d, 2, "Appendix");
  tp_sheet_add_notes(d, &s->solid->notes);
  tp_solid_sheet_add_moments(s);
  tp_solid_sheet_add_poses(s);
  add_proof(s);
  tp_sheet_add_origin(d, files, s->options);
  tp_sheet_add_files(d, files, s->options);
}

void tp_sheet_build_solid(tp_document *document, const tp_solid_sheet *sheet,
                          const tp_sheet_files *files, tp_sheet_head *head, tp_picture picture) {
  tp_solid_sheet s = *sheet;
  tp_document *d = &s.document;
  d->language = head->language;
  d->comma = head->comma;
  tp_sheet_set_letterhead(d, head);
  tp_sheet_add_title(d, s.solid->title,
                     s.solid->has_wedge ? "Stability of a rock wedge"
                                        : "Stability of a solid rock");
  tp_sheet_add_foot(d, files, s.options);
  add_front(&s, head, picture);
  tp_document_page(d);
  tp_solid_sheet_add_bands(&s);
  tp_solid_sheet_add_contacts(&s);
  tp_solid_sheet_add_wedge(&s);
  add_assumptions(&s);
  if (s.scene->letterhead.brief) {
    tp_sheet_add_notes(d, &s.solid->notes);
  } else {
    add_appendix(&s, files);
  }
  *document = s.document;
}
