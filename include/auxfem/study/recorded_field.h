#ifndef auxfem_study_recorded_field_h
#define auxfem_study_recorded_field_h

#include <auxfem/equations/equations.h>
#include <auxfem/parameters/text.h>
#include <auxfem/struts/effects/struts.h>

#include <mpi.h>

#include <vector>

namespace auxfem
{
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
