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
   * Without shear flexibility curvatures are larger than the derivatives of
   * rotations, which makes an element stiffer in bending by what its shear is
   * left to give (doc/theory.md, Sections).
   */
  template <int order>
  struct BeamShape
  {
    static constexpr int n_nodes        = order + 1;
    static constexpr int n_gauss_points = order;

    /**
     * 12 EI / (kGA L^2) up to which an element of length L bends as if it
     * did not shear; linear elements are too stiff by as much.
     * @tuned judgement
     */
    static constexpr double most_shear = order == 1 ? 1. : 5e-3;

    double value[order][order + 1];      ///< N_a at the Gauss points
    double derivative[order][order + 1]; ///< dN_a/dxi at the Gauss points
    /** By which curvatures at the Gauss points follow rotations of nodes:
     * derivative if the struts shear. */
    double rotation_derivative[order][order + 1];
    /** The section's moments at the Gauss points by those that do work on these
     * curvatures: one if the struts shear. */
    double moment[order][order];
    double weight[order];              ///< Gauss weights
    double point[order];               ///< Gauss points in [-1, 1]
    double mass[order + 1][order + 1]; ///< integral of N_a N_b over [-1, 1]
    double integral[order + 1];        ///< integral of N_a over [-1, 1]
    double node[order + 1];            ///< nodes in [-1, 1]

    /**
     * @param shear_made_up_for 12 EI / (kGA L^2) that bending is to be stiffer
     *   by, up to most_shear; 0: the struts shear
     */
    explicit BeamShape(double shear_made_up_for = 0);

    /** N_a at any @p xi in [-1, 1]. */
    void values_at(double xi, double *values) const;

    /** Lagrange polynomials through the Gauss points at @p xi, to interpolate section forces. */
    void gauss_interpolation_at(double xi, double *values) const;
  };
} // namespace auxfem

#endif
