#include "quebra/domain/open_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quebra/sketch/ends.h"

namespace quebra::domain {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::geom::Point;
using dobra::geom::Polyline;

/// Chains are closed over gaps that are no wider than this fraction of their length; wider ones only round a loop.
constexpr double nearly_closed = 0.1;

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Ends 2k and 2k + 1 are those of the k-th open line; each is linked to the one that it would be joined with.
class Chains {
 public:
  Chains(std::vector<sketch::End> ends, double size) : ends_(std::move(ends)), link_(ends_.size(), none) {
    for (const sketch::NearEnds& pair : near_ends(ends_, sketch::RepairOptions::greatest_gap_fraction * size)) {
      if (link_[pair.a] == none && link_[pair.b] == none) join(pair.a, pair.b);
    }
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (link_[e] != none) continue;
      std::size_t last = e ^ 1U;
      while (link_[last] != none) last = link_[last] ^ 1U;
      join(e, last);
    }
  }

  /// The ends at which each line of the closed chain through end `first` begins, in order.
  [[nodiscard]] std::vector<std::size_t> from(std::size_t first) const {
    std::vector<std::size_t> starts;
    for (std::size_t e = first; starts.empty() || e != first; e = link_[e ^ 1U]) starts.push_back(e);
    return starts;
  }
  [[nodiscard]] const sketch::End& end(std::size_t e) const { return ends_[e]; }
  [[nodiscard]] const sketch::End& linked(std::size_t e) const { return ends_[link_[e]]; }
  [[nodiscard]] std::size_t size() const { return ends_.size(); }

 private:
  void join(std::size_t a, std::size_t b) {
    link_[a] = b;
    link_[b] = a;
  }

  std::vector<sketch::End> ends_;
  std::vector<std::size_t> link_;
};

/// A chain closed over its gaps.
struct Closed {
  Polyline outline{{}, true};
  double length = 0.0, gaps = 0.0;  ///< Of the lines, and of the gaps between them.
  std::size_t widest = none;        ///< The end at the widest gap.
  std::size_t count = 0;            ///< Of gaps.
};

Closed closed_chain(const std::vector<sketch::Curve>& curves, const Chains& chains,
                    const std::vector<std::size_t>& starts) {
  Closed chain;
  double widest = 0.0;
  for (const std::size_t e : starts) {
    const sketch::End& start = chains.end(e);
    Polyline line = trace(curves[start.curve]).line;
    if (start.last) line = reversed(std::move(line));
    chain.outline.points.insert(chain.outline.points.end(), line.points.begin(), line.points.end());
    chain.length += length(curves[start.curve]);
    const double gap = distance(start.at, chains.linked(e).at);
    if (gap == 0.0) continue;
    chain.gaps += gap;
    ++chain.count;
    if (gap > widest) chain.widest = e;
    widest = std::max(widest, gap);
  }
  return chain;
}

/// The first loop that the outline holds; nothing if there is none.
const Polyline* held_by(const Polyline& outline, const Inside& inside) {
  const auto box = outline.box();
  for (const Polyline& contour : inside.contours()) {
    const Point p = contour.points.front();
    if (p.x > box.low.x && p.x < box.high.x && locate(outline, p) == dobra::geom::Side::Inside) return &contour;
  }
  return nullptr;
}

}  // namespace

std::string gap_advice(double gap, double size, const std::optional<sketch::RepairOptions>& repaired) {
  const double limit = gap_limit(repaired.value_or(sketch::RepairOptions{}), size);
  std::string text =
      repaired ? fmt::format("--repair closes gaps up to {:.3g} m: ", limit)
               : fmt::format("close it, or give --repair (repair = \"yes\"), which closes gaps up to {:.3g} m", limit);
  if (gap <= limit) return repaired ? text + "close it by hand" : text;
  if (gap > sketch::RepairOptions::greatest_gap_fraction * size)
    return repaired ? text + "close it by hand" : text + " and never one as wide as this";
  const double step = std::pow(10.0, std::floor(std::log10(gap)) - 1.0);
  const double enough = step * std::ceil(gap / step * (1.0 + 1e-9));
  return text + fmt::format("{} --gap (gap in [input]) of {:.3g} m{}", repaired ? "give" : "; for this one give also",
                            enough, repaired ? ", or close it by hand" : "");
}

std::optional<Error> open_outline(const std::vector<sketch::Curve>& curves, const std::vector<Place>& places,
                                  const Inside& inside, const std::optional<sketch::RepairOptions>& repaired) {
  std::vector<sketch::End> ends = open_ends(curves);
  std::erase_if(ends, [&](const sketch::End& end) {
    const sketch::Curve& curve = curves[end.curve];
    return curve.role != sketch::Role::Internal || inside(point(curve, 0.5 * length(curve)));
  });
  dobra::geom::Box box;
  for (const sketch::Curve& curve : curves) box.add(box_of(curve));
  const Chains chains(std::move(ends), box.diagonal());
  std::vector<bool> done(chains.size(), false);
  for (std::size_t e = 0; e < chains.size(); ++e) {
    if (done[e]) continue;
    const auto starts = chains.from(e);
    for (const std::size_t s : starts) done[s] = done[s ^ 1U] = true;
    const Closed chain = closed_chain(curves, chains, starts);
    if (chain.widest == none) continue;
    const bool holds = held_by(chain.outline, inside) != nullptr;
    if (!holds && chain.gaps > nearly_closed * chain.length) continue;
    const sketch::End& a = chains.end(chain.widest);
    const sketch::End& b = chains.linked(chain.widest);
    Place place = a.curve < places.size() ? places[a.curve] : Place{};
    place.x = a.at.x;
    place.y = a.at.y;
    return Error{
        ErrorCode::BadDomain,
        fmt::format("an outline stays open{}: {}{}; {}",
                    holds ? ", and without it a loop that it holds would bound the material" : "",
                    gap_text(curves, a, b), chain.count > 1 ? fmt::format(", the widest of {}", chain.count) : "",
                    gap_advice(distance(a.at, b.at), box.diagonal(), repaired)),
        place};
  }
  return std::nullopt;
}

}  // namespace quebra::domain
