#pragma once
// A fixture that reads drawings, written as text, as the [input] of a scenario does, in a folder of its own.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "quebra/core/operations.h"
#include "quebra/model/model.h"
#include "shared/scenario/runner.h"

namespace quebra::test {

namespace fs = std::filesystem;

class DrawnFile : public testing::Test {
 protected:
  DrawnFile() {
    std::string name = (fs::temp_directory_path() / "dobra_sketch_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~DrawnFile() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// The model of an [input] with these lines.
  [[nodiscard]] dobra::base::Result<model::Model> read(const std::string& input) const {
    const dobra::scenario::Run run = run_of(input);
    if (run.error) return *run.error;
    return dobra::scenario::model_of<model::Model>(run.states.back());
  }
  [[nodiscard]] dobra::scenario::Run run_of(const std::string& input) const {
    auto document = dobra::scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n[input]\n" + input, "test.toml");
    EXPECT_TRUE(document.ok()) << (document ? "" : to_string(document.error()));
    document->file = folder_ / "test.toml";
    dobra::scenario::Runner runner(core::program());
    return runner.run(*document);
  }
  [[nodiscard]] model::Model good(const std::string& input) const {
    auto model = read(input);
    EXPECT_TRUE(model.ok()) << (model ? "" : to_string(model.error()));
    return model ? *std::move(model) : model::Model{};
  }
  [[nodiscard]] std::string refusal(const std::string& input) const {
    const auto model = read(input);
    EXPECT_FALSE(model.ok()) << input;
    return model ? "" : to_string(model.error());
  }

  fs::path folder_;
};

inline double area_of(const model::Model& model) {
  double area = 0.0;
  for (const domain::Face& face : model.domain.faces) area += face.area;
  return area;
}

inline std::string dxf(const std::string& entities, const std::string& header = "") {
  return header + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}
inline std::string dxf_line(double x0, double y0, double x1, double y1, const std::string& layer = "0") {
  std::ostringstream text;
  text.precision(17);
  text << "0\nLINE\n8\n" << layer << "\n10\n" << x0 << "\n20\n" << y0 << "\n11\n" << x1 << "\n21\n" << y1 << "\n";
  return text.str();
}

}  // namespace quebra::test
