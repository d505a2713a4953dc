#include "shared/fem/process_group.h"

#ifdef DOBRA_WITH_MPI
#include <dmumps_c.h>
#include <mpi.h>
#include <unistd.h>

#include <array>
#include <map>
#include <memory>
#else
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#endif

namespace dobra::fem {

#ifdef DOBRA_WITH_MPI

namespace {

using Order = std::array<int, 2>;  ///< Instance, job.
constexpr Order quit{-1, 0};
constexpr int initialise = -1;
constexpr int finish = -2;
constexpr useconds_t pause = 200;  ///< Between looks for an order, microseconds: the first process may need the core.

Order next_order() {
  Order order = quit;
  MPI_Request request = nullptr;
  MPI_Ibcast(order.data(), static_cast<int>(order.size()), MPI_INT, 0, MPI_COMM_WORLD, &request);
  for (int there = 0;;) {
    MPI_Test(&request, &there, MPI_STATUS_IGNORE);
    if (there != 0) return order;
    usleep(pause);
  }
}

void tell(Order order) {
  MPI_Request request = nullptr;
  MPI_Ibcast(order.data(), static_cast<int>(order.size()), MPI_INT, 0, MPI_COMM_WORLD, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

/// Makes the calls of MUMPS that the first process makes, until it ends.
void serve() {
  std::map<int, std::unique_ptr<DMUMPS_STRUC_C>> instances;
  for (Order order = next_order(); order != quit; order = next_order()) {
    const auto [id, job] = order;
    auto& instance = instances[id];
    if (job == initialise) {
      instance = std::make_unique<DMUMPS_STRUC_C>();
      instance->comm_fortran = -987654;  // MPI_COMM_WORLD
      instance->par = 1;
      instance->sym = 1;
    }
    instance->job = job;
    dmumps_c(instance.get());
    for (int stream = 0; job == initialise && stream < 3; ++stream) instance->icntl[stream] = -1;
    if (job == finish) instances.erase(id);
  }
}

bool group = false;  ///< There are others to tell.

}  // namespace

int run_in_group(int argc, char** argv, const std::function<int()>& program) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  group = size > 1;
  int code = 0;
  if (rank == 0) {
    code = program();
    if (group) tell(quit);
  } else {
    serve();
  }
  MPI_Finalize();
  return code;
}

void announce_job(int id, int job) {
  if (group) tell({id, job});
}

#else

int run_in_group(int, char**, const std::function<int()>& program) {
  // Each of the processes would do all of the work and write all of the files.
  const char* const size = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (size != nullptr && std::string(size) != "1") {
    fmt::print(stderr, "this program was built without MPI; build it with -DDOBRA_MPI=ON and start bin/mpi/quebra\n");
    return 2;
  }
  return program();
}

void announce_job(int, int) {}

#endif

}  // namespace dobra::fem
