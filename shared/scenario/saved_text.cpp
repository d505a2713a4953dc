// Saving changes no more of a file than the document has changed: its text is cut into tables and keys, and those whose
// canonical text is another now are exchanged in it.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "shared/base/text.h"
#include "shared/scenario/document.h"

namespace dobra::scenario {

namespace {

/// A header or "key = value", with the lines above it and what stands behind it on its last line.
struct Piece {
  std::string key;  ///< Empty for a header.
  std::string lead;
  std::string body;
  std::string tail;
  [[nodiscard]] std::string canonical() const { return lead + body; }
  [[nodiscard]] std::string all() const { return lead + body + tail; }
};

/// A header with its keys; the first of a text has no header.
struct Block {
  std::string header;
  std::vector<Piece> pieces{};

  [[nodiscard]] std::string canonical() const {
    std::string text = header;
    for (const Piece& piece : pieces) text += piece.canonical();
    return text;
  }
  [[nodiscard]] const Piece* find(const std::string& key) const {
    const auto found = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.key == key; });
    return found == pieces.end() ? nullptr : &*found;
  }
};

struct Text {
  std::vector<Block> blocks{};
  std::string end{};  ///< Comments below everything.
};

/// Where the text or comment that begins at `at` ends; `at` itself if none does.
std::size_t end_of_quoted(const std::string& text, std::size_t at) {
  const char mark = text[at];
  if (mark == '#') return std::min(text.find('\n', at), text.size());
  if (mark != '"' && mark != '\'') return at;
  const std::string three(3, mark);
  const bool long_text = text.compare(at, 3, three) == 0;
  const std::size_t width = long_text ? 3 : 1;
  for (std::size_t i = at + width; i < text.size(); ++i) {
    if (mark == '"' && text[i] == '\\') {
      ++i;
    } else if (long_text ? text.compare(i, 3, three) == 0 : text[i] == mark) {
      return i + width;
    }
  }
  return text.size();
}

/// Behind the last character of the value, or header, that begins at `at`.
std::size_t end_of_value(const std::string& text, std::size_t at) {
  std::size_t end = at;
  int depth = 0;
  while (at < text.size()) {
    if (depth == 0 && (text[at] == '\n' || text[at] == '#')) break;
    const std::size_t quoted = end_of_quoted(text, at);
    if (text[at] == '[' || text[at] == '{') ++depth;
    if (text[at] == ']' || text[at] == '}') --depth;
    const bool blank = std::string(" \t\r\n").find(text[at]) != std::string::npos;
    at = std::max(quoted, at + 1);
    if (!blank) end = at;
  }
  return end;
}

Text cut(const std::string& text) {
  Text cut{{Block{}}, {}};
  std::string lead;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t first = text.find_first_not_of(" \t", at);
    const char sign = first < text.size() ? text[first] : '\n';
    const bool nothing = sign == '\n' || sign == '\r' || sign == '#';
    const std::size_t value = nothing ? at : end_of_value(text, first);
    const std::size_t end = std::min(text.find('\n', value), text.size() - 1) + 1;
    if (nothing) {
      lead += text.substr(at, end - at);
    } else {
      Piece piece{{}, std::exchange(lead, {}), text.substr(at, value - at), text.substr(value, end - value)};
      if (sign == '[') {
        cut.blocks.push_back({std::string(base::trimmed(piece.body)), {}});
      } else {
        piece.key = base::trimmed(piece.body.substr(0, piece.body.find('=')), " \t\"'");
      }
      cut.blocks.back().pieces.push_back(std::move(piece));
    }
    at = end;
  }
  cut.end = lead;
  return cut;
}

/// The items of a list in a body "key = [...]", as places in it; nothing if the value is no list.
std::vector<std::pair<std::size_t, std::size_t>> items_of(const std::string& body) {
  std::vector<std::pair<std::size_t, std::size_t>> items;
  std::size_t at = body.find('=');
  at = at == std::string::npos ? at : body.find_first_not_of(" \t", at + 1);
  if (at == std::string::npos || body[at] != '[') return items;
  std::optional<std::size_t> begin;
  int depth = 1;
  for (++at; at < body.size() && depth > 0;) {
    const std::size_t next = std::max(end_of_quoted(body, at), at + 1);
    const bool comment = body[at] == '#';
    if (body[at] == ']' || body[at] == '}') --depth;
    if ((depth == 1 && body[at] == ',') || depth == 0) {
      begin.reset();
    } else if (!comment && std::string(" \t\r\n").find(body[at]) == std::string::npos) {
      if (!begin) items.emplace_back(*(begin = at), next);
      items.back().second = next;
    }
    if (body[at] == '[' || body[at] == '{') ++depth;
    at = next;
  }
  return items;
}

/// `written` with the items of its list that differ between `before` and `after`; `after` where it is no such list.
std::string with_items(const std::string& written, const std::string& before, const std::string& after) {
  const auto old_items = items_of(before), new_items = items_of(after), items = items_of(written);
  if (items.empty() || new_items.empty() || items.size() != old_items.size()) return after;
  const auto text = [](const std::string& body, std::pair<std::size_t, std::size_t> item) {
    return body.substr(item.first, item.second - item.first);
  };
  const std::size_t n = items.size(), m = new_items.size(), shorter = std::min(n, m);
  std::size_t front = 0, back = 0;
  while (front < shorter && text(before, old_items[front]) == text(after, new_items[front])) ++front;
  while (back < shorter - front && text(before, old_items[n - 1 - back]) == text(after, new_items[m - 1 - back]))
    ++back;
  if (front + back == 0 && n != m) return after;
  std::string out = written;
  if (n == m) {  // from the last on, so that places stay
    for (std::size_t i = n; i-- > 0;) {
      const std::string item = text(after, new_items[i]);
      if (item != text(before, old_items[i])) out.replace(items[i].first, items[i].second - items[i].first, item);
    }
    return out;
  }
  std::string middle;
  for (std::size_t i = front; i < m - back; ++i) {
    const std::string item = text(after, new_items[i]);
    middle += back > 0 ? item + ", " : ", " + item;
  }
  const std::size_t from = back > 0 ? items[front].first : items[front - 1].second;
  const std::size_t to = back > 0 ? items[n - back].first : items[n - 1].second;
  return out.replace(from, to - from, middle);
}

/// Of each block of `after` the block of `before` that it was: equal ones in their order, then such as share a key with
/// its value.
std::vector<std::optional<std::size_t>> partners(const std::vector<Block>& before, const std::vector<Block>& after) {
  std::vector<std::optional<std::size_t>> of(after.size());
  std::vector<bool> taken(before.size(), false);
  const auto pair = [&](std::size_t new_one, std::size_t old_one) {
    of[new_one] = old_one;
    taken[old_one] = true;
  };
  std::multimap<std::string, std::size_t> by_text;
  for (std::size_t i = before.size(); i-- > 0;) by_text.emplace(before[i].canonical(), i);
  for (std::size_t k = 0; k < after.size(); ++k) {
    const auto [first, last] = by_text.equal_range(after[k].canonical());
    if (first == last) continue;
    const auto found = std::prev(last);  // the first of equal ones
    pair(k, found->second);
    by_text.erase(found);
  }
  const auto alike = [](const Block& a, const Block& b) {
    return a.header == b.header && (a.header.empty() || a.header == "[input]" ||
                                    std::any_of(a.pieces.begin(), a.pieces.end(), [&](const Piece& piece) {
                                      const Piece* other = b.find(piece.key);
                                      return !piece.key.empty() && other != nullptr && other->body == piece.body;
                                    }));
  };
  for (std::size_t k = 0; k < after.size(); ++k) {
    for (std::size_t i = 0; i < before.size() && !of[k]; ++i) {
      if (!taken[i] && alike(before[i], after[k])) pair(k, i);
    }
  }
  return of;
}

/// A block as it is written, with what differs between `before` and `after`.
std::string merged(const Block& written, const Block& before, const Block& after) {
  std::map<std::string, std::string> behind;  ///< New keys, by the key that they follow.
  std::string follows;
  for (const Piece& piece : after.pieces) {
    if (written.find(piece.key) == nullptr)
      behind[follows] += piece.all();
    else
      follows = piece.key;
  }
  std::string out;
  for (const Piece& piece : written.pieces) {
    const Piece* was = before.find(piece.key);
    const Piece* is = after.find(piece.key);
    if (is == nullptr && was != nullptr) continue;
    if (is == nullptr || (was != nullptr && was->canonical() == is->canonical()))
      out += piece.all();
    else if (was == nullptr || was->lead != is->lead)
      out += is->all();
    else
      out += piece.lead + with_items(piece.body, was->body, is->body) + piece.tail;
    if (!out.empty() && out.back() != '\n') out += '\n';
    out += behind[piece.key];
  }
  return written.pieces.empty() ? behind[""] : out;
}

std::string with_changes(const Text& source, const Text& before, const Text& after) {
  // The k-th table of a name is the k-th in both.
  std::map<std::string, std::vector<std::size_t>> named;
  for (std::size_t i = 0; i < source.blocks.size(); ++i) named[source.blocks[i].header].push_back(i);
  std::map<std::string, std::size_t> seen;
  std::vector<std::optional<std::size_t>> place(before.blocks.size());
  for (std::size_t i = 0; i < before.blocks.size(); ++i) {
    const std::vector<std::size_t>& all = named[before.blocks[i].header];
    const std::size_t k = seen[before.blocks[i].header]++;
    if (k < all.size()) place[i] = all[k];
  }
  const std::vector<std::optional<std::size_t>> partner = partners(before.blocks, after.blocks);
  // Tables that follow each other as before keep their places; others go behind the one that they follow now.
  std::vector<std::string> texts(source.blocks.size());
  std::vector<bool> known(source.blocks.size(), false);
  for (const std::optional<std::size_t>& at : place) {
    if (at) known[*at] = true;
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (const Piece& piece : source.blocks[i].pieces) texts[i] += known[i] ? std::string() : piece.all();
  }
  std::size_t last = 0;
  for (std::size_t k = 0; k < after.blocks.size(); ++k) {
    const std::optional<std::size_t> at = partner[k] ? place[*partner[k]] : std::nullopt;
    std::string text;
    if (at) {
      text = merged(source.blocks[*at], before.blocks[*partner[k]], after.blocks[k]);
    } else {
      for (const Piece& piece : after.blocks[k].pieces) text += piece.all();
      if (partner[k]) text.clear();  // a header that the source does without
    }
    if (at && *at >= last) last = *at;
    if (!texts[last].empty() && texts[last].back() != '\n') texts[last] += '\n';
    texts[last] += text;
  }
  std::string out;
  for (const std::string& text : texts) out += text;
  return out + (before.end == after.end ? source.end : after.end);
}

}  // namespace

std::string saved_text(const Document& document) {
  std::string canonical = document_text(document);
  if (!document.source) return canonical;
  const base::Result<Document> read = parse_document(*document.source, document.file);
  if (!read) return canonical;
  const std::string before = document_text(*read);
  if (before == canonical) return *document.source;
  const std::string text = with_changes(cut(*document.source), cut(before), cut(canonical));
  const base::Result<Document> again = parse_document(text, document.file);
  return again && document_text(*again) == canonical ? text : canonical;
}

}  // namespace dobra::scenario
