#pragma once
// The processes of a run over MPI. The first runs the program as always. The others serve its solver: they are told
// every call of MUMPS and make it too. Without MPI (DOBRA_WITH_MPI is not defined) there is one process and
// nothing is told. Page: docs/algorithms/fem.md.

#include <functional>

namespace dobra::fem {

/// Runs `program` in the first process and serves it in the others. @return its exit code; 0 in the others.
int run_in_group(int argc, char** argv, const std::function<int()>& program);

/// Of the solver: tells the other processes that instance `id` is to do `job` of MUMPS.
/// @pre called in the first process
void announce_job(int id, int job);

}  // namespace dobra::fem
