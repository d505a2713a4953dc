// Seeded faces that are hard to import. DOBRA_HARD_FACES is how many, DOBRA_HARD_FIRST the first seed.

#include "tests/support/hard_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "shared/io/faces/import.h"
#include "shared/surf/trim/area.h"

namespace dobra::io::faces {
namespace {

std::uint32_t number_from(const char* name, std::uint32_t otherwise) {
  const char* said = std::getenv(name);
  return said != nullptr ? static_cast<std::uint32_t>(std::strtoul(said, nullptr, 10)) : otherwise;
}

Imported import_of(const support::HardFace& hard) {
  const auto model = brep::parse_brep(hard.text, "hard.brep");
  EXPECT_TRUE(model.ok()) << hard.kind << ": " << base::to_string(model.error());
  if (!model) return {};
  auto made = faces_of_model(*model);
  EXPECT_TRUE(made.ok()) << hard.kind << ": " << base::to_string(made.error());
  return made ? *std::move(made) : Imported{};
}

TEST(HardFaces, SoundOnesComeOutWithTheirAreaAndBrokenOnesAreRefused) {
  const std::uint32_t first = number_from("DOBRA_HARD_FIRST", 0);
  const std::uint32_t count = number_from("DOBRA_HARD_FACES", support::hard_face_kinds);
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    const support::HardFace hard = support::hard_face(seed);
    const std::string name = fmt::format("seed {} ({})", seed, hard.kind);
    const Imported made = import_of(hard);
    EXPECT_EQ(made.faces.size() + made.refused, 1U) << name;
    if (!hard.sound) {
      EXPECT_EQ(made.refused, 1U) << name << ": " << hard.wrong;
      ASSERT_FALSE(made.findings.empty()) << name;
      EXPECT_EQ(made.findings.back().code.rfind("face_", 0), 0U) << name << ": " << made.findings.back().code;
      EXPECT_EQ(made.findings.back().place.item, "face 1") << name;
      continue;
    }
    ASSERT_EQ(made.faces.size(), 1U) << name << ": " << (made.findings.empty() ? "" : made.findings.back().message);
    const surf::Measured area = surf::trim::area(made.faces[0]);
    EXPECT_NEAR(area.value, hard.area, (1e-5 + hard.unsure) * hard.area) << name;
    EXPECT_LE(area.error, 1e-6 * area.value) << name;
  }
}

/// What a kind needs is mended with a finding of this code, and nothing else is said.
TEST(HardFaces, WhatIsMendedIsTold) {
  const std::map<std::string, std::set<std::string>> told{
      {"gaps", {"gap_closed"}},          {"cap without seam", {"seam_added"}}, {"ring without seam", {"seam_added"}},
      {"loops turned", {"loop_turned"}}, {"a period off", {"period_shifted"}}, {"tiny edges", {"edge_dropped"}},
      {"beyond knots", {"curve_held"}}};
  for (std::uint32_t seed = 0; seed < support::hard_face_kinds; ++seed) {
    const support::HardFace hard = support::hard_face(seed, support::WithArea::No);
    if (!hard.sound) continue;
    const Imported made = import_of(hard);
    std::set<std::string> codes;
    for (const surf::mesh::Finding& finding : made.findings) codes.insert(finding.code);
    const auto wanted = told.find(hard.kind);
    if (wanted == told.end()) {
      EXPECT_TRUE(codes.empty()) << hard.kind << ": " << (codes.empty() ? "" : *codes.begin());
      continue;
    }
    for (const std::string& code : wanted->second) EXPECT_TRUE(codes.contains(code)) << hard.kind << ": " << code;
  }
}

TEST(HardFaces, AreTheSameForTheSameSeed) {
  for (std::uint32_t seed = 0; seed < support::hard_face_kinds; ++seed)
    EXPECT_EQ(support::hard_face(seed, support::WithArea::No).text,
              support::hard_face(seed, support::WithArea::No).text)
        << seed;
}

}  // namespace
}  // namespace dobra::io::faces
