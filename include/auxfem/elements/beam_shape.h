#ifndef auxfem_elements_beam_shape_h
#define auxfem_elements_beam_shape_h

namespace auxfem
{
  /** Largest polynomial order of struts in the plane, and in space. */
  constexpr int largest_plane_order = 6, largest_space_order = 4;

  /**
   * Shape functions of a line element of polynomial order p on [-1, 1], nodes
   * in the order of FE_Q: both ends, then the inner Gauss-Lobatto nodes.
   * Internal forces use p Gauss points (no locking), inertia is integrated
   * exactly.
   */
  template <int order>
  struct BeamShape
  {
    static constexpr int n_nodes        = order + 1;
    static constexpr int n_gauss_points = order;

    double value[order][order + 1];      ///< N_a at the Gauss points
    double derivative[order][order + 1]; ///< dN_a/dxi at the Gauss points
    double weight[order];                ///< Gauss weights
    double point[order];                 ///< Gauss points in [-1, 1]
    double mass[order + 1][order + 1];   ///< integral of N_a N_b over [-1, 1]
    double integral[order + 1];          ///< integral of N_a over [-1, 1]
    double node[order + 1];              ///< nodes in [-1, 1]

    BeamShape();

    /** N_a at any @p xi in [-1, 1]. */
    void values_at(double xi, double *values) const;

    /** Lagrange polynomials through the Gauss points at @p xi, to interpolate section forces. */
    void gauss_interpolation_at(double xi, double *values) const;
  };
} // namespace auxfem

#endif
