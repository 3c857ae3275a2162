/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pictures: PNG and JPEG. */

#include "fuzz.h"
#include "trace/picture.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  tp_trace_picture picture;
  tp_message message = {.text = ""};
  unsigned char *bytes = (unsigned char *)fuzz_text(data, size);
  const tp_status status = tp_picture_read_bytes(&picture, bytes, size, "picture", &message);
  if (status == TP_OK) {
    FUZZ_EXPECT(picture.width > 0 && picture.height > 0 && picture.rgb != NULL);
    FUZZ_EXPECT(picture.width <= TP_PICTURE_SIDE && picture.height <= TP_PICTURE_SIDE);
  } else {
    FUZZ_EXPECT(message.text[0] != '\0' && picture.rgb == NULL);
  }
  tp_picture_clear(&picture);
  free(bytes);
  return 0;
}
