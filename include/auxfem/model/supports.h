#ifndef auxfem_model_supports_h
#define auxfem_model_supports_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** A support with the unknowns it prescribes on this rank. */
  struct Support
  {
    struct PrescribedUnknown
    {
      int          unknown; ///< local number
      unsigned int component;
      unsigned int joint;
    };
    /** A large spatial rotation with prescribed spins. */
    struct PrescribedRotation
    {
      unsigned int        rotation; ///< index in DofNumbering::rotations()
      std::array<bool, 3> fixed;    ///< about x, y, z
      /** Whether all spins are prescribed, so `motion` is the rotation
       * vector. */
      bool is_whole() const
      {
        return fixed[0] && fixed[1] && fixed[2];
      }
    };
    std::string                    name;
    std::vector<PrescribedUnknown> unknowns;
    /** Rotations whose spins are among `unknowns`. */
    std::vector<PrescribedRotation> rotations;
    /** Time history of each component (m, rad). */
    std::array<TimeFunction, n_motion_components> motion;

    /** Whether an unknown moves as part of one of `rotations`. */
    bool moves_as_rotation(const PrescribedUnknown &prescribed) const
    {
      return !rotations.empty() && prescribed.component >= first_rotation;
    }

    /** Whether an unknown is moved rather than fixed. */
    bool moves(const PrescribedUnknown &prescribed) const
    {
      return !motion[prescribed.component].is_zero();
    }

    /** Whether a rotation is moved rather than fixed. */
    bool moves(const PrescribedRotation &prescribed) const;

    /** Whether the support only fixes unknowns. */
    bool is_at_rest() const;
  };

  /**
   * Motions prescribed by the supports of @p scene, including components that
   * joints lack.
   */
  std::vector<JointMotion> prescribed_motions(const Scene   &scene,
                                              const Lattice &lattice);

  /**
   * Creates the supports of @p plan. Throws InputError for a component
   * prescribed twice and for a missing joint rotation.
   * @param large_rotations whether spatial rotations are large
   */
  std::vector<Support> make_supports(const RunPlan      &plan,
                                     const Lattice      &lattice,
                                     const DofNumbering &numbering,
                                     bool                large_rotations);
} // namespace auxfem

#endif
