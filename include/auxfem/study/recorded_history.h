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
   * A quantity as a run has recorded it: values at increasing times, two at
   * least. What lies between them is taken from the polynomial through the
   * nearest ones, so that a comparison of runs does not see the steps of the
   * record, but the errors of the runs.
   */
  struct RecordedHistory
  {
    std::vector<double> times; ///< s
    std::vector<double> values;
  };

  /**
   * The value at @p time (s), which must not lie outside: one that was recorded
   * if there is one, else of the polynomial of fourth degree through the five
   * nearest (of lower degree through fewer, if there are no more).
   */
  double value_at(const RecordedHistory &history, double time);

  /** The largest value and its time. */
  struct Maximum
  {
    double time; ///< s
    double value;
  };

  /**
   * The maximum of the polynomial through the five values around the largest
   * one; the largest itself at either end of the record.
   */
  Maximum maximum_of(const RecordedHistory &history);

  /** The integral over all times, of cubic polynomials piece by piece. */
  double integral_of(const RecordedHistory &history);

  /** @p history with all values of the other sign. */
  RecordedHistory negative(RecordedHistory history);

  class Equations;

  /**
   * Strains and velocities of all struts at one time, as a run has recorded
   * them: polynomials element by element, scaled as ScaledMotion, by their
   * values at Gauss points.
   */
  struct RecordedField
  {
    struct Element
    {
      unsigned int strut;
      double       begin, end; ///< fractions of the strut's length
      double       length;     ///< of the element (m)
      /** Six numbers at each of n Gauss points. */
      std::vector<double> strains;
      /** Three at each of n + 1 Gauss points; empty without inertia. */
      std::vector<double> velocities;

      /** The number n of Gauss points. */
      unsigned int n_points() const;
    };

    /** By strut, and along each. */
    std::vector<Element> elements;
  };

  /** The field of @p solution, the same on all ranks. Collective. */
  RecordedField field_of(const Equations &equations,
                         const Solution  &solution,
                         MPI_Comm         communicator);

  Json          json_of(const RecordedField &field);
  RecordedField recorded_field_of(const Json &json);

  /** A point of a strut with its part in an integral along all struts. */
  struct FieldPoint
  {
    unsigned int strut;
    double       fraction; ///< of the strut's length
    double       weight;   ///< m
  };

  /**
   * Gauss points at which energies of @p field are integrated exactly, and of
   * fields of no higher order whose elements are made of whole ones of it. By
   * strut, and along each.
   */
  std::vector<FieldPoint> integration_points(const RecordedField &field);

  /**
   * Values of @p field at @p points, so scaled that the sum of the squares is
   * the energy (J): strain energy, and if @p with_velocities kinetic energy of
   * displacements, which is zero without inertia.
   */
  std::vector<double> energy_roots(const RecordedField           &field,
                                   const std::vector<FieldPoint> &points,
                                   bool with_velocities);
} // namespace auxfem

#endif
