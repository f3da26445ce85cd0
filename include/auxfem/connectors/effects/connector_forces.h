#ifndef auxfem_connectors_effects_connector_forces_h
#define auxfem_connectors_effects_connector_forces_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** What one connector does now, for output. */
  struct ConnectorReport
  {
    /** Ends of the connector at rest (m). */
    std::array<dealii::Point<3>, 2> ends;
    /** Displacements of its ends (m); zero at the ground. */
    std::array<dealii::Tensor<1, 3>, 2> displacements;
    double                              force;      ///< N, positive in tension
    double                              extension;  ///< m
    double                              dissipated; ///< J so far
    unsigned int                        cell;
  };

  /** A connector along its line whose direction means little. */
  struct VanishingConnector
  {
    double       part  = 1; ///< of its length at rest that is left, 0 if none
    unsigned int joint = invalid_index; ///< its first
  };

  /** A group of equal connectors between joints, or joints and the ground. */
  class ConnectorForces : public Effect,
                          public StageTerms,
                          public SmallMotionTerms
  {
  public:
    /** The user's name of the group. */
    virtual const std::string &name() const = 0;

    /**
     * The connector counted by this rank with the smallest part of its length
     * left, if that is less than @p least; one whose line has been turned round
     * in the step has passed through zero. Else of no joint. None of a fixed
     * direction.
     * @param results of the evaluation of the end of the step
     */
    virtual VanishingConnector shortest(const Evaluation  &step,
                                        const EffectCache &results,
                                        double             least) const = 0;

    /** Connectors counted by this rank, in order. */
    virtual unsigned int n_reported() const = 0;

    /** Counted connector @p i at @p state, from the results of its evaluation. */
    virtual ConnectorReport report(unsigned int       i,
                                   const State       &state,
                                   const EffectCache *results) const = 0;
  };

  /**
   * @param pairs the connectors of the whole lattice; those whose ends this
   *   rank does not own are left out.
   * @param large_rotation false: the line between the ends is the one at rest.
   */
  std::unique_ptr<ConnectorForces>
  make_connector_forces(const ConnectorDefinition    &definition,
                        const std::vector<JointPair> &pairs,
                        const Lattice                &lattice,
                        const DofNumbering           &numbering,
                        bool                          large_rotation);
} // namespace auxfem

#endif
