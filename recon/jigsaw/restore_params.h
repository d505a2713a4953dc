#pragma once
// Parameters of the step `restore`: of the method, and of a restoration block by block.

#include "recon/jigsaw/blockwise_params.h"
#include "recon/unfold/restore.h"

namespace recon::jigsaw {

/// Describes the fields of a base of P as fields of P.
template <class P, class D>
struct FieldsOfBase {
  D& description;
  template <class Base, class T>
  void field(const char* key, T Base::*member, const dobra::scenario::FieldOptions& options) {
    description.field(key, static_cast<T P::*>(member), options);
  }
  template <class Base, class E>
  void choice(const char* key, E Base::*member, std::vector<std::string> names,
              const dobra::scenario::FieldOptions& options) {
    description.choice(key, static_cast<E P::*>(member), std::move(names), options);
  }
};

struct RestoreStepParams : unfold::RestoreParams, BlockwiseParams {
  template <class D>
  static void describe(D& d) {
    FieldsOfBase<RestoreStepParams, D> fields{d};
    unfold::RestoreParams::describe(fields);
    BlockwiseParams::describe(fields);
  }
};

}  // namespace recon::jigsaw
