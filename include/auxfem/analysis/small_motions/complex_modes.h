#ifndef auxfem_analysis_small_motions_complex_modes_h
#define auxfem_analysis_small_motions_complex_modes_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

#include <complex>
#include <limits>
#include <vector>

namespace auxfem
{
  /** @name Complex values of owned rows: real parts, then imaginary ones. All of
   * these are collective. */
  ///@{

  /** x.y, without conjugation. */
  std::complex<double> product(const UnknownLayout       &layout,
                               const std::vector<double> &x,
                               const std::vector<double> &y);

  /** Square root of the sum of the squared magnitudes. */
  double size(const UnknownLayout &layout, const std::vector<double> &x);

  /** Whether two shapes are one but for a complex factor. */
  bool are_parallel(const UnknownLayout       &layout,
                    const std::vector<double> &x,
                    const std::vector<double> &y);

  /** Makes the real part of @p shape as large as can be; its length is kept. */
  void turn_phase(const UnknownLayout &layout, std::vector<double> &shape);
  ///@}

  /** A small motion x e^(s t) about an equilibrium: A(s) x = 0 with the dynamic
   * stiffness A. */
  struct ComplexMode
  {
    std::complex<double> s; ///< 1/s; of two conjugate ones that above
    /** |A(s) x| over |s A'(s) x|. */
    double residual;
    /** Round-off of s (1/s). */
    double uncertainty;
    /** Parts of x, of all local unknowns; rotations as vectors in the global
     * frame. */
    Vector real, imaginary;
    /** Error of s by the elements, over |s|; NaN: not known. */
    double mesh_error = std::numeric_limits<double>::quiet_NaN();

    /** Whether it grows: Re s > 0 by more than round-off. */
    bool grows() const;

    /** Whether it swings; what grows and swings is flutter, what grows alone
     * divergence. */
    bool swings() const
    {
      return s.imag() > 0;
    }

    /** Damping over the critical one; negative where it grows. */
    double ratio() const;
  };

  /** Modes by rising |s|. */
  struct ComplexModes
  {
    std::vector<ComplexMode> modes;
  };

  /**
   * The @p n lowest modes by |s| of small motions about @p state, at rest there,
   * which need no symmetric stiffness (MotionPencil); also all that grow among
   * those that were found. Left out is what decays with more than 0.99 of the
   * critical damping. Throws ComputationError if none is found. Collective.
   */
  ComplexModes complex_modes(TangentSolver &solver,
                             const State   &state,
                             unsigned int   n,
                             Damping        damping);

  /**
   * Finds the damped modes about @p state, solutions of A(s) x = 0 with the
   * dynamic stiffness A of all connectors and damping that swing, with |s| up
   * to
   * just above the highest frequency of @p found (MotionPencil). Each is given to
   * the natural mode that has the largest part in it, pairs with the largest
   * parts first; those left over are its further ones. Collective.
   */
  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found);
} // namespace auxfem

#endif
