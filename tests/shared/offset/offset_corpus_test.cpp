// Every contour and every bed of the shared data, judged by the verifier: both sides, all joins, distances from below
// the spacing of the points to above the size of the whole. Skips aloud where the data are not there.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"
#include "tests/support/corpus.h"
#include "tests/support/geo_file.h"
#include "tests/support/offset_oracle.h"

namespace dobra::offset {
namespace {

using namespace verifier;
using geom::Polyline;
namespace fs = std::filesystem;

/// Of the diagonal of each base.
constexpr double relative_distances[] = {0.0005, 0.002, 0.01, 0.05, 0.2, 0.5, 1.2};
constexpr std::size_t curves_a_base = 2 * 4 * std::size(relative_distances);

/// Numbers of every line that has only numbers, whatever parts them.
std::vector<std::vector<double>> rows_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    for (char& c : line) c = c == ',' || c == '\t' ? ' ' : c;
    std::istringstream words(line);
    std::vector<double> row;
    for (double value; words >> value;) row.push_back(value);
    if (row.size() >= 2) rows.push_back(row);
  }
  return rows;
}

/// Everything wrong with the curves of one base.
void judge(const Polyline& base, const std::string& name, std::size_t& judged) {
  std::vector<double> distances;
  for (const double d : relative_distances) distances.push_back(d * base.box().diagonal());
  for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
    for (const Join join : {Join::Mitre, Join::Bisector, Join::Round, Join::Bevel}) {
      OffsetOptions options;
      options.side = side;
      options.join = join;
      const auto curves = offset(base, distances, options);
      ASSERT_TRUE(curves.ok()) << name << ": " << curves.error().message;
      for (const OffsetCurve& curve : *curves) {
        const auto verified = verify(base, options, curve);
        ASSERT_TRUE(verified.ok()) << name;
        ++judged;
        for (std::size_t i = 0; i < std::min<std::size_t>(3, verified->findings.size()); ++i) {
          ADD_FAILURE() << name << " side " << int(side) << " join " << int(join) << " D " << curve.distance << " ("
                        << verified->findings.size() << " findings): " << to_string(verified->findings[i]);
        }
      }
    }
  }
}

TEST(OffsetCorpus, EveryContourKeepsItsDistanceAndNothingIsMissing) {
  const auto folder = test::data_folder();
  if (!folder) GTEST_SKIP() << test::no_data;
  std::map<std::string, std::size_t> contours;
  std::size_t judged = 0;
  std::size_t bases = 0;
  for (const auto& entry : fs::directory_iterator(*folder / "contours")) {
    const std::string file = entry.path().string();
    const std::string name = entry.path().filename().string();
    if (file.ends_with(".md")) continue;
    std::vector<Polyline> read;
    if (file.ends_with(".geo")) {
      const auto geo = test::GeoFile::contours(file);
      ASSERT_TRUE(geo.has_value()) << file;
      read = *geo;
    } else {
      read = support::read_contours(file);
    }
    for (const Polyline& contour : read) {
      ASSERT_TRUE(geom::validate(geom::without_repeated_points(contour)).ok()) << name;
      ++bases;
      judge(contour, name + " contour " + std::to_string(++contours[name]), judged);
    }
  }
  EXPECT_EQ(contours.size(), 8U);
  EXPECT_EQ(contours["xfem_two_holes_moes1999.geo"], 3U);
  EXPECT_EQ(contours["xfem_pmma_3holes.geo"], 6U);
  EXPECT_GE(bases, 15U);
  EXPECT_EQ(judged, curves_a_base * bases);
}

TEST(OffsetCorpus, EveryBedOfTheSectionsKeepsItsDistanceAndNothingIsMissing) {
  const auto folder = test::data_folder();
  if (!folder) GTEST_SKIP() << test::no_data;
  std::size_t judged = 0;
  std::size_t lines = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*folder / "sections")) {
    const fs::path& file = entry.path();
    const std::string name = file.filename().string();
    if (name.starts_with("LICENSE") || (file.extension() != ".txt" && file.extension() != ".csv")) continue;
    std::map<std::pair<double, double>, Polyline> parts;  // of profile.csv by layer and part; one of every other file
    for (const auto& row : rows_of(file)) {
      if (file.extension() == ".csv") {
        ASSERT_EQ(row.size(), 5U);
        parts[{row[0], row[1]}].points.push_back({row[3], row[4]});
      } else {
        parts[{0, 0}].points.push_back({row[0], row[1]});
      }
    }
    for (auto& [key, line] : parts) {
      line.closed = name == "subandean.txt";
      if (line.points.size() < 2) continue;  // single points of profile.csv
      ASSERT_TRUE(geom::validate(geom::without_repeated_points(line)).ok()) << name;
      ++lines;
      judge(line,
            file.parent_path().filename().string() + "/" + name + " part " + std::to_string(key.first) + "," +
                std::to_string(key.second),
            judged);
    }
  }
  EXPECT_GE(lines, 29U);
  EXPECT_EQ(judged, curves_a_base * lines);
}

}  // namespace
}  // namespace dobra::offset
