/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Adapter of RapidJSON's iterative reader with numbers kept as texts; an allocator that throws
 * bad_alloc replaces the default one. */

#include "geom/json_events.h"

#include "geom/guard.hpp"

#include <rapidjson/error/en.h>
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <cstdlib>
#include <new>

namespace {

/* RapidJSON writes into what its own allocator gives without asking whether that gave anything. */
class ThrowingAllocator {
public:
  static constexpr bool kNeedFree = true;

  void *Malloc(size_t size) {
    return Realloc(nullptr, 0, size);
  }
  void *Realloc(void *memory, size_t, size_t size) {
    if (size == 0) {
      Free(memory);
      return nullptr;
    }
    void *given = std::realloc(memory, size);
    if (given == nullptr) throw std::bad_alloc();
    return given;
  }
  static void Free(void *memory) {
    std::free(memory);
  }
};

using Reader = rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, ThrowingAllocator>;

class Handler {
public:
  Handler(const rapidjson::MemoryStream &stream, tp_json_visitor visitor, void *context)
      : stream(stream), visitor(visitor), context(context) {
  }

  bool Null() {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Bool(bool) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Int(int) {
    return tell(TP_JSON_EVENT_OTHER);
  } /* never: numbers are texts */
  bool Uint(unsigned) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Int64(int64_t) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Uint64(uint64_t) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Double(double) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool RawNumber(const char *text, rapidjson::SizeType length, bool) {
    return tell(TP_JSON_EVENT_NUMBER, text, length);
  }
  bool String(const char *text, rapidjson::SizeType length, bool) {
    return tell(TP_JSON_EVENT_STRING, text, length);
  }
  bool Key(const char *text, rapidjson::SizeType length, bool) {
    return tell(TP_JSON_EVENT_KEY, text, length);
  }
  bool StartObject() {
    return tell(TP_JSON_EVENT_OBJECT);
  }
  bool EndObject(rapidjson::SizeType) {
    return tell(TP_JSON_EVENT_OBJECT_END);
  }
  bool StartArray() {
    return tell(TP_JSON_EVENT_ARRAY);
  }
  bool EndArray(rapidjson::SizeType) {
    return tell(TP_JSON_EVENT_ARRAY_END);
  }

private:
  bool tell(tp_json_event_kind kind, const char *text = "", size_t length = 0) {
    const tp_json_event event = {kind, text, length, stream.Tell()};
    return visitor(context, &event);
  }

  const rapidjson::MemoryStream &stream;
  tp_json_visitor visitor;
  void *context;
};

} // namespace

bool tp_json_events_are_there(void) {
  return true;
}

tp_geom_status tp_json_visit(const char *text, size_t length, tp_json_visitor visitor,
                             void *context, const char **problem, size_t *at) {
  return tp::guard([&] {
    constexpr unsigned flags = rapidjson::kParseIterativeFlag |
                               rapidjson::kParseNumbersAsStringsFlag |
                               rapidjson::kParseValidateEncodingFlag;
    rapidjson::MemoryStream stream(text, length); /* ends there, also within a character */
    Handler handler(stream, visitor, context);
    Reader reader;
    const rapidjson::ParseResult result = reader.Parse<flags>(stream, handler);
    const bool ended = result.Code() == rapidjson::kParseErrorTermination;
    *problem = result.IsError() && !ended ? rapidjson::GetParseError_En(result.Code()) : nullptr;
    *at = result.Offset();
    return TP_GEOM_OK;
  });
}
