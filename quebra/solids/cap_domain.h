#pragma once
// A section of solids by a plane becomes a plane domain: outlines, holes, lines between materials, each curve called
// after the face that was cut, and regions with the names of materials. Page: docs/algorithms/cap.md.

#include <span>
#include <string>

#include "quebra/sketch/sketch.h"
#include "shared/scenario/document.h"
#include "shared/solid/cap.h"

namespace quebra::solids {

/// Coordinates are those of the cap's frame. A name that several curves would have gets numbers, NAME_1, NAME_2, in
/// the order of the cap; each of them is in the set NAME too, and where faces of several names lie in one place, in
/// the set of each.
/// @param materials  of each solid.  @param fallback  what faces without a name are called
sketch::Sketch sketch_of(const dobra::solid::Cap& cap, std::span<const std::string> materials,
                         const std::string& fallback);

/// What is told of a plane in which a face lies.
constexpr const char* cut_in_face = "the plane lies in a face; the section is that of what lies just below the plane";

/// What is told of solids that cover the same of a section.
std::string message(const dobra::solid::SectionOverlap& overlap, std::span<const std::string> materials);

/// The same as a scenario without steps; where the frame lies in space stands in its comment.
dobra::scenario::Document document_of(const sketch::Sketch& sketch, const dobra::solid::CutPlane& plane,
                                      const dobra::solid::SectionFrame& frame);

}  // namespace quebra::solids
