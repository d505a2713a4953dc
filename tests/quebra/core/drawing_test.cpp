// Curves drawn and edited in the window. Every document is written, read again and run: the domain tells what it holds.

#include "quebra/core/drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quebra/core/operations.h"
#include "shared/scenario/runner.h"

namespace quebra::core {
namespace {

using namespace dobra;
using geom::Point;
using geom::Polyline;
using scene::LineEdit;
using scene::Pick;

scenario::Document document_of(const std::string& text) {
  auto document = scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "x.toml");
  EXPECT_TRUE(document) << to_string(document.error());
  return *document;
}

scenario::Document again(const base::Result<scenario::Document>& document) {
  EXPECT_TRUE(document) << (document ? "" : to_string(document.error()));
  return scenario::parse_document(scenario::document_text(*document), "x.toml").value();
}

model::Model model_of(const scenario::Document& document) {
  scenario::Runner runner(program());
  const scenario::Run run = runner.run(document);
  EXPECT_TRUE(run.complete()) << to_string(*run.error);
  return run.complete() ? scenario::model_of<model::Model>(run.states.front()) : model::Model{};
}

/// As the window shows it, and as a tool hands it back.
struct Shown {
  Pick pick;
  Polyline line;
};

Shown shown(const scenario::Document& document, const std::string& name) {
  scenario::Runner runner(program());
  const scenario::Run run = runner.run(document);
  EXPECT_TRUE(run.complete());
  const model::Model model = scenario::model_of<model::Model>(run.states.front());
  const scene::Picture picture = scenario::in_units(program().picture_of(run.states.front()), document.shown_units());
  for (const scene::Layer& layer : picture.panels.at(0).layers) {
    const auto* lines = std::get_if<scene::Lines>(&layer.content);
    for (std::size_t i = 0; lines != nullptr && i < lines->ids.size(); ++i) {
      if (model.domain.curves[lines->ids[i]].name == name) return {{layer.key, lines->ids[i]}, lines->lines[i]};
    }
  }
  ADD_FAILURE() << "nothing shows " << name;
  return {};
}

base::Result<scenario::Document> edited(const scenario::Document& document, const std::vector<LineEdit>& edits) {
  return with_curves_edited(document, model_of(document), edits);
}

double area(const model::Model& model) {
  double sum = 0.0;
  for (const domain::Domain::Loop& loop : model.domain.loops)
    sum += (loop.depth % 2 == 0 ? 1.0 : -1.0) * std::abs(signed_area(contour(model.domain, loop)));
  return sum;
}

const char* plate = R"(unit_system = "mm, N, MPa"
[[input.curve]]
name = "plate"
kind = "polygon"
points = [[0, 0], [100.1, 0], [100.1, 50.3], [0, 50.3]]
[[input.curve]]
name = "hole"
kind = "circle"
centre = [70, 25]
radius = 5.5
[[input.crack]]
name = "notch"
points = [[0, 20.7], [10, 21], [20, 20.7]]
)";

TEST(Drawing, APlateIsDrawnFromNothing) {
  scenario::Document document = document_of("unit_system = \"mm, N, MPa\"\n[input]\n");
  ASSERT_TRUE(program().nothing_yet(document.input));
  Polyline circle{{}, true};
  for (int i = 0; i < 64; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / 64.0;
    circle.points.push_back({30.0 + 4.0 * std::cos(turn), 20.0 + 4.0 * std::sin(turn)});
  }
  document = again(with_curve(document, "outline", "plate", {{{0, 0}, {60, 0}, {60, 40}, {0, 40}}, true}));
  EXPECT_FALSE(program().nothing_yet(document.input));
  document = again(with_curve(document, "hole", "bore", circle));
  document = again(with_curve(document, "crack", "c", {{{0, 20}, {10, 20}}, false}));
  document = again(with_curve(document, "internal", "seam", {{{0, 35}, {60, 35}}, false}));
  document = again(with_curve(document, "point", "load", {{{60, 20}}, false}));
  document = again(with_curve(document, "region", "above", {{{30, 38}}, false}));
  const std::string text = scenario::document_text(document);
  EXPECT_NE(text.find("centre = [30.0, 20.0]\nradius = 4.0"), std::string::npos) << text;
  const model::Model model = model_of(document);
  ASSERT_EQ(model.domain.curves.size(), 4U);
  const auto* bore = std::get_if<geom::Arc>(&model.domain.curves[1].shape);
  ASSERT_NE(bore, nullptr);
  EXPECT_NEAR(bore->radius(), 0.004, 1e-15);
  EXPECT_NEAR(geom::distance(bore->centre(), {0.03, 0.02}), 0.0, 1e-15);
  EXPECT_EQ(model.domain.curves[1].role, sketch::Role::Hole);
  EXPECT_EQ(model.domain.points.at(0).name, "load");
  EXPECT_EQ(model.domain.region_names.size(), 1U);
  EXPECT_NEAR(area(model), 60e-3 * 40e-3 - std::numbers::pi * 16e-6, 1e-3 * 16e-6 * std::numbers::pi);
}

TEST(Drawing, AVertexMovesAndOtherNumbersStayAsTheyWereWritten) {
  const scenario::Document document = document_of(plate);
  Shown plate_now = shown(document, "plate");
  plate_now.line.points[1] = {120.0, -5.0};
  const scenario::Document moved = again(edited(document, {{plate_now.pick, {plate_now.line}}}));
  const std::string text = scenario::document_text(moved);
  EXPECT_NE(text.find("[[0.0, 0.0], [120.0, -5.0], [100.1, 50.3], [0.0, 50.3]]"), std::string::npos) << text;
  EXPECT_NE(text.find("kind = \"polygon\""), std::string::npos);
  // By hand: the rectangle and the two triangles that the corner has added.
  const double added = 0.5 * std::abs(geom::cross(geom::Vector{100.1, 0}, geom::Vector{120.0, -5.0})) +
                       0.5 * std::abs(geom::cross(geom::Vector{0, 50.3}, geom::Vector{19.9, -5.0}));
  EXPECT_NEAR(area(model_of(moved)) - area(model_of(document)), added * 1e-6, 1e-12);
}

TEST(Drawing, ACrackIsSplitBentAndDeleted) {
  const scenario::Document document = document_of(plate);
  const Shown notch = shown(document, "notch");
  const std::vector<Polyline> halves{{{notch.line.points[0], notch.line.points[1]}, false},
                                     {{notch.line.points[1], notch.line.points[2]}, false}};
  const model::Model split = model_of(again(edited(document, {{notch.pick, halves}})));
  EXPECT_EQ(split.domain.curves.size(), 4U);
  EXPECT_EQ(split.domain.curves[3].name, "notch (2)");
  EXPECT_EQ(split.domain.curves[3].role, sketch::Role::Crack);
  const model::Model gone = model_of(again(edited(document, {{notch.pick, {}}})));
  EXPECT_EQ(gone.domain.curves.size(), 2U);
}

TEST(Drawing, ACircleMovesAsAWholeAndKeepsItsShape) {
  const scenario::Document document = document_of(plate);
  Shown hole = shown(document, "hole");
  for (Point& p : hole.line.points) p = p + geom::Vector{-10.0, 2.5};
  const model::Model moved = model_of(again(edited(document, {{hole.pick, {hole.line}}})));
  const auto& arc = std::get<geom::Arc>(moved.domain.curves[1].shape);
  EXPECT_NEAR(geom::distance(arc.centre(), {0.06, 0.0275}), 0.0, 1e-12);
  EXPECT_EQ(arc.radius(), 0.0055);
  hole.line.points[3].x += 1.0;
  const auto refused = edited(document, {{hole.pick, {hole.line}}});
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("move as a whole"), std::string::npos);
}

TEST(Drawing, WhatTheDocumentDoesNotHoldIsRefused) {
  const scenario::Document document = document_of("[input]\nspecimen = \"single_edge_notch\"\n");
  const model::Model model = model_of(document);
  ASSERT_FALSE(model.domain.curves.empty());
  const bool crack = model.domain.curves[0].role == sketch::Role::Crack;
  const auto refused =
      with_curves_edited(document, model, std::vector<LineEdit>{{{crack ? "cracks" : "boundary", 0}, {}}});
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("a specimen has it by its sizes"), std::string::npos);
  EXPECT_FALSE(with_curves_edited(document, model, std::vector<LineEdit>{{{"mesh", 0}, {}}}));
  EXPECT_FALSE(with_curve(document_of(plate), "crack", "hole", {{{0, 0}, {1, 1}}, false}));
  EXPECT_FALSE(with_curve(document_of(plate), "crack", " ", {{{0, 0}, {1, 1}}, false}));
}

}  // namespace
}  // namespace quebra::core
