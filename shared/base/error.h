#pragma once
// What is said when the user's data or options cannot be used: a code, one line of text and, where there is one, the
// place.

#include <cstddef>
#include <optional>
#include <string>

namespace dobra::base {

/// Codes are grouped by module in hundreds.
enum class ErrorCode : int {
  // base
  Cancelled = 1,
  // geom
  NotFinite = 100,
  DegenerateCurve = 101,
  InvalidOption = 102,
  // topo
  CannotInsert = 200,
  NotInSubdivision = 201,
  // offset
  OffsetFailed = 300,
  // mesh
  SelfIntersection = 400,
  OutsideDomain = 401,
  CannotMesh = 402,
  TooManyElements = 403,
  BadMesh = 404,  ///< A mesh that is given is not what it must be, such as one sheet.
  // fem
  CannotSolve = 500,
  NotSupported = 501,
  BadCrack = 502,
  // scene, render
  CannotDraw = 600,
  // io
  FileNotFound = 700,
  NotAFile = 701,
  CannotRead = 702,
  EmptyFile = 703,
  BadFormat = 704,
  CannotWrite = 705,
  UnknownFormat = 706,
  Unclear = 707,  ///< The file leaves open what only the user can say; the message names the option.
  // scenario
  BadSyntax = 800,
  UnknownKey = 801,
  MissingKey = 802,
  BadValue = 803,
  UnknownOperation = 804,
  UnknownQuantity = 805,
  WrongProgram = 806,
  // command line
  BadUsage = 900,
  // recon
  BadSection = 1000,
  CannotRestore = 1001,
  // quebra
  BadDomain = 1100,
  // solid
  NotClosed = 1200,
  InsideOut = 1201,  ///< Its faces, or those of a part, look inwards.
};

/// Where in the user's material the trouble is. Every part is optional.
struct Place {
  std::string file = {};                   ///< Path as the user gave it; empty if not from a file.
  std::size_t line = 0;                    ///< 1-based; 0 if unknown.
  std::size_t column = 0;                  ///< 1-based; 0 if unknown.
  std::string item = {};                   ///< Name of the entity, such as "horizon 'top'" or "step 2 (grid)".
  std::optional<double> x = std::nullopt;  ///< A point to zoom to, in model coordinates.
  std::optional<double> y = std::nullopt;
  std::optional<double> z = std::nullopt;  ///< Of a place in space, beside x and y.
  std::optional<double> u = std::nullopt;  ///< The same place in the chart of a surface.
  std::optional<double> v = std::nullopt;
};

struct Error {
  ErrorCode code;
  std::string message;  ///< One line: what failed and what to change.
  std::optional<Place> place = std::nullopt;
};

/// "file:line:column: item: message (at x, y)", with the parts that are known.
std::string to_string(const Error& error);

/// Exit code of the programs: 2 wrong usage, 3 bad input, 4 the computation could not be done, 130 interrupted.
int exit_code(ErrorCode code);

/// `error` with the parts of `place` that it did not know itself.
Error located(Error error, const Place& place);

}  // namespace dobra::base
