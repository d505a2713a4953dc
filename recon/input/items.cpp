#include "recon/input/items.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/section/crossings.h"
#include "shared/geom/place.h"
#include "shared/io/gis/raster.h"

namespace recon::input {

namespace {

template <class Input>
base::Result<void> check_names(const std::vector<Input>& inputs, const char* kind) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    base::Place place;
    place.item = fmt::format("{} '{}'", kind, inputs[i].name);
    for (std::size_t j = 0; j < i; ++j) {
      if (inputs[j].name != inputs[i].name) continue;
      return base::Error{base::ErrorCode::BadSection, "two of them have this name; change one of them", place};
    }
  }
  return {};
}

/// As `read_line`, with the kind of thing in the place of errors.
base::Result<ReadLine> read_item(const HorizonInput& input, const char* kind, const ReadSettings& settings,
                                 const dobra::scenario::Context& context, std::vector<std::string>& remarks) {
  auto read = read_line(input, settings, context);
  const std::string item = fmt::format("{} '{}'", kind, input.name);
  if (!read) {
    base::Error error = read.error();
    if (error.place) error.place->item = item;
    return error;
  }
  for (const std::string& remark : read->remarks) remarks.push_back(item + ": " + remark);
  return read;
}

base::Place source_of(const HorizonInput& input) {
  base::Place place;
  place.file = input.file;
  return place;
}

/// A closed line of that kind.
base::Result<geom::Polyline> read_polygon(const HorizonInput& input, const char* kind, const ReadSettings& settings,
                                          const dobra::scenario::Context& context, std::vector<std::string>& remarks) {
  DOBRA_TRY(ReadLine line, read_item(input, kind, settings, context, remarks));
  auto contour = closed_contour(std::move(line.line));
  if (contour) return contour;
  base::Error error = contour.error();
  error.place->file = input.file;
  error.place->item = fmt::format("{} '{}'", kind, input.name);
  return error;
}

/// Adds a line of each input, faults with their ages and hanging walls.
template <class Input>
base::Result<void> read_lines(const std::vector<Input>& inputs, section::LineKind kind, const ReadSettings& settings,
                              const dobra::scenario::Context& context, ReadSection& read) {
  DOBRA_TRY_VOID(check_names(inputs, kind_name(kind)));
  for (const Input& wanted : inputs) {
    DOBRA_TRY(ReadLine line, read_item(wanted, kind_name(kind), settings, context, read.remarks));
    const bool runs_right = kind == section::LineKind::Topography || kind == section::LineKind::Datum;
    if (runs_right && line.line.points.front().x > line.line.points.back().x)
      line.line = geom::reversed(std::move(line.line));
    section::SectionLine made{section::LineId(read.section.lines.size()), kind, wanted.name, std::move(line.line),
                              source_of(wanted)};
    if constexpr (std::is_same_v<Input, FaultInput>) {
      made.piece_of = wanted.piece_of;
      made.order = wanted.age.value_or(0);
      made.hanging_wall = wanted.hanging_wall;
    }
    read.section.lines.push_back(std::move(made));
  }
  return {};
}

/// Pieces of one fault say the same of its age and its hanging wall, and a whole fault has no pieces.
base::Result<void> check_pieces(const std::vector<FaultInput>& faults) {
  for (const FaultInput& piece : faults) {
    if (piece.piece_of.empty()) continue;
    const auto refuse = [&](const std::string& what) {
      return base::Error{base::ErrorCode::BadSection, what, base::Place{.item = fmt::format("fault '{}'", piece.name)}};
    };
    for (const FaultInput& other : faults) {
      if (other.name == piece.piece_of) {
        return refuse(
            fmt::format("piece_of names '{0}', which is a fault itself; give that one another name and "
                        "piece_of = \"{0}\" too",
                        piece.piece_of));
      }
      if (other.piece_of != piece.piece_of) continue;
      if (other.age != piece.age || other.hanging_wall != piece.hanging_wall) {
        return refuse(
            fmt::format("'{}' is a piece of fault '{}' too, but has another order or hanging_wall; say the "
                        "same of both",
                        other.name, piece.piece_of));
      }
    }
  }
  return {};
}

base::Result<void> read_blocks(const std::vector<BlockInput>& blocks, section::Section& section) {
  for (const BlockInput& block : blocks) {
    const auto same = [&](const section::BlockName& other) { return other.name == block.name; };
    if (block.name.empty() || std::any_of(section.block_names.begin(), section.block_names.end(), same)) {
      return base::Error{base::ErrorCode::BadSection,
                         block.name.empty() ? "a block needs a name" : "two blocks have this name; change one of them",
                         base::Place{.item = fmt::format("block '{}'", block.name)}};
    }
    section.block_names.push_back({block.name, to_section(block.point, section.convention), block.part_of});
  }
  return {};
}

}  // namespace

base::Result<geom::Polyline> closed_contour(geom::Polyline line) {
  const geom::Point first = line.points.front();
  const geom::Point last = line.points.back();
  double longest = 0.0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    longest = std::max(longest, geom::distance(line.points[i], line.points[i + 1]));
  if (const double gap = geom::distance(first, last); gap > longest) {
    return base::Error{
        base::ErrorCode::BadSection,
        fmt::format("the polygon does not close: its last point is {:.6g} m from its first, farther than any "
                    "other side is long; add the missing points, or repeat the first point at the end",
                    gap),
        place_at(last)};
  }
  line.closed = true;
  line = geom::without_repeated_points(std::move(line));
  if (line.points.size() < 3) {
    return base::Error{base::ErrorCode::BadSection, "a polygon needs three different points", place_at(first)};
  }
  if (const auto contacts = section::self_crossings(line); !contacts.empty()) {
    return base::Error{base::ErrorCode::BadSection, "the polygon crosses or touches itself here; correct it",
                       place_at(contacts.front().place)};
  }
  return geom::signed_area(line) < 0.0 ? geom::reversed(std::move(line)) : line;
}

bool seems_of_another_unit(const geom::Box& item, const geom::Box& section) {
  const double ratio = section.diagonal() / item.diagonal();
  for (const double factor : {1000.0, 1e-3}) {
    // As large as the section, and where it is, once in its unit.
    if (ratio < 0.3 * factor || ratio > 3.0 * factor) continue;
    const geom::Box scaled{{factor * item.low.x, factor * item.low.y}, {factor * item.high.x, factor * item.high.y}};
    if (scaled.overlaps(section.grown(section.diagonal()))) return true;
  }
  return false;
}

base::Result<void> check_units(const section::Section& section, const SectionInput& input) {
  geom::Box largest;
  for (const section::Horizon& horizon : section.horizons) {
    if (horizon.line.box().diagonal() > largest.diagonal()) largest = horizon.line.box();
  }
  const auto refuse = [&](const std::string& item, const base::Place& source, const geom::Box& box, geom::Point at) {
    base::Place place = place_at(at, item);
    place.file = source.file;
    return base::Error{
        base::ErrorCode::BadSection,
        fmt::format("it is {:.6g} m long while the largest horizon is {:.6g} m long: metres and kilometres seem to be "
                    "mixed; bring all to one unit, or say its own with unit = \"km\" (unit = \"m\" if it is right)",
                    box.diagonal(), largest.diagonal()),
        place};
  };
  const auto says_unit = [](const auto& inputs, const std::string& name) {
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const HorizonInput& i) { return i.name == name && i.unit != LineUnit::Section; });
  };
  for (const section::Horizon& horizon : section.horizons) {
    const geom::Box box = horizon.line.box();
    if (says_unit(input.horizons, horizon.name) || !seems_of_another_unit(box, largest)) continue;
    return refuse(fmt::format("horizon '{}'", horizon.name), horizon.source, box, horizon.line.points.front());
  }
  for (const section::SectionLine& line : section.lines) {
    const auto& inputs = line.kind == section::LineKind::Pin          ? input.pins
                         : line.kind == section::LineKind::Topography ? input.topographies
                         : line.kind == section::LineKind::Datum      ? input.datums
                         : line.kind == section::LineKind::Eroded     ? input.eroded
                                                                      : input.loose_lines;
    const geom::Box box = line.line.box();
    const bool fault = line.kind == section::LineKind::Fault;
    const bool said = fault ? says_unit(input.faults, line.name) : says_unit(inputs, line.name);
    if (said || !seems_of_another_unit(box, largest)) continue;
    return refuse(fmt::format("{} '{}'", kind_name(line.kind), line.name), line.source, box, line.line.points.front());
  }
  for (const section::Unit& unit : section.units) {
    const geom::Box box = unit.contour.box();
    if (says_unit(input.units, unit.name) || !seems_of_another_unit(box, largest)) continue;
    return refuse(fmt::format("unit '{}'", unit.name), unit.source, box, unit.contour.points.front());
  }
  return {};
}

base::Result<void> read_items(const SectionInput& input, const ReadSettings& settings,
                              const dobra::scenario::Context& context, ReadSection& read) {
  section::Section& section = read.section;
  DOBRA_TRY_VOID(check_pieces(input.faults));
  DOBRA_TRY_VOID(read_lines(input.faults, section::LineKind::Fault, settings, context, read));
  struct Lines {
    const std::vector<HorizonInput>& inputs;
    section::LineKind kind;
  };
  for (const Lines& lines :
       {Lines{input.pins, section::LineKind::Pin}, Lines{input.loose_lines, section::LineKind::Loose},
        Lines{input.topographies, section::LineKind::Topography}, Lines{input.datums, section::LineKind::Datum},
        Lines{input.eroded, section::LineKind::Eroded}}) {
    DOBRA_TRY_VOID(read_lines(lines.inputs, lines.kind, settings, context, read));
  }
  DOBRA_TRY_VOID(read_blocks(input.blocks, section));
  DOBRA_TRY_VOID(check_names(input.units, "unit"));
  for (const HorizonInput& wanted : input.units) {
    DOBRA_TRY(geom::Polyline contour, read_polygon(wanted, "unit", settings, context, read.remarks));
    section.units.push_back(
        {section::UnitId(section.units.size()), wanted.name, std::move(contour), source_of(wanted), wanted.piece_of});
  }
  if (input.borders.size() > 1) {
    return base::Error{base::ErrorCode::BadSection, "a section has one border; keep one [[input.border]]",
                       base::Place{.item = fmt::format("border '{}'", input.borders[1].name)}};
  }
  for (const HorizonInput& wanted : input.borders) {
    DOBRA_TRY(section.border, read_polygon(wanted, "border", settings, context, read.remarks));
  }
  DOBRA_TRY_VOID(check_names(input.markers, "marker"));
  for (const HorizonInput& wanted : input.markers) {
    std::vector<geom::Point> points;
    if (wanted.placed && wanted.placed->line.points.size() == 1) {  // a single pick is no line
      points = wanted.placed->line.points;
    } else if (wanted.file.empty() && wanted.points.size() == 1) {
      points.push_back(to_section(wanted.points.front(), section.convention));
    } else {
      DOBRA_TRY(ReadLine line, read_item(wanted, "marker", settings, context, read.remarks));
      points = std::move(line.line.points);
    }
    section.markers.push_back(
        {section::MarkerId(section.markers.size()), wanted.name, std::move(points), source_of(wanted)});
  }
  return check_units(section, input);
}

base::Result<void> read_backdrops(const SectionInput& input, const dobra::scenario::Context& context,
                                  section::Section& section) {
  for (const BackdropInput& wanted : input.backdrops) {
    base::Place place;
    place.file = (context.folder / wanted.file).string();
    place.item = fmt::format("backdrop '{}'", wanted.name);
    dobra::io::gis::RasterOptions options;
    using Place = dobra::io::gis::RasterOptions::Place;
    options.place = wanted.corners.empty() ? Place::AsTheFileSays : Place::GivenByTheCaller;
    auto raster = dobra::io::gis::read_raster(place.file, options);
    if (!raster) return base::located(raster.error(), place);
    std::vector<geom::Point> corners = wanted.corners;
    if (raster->box) {
      corners = {raster->box->low, raster->box->high};
      if (section.convention.y_axis == section::VerticalAxis::Down) dobra::io::gis::turn_upside_down(raster->pixels);
    }
    if (corners.size() != 2) {
      return base::Error{
          base::ErrorCode::BadSection,
          corners.empty() ? "the picture does not say where it lies; give corners = [[x, z], [x, z]], lower left and "
                            "upper right, or a world file beside it"
                          : "corners needs two points: lower left and upper right",
          place};
    }
    geom::Box box;
    for (const geom::Point corner : corners) box.add(to_section(corner, section.convention));
    if (!(box.width() > 0.0 && box.height() > 0.0)) {
      return base::Error{base::ErrorCode::BadSection,
                         "the corners of the picture lie on one line; give two opposite ones", place};
    }
    section.backdrops.push_back(
        {wanted.name,
         {std::make_shared<const dobra::scene::Pixels>(std::move(raster->pixels)), box, wanted.opacity},
         place});
  }
  return {};
}

}  // namespace recon::input
