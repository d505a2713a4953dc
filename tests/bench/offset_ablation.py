#!/usr/bin/env python3
"""What each device of the general offset engine is worth: how much longer each row of offset_bench takes without it.

  tests/bench/offset_ablation.py [--rows REGEX] [--rounds N] [--only NAME,NAME+NAME] [--against PROGRAM] [--all]

Copies the tree to build/ablation, puts a switch before every device listed below, builds offset_bench once there, and
runs each row with each device off in turn (environment DOBRA_OFF), several rounds. Prints a table: the least of the
times (each the median of a row's runs; whatever else the machine does only adds to it) over that with everything on, in
the rows where it is greatest. --against: a row for another offset_bench, such as
one of an older commit. --all: every row. Times are of the processor, so other programs disturb them little.
"""
import argparse
import json
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
COPY = os.path.join(ROOT, "build", "ablation")
BUILD = os.path.join(COPY, "build")
E = "shared/offset/"
# A name, what is left out, and how: files with a text that stands there once, and what takes its place. OFF is true if
# the device is off.
DEVICES = [
    ("escape_ways", "escape rays from both ends part the two sides of an open base",
     [(E + "offset.cpp", "base.closed || made->has_mitres() ? 0", "base.closed || made->has_mitres() || OFF ? 0")]),
    ("gaps", "distances up to which blocks meet nothing but their neighbours",
     [(E + "offset.cpp", "if (!made->parts_sides(greatest)) made", "if (!made->parts_sides(greatest) && !OFF) made")]),
    ("gaps_harmless", "of those, that a block meets nothing at all",
     [(E + "general/clearance.h", "return !gaps_.empty() && d < gaps_[block].harmless", "return !OFF && !gaps_.empty() && d < gaps_[block].harmless")]),
    ("gaps_alone", "of those, that a block meets its neighbours only",
     [(E + "general/clearance.h", "return !gaps_.empty() && d < gaps_[block].alone", "return !OFF && !gaps_.empty() && d < gaps_[block].alone")]),
    ("bends_little", "directions of neighbouring blocks compared exactly",
     [(E + "general/clearance.h", "return (bends_[block] & 1) != 0", "return !OFF && (bends_[block] & 1) != 0"),
      (E + "general/clearance.h", "return (bends_[block] & 2) != 0", "return !OFF && (bends_[block] & 2) != 0"),
      (E + "general/clearance.cpp", "const auto bends_little = [&](std::size_t b, std::size_t many) {", "const auto bends_little = [&](std::size_t b, std::size_t many) { if (OFF) return false;")]),
    ("tips_stay", "lines to tips that stay buried up to the greatest distance",
     [(E + "general/candidates.cpp", "tips && witnesses_.tips_stay", "!OFF && tips && witnesses_.tips_stay")]),
    ("memory", "what is buried at one distance is at all greater ones",
     [(E + "offset.cpp", "if (more) found.emplace(known);", "if (more && !OFF) found.emplace(known);"),
      (E + "offset.cpp", "more && first + i + 1 == last ? &*found", "more && !OFF && first + i + 1 == last ? &*found"),
      (E + "offset.cpp", "known = std::move(*found);", "if (!OFF) known = std::move(*found);")]),
    ("tell_buried", "pieces without a valid section are remembered",
     [(E + "general/sections.cpp", "if (found != nullptr) tell_buried", "if (found != nullptr && !OFF) tell_buried")]),
    ("held_by_cutter", "what cuts a section is asked whether it holds it",
     [(E + "general/sections.cpp", "for (const std::uint32_t end : {section.from, section.to}) {", "for (const std::uint32_t end : {section.from, section.to}) { if (OFF) break;")]),
    ("starts", "natural starts without detours",
     [(E + "general/outline.h", "return starts_.find(s, start) ?", "return !OFF && starts_.find(s, start) ?")]),
    ("write_block", "the points of plain blocks written at once",
     [(E + "general/assemble.cpp", "may_begin ? write_block", "may_begin && !OFF ? write_block")]),
    ("glide_blocks", "plain blocks pass the stack pass at once",
     [(E + "general/candidates.cpp", """std::uint32_t StackPass::glide_blocks(std::uint32_t step) {
  if (!goes_on()) return step;""", """std::uint32_t StackPass::glide_blocks(std::uint32_t step) {
  if (OFF || !goes_on()) return step;""")]),
    ("glide", "steps where line follows line pass without their places",
     [(E + "general/candidates.cpp", """std::uint64_t dead) {
  if (!goes_on()) return step;""", """std::uint64_t dead) {
  if (OFF || !goes_on()) return step;""")]),
    ("tail_cuts", "tail and head of the stack cut each other",
     [(E + "general/candidates.cpp", "if (tail.site.kind == SiteKind::Bevel || head", "if (OFF || tail.site.kind == SiteKind::Bevel || head")]),
    ("buried_by_tail", "the tail of the stack is asked first whether it hides the head",
     [(E + "general/candidates.cpp", "if (!pieces.empty() && buried_by_tail", "if (!OFF && !pieces.empty() && buried_by_tail")]),
    ("cells", "what hid a place is noted for its surroundings",
     [(E + "general/witness.cpp", "if (cells_.empty()) return Clearance::none;", "if (OFF || cells_.empty()) return Clearance::none;"),
      (E + "general/witness.cpp", "void WitnessSearch::note(Flat p, std::uint32_t step) {", "void WitnessSearch::note(Flat p, std::uint32_t step) { if (OFF) return;")]),
    ("shorten", "lines to far tips are shortened",
     [(E + "general/pairs.cpp", "if (clearance_.has_long_mitres()) find_parts", "if (clearance_.has_long_mitres() && !OFF) find_parts")]),
    ("recent", "what hid the last piece is asked first",
     [(E + "general/witness.cpp", "if (witness_ != Clearance::none && in_set(", "if (!OFF && witness_ != Clearance::none && in_set(")]),
    ("halving", "pieces hidden by several segments together",
     [(E + "general/witness.cpp", "return between(s, a, held[1], places[0]", "return !OFF && between(s, a, held[1], places[0]")]),
    ("deep_halving", "more than two halvings of those",
     [(E + "general/witness.cpp", "constexpr int depth = 10;", "const int depth = OFF ? 2 : 10;")]),
    ("judge", "cutters that lie in U are left out",
     [(E + "general/pairs.cpp", "cutter.piece = witnesses_.covers(", "cutter.piece = !OFF && witnesses_.covers(")]),
    ("left_boxes", "boxes of the left side of four segments",
     [(E + "general/pairs.cpp", "= clearance_.left_box(leaf, outline_.distance(), margin_);", "= OFF ? clearance_.blocks()[block].box(true, outline_.distance(), margin_) : clearance_.left_box(leaf, outline_.distance(), margin_);")]),
    ("directions", "direction masks of the tree",
     [(E + "kernel/chain_tree.cpp", "bool ChainTree::fits_half_plane(std::uint64_t directions) {", "bool ChainTree::fits_half_plane(std::uint64_t directions) { if (OFF) return false;")]),
    ("few", "boxes of what is left of a block",
     [(E + "general/pairs.cpp", "if (last - first < few ||", "if ((!OFF && last - first < few) ||")]),
    ("runs", "boxes of runs of four pieces",
     [(E + "general/pairs.cpp", "if (!p.runs[i].overlaps(q.box)) continue;", "if (!OFF && !p.runs[i].overlaps(q.box)) continue;"),
      (E + "general/pairs.cpp", "if (!p.runs[i].overlaps(q.runs[j])) continue;", "if (!OFF && !p.runs[i].overlaps(q.runs[j])) continue;")]),
    ("hulls", "convex hulls of pieces",
     [(E + "general/pairs.cpp", "return beyond_an_edge(p, q) || beyond_an_edge(q, p);", "return !OFF && (beyond_an_edge(p, q) || beyond_an_edge(q, p));")]),
    ("cache", "pieces of 128 groups are kept at hand",
     [(E + "general/pairs.cpp", "if (bunch.group == group) return;", "if (!OFF && bunch.group == group) return;")]),
    ("skip", "sections pass over linked pieces that nothing may cut",
     [(E + "general/sections.cpp", "if (k > 0 && pieces_[k].linked()) k = skip(k);", "if (!OFF && k > 0 && pieces_[k].linked()) k = skip(k);")]),
    ("likely", "gaps are measured first where they are likely to be least",
     [(E + "general/clearance_gaps.cpp", "for (std::size_t i = first; i < last; i += run) {\n    if (i + 2", "for (std::size_t i = first; i < last; i += run) {\n    if (OFF) break;\n    if (i + 2")]),
    ("mitre_rough", "doubles tell first that a place is out of a mitre",
     [(E + "general/validity.cpp", """if (dot(near, u) < -margin || dot(near, v) > margin || dot(near, right_of(u)) > limit ||
      dot(near, right_of(v)) > limit) {""", """if (!OFF && (dot(near, u) < -margin || dot(near, v) > margin || dot(near, right_of(u)) > limit ||
      dot(near, right_of(v)) > limit)) {""")]),
    ("one_side", "a simple contour needs no cutters",
     [(E + "offset.cpp", "input.simple && input.clearance->tells_sides", "!OFF && input.simple && input.clearance->tells_sides")]),
    ("rough", "doubles decide where they are certain",
     [(E + "general/validity.cpp", "if (rough > (reach + margin) * (reach + margin))", "if (!OFF && rough > (reach + margin) * (reach + margin))"),
      (E + "general/validity.cpp", "if (reach > margin && rough <", "if (!OFF && reach > margin && rough <")]),
]

SWITCH = """#pragma once
#include <cstdlib>
// Which devices are off, by their bits.
inline const unsigned long long dobra_off_bits =
    std::getenv("DOBRA_OFF") ? std::strtoull(std::getenv("DOBRA_OFF"), nullptr, 16) : 0;
"""


def copy_with_switches():
    files = subprocess.run(["git", "ls-files", "shared", "recon", "quebra", "tests", "CMakeLists.txt"], cwd=ROOT,
                           capture_output=True, text=True, check=True).stdout.split("\n")
    text = {}
    for name in filter(None, files):
        with open(os.path.join(ROOT, name), "rb") as f:
            text[name] = f.read()
    text["ablation.h"] = SWITCH.encode()
    for k, (device, _, edits) in enumerate(DEVICES):
        for name, old, new in edits:
            found = text[name].count(old.encode())
            if found != 1:
                raise SystemExit(f"{device}: {found} times in {name}: {old}")
            new = new.replace("OFF", f"(dobra_off_bits >> {k} & 1)")
            text[name] = text[name].replace(old.encode(), new.encode())
    for room, _, names in os.walk(os.path.join(COPY, "shared")):
        for name in names:  # what the tree had before
            path = os.path.join(room, name)
            if os.path.relpath(path, COPY) not in text:
                os.remove(path)
    for name, content in text.items():
        path = os.path.join(COPY, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        if not os.path.exists(path) or open(path, "rb").read() != content:
            with open(path, "wb") as f:
                f.write(content)


def build():
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DDOBRA_BENCH=ON", "-DDOBRA_TESTS=OFF", "-DDOBRA_RENDER=OFF",
               "-DDOBRA_GUI=OFF", f"-DCMAKE_CXX_FLAGS=-include {COPY}/ablation.h"]
    subprocess.run(["cmake", "-G", "Ninja", "-S", COPY, "-B", BUILD, *options], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", BUILD, "-j2", "offset_bench"], check=True, stdout=subprocess.DEVNULL)
    return os.path.join(BUILD, "bin", "offset_bench")


def run(program, bits, rows):
    made = subprocess.run([program, "--alone", "--benchmark_format=json", f"--benchmark_filter={rows}"],
                          env={**os.environ, "DOBRA_OFF": f"{bits:x}"}, capture_output=True, text=True, check=True)
    return {b["name"].rsplit("/iterations", 1)[0]: b["ns_point_curve"] for b in json.loads(made.stdout)["benchmarks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", default="/(1000|10000)/")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", default="")
    parser.add_argument("--against", default="")
    parser.add_argument("--all", action="store_true")
    asked = parser.parse_args()
    copy_with_switches()
    program = build()
    bit = {name: 1 << k for k, (name, _, _) in enumerate(DEVICES)}
    told = {name: what for name, what, _ in DEVICES}
    variants = asked.only.split(",") if asked.only else list(bit)
    times = {}
    for _ in range(asked.rounds):
        for name in ["everything", *variants, *([asked.against] if asked.against else [])]:
            bits = 0 if name in ("everything", asked.against) else sum(bit[part] for part in name.split("+"))
            for row, ns in run(asked.against if name == asked.against else program, bits, asked.rows).items():
                times.setdefault(row, {}).setdefault(name, []).append(ns)
    least = {row: {name: min(v) for name, v in of.items()} for row, of in times.items()}
    print("| device | what it does | times as long without it, where it helps most |")
    print("|---|---|---|")
    ratios = {name: sorted(((of[name] / of["everything"], row) for row, of in least.items()), reverse=True)
              for name in next(iter(least.values())) if name != "everything"}
    for name in sorted(ratios, key=lambda n: -ratios[n][0][0]):
        best = ratios[name] if asked.all else ratios[name][:3]
        print(f"| {name} | {told.get(name, '')} | " + ", ".join(f"{r:.2f} {row}" for r, row in best) + " |")


main()
