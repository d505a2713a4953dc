#pragma once
// The Brazilian texts of the tree, and the texts of a program that need one.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "shared/io/file.h"
#include "shared/scenario/program.h"

namespace dobra::test {

inline std::string unescaped(std::string text) {
  for (const auto& [entity, sign] :
       {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}) {
    const std::string wanted = entity;
    for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1))
      text.replace(at, wanted.size(), sign);
  }
  return text;
}

/// Source texts and their translations.
inline std::map<std::string, std::string> brazilian() {
  const std::string ts =
      io::read_text(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/translations/dobra_pt_BR.ts").value();
  std::map<std::string, std::string> texts;
  const auto between = [&](const std::string& open, const std::string& close, std::size_t& at) {
    const std::size_t begin = ts.find(open, at);
    if (begin == std::string::npos) return std::string();
    const std::size_t end = ts.find(close, begin);
    at = end;
    return unescaped(ts.substr(begin + open.size(), end - begin - open.size()));
  };
  for (std::size_t at = 0; ts.find("<source>", at) != std::string::npos;) {
    const std::string source = between("<source>", "</source>", at);
    texts[source] = between("<translation>", "</translation>", at);
  }
  return texts;
}

inline void collect(const std::vector<scenario::Field>& fields, std::set<std::string>& texts) {
  for (const scenario::Field& field : fields) {
    texts.insert({field.options.title, field.options.help});
    for (const scenario::FileKind& kind : field.options.files) texts.insert(kind.title);
    collect(field.fields, texts);
  }
}

/// Of its forms and its help.
inline std::set<std::string> texts_of(const scenario::Program& program) {
  std::set<std::string> texts;
  collect(program.input_fields, texts);
  for (const scenario::Operation& operation : program.operations) {
    texts.insert({operation.title, operation.help});
    collect(operation.fields, texts);
  }
  for (const scenario::Importing::Kind& kind : program.importing.kinds) texts.insert(kind.title);
  for (const scenario::FileKind& kind : program.importing.files) texts.insert(kind.title);
  texts.erase("");
  return texts;
}

/// Of these texts those without a Brazilian one.
inline std::vector<std::string> untranslated(const std::set<std::string>& texts) {
  const std::map<std::string, std::string> known = brazilian();
  std::vector<std::string> missing;
  for (const std::string& text : texts) {
    if (known.count(text) == 0 || known.at(text).empty()) missing.push_back(text);
  }
  return missing;
}

}  // namespace dobra::test
