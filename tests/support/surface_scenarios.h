#pragma once
// Scenarios with surfaces, for tests.

#include <gtest/gtest.h>

#include <string>

#include "quebra/surfaces/surface_input.h"
#include "shared/scenario/document.h"
#include "shared/scenario/field.h"

namespace quebra::test {

struct OnlySurfaces : surfaces::SurfaceInput {
  template <class D>
  static void describe(D& d) {
    surfaces::SurfaceInput::describe_in<OnlySurfaces>(d);
  }
};

inline dobra::scenario::Document surface_document(const std::string& text) {
  auto document = dobra::scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "test.toml");
  EXPECT_TRUE(document.ok()) << (document ? "" : to_string(document.error()));
  return *document;
}

/// The surfaces of a text, as the program reads them.
inline dobra::base::Result<surfaces::Surfaces> surfaces_of(const std::string& text) {
  using namespace dobra;
  const scenario::Document document = surface_document(text);
  const auto fields = scenario::fields_of<OnlySurfaces>();
  DOBRA_TRY_VOID(scenario::check(document.input, fields, ""));
  const scenario::Table table = scenario::in_si(document.input, fields, document.units);
  return surfaces::make_surfaces(scenario::from_table<OnlySurfaces>(table), table, document.units);
}

inline const std::string plate = "[[input.surface]]\nname = \"plate\"\nkind = \"plane\"\nu = [0, 10]\nv = [0, 10]\n";

}  // namespace quebra::test
