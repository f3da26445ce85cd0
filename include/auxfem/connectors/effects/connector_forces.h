#ifndef auxfem_connectors_effects_connector_forces_h
#define auxfem_connectors_effects_connector_forces_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** State of one connector, for output. */
  struct ConnectorReport
  {
    /** Positions of its ends at rest (m). */
    std::array<dealii::Point<3>, 2> ends;
    /** Displacements of its ends (m); zero at the ground. */
    std::array<dealii::Tensor<1, 3>, 2> displacements;
    double                              force;      ///< N, positive in tension
    double                              extension;  ///< m
    double                              dissipated; ///< J since the start
    double       is_broken; ///< 1 if it has broken, else 0
    unsigned int cell;
  };

  /** Connector with the smallest length relative to rest, whose direction may
   * be ill-defined. */
  struct ShortestConnector
  {
    double length_ratio = 1; ///< length over length at rest, 0 if it inverts
    unsigned int joint  = invalid_index; ///< first joint
  };

  /** Forces of a group of equal connectors between joints, or joints and the
   * ground. */
  class ConnectorForces : public Effect,
                          public StageTerms,
                          public SmallMotionTerms
  {
  public:
    /** The user's name of the group. */
    virtual const std::string &name() const = 0;

    /**
     * Returns the owned connector with the smallest length ratio, if below @p
     * least; otherwise no joint. A connector whose line reverses in the step
     * has the ratio 0. Groups with a fixed direction return no joint.
     * @param results cache of the evaluation of the end of the step
     */
    virtual ShortestConnector shortest(const Evaluation  &step,
                                       const EffectCache &results,
                                       double             least) const = 0;

    /** Whether connectors of the group may break. */
    virtual bool may_break() const = 0;

    /** Number of connectors that this rank owns. */
    virtual unsigned int n_reported() const = 0;

    /** Report on owned connector @p i at @p state, from the @p results of its
     * evaluation. */
    virtual ConnectorReport report(unsigned int       i,
                                   const State       &state,
                                   const EffectCache *results) const = 0;
  };

  /**
   * @param pairs all connectors of the lattice; this rank keeps those with an
   *   owned unknown
   * @param large_rotation false: the line between the ends keeps its direction
   *   at rest
   */
  std::unique_ptr<ConnectorForces>
  make_connector_forces(const ConnectorDefinition    &definition,
                        const std::vector<JointPair> &pairs,
                        const Lattice                &lattice,
                        const DofNumbering           &numbering,
                        bool                          large_rotation);
} // namespace auxfem

#endif
