/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solved scene as a drawing: docs/figure.md explains what it shows. Included by topple.h; the
 * calls tp_report_figure… are in a separate library, topple-figure, which alone needs Cairo. */

#ifndef TOPPLE_FIGURE_H
#define TOPPLE_FIGURE_H

#include "topple_block_system.h"
#include "topple_solid.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Does the name end in .svg, .pdf, .png or .dxf, the kinds of file that a figure can be, or in
 * .glb, which that of a solid can be too? */
bool tp_figure_is_file_name(const char *path);

/* The version of the library topple-figure that the program has loaded, as TP_VERSION. It is to be
 * that of libtopple to the last digit: what is drawn by another one is TP_DEPENDENCY_FAILED. */
const char *tp_figure_version(void);

/* Draw the solution of the scene into the file `path`, of the kind that its ending names; a file of
 * that name is replaced, keeps its owner and mode, and stays as it was where the drawing fails. A
 * file that the scene was read from is bad input. The triangles of the account
 * by elements are drawn where the solution has one. The colours are legible to the colour-blind.
 * The same program draws the same bytes each time it is run. Fontconfig, which finds the letters,
 * crashes where memory is exhausted: a program that must not is to draw in a separate process.
 * TP_SYSTEM_FAILED where the file cannot be written, TP_DEPENDENCY_FAILED where Cairo fails. */
TP_MUST_USE tp_status tp_report_figure(const char *path, const tp_scene *scene,
                                       const tp_solution *solution, tp_message *message);

/* What is asked before a file is written. */
typedef struct tp_figure_consent {
  bool (*give)(void *context); /* true: the file may be written; NULL: it need not be asked */
  void *context;               /* what it is called with */
} tp_figure_consent;

/* The same, but asked for consent once the figure is drawn and the file can take it; where that is
 * refused (false), no file is made or changed, and the status is TP_SYSTEM_FAILED. Of what is not
 * a regular file, or is the standard output, nothing could be taken back: it is not asked for. */
TP_MUST_USE tp_status tp_report_figure_if(const char *path, const tp_scene *scene,
                                          const tp_solution *solution, tp_figure_consent consent,
                                          tp_message *message);

/* The same of many blocks, by their result: as .svg, .pdf or .png, the direction that governs, by
 * collapse, factor of safety, and how much more tilt it bears. Bad input: the result is of another
 * scene, or of it before it was changed. */
TP_MUST_USE tp_status tp_report_figure_block_system(const char *path, const tp_scene *scene,
                                                    const tp_block_system *system,
                                                    tp_message *message);
TP_MUST_USE tp_status tp_report_figure_block_system_if(const char *path, const tp_scene *scene,
                                                       const tp_block_system *system,
                                                       tp_figure_consent consent,
                                                       tp_message *message);

/* The same of a solid, as .svg, .pdf or .png: the rock on its base at its tilt, shaded, with the
 * edge that governs; what of it touches, seen from above; and the rose of its critical tilts. Or
 * its contacts, with the forces that hold it and the screw that begins; or a wedge, with its planes
 * on a stereonet. As .glb the rock in its pose, as a model of glTF 2.0, with what touches, the edge
 * and the forces as lines. The mesh is read again; bad input: it is not the one that was solved. */
TP_MUST_USE tp_status tp_report_figure_solid(const char *path, const tp_solid *solid,
                                             tp_message *message);
TP_MUST_USE tp_status tp_report_figure_solid_if(const char *path, const tp_solid *solid,
                                                tp_figure_consent consent, tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
