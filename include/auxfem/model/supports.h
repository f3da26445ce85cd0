#ifndef auxfem_model_supports_h
#define auxfem_model_supports_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** A support of the scene with the unknowns it prescribes on this rank. */
  struct Support
  {
    struct PrescribedUnknown
    {
      int          unknown; ///< local number
      unsigned int component;
    };
    /** A large rotation in space of which spins are prescribed. */
    struct PrescribedRotation
    {
      unsigned int        rotation; ///< of DofNumbering::spatial_rotations()
      std::array<bool, 3> fixed;    ///< about x, y, z
      /** All three, so that its rotation vector is `motion`. */
      bool is_whole() const
      {
        return fixed[0] && fixed[1] && fixed[2];
      }
    };
    std::string                    name;
    std::vector<PrescribedUnknown> unknowns;
    /** Those whose spins are among `unknowns`. */
    std::vector<PrescribedRotation> rotations;
    /** Time history of each component (m, rad). */
    std::array<TimeFunction, n_motion_components> motion;

    /** Whether an unknown is moved as part of one of `rotations`. */
    bool moves_as_rotation(const PrescribedUnknown &prescribed) const
    {
      return !rotations.empty() && prescribed.component >= first_rotation;
    }

    /** Whether an unknown is moved, not only held. */
    bool moves(const PrescribedUnknown &prescribed) const
    {
      return !motion[prescribed.component].is_zero();
    }

    /** Whether a rotation is moved, not only held. */
    bool moves(const PrescribedRotation &prescribed) const;

    /** Whether it holds everything at rest. */
    bool is_at_rest() const;
  };

  /** The motions that the supports of @p scene prescribe, whether or not the
   * joints have them. */
  std::vector<JointMotion> prescribed_motions(const Scene   &scene,
                                              const Lattice &lattice);

  /**
   * The supports of @p plan. Throws InputError for a component prescribed
   * twice and for a rotation that a joint does not have.
   * @param large_rotations whether rotations in space are large.
   */
  std::vector<Support> make_supports(const RunPlan      &plan,
                                     const Lattice      &lattice,
                                     const DofNumbering &numbering,
                                     bool                large_rotations);
} // namespace auxfem

#endif
