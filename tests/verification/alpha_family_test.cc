#include <deal.II/lac/lapack_full_matrix.h>

#include <support/scene_run.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <verification/label.h>
#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// The alpha family on u'' + u = 0 with steps of O: what the schemes must give
// is known exactly.

namespace
{
  const std::string unit_spring = "Law = spring | Spring stiffness = 1";

  /**
   * Matrix that takes (O^2 u, O v, O^2 a) over a step of length O, a being the
   * algorithmic acceleration; so scaled, all entries stay finite for O ->
   * infinity. Found by stepping the three unit states.
   */
  dealii::LAPACKFullMatrix<double> amplification(const Scheme &scheme,
                                                 const double  O)
  {
    dealii::LAPACKFullMatrix<double> matrix(3, 3);
    for (unsigned int j = 0; j < 3; ++j)
      {
        // The unit states are no motions of the mass: their energies mean
        // nothing.
        SceneRun run(
          one_mass_scene(unit_spring,
                         scheme.steps(O, O) + " | Largest energy error = 1e30",
                         mass_and_velocity(1, 1)));
        const int i              = run.model.numbering.joint_unknown(0, 0);
        State    &state          = run.state;
        Vector   &a              = state.algorithmic_acceleration
                         ? *state.algorithmic_acceleration
                         : *state.acceleration;
        state.displacement[i]    = j == 0 ? 1 / (O * O) : 0;
        (*state.velocity)[i]     = j == 1 ? 1 / O : 0;
        (*state.acceleration)[i] = -state.displacement[i];
        a[i]                     = j == 2 ? 1 / (O * O) : 0;
        run.run();
        matrix(0, j) = O * O * state.displacement[i];
        matrix(1, j) = O * (*state.velocity)[i];
        matrix(2, j) = O * O * a[i];
      }
    return matrix;
  }

  double spectral_radius(const Scheme &scheme, const double O)
  {
    dealii::LAPACKFullMatrix<double> matrix = amplification(scheme, O);
    matrix.compute_eigenvalues();
    double largest = 0;
    for (unsigned int i = 0; i < matrix.m(); ++i)
      largest = std::max(largest, std::abs(matrix.eigenvalue(i)));
    return largest;
  }

  struct SpectralRadii
  {
    Scheme scheme;
    double at_half, at_one, at_infinity;
    /** Whether the three eigenvalues meet at infinity. */
    bool all_meet;
  };
} // namespace

TEST(AlphaFamilyOneMass, NewmarkFrequencyIsTheExactDiscreteOne)
{
  ComparisonTable table(
    "Average-acceleration Newmark, angle per step of u'' + u = 0, "
    "exactly 2 atan(O/2)");
  for (const double O : {0.1, 0.5, 1.})
    {
      SceneRun            run(one_mass_scene(unit_spring,
                                  newmark().steps(O, 20 * O),
                                  mass_and_velocity(1, 1)));
      std::vector<double> u = {run.motion(0, 0)};
      run.run([&] { u.push_back(run.motion(0, 0)); });

      // u_n = sin(n W): round-off only, some digits lost by acos.
      const unsigned int n = 7;
      table.row(label("O", O),
                std::acos((u[n + 1] + u[n - 1]) / (2 * u[n])),
                2 * std::atan(O / 2),
                1e-12);
      for (unsigned int i = 0; i < u.size(); ++i)
        EXPECT_NEAR(u[i], std::sin(i * 2 * std::atan(O / 2)), 1e-13);
      // The scheme conserves m v^2 / 2 + k u^2 / 2 = 1/2 exactly.
      EXPECT_NEAR(run.balance(), 0, 1e-14);
    }
}

TEST(AlphaFamilyOneMass, SpectralRadiiAreThoseOfTheSchemes)
{
  // Chung & Hulbert 1993, Hilber, Hughes & Taylor 1977: eigenvalues of their
  // amplification matrices, ten digits.
  const std::vector<SpectralRadii> expected = {
    {newmark(), 1, 1, 1, false},
    {generalized_alpha("1"), 1, 1, 1, false},
    {generalized_alpha("0.8"), 0.9999601108, 0.9994746140, 0.8, true},
    {generalized_alpha("0.5"), 0.9990113987, 0.9893127860, 0.5, true},
    {generalized_alpha("0"), 0.9842429788, 0.9065633333, 0, true},
    {hht("-0.05"), 0.9996908492, 0.9964896684, 0.95 / 1.05, false},
    {hht("-0.1"), 0.9994497406, 0.9938473293, 0.9 / 1.1, false},
    {hht("-0.3"), 0.9990187004, 0.9893840771, 0.7 / 1.3, false}};

  ComparisonTable table("Spectral radius of the alpha family, one mass");
  for (const SpectralRadii &row : expected)
    {
      // Half a unit of the tenth digit.
      table.row(row.scheme.name + ", O = 0.5",
                spectral_radius(row.scheme, 0.5),
                row.at_half,
                6e-11);
      table.row(row.scheme.name + ", O = 1",
                spectral_radius(row.scheme, 1),
                row.at_one,
                6e-11);
      // Eigenvalues tend to their limits like 1/O^2; three that become equal
      // there by its cube root.
      const double O = 1e4;
      table.row(row.scheme.name + ", O = 1e4",
                spectral_radius(row.scheme, O),
                row.at_infinity,
                row.all_meet ? 1.1 * std::pow(O, -2. / 3) : 1000 / (O * O));
    }
}
