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
  /**
   * @name Complex vectors of owned rows: real parts, then imaginary ones. All
   * functions are collective.
   */
  ///@{

  /** x.y, without conjugation. */
  std::complex<double> product(const UnknownLayout       &layout,
                               const std::vector<double> &x,
                               const std::vector<double> &y);

  /** Square root of the sum of the squared magnitudes. */
  double size(const UnknownLayout &layout, const std::vector<double> &x);

  /** Whether two shapes differ by a complex factor only. */
  bool are_parallel(const UnknownLayout       &layout,
                    const std::vector<double> &x,
                    const std::vector<double> &y);

  /**
   * Rotates the phase of @p shape so that its real part is as large as
   * possible; its norm does not change.
   */
  void maximize_real_part(const UnknownLayout &layout,
                          std::vector<double> &shape);
  ///@}

  /** A small motion x e^(s t) about an equilibrium: A(s) x = 0 with the dynamic
   * stiffness A. */
  struct ComplexMode
  {
    std::complex<double> s; ///< 1/s; of a conjugate pair the one with Im s > 0
    /** |A(s) x| over |s A'(s) x|. */
    double residual;
    /** Round-off of s (1/s). */
    double uncertainty;
    /**
     * Real and imaginary part of x, values of all local unknowns; rotations as
     * vectors in the global frame.
     */
    Vector real, imaginary;
    /** Discretization error of s over |s|; NaN: unknown. */
    double mesh_error = std::numeric_limits<double>::quiet_NaN();

    /** Whether the mode grows: Re s > 0 by more than round-off. */
    bool grows() const;

    /**
     * Whether the mode oscillates. A growing mode is flutter if it oscillates,
     * else divergence.
     */
    bool swings() const
    {
      return s.imag() > 0;
    }

    /** Damping ratio; negative if the mode grows. */
    double ratio() const;
  };

  /** Complex modes, sorted by increasing |s|. */
  struct ComplexModes
  {
    std::vector<ComplexMode> modes;
  };

  /**
   * Computes the @p n modes of smallest |s| about the rest state @p state; the
   * stiffness may be unsymmetric (MotionPencil). Growing modes found beyond
   * these are added. Modes with a damping ratio above 0.99 are omitted. Throws
   * ComputationError if none is found. Collective.
   */
  ComplexModes complex_modes(TangentSolver &solver,
                             const State   &state,
                             unsigned int   n,
                             Damping        damping);

  /**
   * Computes the damped oscillating modes about @p state with |s| up to just
   * above the highest frequency of @p found (MotionPencil). Each damped mode is
   * assigned to the natural mode with the largest share in it, largest shares
   * first. Unassigned ones become NaturalModes::further_damped. Collective.
   */
  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found);
} // namespace auxfem

#endif
