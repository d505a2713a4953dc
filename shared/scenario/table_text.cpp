#include "shared/scenario/table_text.h"

#include "shared/base/text.h"

namespace dobra::scenario {
namespace {

std::string cell_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}
std::string cell_text(double number) { return base::number_text(number); }

}  // namespace

std::string csv_text(const DataTable& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += (i > 0 ? "," : "") + cell_text(table.columns[i]);
  out += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += (i > 0 ? "," : "") + std::visit([](const auto& cell) { return cell_text(cell); }, row[i]);
    }
    out += '\n';
  }
  return out;
}

}  // namespace dobra::scenario
