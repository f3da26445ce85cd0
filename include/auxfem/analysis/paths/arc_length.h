#ifndef auxfem_analysis_paths_arc_length_h
#define auxfem_analysis_paths_arc_length_h

#include <auxfem/model/lattice_model.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/time/newton.h>

#include <cmath>
#include <optional>

namespace auxfem
{
  /**
   * Norm of increments on a path: root mean square of nodal displacements (m).
   * Rotations are multiplied by the mean strut length; constraint forces do not
   * count. Functions that compute are collective.
   */
  class PathMetric
  {
  public:
    /** @p model must outlive the object. */
    explicit PathMetric(const LatticeModel &model);

    /**
     * Inner product of two increments (m2); rotations are vectors in one frame.
     */
    double product(const Vector &one, const Vector &other) const;

    double length(const Vector &increment) const; ///< m

    /** Diagonal matrix of the metric on owned rows (1, m2). */
    const Vector &weights() const
    {
      return weight;
    }

  private:
    const UnknownLayout &layout;
    Vector               weight;
  };

  /** Direction of a path of equilibria at one of its points. */
  struct PathTangent
  {
    /**
     * Values of all local unknowns, of unit length; rotations as vectors in the
     * global frame.
     */
    Vector direction;
    /** Derivative of the load factor by arc length (1/m). */
    double load_rate;

    /**
     * @name Derivatives of direction and load rate by arc length (1/m, 1/m2);
     * empty and 0 if unknown.
     */
    ///@{
    Vector curvature      = {};
    double load_curvature = 0;
    ///@}

    /**
     * Second-order term of the prediction at the arc length @p length (m): of
     * the unknowns, and of the load factor.
     */
    ///@{
    Vector deviation(double length) const;

    double load_deviation(const double length) const
    {
      return length * length / 2 * load_curvature;
    }
    ///@}

    /** Collective. */
    void serialize(const DofNumbering &numbering, CheckpointArchive &archive);
  };

  /**
   * Linear increment of all local unknowns for a unit increment of the load
   * factor at the equilibrium evaluation.to; rotations as vectors in the global
   * frame. The stiffness is already factorized in @p solver; empty if that
   * fails. Collective.
   */
  std::optional<Vector> load_response(TangentSolver    &solver,
                                      const Evaluation &evaluation);

  /**
   * Arc-length constraint with the load factor as unknown: corrections are
   * normal to the predictor's direction (Riks 1972, Journal of Applied
   * Mechanics 39, 1060; Ramm 1981). Solved by block elimination with one
   * additional right-hand side (Batoz and Dhatt 1979, International Journal for
   * Numerical Methods in Engineering 14, 1262).
   */
  class ArcLength : public AddedEquation
  {
  public:
    /**
     * @param metric, tangent must outlive the object
     * @param length arc length of the step (m)
     */
    ArcLength(const PathMetric  &metric,
              const PathTangent &tangent,
              double             length);

    bool complete(TangentSolver    &solver,
                  const Evaluation &evaluation,
                  Vector           &increment) override;

    void undo_increment(const Evaluation &evaluation,
                        const Vector     &undone_increment,
                        double            part) override;

    /** @name Distance of the point from the tangent. */
    ///@{
    double deviation() const ///< m
    {
      return metric.length(off_tangent);
    }

    double load_deviation() const
    {
      return std::abs(load_off_tangent);
    }
    ///@}

  private:
    const PathMetric &metric;
    const Vector     &direction;
    Vector            off_tangent;
    double            load_off_tangent;
    double            last_load = 0; ///< load increment of the last complete()
  };
} // namespace auxfem

#endif
