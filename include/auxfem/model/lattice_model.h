#ifndef auxfem_model_lattice_model_h
#define auxfem_model_lattice_model_h

#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/initial_strains.h>
#include <auxfem/model/joint_releases.h>
#include <auxfem/model/linear_relations.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/model/supports.h>

#include <algorithm>
#include <memory>

namespace auxfem
{
  /**
   * Structural model of a run on this rank: lattice, sections, unknowns,
   * supports and rigid bodies. Constant except for explain(). Members are
   * initialised in order, each from earlier ones.
   */
  struct LatticeModel
  {
    /**
     * @param plan plan whose effects are decided here
     * @param lattice must outlive the model, as the scene of @p plan
     *
     * Throws InputError for contradictions visible only on the lattice, such as
     * a component prescribed twice or an unusable reference vector.
     */
    LatticeModel(const RunPlan &plan,
                 const Lattice &lattice,
                 MPI_Comm       communicator);

    /** Copy of @p other with other effects, except hinges and relaxation;
     * shares the numbering. */
    LatticeModel(const LatticeModel &other, SimulatedEffects simulated);

    LatticeModel(const LatticeModel &)            = delete;
    LatticeModel &operator=(const LatticeModel &) = delete;

    RunPlan                    plan; ///< with decided effects
    const Lattice             &lattice;
    const std::vector<Section> sections; ///< by Strut::section
    const InitialStrains       initial_strains;
    /** Laws of the sections by DofNumbering::Group::law; the first is empty:
     * the elastic law. Struts with initial strains have one that is not. */
    const std::vector<std::shared_ptr<const SectionLaw>> laws;
    /** Reference length (m) that converts moments to forces. */
    const double mean_strut_length;
    /** Hinges and springs; empty if disabled. */
    const std::vector<JointRelease>   releases;
    const std::vector<LinearRelation> relations;
    /** Bars that can spin between ball hinges. */
    const std::vector<FreeSpin> free_spins;
    /** Joint pairs of the whole lattice by connector group. */
    const std::vector<std::vector<JointPair>> connector_pairs;

  private:
    const std::shared_ptr<const DofNumbering> shared_numbering;

  public:
    const DofNumbering &numbering;
    /** Owned rows by physical unit and kind. */
    const OwnedRows            rows;
    const std::vector<Support> supports;
    const RigidBodies          bodies;

    /** Whether a law lets struts break. */
    bool struts_may_fail() const
    {
      return std::any_of(laws.begin(), laws.end(), [](const auto &law) {
        return law && law->failure_time();
      });
    }

    /** Number of rotations kept as quaternions; 0 for small rotations. */
    unsigned int n_large_rotations() const
    {
      return plan.simulated.large_rotation ? numbering.rotations().size() : 0;
    }

    /** Replaces the reported decision on an effect that only a computation can
     * settle. */
    void explain(const EffectDecision &decision)
    {
      plan.simulated.decision(decision.name) = decision;
    }
  };
} // namespace auxfem

#endif
