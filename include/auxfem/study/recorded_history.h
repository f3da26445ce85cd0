#ifndef auxfem_study_recorded_history_h
#define auxfem_study_recorded_history_h

#include <auxfem/equations/equations.h>
#include <auxfem/parameters/text.h>
#include <auxfem/struts/effects/struts.h>

#include <mpi.h>

#include <vector>

namespace auxfem
{
  /**
   * Recorded quantity of a run: at least two values at increasing times. Values
   * in between are interpolated by polynomials, so that comparisons show the
   * errors of the runs and not the sampling. Studies compare such records.
   */
  struct RecordedHistory
  {
    std::vector<double> times; ///< s
    std::vector<double> values;
  };

  /**
   * Value at @p time (s) within the record: the recorded one if it exists, else
   * that of the polynomial through the five nearest values (fewer if there are
   * fewer).
   */
  double value_at(const RecordedHistory &history, double time);

  /** A maximum and its time. */
  struct Maximum
  {
    double time; ///< s
    double value;
  };

  /**
   * Maximum of the polynomial through the five values around the largest one;
   * at either end of the record, the largest value itself.
   */
  Maximum maximum_of(const RecordedHistory &history);

  /** Integral over all times, by piecewise cubic polynomials. */
  double integral_of(const RecordedHistory &history);

  /** @p history with the sign of all values changed. */
  RecordedHistory negative(RecordedHistory history);

  class Equations;

  /**
   * Strains and velocities of all struts at one time, scaled as ScaledMotion.
   * Each element has polynomials, given by values at Gauss points.
   */
  struct RecordedField
  {
    struct Element
    {
      unsigned int strut;
      double       begin, end; ///< fractions of the strut's length
      double       length;     ///< of the element (m)
      /** Six strains at each of n Gauss points. */
      std::vector<double> strains;
      /**
       * Three velocities at each of n + 1 Gauss points; empty without inertia.
       */
      std::vector<double> velocities;

      /** The number n of Gauss points. */
      unsigned int n_points() const;
    };

    /** Elements, sorted by strut and along each strut. */
    std::vector<Element> elements;
  };

  /** The field of @p solution, the same on all ranks. Collective. */
  RecordedField field_of(const Equations &equations,
                         const Solution  &solution,
                         MPI_Comm         communicator);

  Json          json_of(const RecordedField &field);
  RecordedField recorded_field_of(const Json &json);

  /** A quadrature point of an integral along all struts. */
  struct FieldPoint
  {
    unsigned int strut;
    double       fraction; ///< of the strut's length
    double       weight;   ///< m
  };

  /**
   * Gauss points that integrate energies of @p field exactly, and those of
   * coarser fields on unions of its elements. Sorted by strut and along each
   * strut.
   */
  std::vector<FieldPoint> integration_points(const RecordedField &field);

  /**
   * Values of @p field at @p points, scaled so that their sum of squares is the
   * strain energy (J). If @p with_velocities, the kinetic energy of
   * displacements is added, which is zero without inertia.
   */
  std::vector<double> energy_roots(const RecordedField           &field,
                                   const std::vector<FieldPoint> &points,
                                   bool with_velocities);
} // namespace auxfem

#endif
