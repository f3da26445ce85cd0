#ifndef auxfem_contact_contact_law_h
#define auxfem_contact_contact_law_h

namespace auxfem
{
  /**
   * Force against penetration: none without it, a parabola up to the depth
   * `smoothing`, from there on a straight line of slope `stiffness`,
   *
   *     f(d) = k d^2 / (2 s),  0 < d < s,     f(d) = k (d - s/2),  d >= s,
   *
   * so that force and stiffness begin at zero. A penalty law as in C. Meier, A.
   * Popp, W. A. Wall, A finite element approach for the line-to-line contact
   * interaction of thin beams with arbitrary orientation, Comput. Methods Appl.
   * Mech. Eng. 308, 2016, 377-413 (their quadratically regularised law).
   */
  struct ContactLaw
  {
    double stiffness; ///< k (N/m)
    double smoothing; ///< s (m)

    /** N, at the penetration @p depth (m), negative where there is a gap. */
    double force(double depth) const;

    /** Derivative of the force by the depth (N/m). */
    double slope(double depth) const;

    /** Integral of the force from no penetration to @p depth (J). */
    double energy(double depth) const;

    /** Mean of the force over the depths between @p from and @p to (N): its
     * work on the way is the change of the energy, without cancellation. */
    double mean_force(double from, double to) const;

    /** Derivative of the mean force by @p to (N/m). */
    double mean_slope(double from, double to) const;
  };
} // namespace auxfem

#endif
