// The worked example of docs/algorithms/offset_example.md: one small base, and what each stage of the general engine
// makes of it. Titles count what was found.
#include <fmt/format.h>

#include <algorithm>

#include "shared/offset/general/contact.h"
#include "shared/offset/general/pairs.h"
#include "shared/offset/general/validity.h"
#include "shared/offset/offset.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using offset::CornerKind;
using offset::Flat;
using offset::Real;
using offset::Site;
using offset::SiteKind;
using offset::Vec;
using offset::general::Outline;

constexpr double d = 0.6;
constexpr scene::Color light{240, 178, 92};

/// A notch, a bulb with a neck that is narrower than 2 D, and an end that comes back below.
geom::Polyline example() {
  return chain({{-2, 0},
                {0.8, 0},
                {1, 0.4},
                {1.2, 0},
                {2, 0},
                {2.2, 1},
                {1.2, 2.2},
                {2.4, 3.6},
                {4.2, 3.4},
                {4.8, 2},
                {3.2, 1},
                {3.4, 0},
                {5.4, 0.2},
                {5.9, -0.7},
                {4.2, -1.05}});
}

bool straight(Site site) { return site.kind == SiteKind::Line || site.kind == SiteKind::Bevel; }

/// A part of a piece with the places where others cut it.
struct Stretch {
  Site site;
  Flat a, b;
  bool linked;  ///< Begins where the one before ends.
  std::vector<Flat> cuts;
};

/// The stages, one after the other. In the engine the last three are Trimmer's (sections.h).
class Stages {
 public:
  Stages(const offset::BaseCurve& base, const geom::Polyline& line)
      : base_(base),
        line_(line),
        clearance_(base, {.join = offset::Join::Round}),
        outline_(base, clearance_.corners(), Outline::Sides::Both, d),
        witnesses_(outline_, clearance_),
        known_(base, clearance_),
        chain_(offset::general::candidates(outline_, clearance_, witnesses_, known_, nullptr, {})) {
    for (const auto& p : chain_.pieces) {
      stretches_.push_back({p.site(), chain_.start(outline_, p), chain_.end(outline_, p), p.linked(), {}});
    }
    wanted_ = stretches_.size();
    const base::Progress progress;
    pairs_ = offset::general::Pairing(outline_, clearance_, chain_, witnesses_, progress).run(known_, nullptr);
    for (std::size_t k = wanted_; k < chain_.pieces.size(); ++k) {
      const Site site = chain_.pieces[k].site();
      stretches_.push_back({site, outline_.start_of(site), outline_.end_of(site), false, {}});
    }
    for (const auto& [i, j] : pairs_) cut(stretches_[i], stretches_[j]);
  }

  [[nodiscard]] scene::Panel raw() const {
    std::vector<geom::Polyline> all;
    std::vector<scene::Label> numbers;
    for (std::uint32_t step = 0; step < base_.segment_count(); ++step) {
      std::vector<Site> sites{{step, SiteKind::Line}};
      if (outline_.corner(step) == CornerKind::Arc && !outline_.is_cap(step)) {
        sites.push_back({step, SiteKind::Arc});
        if (outline_.splits_arc(step)) sites.push_back({step, SiteKind::SecondArc});
      }
      for (const Site site : sites) all.push_back(drawn(site, outline_.start_of(site), outline_.end_of(site)));
      const geom::Segment s = line_.segment(step);
      const Point middle = geom::midpoint(s.from, s.to);
      numbers.push_back({middle + 0.18 * geom::left_of(geom::normalised(s.vector())), std::to_string(step)});
    }
    const std::string title = fmt::format("1  Raw outline: {} pieces", all.size());
    return panel_of(title, {lines({}, stroke(red, 1.4), std::move(all)), labels(ink, std::move(numbers))});
  }

  [[nodiscard]] scene::Panel candidates() const {
    return panel_of(fmt::format("2  Candidates: {} pieces", wanted_),
                    {lines({}, stroke(light, 4.0), drawn_from(0, wanted_)), markers({}, dots(ink, 4.0), ends())});
  }

  [[nodiscard]] scene::Panel pairs() const {
    std::vector<geom::Polyline> links;
    for (const auto& [i, j] : pairs_) links.push_back(chain({middle(stretches_[i]), middle(stretches_[j])}));
    return panel_of(fmt::format("3  Pairs: {}; cutters: {}", pairs_.size(), stretches_.size() - wanted_),
                    {lines({}, stroke(light, 4.0), drawn_from(0, wanted_)),
                     lines({}, stroke(green, 1.6), drawn_from(wanted_, stretches_.size())),
                     lines({}, stroke(grey, 1.0, scene::Dash::Dashed), std::move(links))});
  }

  [[nodiscard]] scene::Panel cuts() const {
    std::vector<Point> places;
    for (std::size_t k = 0; k < wanted_; ++k) {
      for (const Flat p : stretches_[k].cuts) places.push_back(user(p));
    }
    std::vector<Point> apart;  // a place once, though two pieces are cut there
    for (const Point p : places) {
      if (std::ranges::none_of(apart, [&](Point q) { return geom::distance(p, q) < 1e-9; })) apart.push_back(p);
    }
    const std::string title = fmt::format("4  Cuts: at {} places", apart.size());
    return panel_of(title, {lines({}, stroke(light, 4.0), drawn_from(0, wanted_)),
                            lines({}, stroke(green, 1.6), drawn_from(wanted_, stretches_.size())),
                            markers({}, dots(red, 6.0), std::move(apart))});
  }

  [[nodiscard]] scene::Panel sections() {
    std::vector<geom::Polyline> valid, invalid, now;
    std::size_t count = 0;
    std::size_t good = 0;
    std::pair<double, bool> longest{-1, false};  // of the section's parts, and whether its middle is free
    const auto end_section = [&] {
      if (now.empty()) return;
      ++count;
      good += longest.second ? 1 : 0;
      auto& all = longest.second ? valid : invalid;
      all.insert(all.end(), now.begin(), now.end());
      now.clear();
      longest.first = -1;
    };
    for (std::size_t k = 0; k < wanted_; ++k) {
      const Stretch& s = stretches_[k];
      if (!s.linked) end_section();
      std::vector<Flat> places = s.cuts;
      std::ranges::sort(places, {}, [&](Flat p) { return length(p - s.a); });
      places.insert(places.begin(), s.a);
      places.push_back(s.b);
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        if (i > 0) end_section();
        now.push_back(drawn(s.site, places[i], places[i + 1]));
        const double size = length(places[i + 1] - places[i]);
        if (size > longest.first) longest = {size, is_free(s.site, places[i], places[i + 1])};
      }
    }
    end_section();
    return panel_of(fmt::format("5  Sections: {}, of which {} are valid", count, good),
                    {lines({}, stroke(red, 1.4, scene::Dash::Dashed), std::move(invalid)),
                     lines({}, stroke(blue, 2.4), std::move(valid))});
  }

  [[nodiscard]] base::Result<scene::Panel> curve() const {
    const offset::OffsetOptions options{.join = offset::Join::Round};
    DOBRA_TRY(const auto curves, offset::offset(line_, std::vector{d}, options));
    const auto& pieces = curves.front().pieces;
    const std::string title = fmt::format("6  The curve; {} shorter piece dropped", curves.front().dropped);
    return panel_of(title, {lines({}, stroke(blue, 2.4), {offset::chords(pieces.front(), line_).polyline}),
                            markers({}, dots(blue, 5.0), pieces.front().points)});
  }

 private:
  [[nodiscard]] scene::Panel panel_of(std::string title, std::vector<scene::Layer> layers) const {
    layers.push_back(lines({}, stroke(ink, 2.2), {line_}));
    scene::Panel made = panel(std::move(title), std::move(layers), 0.0, {"", ""});
    made.extent = line_.box().grown(1.35 * d);
    return made;
  }
  [[nodiscard]] Point user(Flat p) const { return base_.user(Point{p.x, p.y}); }
  [[nodiscard]] Flat on_circle(Site site, Flat p) const {
    const Flat c = outline_.centre(site);
    return c + (d / length(p - c)) * (p - c);
  }
  [[nodiscard]] geom::Polyline drawn(Site site, Flat a, Flat b) const {
    const int steps = straight(site) ? 1 : 12;
    geom::Polyline line;
    for (int i = 0; i <= steps; ++i) {
      const Flat p = a + (static_cast<double>(i) / steps) * (b - a);
      line.points.push_back(user(straight(site) ? p : on_circle(site, p)));
    }
    return line;
  }
  [[nodiscard]] std::vector<geom::Polyline> drawn_from(std::size_t first, std::size_t last) const {
    std::vector<geom::Polyline> all;
    for (std::size_t k = first; k < last; ++k) {
      all.push_back(drawn(stretches_[k].site, stretches_[k].a, stretches_[k].b));
    }
    return all;
  }
  [[nodiscard]] std::vector<Point> ends() const {
    std::vector<Point> all;
    for (std::size_t k = 0; k < wanted_; ++k) all.insert(all.end(), {user(stretches_[k].a), user(stretches_[k].b)});
    return all;
  }
  [[nodiscard]] Point middle(const Stretch& s) const {
    const Flat half = 0.5 * (s.a + s.b);
    return user(straight(s.site) ? half : on_circle(s.site, half));
  }
  [[nodiscard]] offset::general::Shape<Real> shape(const Stretch& s) const {
    offset::general::Shape<Real> made;
    made.line = straight(s.site);
    made.a = exact(s.a);
    made.b = exact(s.b);
    made.pole = made.line ? unit(made.b - made.a) : outline_.to<Real>(s.site.step);
    made.size = length(made.b - made.a);
    made.error = made.slide = 1e-14;
    return made;
  }
  void cut(Stretch& p, Stretch& q) const {
    for (const auto& contact : offset::general::Contacts<Real>(shape(p), shape(q), d)) {
      p.cuts.push_back(flat(contact.at));
      q.cuts.push_back(flat(contact.at));
    }
  }
  [[nodiscard]] bool is_free(Site site, Flat a, Flat b) const {
    const Flat half = 0.5 * (a + b);
    const Vec place = exact(straight(site) ? half : on_circle(site, half));
    offset::general::Validity validity(outline_, clearance_);
    return validity.of(place, site, 1e-14) == offset::general::Place::Free;
  }

  const offset::BaseCurve& base_;
  const geom::Polyline& line_;
  const offset::general::Clearance clearance_;
  const Outline outline_;
  offset::general::WitnessSearch witnesses_;
  const offset::general::Buried known_;
  offset::general::Candidates chain_;
  std::vector<Stretch> stretches_;  // the candidates, then the cutters
  std::size_t wanted_ = 0;
  offset::general::Pairing::Pairs pairs_;
};

}  // namespace

base::Result<scene::Picture> offset_stages() {
  const geom::Polyline line = example();
  DOBRA_TRY(const offset::BaseCurve base, offset::prepare(line, offset::Side::RightOfTravel));
  Stages stages(base, line);
  DOBRA_TRY(scene::Panel curve, stages.curve());
  return scene::Picture{
      {},
      {stages.raw(), stages.candidates(), stages.pairs(), stages.cuts(), stages.sections(), std::move(curve)},
      scene::Arrangement::Grid};
}

}  // namespace dobra::figures
