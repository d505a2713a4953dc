#include "recon/faults/report.h"

#include <gmock/gmock.h>

#include "shared/geom/place.h"
#include "tests/recon/faults/sections.h"

namespace recon::faults {
namespace {

using test::faulted;
using test::item;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> remarks_of(const section::Section& section, std::optional<double> tolerance = {}) {
  FaultsParams params;
  params.tolerance = tolerance;
  const auto report = report_faults(section, params);
  EXPECT_TRUE(report) << to_string(report.error());
  return report ? report->remarks : std::vector<std::string>();
}

const std::vector<test::NamedPoints> two_beds{{"A/1", {{0, 0}, {500, 0}}},
                                              {"A/2", {{600, -100}, {2000, -100}}},
                                              {"B/1", {{0, -300}, {800, -300}}},
                                              {"B/2", {{900, -400}, {2000, -400}}}};

TEST(FaultReport, FaultsNearerThanTheToleranceAreTold) {
  const auto section =
      faulted(two_beds, {item("F", {{400, 100}, {1200, -700}}), item("G", {{412, 100}, {1212, -700}})});
  EXPECT_THAT(remarks_of(section), Contains(HasSubstr("faults 'F' and 'G' run 8.485 m apart or less")));
  EXPECT_THAT(remarks_of(section, 2.0), Not(Contains(HasSubstr("apart or less"))));
}

TEST(FaultReport, AFaultWithoutCutoffsAndOneThatPartsNothingAreTold) {
  std::vector<test::NamedPoints> beds = two_beds;
  beds[0].second.back().x = beds[2].second.back().x = 200.0;  // 300 m short, and
  beds[1].second.front().x = beds[3].second.front().x = 1500.0;
  const auto far = faulted(beds, {item("F", {{400, 100}, {1200, -700}})});
  EXPECT_THAT(remarks_of(far), Contains(HasSubstr("fault 'F' has no cutoffs")));
  const auto tip =
      faulted({{"A", {{0, 0}, {2000, 0}}}, {"B", {{0, -300}, {2000, -300}}}}, {item("F", {{400, 100}, {600, -100}})});
  EXPECT_THAT(remarks_of(tip), Contains(HasSubstr("fault 'F': it ends in rock, 100 m from the border")));
  const auto through = faulted(two_beds, {item("F", {{400, 100}, {1200, -700}})});
  EXPECT_THAT(remarks_of(through), Not(Contains(HasSubstr("it ends in rock"))));
  EXPECT_THAT(remarks_of(through), Not(Contains(HasSubstr("no cutoffs"))));
}

TEST(FaultReport, PlacesKeepTheirMetresInCoordinatesOfMaps) {
  std::vector<test::NamedPoints> beds = two_beds;
  beds[0].second.back().x += 4.25;  // runs past the fault
  for (auto& [name, points] : beds) {
    for (geom::Point& p : points) p = p + geom::Vector{500000.0, 7000000.0};
  }
  const auto section = faulted(beds, {item("F", {{500400, 7000100}, {501200, 6999300}})});
  EXPECT_THAT(remarks_of(section), Contains(HasSubstr("is trimmed by 4.25 m to fault 'F' at (500500, 7000000)")));
  EXPECT_EQ(fmt::format("{}", geom::Point{501914.256, 6999873.444}), "(501914.26, 6999873.44)");
  EXPECT_EQ(fmt::format("{}", geom::Point{1914.256, -873.4444}), "(1914.26, -873.444)");
}

}  // namespace
}  // namespace recon::faults
