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
   * Lengths of increments of all unknowns, the root mean square over the nodes
   * of how far they move, where a rotation counts as that of an arm of the mean
   * strut length; forces of constraints do not count. What computes is
   * collective.
   */
  class PathMetric
  {
  public:
    /** @p model must outlive the object. */
    explicit PathMetric(const LatticeModel &model);

    /** Of two increments, of which rotations are vectors in one frame (m2). */
    double product(const Vector &one, const Vector &other) const;

    double length(const Vector &increment) const; ///< m

    /** The metric as a diagonal matrix, on owned rows (1, m2). */
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
    /** Of all local unknowns, of unit length; rotations as vectors in the
     * global frame. */
    Vector direction;
    /** Change of the load factor on the way (1/m). */
    double load_rate;

    /** @name By how much both change on the way, as far as is known; empty: not
     * at all (1/m, 1/m2). */
    ///@{
    Vector bend      = {};
    double load_bend = 0;
    ///@}

    /** What the bend adds to the tangent on the way @p length (m); of the
     * load factor. */
    ///@{
    Vector deviation(double length) const;

    double deviation_of_load(const double length) const
    {
      return length * length / 2 * load_bend;
    }
    ///@}

    /** Collective. */
    void serialize(const DofNumbering &numbering, CheckpointArchive &archive);
  };

  /**
   * Increment of all local unknowns with which equilibrium at evaluation.to is
   * kept when the load factor grows by one, by linear theory; rotations as
   * vectors in the global frame. Nothing if @p solver, which has the stiffness
   * factorized, fails. Collective.
   */
  std::optional<Vector> load_response(TangentSolver    &solver,
                                      const Evaluation &evaluation);

  /**
   * The load factor as an unknown, with the condition that what is added to the
   * prediction of a step is normal to its direction (Riks 1972, Journal of
   * Applied Mechanics 39, 1060; Ramm 1981): the arc length of the step,
   * measured along the direction, is given. Solved by elimination, with one
   * solution more for the tangent (Batoz and Dhatt 1979, International Journal
   * for Numerical Methods in Engineering 14, 1262).
   */
  class ArcLength : public AddedEquation
  {
  public:
    /** @param metric, tangent must outlive the object
     * @param length of the step (m), predicted by the tangent and its bend */
    ArcLength(const PathMetric  &metric,
              const PathTangent &tangent,
              double             length);

    bool complete(TangentSolver    &solver,
                  const Evaluation &evaluation,
                  Vector           &increment) override;

    void undo_increment(const Evaluation &evaluation,
                        const Vector     &way_back,
                        double            part) override;

    /** @name How far the point lies off the tangent. */
    ///@{
    double deviation() const ///< m
    {
      return metric.length(off_tangent);
    }

    double deviation_of_load() const
    {
      return std::abs(load_off_tangent);
    }
    ///@}

  private:
    const PathMetric &metric;
    const Vector     &direction;
    Vector            off_tangent;
    double            load_off_tangent;
    double            last_load = 0; ///< by the last complete()
  };
} // namespace auxfem

#endif
