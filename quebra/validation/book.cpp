#include "quebra/validation/book.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "quebra/core/operations.h"
#include "shared/base/text.h"
#include "shared/scenario/runner.h"

namespace quebra::validation {

using namespace dobra;
using base::Error;
using base::ErrorCode;

namespace {

/// The text with others in the place of some characters.
std::string escaped(const std::string& text, const std::map<char, std::string>& others) {
  std::string out;
  for (const char c : text) out += others.contains(c) ? others.at(c) : std::string(1, c);
  return out;
}

}  // namespace

base::Result<std::vector<scenario::Document>> read_book(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  if (error || files.empty())
    return Error{ErrorCode::FileNotFound, error ? error.message() : "there is no scenario (.toml) in this folder",
                 base::Place{.file = folder.string()}};
  std::sort(files.begin(), files.end());
  std::vector<scenario::Document> book;
  for (const auto& file : files) {
    DOBRA_TRY(scenario::Document document, scenario::read_document(file));
    DOBRA_TRY_VOID(scenario::check(document, core::program()));
    for (const scenario::Expect& expect : document.expects) {
      if (expect.name.empty() || !expect.value || *expect.value == 0.0)
        return Error{ErrorCode::MissingKey, "a row of the book needs `name` and a `value` other than 0", expect.place};
    }
    book.push_back(std::move(document));
  }
  return book;
}

base::Result<std::vector<Row>> validate(const std::vector<scenario::Document>& book, const base::Progress& progress) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < book.size(); ++i) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(i) / static_cast<double>(book.size()), book[i].title);
    const scenario::Run run = scenario::Runner(core::program()).run(book[i]);
    if (run.error) return base::located(*run.error, base::Place{.file = book[i].file.string()});
    for (const scenario::Verdict& verdict : scenario::judge(book[i], core::program(), run)) {
      const scenario::Expect& expect = verdict.expect;
      if (!verdict.found) return Error{ErrorCode::UnknownQuantity, verdict.message, expect.place};
      const double off = std::abs(*verdict.found / *expect.value - 1.0);
      if (!std::isfinite(off))
        return Error{
            ErrorCode::CannotSolve,
            fmt::format("'{}' came out as {} against {}, which is no finite number to judge; no result is written",
                        expect.name, *verdict.found, *expect.value),
            expect.place};
      rows.push_back({expect, *verdict.found, off, verdict.met});
    }
  }
  return rows;
}

std::string csv(const std::vector<Row>& rows) {
  const auto quoted = [](const std::string& text) { return '"' + escaped(text, {{'"', "\"\""}}) + '"'; };
  std::string text = "section,case,value,reference,error,tolerance,met,source,note\n";
  for (const auto& [expect, value, error, met] : rows) {
    text +=
        fmt::format("{},{},{},{},{:.3e},{},{},{},{}\n", expect.section, quoted(expect.name), base::number_text(value),
                    base::number_text(*expect.value), error, base::number_text(expect.relative_tolerance),
                    met ? "yes" : "no", quoted(expect.source), quoted(expect.note));
  }
  return text;
}

std::string json(const std::vector<Row>& rows) {
  std::string text = "[";
  for (const auto& [expect, value, error, met] : rows) {
    nlohmann::ordered_json row = {{"section", expect.section}, {"case", expect.name}};
    row.update({{"value", value}, {"reference", *expect.value}, {"error", error}});
    row.update({{"tolerance", expect.relative_tolerance}, {"met", met}});
    row.update({{"source", expect.source}, {"note", expect.note}});
    text += (text.size() > 1 ? ",\n  " : "\n  ") + row.dump();
  }
  return text + "\n]\n";
}

std::string html(const std::vector<Row>& rows) {
  const auto plain = [](const std::string& text) {
    return escaped(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}});
  };
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>QUEBRA: "
      "validation</title>\n<style>body{font-family:sans-serif;margin:2em}table{border-collapse:collapse}"
      "td,th{padding:.2em .8em;border-bottom:1px solid #ccc;text-align:left}.no{background:#fdd}</style>\n<h1>QUEBRA: "
      "validation</h1>\n" +
      fmt::format("<p>{} values, {} within the tolerance.</p>\n", rows.size(),
                  std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.met; })) +
      "<table>\n"
      "<tr><th>Section</th><th>Case</th><th>Value</th><th>Reference</th><th>Error</th><th>Tolerance</th><th>Source</"
      "th><th>Note</th></tr>\n";
  for (const auto& [expect, value, error, met] : rows) {
    text += fmt::format(
        "<tr{}><td>{}</td><td>{}</td><td>{:.9g}</td><td>{:.9g}</td><td>{:.3g} %</td><td>{:.3g} "
        "%</td><td>{}</td><td>{}</td></tr>\n",
        met ? "" : " class=\"no\"", plain(expect.section), plain(expect.name), value, *expect.value, 100.0 * error,
        100.0 * expect.relative_tolerance, plain(expect.source), plain(expect.note));
  }
  return text + "</table></html>\n";
}

}  // namespace quebra::validation
