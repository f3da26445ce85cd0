#ifndef auxfem_model_lattice_model_h
#define auxfem_model_lattice_model_h

#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/free_spins.h>
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
     * @param scene, lattice must outlive the model.
     * @param divisions of the struts; none: all have common_division()
     *
     * Throws InputError for contradictions only the lattice can show (a
     * component prescribed twice, a section that its reference vector does not
     * orient).
     */
    LatticeModel(const Scene               &scene,
                 const Lattice             &lattice,
                 MPI_Comm                   communicator,
                 std::vector<StrutDivision> divisions = {});

    /**
     * The structure of @p other with other effects, of which hinges may not
     * differ; shares the numbering.
     * @param scene must outlive the model, as the lattice of @p other.
     */
    LatticeModel(const Scene        &scene,
                 const LatticeModel &other,
                 SimulatedEffects    simulated);

    LatticeModel(const LatticeModel &)            = delete;
    LatticeModel &operator=(const LatticeModel &) = delete;

    const Lattice             &lattice;
    SimulatedEffects           simulated;
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
      return simulated.large_rotation ? numbering.rotations().size() : 0;
    }

    /** On the effect of this name. */
    const EffectDecision &decision(const std::string &effect) const;

    /** Replaces that on the same effect in the list for users: where it takes a
     * computation to know. */
    void explain(const EffectDecision &decision);
  };
} // namespace auxfem

#endif
