#include <auxfem/algebra/krylov_eigenpairs.h>
#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/parameters/errors.h>

#include <dlfcn.h>

namespace auxfem
{
  namespace
  {
    /** The library stays until the program ends: MPI and Kokkos clear up then.
     */
    void *symbol_of_library(const std::string &file, const char *name)
    {
      void *library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
      void *symbol  = library ? dlsym(library, name) : nullptr;
      if (!symbol)
        throw ComputationError(
          "the library of iterative methods cannot be loaded: " +
          std::string(dlerror()) +
          "\n  It is built and installed together with auxfem: build again, "
          "or, for Solver/Type = gmres, choose another type.");
      return symbol;
    }
  } // namespace

  std::unique_ptr<KrylovSolver>
  load_krylov_solver(const SolverParameters &parameters)
  {
    using Make = decltype(&auxfem_make_krylov_solver);
    // Found by the run path that the program was linked with.
    static const auto make = reinterpret_cast<Make>(
      symbol_of_library(AUXFEM_ITERATION_LIBRARY, "auxfem_make_krylov_solver"));
    return std::unique_ptr<KrylovSolver>(make(parameters));
  }

  Eigenpairs krylov_eigenpairs(const ShiftedEigenproblem &problem,
                               const unsigned int         n)
  {
    using Find             = decltype(&auxfem_find_eigenpairs);
    static const auto find = reinterpret_cast<Find>(
      symbol_of_library(AUXFEM_ITERATION_LIBRARY, "auxfem_find_eigenpairs"));
    Eigenpairs found;
    find(problem, n, found);
    return found;
  }
} // namespace auxfem
