#include "shared/operations/offset_step.h"

#include <fmt/format.h>

#include "shared/base/text.h"
#include "shared/operations/offset_layers.h"

namespace dobra::operations {
namespace {

using base::Result;

std::string number_of(std::size_t step, const char* what) { return fmt::format("offset.{}.{}", step + 1, what); }

/// In the units of the results, as they stand in files.
std::vector<io::lines::Feature> features_in(const Offsets& offsets) {
  std::vector<OffsetFamily> families = offsets.families;
  const scenario::UnitSystem& units = offsets.units;
  if (!units.si()) {
    for (OffsetFamily& family : families) {
      for (DrawnOffset& curve : family.curves) {
        for (double* length : {&curve.distance, &curve.length, &curve.dropped_length})
          *length = units.from_si(*length, "m");
        if (curve.area) curve.area = units.from_si(*curve.area, "m2");
        for (geom::Polyline& line : curve.lines) {
          for (geom::Point& p : line.points) p = {units.from_si(p.x, "m"), units.from_si(p.y, "m")};
        }
      }
    }
  }
  return features_of(families);
}

/// Of all curves of a step.
struct Sums {
  std::size_t curves = 0, pieces = 0, dropped = 0;
  double length = 0.0;
  double area = 0.0;
  bool closed = true;
};

Sums sums_of(const Offsets& offsets) {
  Sums sums;
  for (const OffsetFamily& family : offsets.families) {
    for (const DrawnOffset& curve : family.curves) {
      ++sums.curves;
      sums.pieces += curve.lines.size();
      sums.dropped += curve.dropped;
      sums.length += curve.length;
      sums.area += curve.area.value_or(0.0);
      sums.closed = sums.closed && curve.area.has_value();
    }
  }
  return sums;
}

}  // namespace

Result<Offsets> offset_curves(const OffsetCaller& caller, const OffsetPlan& plan, io::formats::LineWork lines,
                              const std::string& file) {
  DOBRA_TRY(const OffsetInput input, offset_input(caller, std::move(lines), file, plan));
  Offsets made{.origin = input.origin, .verified = plan.verify, .of_file = !file.empty()};
  if (plan.stop_after > 0) {
    DOBRA_TRY(StagedOffsets staged, offset_stages(caller, file, input, plan));
    made.families = std::move(staged.families);
    made.stage = std::move(staged.stage);
  } else {
    DOBRA_TRY(made.families, offset_families(caller, file, input, plan, made.verdict));
  }
  DOBRA_TRY_VOID(check_numbers(made.families));
  return made;
}

std::vector<std::string> verdict_text(const Offsets& offsets, const OffsetPlan& plan) {
  const OffsetVerdict& verdict = offsets.verdict;
  std::vector<std::string> all{fmt::format(
      "verified {} edges of {} curves, and {} places where they must be: {}", verdict.edges, verdict.curves,
      verdict.samples,
      verdict.findings.empty() ? "nothing is wrong with them" : fmt::format("{} findings", verdict.findings.size()))};
  if (const std::string rest = not_judged(verdict, plan.curves); !rest.empty()) all.push_back("not judged: " + rest);
  return all;
}

Result<Offsets> offset_step(const OffsetParams& params, const std::vector<io::lines::Feature>& of_model,
                            const scenario::Context& context, const base::Progress& progress) {
  std::vector<std::string> remarks;
  const OffsetCaller caller{.note = [&](const std::string& note) { remarks.push_back("offset: " + note); },
                            .progress = progress};
  DOBRA_TRY(const OffsetPlan plan, offset_plan(params, caller));
  io::formats::LineWork lines;
  std::string file;
  if (params.file.empty()) {
    lines.features = of_model;
  } else {
    file = (context.folder / params.file).string();
    io::formats::LineOptions options;
    options.coordinates = io::formats::Coordinates::Section;
    options.silent_unit = context.units.to_si(1.0, "m");
    options.faulty = io::lines::Faulty::Skip;
    DOBRA_TRY(lines, io::formats::read_any_lines(file, options));
    for (const std::string& remark : lines.remarks) remarks.push_back(remark);
  }
  DOBRA_TRY(Offsets made, offset_curves(caller, plan, std::move(lines), file));
  for (const std::string& finding : made.verdict.findings) remarks.push_back("offset: " + finding);
  if (made.verified) {
    for (const std::string& line : verdict_text(made, plan)) remarks.push_back("offset: " + line);
  }
  if (made.stage) {
    remarks.push_back(fmt::format(
        "offset: the construction stands after {} steps, at {}, distance {} m; stop_after = 0 makes the curves",
        made.stage->steps, made.stage->curve, base::number_text(made.stage->distance)));
  }
  made.remarks = std::move(remarks);
  made.units = context.shown_units;
  return made;
}

void add_offset_quantities(const AllOffsets& all, std::vector<scenario::Quantity>& quantities) {
  for (std::size_t n = 0; n < all.size(); ++n) {
    const Sums sums = sums_of(*all[n]);
    const auto add = [&](const char* name, double value, const char* unit) {
      quantities.push_back({number_of(n, name), value, unit});
    };
    add("curves", static_cast<double>(sums.curves), "");
    add("pieces", static_cast<double>(sums.pieces), "");
    add("left_out", static_cast<double>(sums.dropped), "");
    add("length", sums.length, "m");
    if (sums.closed) add("area", sums.area, "m2");
    if (all[n]->verified) add("findings", static_cast<double>(all[n]->verdict.findings.size()), "");
    if (!all[n]->stage) continue;
    add("work.steps", static_cast<double>(all[n]->stage->steps), "");
    add("work.edges", static_cast<double>(all[n]->stage->so_far.size()), "");
    add("work.deleted", static_cast<double>(all[n]->stage->deleted.size()), "");
  }
}

void add_offset_tables(const AllOffsets& all, std::vector<scenario::DataTable>& tables) {
  if (all.empty()) return;
  scenario::DataTable table{"offset",
                            {"offset", "curve", "distance [m]", "pieces", "points", "length [m]", "area [m2]",
                             "left out", "length left out [m]"},
                            {}};
  for (std::size_t n = 0; n < all.size(); ++n) {
    for (const OffsetFamily& family : all[n]->families) {
      for (const DrawnOffset& curve : family.curves) {
        std::variant<double, std::string> area = std::string();
        if (curve.area) area = *curve.area;
        table.rows.push_back({static_cast<double>(n + 1), family.name, curve.distance,
                              static_cast<double>(curve.lines.size()), static_cast<double>(point_count(curve)),
                              curve.length, area, static_cast<double>(curve.dropped), curve.dropped_length});
      }
    }
  }
  tables.push_back(std::move(table));
}

void add_offset_remarks(const AllOffsets& all, std::vector<std::string>& remarks) {
  for (const Offsets* one : all) remarks.insert(remarks.end(), one->remarks.begin(), one->remarks.end());
}

void add_offset_outputs(const AllOffsets& all, const scenario::State& model, std::vector<scenario::Output>& outputs) {
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (all[n]->stage) continue;
    outputs.push_back(
        {fmt::format("offset_{}.geojson", n + 1), [one = all[n], model](const std::filesystem::path& path) {
           io::formats::LineWork work;
           work.features = features_in(*one);
           std::vector<std::string> losses;  // none of GeoJSON
           return io::formats::write_any_lines(path.string(), work, {.coordinates = io::formats::Coordinates::Section},
                                               losses);
         }});
  }
}

void draw_offsets(const AllOffsets& all, std::size_t state, scene::Picture& picture) {
  if (all.empty() || picture.panels.empty()) return;
  std::vector<scene::Layer>& layers = picture.panels.front().layers;
  const auto add = [&](std::vector<scene::Layer> more) {
    layers.insert(layers.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  for (std::size_t n = 0; n < all.size(); ++n) {
    const Offsets& one = *all[n];
    if (one.state != state) continue;
    const OffsetNaming naming{fmt::format("offset_{}", n + 1), one.units.to_si(1.0, "m"), one.units.length_unit()};
    if (one.of_file) add({base_layer(one.families, naming)});
    add(offset_layers(one.families, naming, one.stage ? Nothing::LeftOut : Nothing::Told));
    if (one.stage) add(stage_layers(*one.stage, naming));
  }
}

std::optional<bool> offsets_verified(const AllOffsets& all) {
  std::optional<bool> good;
  for (const Offsets* one : all) {
    if (one->verified) good = good.value_or(true) && one->verdict.findings.empty();
  }
  return good;
}

}  // namespace dobra::operations
