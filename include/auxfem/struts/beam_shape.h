#ifndef auxfem_struts_beam_shape_h
#define auxfem_struts_beam_shape_h



namespace auxfem
{
  /**
   * Shape functions of a line element of polynomial order p on [-1, 1], nodes
   * in the order of FE_Q: both ends, then the inner Gauss-Lobatto nodes.
   * Internal forces use p Gauss points (no locking), inertia is integrated
   * exactly.
   *
   * Without shear flexibility, curvatures exceed the derivatives of rotations.
   * This increases the bending stiffness by the residual shear flexibility of
   * the element (doc/theory/struts.md, Sections).
   */
  template <int order>
  struct BeamShape
  {
    static constexpr int n_nodes        = order + 1;
    static constexpr int n_gauss_points = order;

    /**
     * Largest 12 EI / (kGA L^2) at which an element of length L bends as if it
     * did not shear; linear elements are too stiff by this fraction.
     * @tuned judgement (doc/theory/struts.md, Sections)
     */
    static constexpr double max_compensated_shear = order == 1 ? 1. : 5e-3;

    double value[order][order + 1];      ///< N_a at the Gauss points
    double derivative[order][order + 1]; ///< dN_a/dxi at the Gauss points
    /** Curvatures at the Gauss points by nodal rotations: equal to derivative
     * if the struts shear. */
    double rotation_derivative[order][order + 1];
    /** Section moments at the Gauss points by the moments work-conjugate to
     * these curvatures: the identity if the struts shear. */
    double moment[order][order];
    double weight[order];              ///< Gauss weights
    double point[order];               ///< Gauss points in [-1, 1]
    double mass[order + 1][order + 1]; ///< integral of N_a N_b over [-1, 1]
    double integral[order + 1];        ///< integral of N_a over [-1, 1]
    double node[order + 1];            ///< nodes in [-1, 1]

    /**
     * @param compensated_shear 12 EI / (kGA L^2) to compensate by higher
     *   bending stiffness, up to max_compensated_shear; 0: the struts shear
     */
    explicit BeamShape(double compensated_shear = 0);

    /** N_a at any @p xi in [-1, 1]. */
    void values_at(double xi, double *values) const;

    /** Lagrange polynomials through the Gauss points at @p xi, to interpolate
     * section forces. */
    void gauss_interpolation_at(double xi, double *values) const;
  };
} // namespace auxfem

#endif
