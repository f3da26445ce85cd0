#ifndef auxfem_tests_verification_clamped_strut_3d_h
#define auxfem_tests_verification_clamped_strut_3d_h

#include <auxfem/elements/beam_3d.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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

    /** A strut along x from the origin, section axes along those of space. */
    inline StrutAtRest along_x(const double length)
    {
      return {length,
              [](const double s) {
                return SpaceVector({s, 0., 0.});
              },
              [](const double) {
                return section_frame(SpaceVector({1., 0., 0.}),
                                     SpaceVector({0., 0., 1.}));
              }};
    }

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
       * Brings the strut into equilibrium with @p target, from where it is, in
       * as few steps as Newton's method allows; returns iterations of the last.
       */
      std::vector<NewtonIteration> load_to(const TipLoad &target)
      {
        const TipLoad                start = load;
        std::vector<NewtonIteration> iterations;
        double                       done = 0, step = 1;
        while (done < 1)
          {
            const auto   before = nodes;
            const double share  = done + step;
            load = {(1 - share) * start.force + share * target.force,
                    (1 - share) * start.moment + share * target.moment};
            if (solve(iterations))
              {
                done = share;
                step = std::min(2 * step, 1 - done);
              }
            else
              {
                nodes = before;
                step /= 2;
                if (step < 1e-4)
                  {
                    ADD_FAILURE() << "Newton's method does not converge";
                    return iterations;
                  }
              }
          }
        return iterations;
      }

      SpaceVector tip() const
      {
        return tip_at_rest + nodes.back().displacement;
      }

      /** Of the section at the tip, since rest. */
      const Quaternion &tip_rotation() const
      {
        return nodes.back().rotation;
      }

    private:
      static constexpr int n = Beam3D::n_components;

      static unsigned int node_of(const unsigned int e, const int a)
      {
        return e * p + (a == 0 ? 0 : a == 1 ? p : a - 1);
      }

      /** Newton's method; whether it comes to an end. */
      bool solve(std::vector<NewtonIteration> &iterations)
      {
        const unsigned int n_iterations = 12;
        const double       far          = 3; // lengths or rad
        iterations.clear();
        while (iterations.size() < n_iterations)
          {
            assemble();
            const dealii::Vector<double> residual = right_side;
            matrix.compute_lu_factorization();
            matrix.solve(right_side);
            const double increment = move();
            iterations.push_back({residual.linfty_norm(),
                                  increment,
                                  std::abs(residual * right_side)});
            // Convergence is quadratic: the next one would be round-off.
            if (increment < 1e-9)
              return true;
            if (!(increment < far))
              return false;
          }
        return false;
      }

      void assemble()
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
      TipLoad                   load;  ///< that nodes are in equilibrium with
      std::vector<Beam3D::Node> nodes; ///< along the axis
      const SpaceVector         tip_at_rest;
      dealii::LAPACKFullMatrix<double> matrix;
      dealii::Vector<double>           right_side;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
