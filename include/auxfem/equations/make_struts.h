#ifndef auxfem_equations_make_struts_h
#define auxfem_equations_make_struts_h

#include <auxfem/equations/effects/struts.h>
#include <auxfem/model/lattice_model.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Internal forces of all struts of @p numbering, one effect for each group of
   * its elements.
   * @param model what is simulated, and the sections
   * @param high_frequency_damping see ImplicitScheme
   */
  std::vector<std::unique_ptr<StrutForces>>
  make_strut_forces(const LatticeModel &model,
                    const Lattice      &lattice,
                    const DofNumbering &numbering,
                    double              high_frequency_damping);

  /** Inertia of the same struts; none if it is not simulated. */
  std::vector<std::unique_ptr<Effect>>
  make_strut_inertia(const LatticeModel &model,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);
} // namespace auxfem

#endif
