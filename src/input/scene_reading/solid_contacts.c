/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key solid.contacts: points at which the ground touches a solid, with their normals. */

#include "scene/members.h"
#include "scene_reading/read.h"

#include <stdlib.h>

enum { MOST_CONTACTS = TP_SOLID_CONTACTS };

tp_status tp_read_triple(const tp_reader *reader, fmpq point[3], const tp_node *node,
                         const char *name) {
  static const char *const axes[3] = {"x", "y", "z"};
  if (node->kind != TP_NODE_SEQUENCE || node->count != 3) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "'%s' is three numbers in the axes of the mesh, written [x, y, z]", name);
  }
  tp_status status = TP_OK;
  const tp_node *n = node->first;
  for (int k = 0; k < 3 && status == TP_OK; k++, n = n->next) {
    status = tp_read_number(reader, point + k, n, axes[k]);
  }
  return status;
}

/* The next of those that there is room for. */
static tp_contact_description *next_contact(tp_solid_description *solid, tp_place place) {
  tp_contact_description *own = solid->contacts + solid->contact_count++;
  for (size_t k = 0; k < tp_contact_numbers.count; k++) {
    fmpq_init(tp_member_number(own, tp_contact_numbers.items[k]));
  }
  for (int k = 0; k < 3; k++) {
    fmpq_init(own->at + k);
    fmpq_init(own->normal + k);
  }
  own->place = place;
  return own;
}

static tp_status read_normal(const tp_reader *reader, tp_contact_description *own,
                             const tp_node *node) {
  own->has_normal = node != NULL;
  if (node == NULL) return TP_OK;
  const tp_status status = tp_read_triple(reader, own->normal, node, "normal");
  const bool is_zero =
      fmpq_is_zero(own->normal) && fmpq_is_zero(own->normal + 1) && fmpq_is_zero(own->normal + 2);
  if (status != TP_OK || !is_zero) return status;
  return tp_read_fail(reader, TP_FAULT_RANGE, node,
                      "of the three numbers of a 'normal' at least one is not 0");
}

static tp_status read_contact(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  const tp_node *at = NULL;
  tp_contact_description *own = next_contact(&scene->solid, tp_node_place(node, scene->path));
  tp_status status = tp_read_map(reader, own, node, &tp_key_map_solid_contacts, "a contact");
  if (status == TP_OK) status = tp_read_required(reader, &at, node, "at", "at: [0, 0, 0]");
  if (status == TP_OK) status = tp_read_triple(reader, own->at, at, "at");
  return status == TP_OK ? read_normal(reader, own, tp_node_get(node, "normal")) : status;
}

/* Keys that have another meaning where a band touches a plane, or none. */
static tp_status check_beside(const tp_reader *reader, const tp_node *solid, const tp_node *list) {
  static const char *const keys[] = {"bands", "base", NULL};
  const tp_node *node = tp_node_first_of(solid, keys);
  if (node != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "what touches this rock is given by its 'contacts', as it lies: leave out "
                        "'%s'",
                        node->key);
  }
  return list->kind == TP_NODE_SEQUENCE && list->count > 0 && list->count <= MOST_CONTACTS
             ? TP_OK
             : tp_read_fail(reader, TP_FAULT_FORMAT, list,
                            "contacts are a list of 1 to %d: [{at: [x, y, z], normal: [x, y, z]}, "
                            "…]",
                            MOST_CONTACTS);
}

tp_status tp_read_solid_contacts(const tp_reader *reader, const tp_node *solid) {
  tp_solid_description *own = &reader->scene->solid;
  const tp_node *list = tp_node_get(solid, "contacts");
  if (list == NULL) return TP_OK;
  tp_status status = check_beside(reader, solid, list);
  if (status != TP_OK) return status;
  own->contacts = calloc((size_t)list->count + 1, sizeof *own->contacts);
  if (own->contacts == NULL) return tp_fail_memory(reader->message, "the contacts of a solid");
  for (const tp_node *n = list->first; n != NULL && status == TP_OK; n = n->next) {
    status = read_contact(reader, n);
  }
  return status;
}
