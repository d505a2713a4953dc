#include "shared/gui/documents/copied.h"

#include <gtest/gtest.h>

#include "tests/shared/gui/fake_program.h"

namespace dobra::gui::documents {
namespace {

class Copied : public testing::Test {
 protected:
  scenario::Document read(const std::string& text) { return *scenario::parse_document(text, "/data/my waves.toml"); }
  const scenario::Program program = test::fake_program();
  const std::string text =
      "dobra = 1\nprogram = \"waves\"\ntitle = \"T\"\n\n[input]\namplitude = 2.0\n\n"
      "# first\n[[step]]\noperation = \"stack\"\nname = \"grid\"\ncount = 4\n\n[[step]]\noperation = \"lift\"\n\n"
      "[[expect]]\nquantity = \"stack.count\"\nvalue = 4.0\n";
};

TEST_F(Copied, APartIsWrittenAsTheDocumentWritesIt) {
  const scenario::Document document = read(text);
  ASSERT_EQ(scenario::document_text(document), text);
  EXPECT_EQ(part_text(document, 0), "[input]\namplitude = 2.0\n");
  EXPECT_EQ(part_text(document, 1), "# first\n[[step]]\noperation = \"stack\"\nname = \"grid\"\ncount = 4\n");
  EXPECT_EQ(part_text(document, 2), "[[step]]\noperation = \"lift\"\n");
  EXPECT_EQ(part_text(scenario::Document{}, 0), "[input]\n");
}

TEST_F(Copied, PastedStepsStandBehindTheSelectedOne) {
  const scenario::Document document = read(text);
  const auto made = with_pasted(document, program, 1, part_text(document, 1));
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->steps.size(), 3U);
  EXPECT_EQ(part_text(*made, 2), part_text(document, 1));
  EXPECT_EQ(made->steps[2].operation, "lift");
  const auto whole = with_pasted(document, program, 0, text);
  ASSERT_TRUE(whole.ok());
  EXPECT_EQ(whole->steps.size(), 4U);
  EXPECT_EQ(whole->expects.size(), 1U);
  EXPECT_EQ(whole->title, "T");
}

TEST_F(Copied, WhatIsNoStepOfTheProgramIsRefusedWithItsLine) {
  const scenario::Document document = read(text);
  for (const auto& [pasted, said, line] :
       {std::tuple{"", "[[step]]", 0u},
        {"Lorem ipsum, 3 = 4", "", 1u},
        {"[[step]]\noperation = \"stock\"\n", "'stack'", 1u},
        {"[[step]]\noperation = \"stack\"\ncount = 99\n", "at most 40", 3u},
        {"[[step]]\noperation = \"stack\"\n\ncuont = 3\n", "'count'", 4u},
        {"[[step]]\ncount = 3\n", "operation", 1u},
        {"dobra = 1\nprogram = \"recon\"\n[[step]]\noperation = \"grid\"\n", "recon", 0u},
        {"[input]\namplitude = 3.0\n", "[[step]]", 0u}}) {
    const auto made = with_pasted(document, program, 1, pasted);
    ASSERT_FALSE(made.ok()) << pasted;
    const std::string message = base::to_string(made.error());
    EXPECT_NE(message.find(said), std::string::npos) << message;
    if (line > 0) {
      ASSERT_TRUE(made.error().place) << message;
      EXPECT_EQ(made.error().place->line, line) << message;
    }
  }
}

TEST_F(Copied, TheCommandSaysWhatWasEditedSinceTheFileWasWritten) {
  const scenario::Document disk = read(text);
  EXPECT_EQ(command_of(disk, program, disk), "waves run '/data/my waves.toml' --out '/data/my waves_results'\n");
  scenario::Document edited = disk;
  edited.steps[0].params.set("count", std::int64_t{7});
  edited.steps[0].params.set("note", std::string("it's two words"));
  edited.input.set("amplitude", 3.5);
  EXPECT_EQ(command_of(edited, program, disk),
            "waves run '/data/my waves.toml' --out '/data/my waves_results' --set input.amplitude=3.5 --set "
            "steps.1.count=7 --set 'steps.1.note=it'\\''s two words'\n");
}

TEST_F(Copied, WhatSetCannotSayIsSaid) {
  const scenario::Document disk = read(text);
  scenario::Document edited = disk;
  edited.steps.pop_back();
  for (const auto& before : {std::optional(disk), std::optional<scenario::Document>()}) {
    const std::string command = command_of(edited, program, before);
    EXPECT_TRUE(command.starts_with("# Not all changes")) << command;
    EXPECT_EQ(command.find("--set"), std::string::npos);
  }
}

}  // namespace
}  // namespace dobra::gui::documents
