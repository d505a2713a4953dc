#include "shared/fem/sparse_solver.h"

#include <dmumps_c.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>

#include "shared/fem/process_group.h"

namespace dobra::fem {
namespace {

using base::Error;
using base::ErrorCode;

/// MUMPS keeps parts of its state in Fortran modules, one for the whole process.
std::mutex& mumps_mutex() {
  static std::mutex mutex;
  return mutex;
}

constexpr double mega = 1e6;
constexpr MUMPS_INT singular = -10;
constexpr MUMPS_INT workspace_too_small = -9;
constexpr MUMPS_INT workspace_too_small_2 = -8;
constexpr MUMPS_INT out_of_memory = -13;

/// Counts too great for an integer are told in negative millions.
double entries(MUMPS_INT count) { return count < 0 ? -mega * count : count; }

Error failed(MUMPS_INT code, MUMPS_INT detail, const char* what) {
  if (code == out_of_memory)
    return {ErrorCode::CannotSolve, fmt::format("not enough memory for the {}; use a coarser mesh", what)};
  return {ErrorCode::CannotSolve, fmt::format("MUMPS could not do the {} (INFOG {}, {})", what, code, detail)};
}

}  // namespace

struct Factorisation::Instance {
  DMUMPS_STRUC_C mumps{};
  int id = 0;  ///< Among the instances of all processes.
  void run(MUMPS_INT job) {
    const std::lock_guard lock(mumps_mutex());
    static int instances = 0;
    if (job == -1) id = ++instances;
    announce_job(id, job);
    mumps.job = job;
    dmumps_c(&mumps);
  }
  // The numbers of the users' guide count from 1.
  MUMPS_INT& control(int i) { return mumps.icntl[i - 1]; }
  [[nodiscard]] MUMPS_INT info(int i) const { return mumps.infog[i - 1]; }
};

void Factorisation::Deleter::operator()(Instance* instance) const {
  instance->run(-2);
  delete instance;
}

double machine_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : 0.0;
}

base::Result<Factorisation> Factorisation::make(const SymmetricMatrix& matrix, const SolverOptions& options,
                                                const base::Progress& progress) {
  Factorisation result;
  result.instance_.reset(new Instance);
  Instance& instance = *result.instance_;
  instance.mumps.comm_fortran = -987654;  // MPI_COMM_WORLD, of the sequential build too
  instance.mumps.par = 1;
  instance.mumps.sym = 1;
  instance.run(-1);
  for (const int stream : {1, 2, 3, 4}) instance.control(stream) = stream == 4 ? 0 : -1;
  instance.control(7) = 4;  // PORD: the default, SCOTCH 7, orders by threads and differently each time
  instance.mumps.n = static_cast<MUMPS_INT>(matrix.size);
  instance.mumps.nnz = static_cast<MUMPS_INT8>(matrix.values.size());
  // MUMPS only reads them.
  instance.mumps.irn = const_cast<MUMPS_INT*>(matrix.rows.data());
  instance.mumps.jcn = const_cast<MUMPS_INT*>(matrix.columns.data());
  instance.mumps.a = const_cast<double*>(matrix.values.data());
  instance.run(1);
  if (instance.info(1) < 0) return failed(instance.info(1), instance.info(2), "analysis of the equations");
  // Whole megabytes of working memory; the factors alone where that rounds to none.
  result.statistics_ = {matrix.size, std::max(mega * instance.info(17), sizeof(double) * entries(instance.info(20))),
                        0.0};
  const double limit = options.memory_limit > 0.0 ? options.memory_limit : machine_memory();
  if (limit > 0.0 && result.statistics_.memory_estimate > limit) {
    return Error{
        ErrorCode::CannotSolve,
        fmt::format("{} unknowns need about {:.2g} GB to be factorised, and {:.2g} GB are allowed; use a coarser mesh",
                    matrix.size, result.statistics_.memory_estimate / 1e9, limit / 1e9)};
  }
  DOBRA_TRY_VOID(progress.check());
  progress.report(0.3);

  instance.run(2);
  // The estimate of the workspace can fall short; MUMPS asks for more of it.
  for (int more = 0; more < 4 && (instance.info(1) == workspace_too_small || instance.info(1) == workspace_too_small_2);
       ++more) {
    instance.control(14) = 2 * std::max<MUMPS_INT>(instance.control(14), 20);
    instance.run(2);
  }
  if (instance.info(1) == singular)
    return Error{ErrorCode::CannotSolve, "the equations are singular: something can move without resistance"};
  if (instance.info(1) < 0) return failed(instance.info(1), instance.info(2), "factorisation");
  result.statistics_.factor_entries = entries(instance.info(29));
  DOBRA_TRY_VOID(progress.check());
  progress.report(1.0);
  return result;
}

base::Result<void> Factorisation::solve(std::span<double> right_sides, std::size_t count) {
  Instance& instance = *instance_;
  instance.mumps.nrhs = static_cast<MUMPS_INT>(count);
  instance.mumps.lrhs = instance.mumps.n;
  instance.mumps.rhs = right_sides.data();
  instance.run(3);
  if (instance.info(1) < 0) return failed(instance.info(1), instance.info(2), "solution");
  return {};
}

}  // namespace dobra::fem
