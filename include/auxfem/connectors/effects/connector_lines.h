#ifndef auxfem_connectors_effects_connector_lines_h
#define auxfem_connectors_effects_connector_lines_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>

#include <string>

namespace auxfem
{
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
    /** Of the force; of a mean force not quite of unit length; not a number
     * where the ends meet. */
    std::vector<dealii::Tensor<1, 3>> direction;
    std::vector<dealii::Tensor<1, 3>> velocity_difference;
    std::vector<double>               current_length; ///< m
  };

  /** @p results of a group of connectors as what they are. */
  inline const ConnectorResults &connector_cache(const EffectCache &results)
  {
    return static_cast<const ConnectorResults &>(results);
  }

  /** The two ends of a connector. */
  struct ConnectorEnds
  {
    /** Local unknowns x1, y1, z1, x2, y2, z2; -1: ground, z in the plane. */
    std::array<int, 6> unknowns;
    /** From first to second end at rest (m). */
    dealii::Tensor<1, 3> span;
    double               rest_length; ///< m
    /** Of the force, at rest. */
    dealii::Tensor<1, 3> direction;
    unsigned int         first_joint, second_joint, cell;
    /** Among all pairs of the group. */
    unsigned int number;
    bool         owned; ///< by this rank

    /** Difference of the values, by local unknown, at both ends. */
    dealii::Tensor<1, 3> difference(const double *values) const;

    /** From first to second end (m). */
    dealii::Tensor<1, 3> line(const Vector &displacement) const
    {
      return span + difference(displacement.data());
    }
  };

  /** How a group of equal connectors lies and moves. */
  class ConnectorLines
  {
  public:
    /**
     * @param pairs the connectors of the whole lattice; those whose ends this
     *   rank does not own are left out.
     * @param large_rotation false: the line between the ends is the one at rest.
     */
    ConnectorLines(const ConnectorDefinition    &definition,
                   const std::vector<JointPair> &pairs,
                   const Lattice                &lattice,
                   const DofNumbering           &numbering,
                   bool                          large_rotation);

    /** Fills all but the response. */
    void find_motion(const Evaluation &evaluation,
                     ConnectorResults &results) const;

    /** Rate of a connector at the instant @p state (m/s). */
    double rate_at(const ConnectorEnds &ends, const State &state) const;

    /** What is wrong with @p results at @p time (s), if the ends of a connector
     * of the @p group meet; empty otherwise. */
    std::string nonfinite_reason(const std::string      &group,
                                 double                  time,
                                 const ConnectorResults &results) const;

    /** Whether the force is along the line between the ends as it is now. */
    const bool                 follow_ends;
    std::vector<ConnectorEnds> ends;

  private:
    /** Whether the ends meet, so that there is no direction at a length (m). */
    bool meet(const ConnectorEnds &ends, double length) const;

    /** Under @p displacement, by local unknown (m). */
    double extension(const ConnectorEnds &ends,
                     const Vector        &displacement) const;

    /** At which connector @p i with the extensions in @p results grows (m/s). */
    double rate(unsigned int            i,
                const Evaluation       &evaluation,
                const ConnectorResults &results) const;
  };
} // namespace auxfem

#endif
