#ifndef auxfem_loads_effects_follower_loads_h
#define auxfem_loads_effects_follower_loads_h

#include <auxfem/equations/effect.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/model/numbering.h>

#include <array>
#include <memory>
#include <vector>

namespace auxfem
{
  /** A force and a moment that turn with their joints. */
  struct FollowerLoad
  {
    std::array<TimeFunction, n_motion_components> components; ///< N, N m
    EnergyEntry                                   work;
    /** Joints with a rotation on this rank. */
    std::vector<unsigned int> joints;
  };

  /** Makes the effect of follower loads.
   * @param raised_from_zero as for make_applied_loads() */
  std::unique_ptr<Effect>
  make_follower_loads(const Lattice                   &lattice,
                      const DofNumbering              &numbering,
                      bool                             raised_from_zero,
                      const std::vector<FollowerLoad> &loads);
} // namespace auxfem

#endif
