/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reading values of a scene out of its nodes. Shared by the readers of its sections. */

#ifndef TP_SCENE_READING_READ_H
#define TP_SCENE_READING_READ_H

#include "scene/check.h"
#include "scene/node.h"
#include "scene/scene.h"
#include "scene_keys.h"

/* How far the reading of a file is. */
typedef struct tp_reading {
  bool again;  /* the file was read before: its chains are known */
  bool varies; /* the last numbers depend on a parameter, or are not those of the file */
  long next_chain;
  bool cut; /* a mesh was cut by the plane that the scene gives */
} tp_reading;

typedef struct tp_reader {
  tp_scene *scene;
  tp_message *message;
  tp_reading *reading;
} tp_reader;

/* An expression; `name` is the key or the role of the value in messages. */
TP_MUST_USE tp_status tp_read_number(const tp_reader *reader, fmpq_t value, const tp_node *node,
                                     const char *name);

/* The same by a rule. */
TP_MUST_USE tp_status tp_read_by_rule(const tp_reader *reader, fmpq_t value, const tp_node *node,
                                      const char *name, tp_rule rule);

/* A quantity that may be missing (`node` NULL: not given). */
TP_MUST_USE tp_status tp_read_quantity(const tp_reader *reader, tp_quantity *quantity,
                                       const tp_node *node, const char *name, tp_rule rule);
TP_MUST_USE tp_status tp_read_bool(const tp_reader *reader, bool *value, const tp_node *node,
                                   const char *name);

/* Has a map no keys but its own? `what` it is called in messages. And the numbers
 * among them that it gives, into the scene or the item `of`. */
TP_MUST_USE tp_status tp_read_keys(const tp_reader *reader, const tp_node *node,
                                   const tp_key_map *map, const char *what);
TP_MUST_USE tp_status tp_read_values(const tp_reader *reader, void *of, const tp_node *node,
                                     const tp_key_map *map);

/* A point, [x, y]. */
TP_MUST_USE tp_status tp_read_point(const tp_reader *reader, tp_quantity *x, tp_quantity *y,
                                    const tp_node *node, const char *name);

/* The number of a facet of the base. */
TP_MUST_USE tp_status tp_read_facet_number(const tp_reader *reader, long *number,
                                           const tp_node *node);

/* A list of [x, y], the name of a CSV file beside the scene, or a mesh. */
TP_MUST_USE tp_status tp_read_points(const tp_reader *reader, tp_polyline *line,
                                     const tp_node *node, bool closed, const char *name);

/* The same of the outline of the block, whose holes are those that a mesh has there. */
TP_MUST_USE tp_status tp_read_outline(const tp_reader *reader, const tp_node *node);

/* The same of a map that names a mesh, which is cut by the plane of the key section of the scene.
 * `holes` NULL: of what may have none. */
TP_MUST_USE tp_status tp_read_mesh(const tp_reader *reader, tp_polyline *line, tp_polylines *holes,
                                   const tp_node *node, bool closed, tp_notes *notes);
/* What a map says of a mesh: its unit in scene lengths, 1 where `node` is NULL; one object of it,
 * below zero where that is NULL; and a caution where the map has no unit. */
TP_MUST_USE tp_status tp_read_mesh_unit(const tp_reader *reader, fmpq_t factor,
                                        const tp_node *node);
TP_MUST_USE tp_status tp_read_mesh_object(const tp_reader *reader, long *object,
                                          const tp_node *node, const tp_mesh *mesh);
TP_MUST_USE tp_status tp_note_mesh_unit(const tp_reader *reader, const tp_node *mesh,
                                        tp_notes *notes);
/* The key solid, of a scene of a solid; its keys tilt.azimuth_deg and loads.seismic.azimuth_deg are
 * refused where the scene is of another kind, and those of a section where it is of a solid. */
TP_MUST_USE tp_status tp_read_solid(const tp_reader *reader, const tp_node *root);
/* true, or {merge_within, drop_below}; NULL: none. */
TP_MUST_USE tp_status tp_read_solid_repair(const tp_reader *reader, const tp_node *node);
/* A length; NULL: none. */
TP_MUST_USE tp_status tp_read_solid_thin(const tp_reader *reader, const tp_node *node);
/* Metres to a length of a mesh, by 'unit' or 'scale' of a node; by neither those of the scene. */
TP_MUST_USE tp_status tp_read_mesh_lengths(const tp_reader *reader, fmpq_t metres, bool *given,
                                           const tp_node *node);
TP_MUST_USE tp_status tp_read_solid_parts(const tp_reader *reader, const tp_node *solid);
/* The mesh that a map names, and the object of it. */
TP_MUST_USE tp_status tp_read_solid_mesh(const tp_reader *reader, const tp_mesh **mesh,
                                         long *object, const tp_node *node);
TP_MUST_USE tp_status tp_read_solid_contacts(const tp_reader *reader, const tp_node *solid);
/* The plane or the ground that a solid lies on; its mesh was read. */
TP_MUST_USE tp_status tp_read_solid_base(const tp_reader *reader, const tp_node *solid);
TP_MUST_USE tp_status tp_read_wedge(const tp_reader *reader, const tp_node *solid);
/* A point or a vector of space, [x, y, z], in the axes of the mesh. */
TP_MUST_USE tp_status tp_read_triple(const tp_reader *reader, fmpq point[3], const tp_node *node,
                                     const char *name);
TP_MUST_USE tp_status tp_check_solid_keys(const tp_reader *reader, const tp_node *root);
/* The key section: has it a mesh to cut? After all chains. */
TP_MUST_USE tp_status tp_read_section_used(const tp_reader *reader, const tp_node *node);

/* A chain that is made of numbers under a node, all read since `varies` was last set to false: what
 * the same numbers made before, or NULL; and keep what they made now, ready to be shared, for when
 * the file is read again. False when memory is exhausted. */
const tp_polyline *tp_read_kept(const tp_reader *reader, const tp_node *node);
TP_MUST_USE bool tp_read_keep(const tp_reader *reader, const tp_polyline *line,
                              const tp_node *node);

/* The child that a mapping must have. */
TP_MUST_USE tp_status tp_read_required(const tp_reader *reader, const tp_node **child,
                                       const tp_node *mapping, const char *key,
                                       const char *example);

/* The key drawing, before the sections that it gives something to. */
TP_MUST_USE tp_status tp_read_drawing(const tp_reader *reader, const tp_node *node);
/* The unit weights of the parts that a drawing gives, behind the block's own parts. */
TP_MUST_USE tp_status tp_read_drawn_parts(const tp_reader *reader, const tp_node *drawing);
/* Holes and arcs that it gives, behind the block's own. */
TP_MUST_USE tp_status tp_read_drawn_holes(const tp_reader *reader);
TP_MUST_USE tp_status tp_read_drawn_arcs(const tp_reader *reader);

TP_MUST_USE tp_status tp_read_block(const tp_reader *reader, const tp_node *node);
/* Its form and what it is made of, whatever other keys stand beside them. */
TP_MUST_USE tp_status tp_read_block_shape(const tp_reader *reader, const tp_node *node,
                                          const tp_node *drawing);
/* The keys blocks, joints and block of a scene of many blocks; and which one gives it its blocks,
 * NULL of a scene of one. */
TP_MUST_USE tp_status tp_read_blocks(const tp_reader *reader, const tp_node *root);
const tp_node *tp_read_blocks_given(const tp_node *root);
/* Layers of a drawing of many blocks: how many a key of it names, `blocks` or `ground`, and all of
 * them in this order; and the blocks that stand there. */
long tp_drawn_layer_count(const tp_node *drawing, const char *key);
/* The number of one, from 1, as blocks have it; 0: neither key names it. */
long tp_drawn_layer_of(const tp_node *drawing, const char *name);
TP_MUST_USE tp_status tp_read_drawn_layers(const tp_reader *reader, const char **layers,
                                           const tp_node *drawing);
TP_MUST_USE tp_status tp_read_drawn_blocks(const tp_reader *reader, const tp_node *drawing,
                                           const tp_quantity *unit_weight);
/* The key jointed_slope. */
TP_MUST_USE tp_status tp_read_jointed_slope(const tp_reader *reader, const tp_node *node,
                                            const tp_quantity *unit_weight);
/* The key columns: the blocks that it makes; and their joints, behind those that were read. */
enum { TP_MOST_COLUMNS = 100000 };
TP_MUST_USE tp_status tp_read_columns(const tp_reader *reader, const tp_node *node,
                                      const tp_node *root, const tp_quantity *unit_weight);
/* Heights of columns from the toe on, of which the scene has their step then; theirs to clear. */
TP_MUST_USE tp_status tp_read_equal_area(const tp_reader *reader, fmpq **heights, long *count,
                                         const tp_node *columns, const tp_node *root);
TP_MUST_USE tp_status tp_read_column_joints(const tp_reader *reader);
/* Which of many blocks each load acts on, after the loads; and the key support. Keys of many blocks
 * are refused where the scene has one. */
TP_MUST_USE tp_status tp_read_block_loads(const tp_reader *reader, const tp_node *root);
TP_MUST_USE tp_status tp_read_arcs(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_rounded(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_loads(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_water(const tp_reader *reader, const tp_node *node);
/* The key friction, beside friction_angle_deg, which was read. */
TP_MUST_USE tp_status tp_read_friction(const tp_reader *reader, const tp_node *root);
TP_MUST_USE tp_status tp_read_frame(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_slope(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_base(const tp_reader *reader, const tp_node *node);
/* A profile that is made by rule. */
TP_MUST_USE tp_status tp_read_generated(const tp_reader *reader, const tp_node *node);

/* The key contact of the scene. */
TP_MUST_USE tp_status tp_read_contact(const tp_reader *reader, const tp_node *node);
/* The key joint, after base and contact. */
TP_MUST_USE tp_status tp_read_joint(const tp_reader *reader, const tp_node *node);

/* The key report. */
TP_MUST_USE tp_status tp_read_report(const tp_reader *reader, const tp_node *node);

/* The key result_units. */
TP_MUST_USE tp_status tp_read_result_units(const tp_reader *reader, const tp_node *node);

/* The keys tilt_test and shaking. */
TP_MUST_USE tp_status tp_read_tilt_test(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_shaking(const tp_reader *reader, const tp_node *node);

/* The keys partial_factors, after friction and required_fos, and cases. */
TP_MUST_USE tp_status tp_read_partial_factors(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_load_cases(const tp_reader *reader, const tp_node *node);

/* Both of a map: its keys, then its values. */
TP_MUST_USE tp_status tp_read_map(const tp_reader *reader, void *of, const tp_node *node,
                                  const tp_key_map *map, const char *what);

/* Where a node stands. */
tp_place tp_read_place(const tp_reader *reader, const tp_node *node);

/* Refuse what stands at a node. */
tp_status tp_read_fail(const tp_reader *reader, tp_fault fault, const tp_node *node,
                       const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif
