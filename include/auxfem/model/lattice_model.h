#ifndef auxfem_model_lattice_model_h
#define auxfem_model_lattice_model_h

#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/joint_releases.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/model/supports.h>

#include <memory>

namespace auxfem
{
  /**
   * The structure as it is computed: the lattice with sections, unknowns,
   * supports and rigid bodies, on this rank. Nothing of it changes but reasons,
   * before a run. The members are built in their order, each from those before
   * it.
   */
  struct LatticeModel
  {
    /**
     * @param plan of which the effects are decided here
     * @param lattice, scene of the plan must outlive the model.
     *
     * Throws InputError for contradictions only the lattice can show (a
     * component prescribed twice, a section that its reference vector does not
     * orient).
     */
    LatticeModel(const RunPlan &plan,
                 const Lattice &lattice,
                 MPI_Comm       communicator);

    /**
     * The structure of @p other with other effects, of which hinges may not
     * differ; shares the numbering.
     */
    LatticeModel(const LatticeModel &other, SimulatedEffects simulated);

    LatticeModel(const LatticeModel &)            = delete;
    LatticeModel &operator=(const LatticeModel &) = delete;

    RunPlan                    plan; ///< with the effects that are decided
    const Lattice             &lattice;
    const std::vector<Section> sections; ///< by Strut::section
    /** Ties moments to forces in tests (m). */
    const double mean_strut_length;
    /** Hinges and springs; empty if they are left out. */
    const std::vector<JointRelease> releases;
    /** Bars that turn about themselves between ball hinges. */
    const std::vector<FreeSpin> free_spins;
    /** Of the whole lattice, by the scene's groups of connectors. */
    const std::vector<std::vector<JointPair>> connector_pairs;

  private:
    const std::shared_ptr<const DofNumbering> shared_numbering;

  public:
    const DofNumbering &numbering;
    /** Owned rows by what is measured in them. */
    const OwnedRows            rows;
    const std::vector<Support> supports;
    const RigidBodies          bodies;

    /** Rotations in space kept as quaternions; none if they stay small. */
    unsigned int n_large_rotations() const
    {
      return plan.simulated.large_rotation ? numbering.rotations().size() : 0;
    }

    /** Replaces the decision on the same effect in the list for users: where it
     * takes a computation to know. */
    void explain(const EffectDecision &decision)
    {
      plan.simulated.decision(decision.name) = decision;
    }
  };
} // namespace auxfem

#endif
