// Saving changes no more of a file than the document has changed.

#include <gtest/gtest.h>

#include "shared/scenario/document.h"

namespace dobra::scenario {
namespace {

const char* const written = R"(# Two beds.
dobra=1
program = 'recon'   # the program
unit_system = "SI"

[input]
snap = 1e-6            # metres
y_axis   = "up"

# the upper one
[[input.horizon]]
name = "Top"
points = [[0, 100], [50, 1.50e2],   # the crest
          [100, 100]]

# the lower one
[[input.horizon]]
name = "Base"
points = [[0, 0], [100, 0]]

[[step]]
name = "first"
operation = "grid"
distance = 5e1

[[expect]]
quantity = "a"
value = 1
tolerance = 0.0
# the end
)";

Document read() { return parse_document(written, "a.toml").value(); }
std::vector<Table> beds(const Document& document) {
  return std::get<std::vector<Table>>(*document.input.find("horizon"));
}
std::string exchanged(const std::string& from, const std::string& to) {
  std::string text = written;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SavedText, OfAnUnchangedDocumentIsWhatWasRead) {
  EXPECT_EQ(saved_text(read()), written);
  EXPECT_NE(document_text(read()), written);
}

TEST(SavedText, AChangedNumberLeavesEverythingElse) {
  Document document = read();
  document.steps[0].params.set("distance", 60.0);
  EXPECT_EQ(saved_text(document), exchanged("5e1", "60.0"));
  document.steps[0].params.set("distance", 50.0);
  EXPECT_EQ(saved_text(document), written);
  document.input.set("snap", 0.5);
  EXPECT_EQ(saved_text(document), exchanged("1e-6 ", "0.5 "));
}

TEST(SavedText, AMovedVertexIsExchangedInItsList) {
  Document document = read();
  std::vector<Table> all = beds(document);
  all[0].set("points", std::vector<geom::Point>{{0, 100}, {50, 160}, {100, 100}});
  document.input.set("horizon", all);
  EXPECT_EQ(saved_text(document), exchanged("[50, 1.50e2]", "[50.0, 160.0]"));
}

TEST(SavedText, VerticesAreInsertedAndRemovedInTheirList) {
  for (const auto& [points, from, to] :
       {std::tuple{std::vector<geom::Point>{{0, 100}, {50, 150}, {75, 120}, {100, 100}}, "[100, 100]]",
                   "[75.0, 120.0], [100, 100]]"},
        {std::vector<geom::Point>{{0, 100}, {50, 150}, {100, 100}, {120, 90}}, "[100, 100]]",
         "[100, 100], [120.0, 90.0]]"},
        {std::vector<geom::Point>{{50, 150}, {100, 100}}, "[0, 100], ", ""}}) {
    Document document = read();
    std::vector<Table> all = beds(document);
    all[0].set("points", points);
    document.input.set("horizon", all);
    EXPECT_EQ(saved_text(document), exchanged(from, to));
  }
}

TEST(SavedText, ATableIsRemovedWithItsCommentAndAddedBehindTheOneBefore) {
  Document document = read();
  std::vector<Table> all = beds(document);
  const Table top = all[0];
  all.erase(all.begin());
  document.input.set("horizon", all);
  const std::string without = saved_text(document);
  EXPECT_EQ(without.find("the upper one"), std::string::npos);
  EXPECT_NE(without.find("# the lower one\n[[input.horizon]]\nname = \"Base\"\npoints = [[0, 0], [100, 0]]\n"),
            std::string::npos)
      << without;
  EXPECT_NE(without.find("snap = 1e-6            # metres"), std::string::npos);
  Table more;
  more.set("name", std::string("New"));
  more.set("points", std::vector<geom::Point>{{0, -50}, {100, -50}});
  all.insert(all.begin(), {top, more});
  document.input.set("horizon", all);
  EXPECT_EQ(saved_text(document), exchanged("\n# the lower one",
                                            "\n[[input.horizon]]\nname = \"New\"\npoints = [[0.0, -50.0], [100.0, "
                                            "-50.0]]\n\n# the lower one"));
}

TEST(SavedText, StepsThatChangePlacesKeepTheirText) {
  Document document = read();
  Step step;
  step.operation = "restore";
  document.steps.push_back(step);
  const std::string longer = saved_text(document);
  EXPECT_EQ(longer, exchanged("distance = 5e1\n", "distance = 5e1\n\n[[step]]\noperation = \"restore\"\n"));
  std::swap(document.steps[0], document.steps[1]);
  const std::string swapped = saved_text(document);
  EXPECT_NE(swapped.find("distance = 5e1\n"), std::string::npos) << swapped;
  EXPECT_LT(swapped.find("restore"), swapped.find("grid"));
}

/// Whatever is done, the text that is saved reads back to the document.
TEST(SavedText, ReadsBackToTheDocumentWhateverWasDone) {
  std::uint32_t random = 7;
  const auto below = [&](std::uint32_t n) { return (random = random * 1664525U + 1013904223U) / 65536U % n; };
  Document document = read();
  for (int k = 0; k < 300; ++k) {
    std::vector<Table> all = beds(document);
    switch (below(5)) {
      case 0:
        all.insert(all.begin() + below(static_cast<std::uint32_t>(all.size()) + 1), all[below(1)]);
        break;
      case 1:
        if (all.size() > 1) all.erase(all.begin() + below(static_cast<std::uint32_t>(all.size())));
        break;
      case 2:
        all[below(static_cast<std::uint32_t>(all.size()))].set("name", std::string(1, static_cast<char>('a' + k % 26)));
        break;
      case 3: {
        std::vector<geom::Point> points(2 + below(4));
        for (geom::Point& p : points) p = {1.0 * below(3), 1.0 * below(3)};
        all[below(static_cast<std::uint32_t>(all.size()))].set("points", points);
        break;
      }
      default:
        document.steps.insert(document.steps.begin(), Step{})->operation = k % 2 == 0 ? "grid" : "target";
        if (document.steps.size() > 4) document.steps.pop_back();
    }
    document.input.set("horizon", all);
    const auto again = parse_document(saved_text(document), "a.toml");
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(document_text(*again), document_text(document));
  }
}

TEST(SavedText, WithoutASourceIsCanonical) {
  Document document = read();
  document.source = nullptr;
  EXPECT_EQ(saved_text(document), document_text(document));
}

}  // namespace
}  // namespace dobra::scenario
