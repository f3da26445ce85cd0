#ifndef auxfem_model_least_damping_h
#define auxfem_model_least_damping_h

#include <auxfem/model/lattice_model.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * By how much all oscillations of a structure are damped at least: by the
   * stiffness-proportional damping of its struts, if all have some, and nothing
   * else that is elastic is damped less. Forces of contact are taken for as
   * well damped.
   */
  class LeastDamping
  {
  public:
    LeastDamping(const Scene &scene, const LatticeModel &model);

    /**
     * The rate (1/s) at which an oscillation of the angular frequency @p omega
     * (1/s), undamped, loses its amplitude at least; where it would not swing
     * at all, that at which it creeps back.
     */
    double rate(double omega) const;

  private:
    /** The least time over which forces of the rates of strain, damping over
     * stiffness, are those of the strains (s). */
    double time(double omega) const;

    double                                           of_struts; ///< s
    std::vector<std::shared_ptr<const ConnectorLaw>> connectors;
  };
} // namespace auxfem

#endif
