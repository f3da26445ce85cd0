#ifndef auxfem_tests_verification_clamped_strut_3d_h
#define auxfem_tests_verification_clamped_strut_3d_h

#include <auxfem/elements/beam_3d.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Axis and section axes of a strut at rest, by the length along it. */
    struct StrutAtRest
    {
      double                             length;
      std::function<SpaceVector(double)> place;
      std::function<SpaceTensor(double)> axes;
    };

    /** Dead force (N) and moment (N m, along fixed directions). */
    struct TipLoad
    {
      SpaceVector force, moment;
    };

    /** Measures of an iteration of Newton's method. */
    struct NewtonIteration
    {
      double residual;  ///< largest
      double increment; ///< largest, by length or in rad
      double energy;    ///< work of the residual along the increment (J)
    };

    /**
     * A strut in space, clamped at its beginning and loaded at its tip, in
     * elements of equal length and order p; statics by Newton's method with a
     * dense matrix.
     */
    template <int p>
    class ClampedStrut3D
    {
    public:
      ClampedStrut3D(const StrutAtRest       &rest,
                     const unsigned int       n_elements,
                     const Beam3D::Stiffness &stiffness)
        : stiffness(stiffness)
        , jacobian(rest.length / n_elements / 2)
        , frames(n_elements)
        , nodes(n_elements * p + 1)
        , tip_at_rest(rest.place(rest.length))
      {
        for (unsigned int e = 0; e < n_elements; ++e)
          for (int g = 0; g < p; ++g)
            {
              const auto at = [&](const double point) {
                return jacobian * (2 * e + 1 + point);
              };
              SpaceVector slope;
              for (int a = 0; a <= p; ++a)
                slope += shape.derivative[g][a] / jacobian *
                  rest.place(at(shape.node[a]));
              frames[e][g] = {rest.axes(at(shape.point[g])), slope};
            }
      }

      /**
       * Brings the strut into equilibrium with @p load, starting from where it
       * is. Newton's method must come to an end within 25 iterations.
       */
      std::vector<NewtonIteration> solve(const TipLoad &load)
      {
        std::vector<NewtonIteration> iterations;
        double                       increment = 1;
        // Quadratic: the next increment would be round-off.
        while (increment > 1e-9 && iterations.size() < 25)
          {
            assemble(load);
            const dealii::Vector<double> residual = right_side;
            matrix.compute_lu_factorization();
            matrix.solve(right_side);
            increment = move();
            iterations.push_back({residual.linfty_norm(),
                                  increment,
                                  std::abs(residual * right_side)});
          }
        EXPECT_LE(increment, 1e-9) << "Newton's method does not converge";
        return iterations;
      }

      SpaceVector tip() const
      {
        return tip_at_rest + nodes.back().displacement;
      }

    private:
      static constexpr int n = Beam3D::n_components;

      static unsigned int node_of(const unsigned int e, const int a)
      {
        return e * p + (a == 0 ? 0 : a == 1 ? p : a - 1);
      }

      void assemble(const TipLoad &load)
      {
        // The clamped node has no unknowns.
        const unsigned int size = (nodes.size() - 1) * n;
        matrix.reinit(size);
        right_side.reinit(size);
        for (int i = 0; i < 3; ++i)
          {
            right_side[size - n + i]     = load.force[i];
            right_side[size - n + 3 + i] = load.moment[i];
          }
        for (unsigned int e = 0; e < frames.size(); ++e)
          add_element(e);
      }

      void add_element(const unsigned int e)
      {
        constexpr int n_unknowns = n * (p + 1);
        Beam3D::Node  element_nodes[p + 1];
        double        force[n_unknowns], tangent[n_unknowns * n_unknowns];
        for (int a = 0; a <= p; ++a)
          element_nodes[a] = nodes[node_of(e, a)];
        Beam3D::internal_force(shape,
                               frames[e].data(),
                               jacobian,
                               stiffness,
                               element_nodes,
                               force);
        Beam3D::tangent(shape,
                        frames[e].data(),
                        jacobian,
                        stiffness,
                        element_nodes,
                        1,
                        tangent);
        const auto unknown = [e](const int i) {
          return int(node_of(e, i / n)) * n + i % n - n;
        };
        for (int i = 0; i < n_unknowns; ++i)
          if (unknown(i) >= 0)
            {
              right_side[unknown(i)] -= force[i];
              for (int j = 0; j < n_unknowns; ++j)
                if (unknown(j) >= 0)
                  matrix(unknown(i), unknown(j)) += tangent[i * n_unknowns + j];
            }
      }

      /**
       * Adds the increment in right_side; returns its largest displacement (by
       * the length) or spin.
       */
      double move()
      {
        const double length  = 2 * jacobian * frames.size();
        double       largest = 0;
        for (unsigned int i = 1; i < nodes.size(); ++i)
          {
            SpaceVector displacement, spin;
            for (int d = 0; d < 3; ++d)
              {
                displacement[d] = right_side[(i - 1) * n + d];
                spin[d]         = right_side[(i - 1) * n + 3 + d];
              }
            largest =
              std::max({largest, displacement.norm() / length, spin.norm()});
            nodes[i] = {nodes[i].displacement + displacement,
                        normalized(exponential(spin) * nodes[i].rotation)};
          }
        return largest;
      }

      const BeamShape<p>                        shape;
      const Beam3D::Stiffness                   stiffness;
      const double                              jacobian;
      std::vector<std::array<Beam3D::Frame, p>> frames; ///< by element
      std::vector<Beam3D::Node>                 nodes;  ///< along the axis
      const SpaceVector                         tip_at_rest;
      dealii::LAPACKFullMatrix<double>          matrix;
      dealii::Vector<double>                    right_side;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
