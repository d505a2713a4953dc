#pragma once
// Whether a place on the raw outline belongs to the curve: it must keep D from all of the base and stay out of its
// mitres. The parts of the base that the place's own piece is parallel to are left out. Doubles decide where they are
// certain, else T does.

#include "shared/offset/general/clearance.h"
#include "shared/offset/kernel/high.h"

namespace dobra::offset::general {

enum class Place { Free, Inside, Doubtful };  ///< Never Doubtful in High, where what touches for every D is free.

class Validity {
 public:
  Validity(const Outline& outline, const Clearance& clearance);

  /// @param q      on the piece of `own`, not at its ends.
  /// @param error  bound of its error.
  template <class T>
  [[nodiscard]] Place of(const VecOf<T>& q, Site own, double error) const;
  /// A free place q of the outline of a simple contour, rounded, lies on the other side: in a mitre's tip that pokes
  /// through.
  [[nodiscard]] bool pokes_through(Flat q, Site own) const;

 private:
  template <class T>
  [[nodiscard]] Place near_segment(std::size_t segment, const VecOf<T>& q, const T& d, double error) const;
  template <class T>
  [[nodiscard]] Place in_mitre(std::uint32_t step, const VecOf<T>& q, const T& d, double error) const;

  const Outline& outline_;
  const Clearance& clearance_;
  double margin_;
};

}  // namespace dobra::offset::general
