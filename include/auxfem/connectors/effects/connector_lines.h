#ifndef auxfem_connectors_effects_connector_lines_h
#define auxfem_connectors_effects_connector_lines_h

#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <deal.II/base/symmetric_tensor.h>

#include <string>

namespace auxfem
{
  /** I - e n: derivative of a unit vector along @p n with respect to its vector,
   * times the length. */
  inline dealii::Tensor<2, 3> normal_projector(const dealii::Tensor<1, 3> &e,
                                               const dealii::Tensor<1, 3> &n)
  {
    return dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()) -
      dealii::outer_product(e, n);
  }

  /** Motion and forces of a group of connectors in one evaluation. */
  struct ConnectorResults : public EffectCache
  {
    explicit ConnectorResults(const unsigned int n_connectors)
      : motion(n_connectors)
      , response(n_connectors)
      , direction(n_connectors)
      , velocity_difference(n_connectors)
      , current_length(n_connectors)
    {}

    std::vector<ConnectorMotion>   motion;
    std::vector<ConnectorResponse> response;
    /** Force direction; not a unit vector for mean forces, NaN if the ends
     * coincide. */
    std::vector<dealii::Tensor<1, 3>> direction;
    std::vector<dealii::Tensor<1, 3>> velocity_difference;
    std::vector<double>               current_length; ///< m
  };

  /** Casts @p results of a group of connectors. */
  inline const ConnectorResults &connector_cache(const EffectCache &results)
  {
    return static_cast<const ConnectorResults &>(results);
  }

  /** The two ends of a connector. */
  struct ConnectorEnds
  {
    /** Local unknowns x1, y1, z1, x2, y2, z2; -1 at the ground and for z in the
     * plane. */
    std::array<int, 6> unknowns;
    /** Vector from first to second end at rest (m). */
    dealii::Tensor<1, 3> span;
    double               rest_length; ///< m
    /** Extension of the law at rest (m), by the free length. */
    double extension_at_rest;
    /** Force direction at rest. */
    dealii::Tensor<1, 3> direction;
    unsigned int         first_joint, second_joint, cell;
    /** Index among all pairs of the group. */
    unsigned int number;
    bool         owned; ///< by this rank

    /** Second end minus first end of @p values, by local unknown. */
    dealii::Tensor<1, 3> difference(const double *values) const;

    /** Vector from first to second end (m). */
    dealii::Tensor<1, 3> line(const Vector &displacement) const
    {
      return span + difference(displacement.data());
    }
  };

  /** Geometry and motion of a group of equal connectors, for ConnectorForces.
   */
  class ConnectorLines
  {
  public:
    /**
     * @param pairs all connectors of the lattice; this rank keeps those with an
     *   owned unknown
     * @param large_rotation false: the line between the ends keeps its
     *   direction at rest
     */
    ConnectorLines(const ConnectorDefinition    &definition,
                   const std::vector<JointPair> &pairs,
                   const Lattice                &lattice,
                   const DofNumbering           &numbering,
                   bool                          large_rotation);

    /** Computes all of @p results except the response. */
    void find_motion(const Evaluation &evaluation,
                     ConnectorResults &results) const;

    /**
     * Derivative of the force on the second end of connector @p i by the
     * relative motion.
     * @param results of the evaluation with their response
     */
    dealii::Tensor<2, 3> tangent(unsigned int            i,
                                 const Evaluation       &evaluation,
                                 const TangentFactors   &factors,
                                 const ConnectorResults &results) const;

    /** Same as tangent() for the mean force of a discrete-gradient step. */
    dealii::Tensor<2, 3> mean_tangent(unsigned int            i,
                                      const Evaluation       &evaluation,
                                      const ConnectorResults &results) const;

    /** Rate of extension of a connector at @p state (m/s). */
    double rate_at(const ConnectorEnds &ends, const State &state) const;

    /** Description of a connector of the @p group whose ends coincide at @p
     * time (s); empty if there is none. */
    std::string nonfinite_reason(const std::string      &group,
                                 double                  time,
                                 const ConnectorResults &results) const;

    /** ConnectorForces::shortest(). */
    ShortestConnector shortest(const Evaluation       &step,
                               const ConnectorResults &results,
                               double                  least) const;

    /** Whether the force acts along the current line between the ends. */
    const bool                 follow_ends;
    std::vector<ConnectorEnds> ends;

  private:
    /** Whether the ends coincide at a @p length (m), so that the direction is
     * undefined. */
    bool ends_coincide(const ConnectorEnds &ends, double length) const;

    /** Extension under @p displacement, by local unknown (m). */
    double extension(const ConnectorEnds &ends,
                     const Vector        &displacement) const;

    /** Rate of extension of connector @p i with the extensions in @p results
     * (m/s). */
    double rate(unsigned int            i,
                const Evaluation       &evaluation,
                const ConnectorResults &results) const;
  };
} // namespace auxfem

#endif
