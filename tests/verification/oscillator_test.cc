#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>
#include <support/markdown_table.h>
#include <support/one_mass_scene.h>
#include <support/scene_run.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  struct Scheme
  {
    std::string name, entries;
  };

  const Scheme newmark = {"Newmark", "set Scheme = newmark\n"};

  Scheme hht(const double alpha)
  {
    return {"HHT " + MarkdownNumber(alpha),
            "set Scheme = hht\nset HHT alpha = " + digits(alpha) + "\n"};
  }

  Scheme generalized_alpha(const double radius)
  {
    return {"generalized-alpha " + MarkdownNumber(radius),
            "set Scheme = generalized-alpha\nset Spectral radius = " + digits(radius) +
              "\n"};
  }

  std::string steps(const Scheme &scheme, const double dt, const double end)
  {
    return scheme.entries + "set Time step = " + digits(dt) +
           "\nset End time = " + digits(end) + "\n";
  }

  std::string spring(const double stiffness)
  {
    return "set Law = spring\nset Spring stiffness = " + digits(stiffness);
  }

  /**
   * Matrix that takes (O^2 u, dt v, dt^2 a) over a step, O = w dt, a the
   * algorithmic acceleration; so scaled, all entries stay finite for O ->
   * infinity. Found by stepping the three unit states.
   */
  dealii::LAPACKFullMatrix<double> amplification(const Scheme &scheme, const double O)
  {
    const double                     w = 1, dt = O / w;
    dealii::LAPACKFullMatrix<double> matrix(3, 3);
    for (unsigned int j = 0; j < 3; ++j)
      {
        SceneRun  run(one_mass_scene(spring(w * w), steps(scheme, dt, dt), mass_and_velocity(1, 0)));
        const int i                 = run.system.numbering().joint_unknown(0, 0);
        State    &state             = run.state;
        state.displacement[i]       = j == 0 ? 1 / (O * O) : 0.;
        (*state.velocity)[i]        = j == 1 ? 1 / dt : 0.;
        (*state.acceleration)[i]    = -w * w * state.displacement[i];
        const double a              = j == 2 ? 1 / (dt * dt) : 0.;
        const bool   has_own        = bool(state.algorithmic_acceleration);
        auto &algorithmic = has_own ? *state.algorithmic_acceleration : *state.acceleration;
        algorithmic[i]    = a;
        run.run();
        matrix(0, j) = O * O * state.displacement[i];
        matrix(1, j) = dt * (*state.velocity)[i];
        matrix(2, j) = dt * dt * algorithmic[i];
      }
    return matrix;
  }

  double spectral_radius(const Scheme &scheme, const double O)
  {
    auto matrix = amplification(scheme, O);
    matrix.compute_eigenvalues();
    double largest = 0;
    for (unsigned int i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(matrix.eigenvalue(i)));
    return largest;
  }
} // namespace
