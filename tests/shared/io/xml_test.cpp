#include "shared/io/xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/shared/io/io_examples.h"

namespace dobra::io {
namespace {

using base::ErrorCode;
using test::place_text;
using testing::HasSubstr;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

TEST(Xml, ElementsAndTextsKnowTheirPlacesWhateverTheLineEnds) {
  const std::string text = "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!-- <no> -->\r\n<a x='1\r\n2'>\r\n  <b>7 8</b></a>\n";
  const auto xml = Xml::parse(text, "f");
  ASSERT_TRUE(xml.ok());
  const pugi::xml_node a = xml->root().first_child();
  const pugi::xml_node b = a.child("b");
  EXPECT_EQ(place_text({ErrorCode::BadFormat, "", xml->place(a)}), "f:3:1");
  EXPECT_EQ(place_text({ErrorCode::BadFormat, "", xml->place(b)}), "f:5:3");
  EXPECT_EQ(place_text({ErrorCode::BadFormat, "", xml->place(b.first_child().value() + 2)}), "f:5:8");
  EXPECT_STREQ(a.attribute("x").value(), "1\r\n2");
}

TEST(Xml, MarkupThatIsWrongIsRefusedWithItsPlace) {
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {"", "f:0:0", "empty"},
      {"<a>\n<b x=1/></a>", "f:2:6", "between quotes"},
      {"<a>\n<b x='1/></a>", "f:2:7", "between quotes"},
      {"<a>\n<!-- b </a>", "f:2:1", "this comment does not end"},
      {"<a>\n<![CDATA[ b </a>", "f:2:1", "this markup does not end"},
      {"<a>\n <b></a></b>", "f:2:5", "the end tag '</a>' closes nothing that is open"},
      {"<a/>\n</a>", "f:2:1", "the end tag '</a>' closes nothing that is open"},
      {"<a>\n<b/><c><d></d>\n", "f:2:5", "'c' is not closed"},
      {"<a>\n<b>1 2 3", "f:2:1", "'b' is not closed"},
      {"<a>\n1 < 2</a>", "f:2:4", "&lt;"},
  };
  for (const auto& [text, place, says] : cases) {
    const auto xml = Xml::parse(text, "f");
    ASSERT_FALSE(xml.ok()) << text;
    EXPECT_EQ(place_text(xml.error()), place) << text;
    EXPECT_THAT(xml.error().message, HasSubstr(says)) << text;
  }
}

/// The element that a text cut after `size` bytes leaves open, by counting brackets; empty where it ends within a tag.
std::string open_at(const std::string& text, std::size_t size) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < size; ++at) {
    if (text[at] != '<') continue;
    const std::size_t end = text.find('>', at);
    if (end >= size) return "";
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag[0] == '/') open.pop_back();
    if (tag[0] != '/' && tag.back() != '/') open.push_back(tag.substr(0, tag.find(' ')));
  }
  return open.empty() ? "" : open.back();
}

TEST(Xml, AFileThatIsCutShortNamesTheElementThatIsOpen) {
  const std::string text = "<a><b x='1'><c/>12<d>3</d></b><b><b>4</b><e/></b>\n<f y='2'/><g><h>5</h></g></a>";
  ASSERT_TRUE(Xml::parse(text, "f").ok());
  std::size_t named = 0;
  for (std::size_t size = 1; size < text.size(); ++size) {
    const auto xml = Xml::parse(text.substr(0, size), "f");
    ASSERT_FALSE(xml.ok()) << size;
    ASSERT_TRUE(xml.error().place && xml.error().place->line >= 1) << size;
    ASSERT_EQ(xml.error().message.find('\n'), std::string::npos) << xml.error().message;
    const std::string open = open_at(text, size);
    if (open.empty()) continue;
    EXPECT_THAT(xml.error().message, HasSubstr("'" + open + "' is not closed")) << text.substr(0, size);
    ++named;
  }
  EXPECT_GT(named, 20U);
}

TEST(Xml, DepthsAndDeclaredEntitiesDoNoHarm) {
  constexpr std::size_t deep = 100'000;
  EXPECT_TRUE(Xml::parse(repeated("<a>", deep) + repeated("</a>", deep), "f").ok());
  EXPECT_THAT(Xml::parse(repeated("<a>", deep), "f").error().message, HasSubstr("'a' is not closed"));
  std::string bomb = "<!DOCTYPE a [<!ENTITY e0 'eeeeeeeeee'>";
  for (int i = 1; i < 20; ++i) {
    const std::string name = std::to_string(i);
    bomb += "<!ENTITY e" + name + " '" + repeated("&e" + std::to_string(i - 1) + ";", 10) + "'>";
  }
  const auto xml = Xml::parse(bomb + "]><a x='&e19;'>&e19; &lt;</a>", "f");
  ASSERT_TRUE(xml.ok());
  EXPECT_STREQ(xml->root().child("a").attribute("x").value(), "&e19;");
  EXPECT_STREQ(xml->root().child("a").child_value(), "&e19; <");
}

}  // namespace
}  // namespace dobra::io
