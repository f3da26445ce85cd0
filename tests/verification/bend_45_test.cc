#include <verification/clamped_strut_3d.h>
#include <verification/comparison_table.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Bathe & Bolourchi (1979): an arc of 45 degrees, radius 100, clamped at the
// origin with its tangent along y, bending towards x; unit square section,
// dead load P along z at the tip.
namespace
{
  constexpr double pi = 3.14159265358979323846;

  constexpr double radius = 100, opening = pi / 4, youngs_modulus = 1e7;

  Beam3D::Stiffness square_section(const double torsion_constant,
                                   const double shear_stiffness)
  {
    const double bending = youngs_modulus / 12;
    return {youngs_modulus,
            shear_stiffness,
            shear_stiffness,
            youngs_modulus / 2 * torsion_constant,
            bending,
            bending};
  }

  SpaceVector on_arc(const double angle)
  {
    return SpaceVector(
      {radius * (1 - std::cos(angle)), radius * std::sin(angle), 0.});
  }

  SpaceTensor axes_at(const double angle)
  {
    return section_frame(SpaceVector({std::sin(angle), std::cos(angle), 0.}),
                         SpaceVector({0., 0., 1.}));
  }

  StrutAtRest arc()
  {
    return {radius * opening,
            [](const double s) { return on_arc(s / radius); },
            [](const double s) { return axes_at(s / radius); }};
  }

  /** The chords of @p n equal parts of the arc. */
  StrutAtRest polygon(const unsigned int n)
  {
    const double angle = opening / n, chord = 2 * radius * std::sin(angle / 2);
    return {n * chord,
            [=](const double s) {
              const double part =
                std::min(std::floor(s / chord + 1e-9), n - 1.);
              const double share = s / chord - part;
              return (1 - share) * on_arc(part * angle) +
                share * on_arc((part + 1) * angle);
            },
            [=](const double s) {
              return axes_at((std::floor(s / chord) + 0.5) * angle);
            }};
  }

  TipLoad upwards(const double load)
  {
    return {SpaceVector({0., 0., load}), {}};
  }

  struct Model
  {
    std::string                name;
    Beam3D::Stiffness          section;
    std::array<SpaceVector, 3> tips; ///< at loads 300, 450, 600
  };

  template <int p>
  void compare(const Model       &model,
               const StrutAtRest &rest,
               const unsigned int n_elements,
               const double       allowed)
  {
    ComparisonTable   table("45-degree bend, " + model.name);
    ClampedStrut3D<p> strut(rest, n_elements, model.section);
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double load = 300 + 150 * i;
        strut.load_to(upwards(load));
        const char *names[] = {", x", ", y", ", z"};
        for (int d = 0; d < 3; ++d)
          table.row(label("P", load) + names[d],
                    strut.tip()[d],
                    model.tips[i][d],
                    allowed);
      }
  }
} // namespace

TEST(Bend45, TipAgainstTheRodEquation)
{
  const double polar = 1. / 6, saint_venant = 0.140577, shear = 5e6,
               corrected_shear = shear * 5 / 6;
  // At EA = kGA = 1e12 extension and shear move the tip by 1e-7 at most (the
  // rows show 6e-3 at 1e7).
  Beam3D::Stiffness stiff = square_section(polar, 1e12);
  stiff.axial             = 1e12;
  const Model models[]    = {{"polar J, kGA = 5e6",
                              square_section(polar, shear),
                              {SpaceVector({22.244781, 58.779122, 40.191892}),
                               SpaceVector({18.508179, 52.238558, 48.502927}),
                               SpaceVector({15.684801, 47.150439, 53.474859})}},
                             {"polar J, kGA = 4.16667e6",
                              square_section(polar, corrected_shear),
                              {SpaceVector({22.244679, 58.778897, 40.192392}),
                               SpaceVector({18.508065, 52.238262, 48.503492}),
                               SpaceVector({15.684689, 47.150096, 53.475478})}},
                             {"Saint-Venant's J, kGA = 4.16667e6",
                              square_section(saint_venant, corrected_shear),
                              {SpaceVector({22.112514, 58.535709, 40.480757}),
                               SpaceVector({18.369163, 51.969425, 48.705349}),
                               SpaceVector({15.557676, 46.891586, 53.607986})}},
                             {"polar J, inextensible without shear",
                              stiff,
                              {SpaceVector({22.245035, 58.779685, 40.188284}),
                               SpaceVector({18.508464, 52.239298, 48.497983}),
                               SpaceVector({15.685078, 47.151294, 53.468598})}}};
  // The reference has six decimals; eight elements of order 4 are much nearer
  // to the rod than that (next test but one).
  for (const Model &model : models)
    compare<4>(model, arc(), 8, 1e-6);
}

TEST(Bend45, EightStraightLinearElements)
{
  // From another code with one-point elements. There the section turns evenly
  // by the angle between the ends, in Beam3D by 4 tan(angle / 4): near the
  // clamp an element turns by up to 0.4 rad and is 0.4 % stiffer, of
  // deflections of 53.
  compare<1>({"eight straight linear elements",
              square_section(1. / 6, 5e6),
              {SpaceVector({22.2958, 58.8609, 40.0770}),
               SpaceVector({18.5665, 52.3391, 48.3968}),
               SpaceVector({15.7424, 47.2600, 53.3742})}},
             polygon(8),
             8,
             0.2);
}

TEST(Bend45, NewtonConvergesQuadratically)
{
  ClampedStrut3D<3> strut(arc(), 8, square_section(1. / 6, 5e6));
  std::cout << "\n**Newton's method, 45-degree bend**\n\n"
            << "| load | iteration | largest residual (N) | largest increment "
               "(1) | energy (J) |\n|---|---|---|---|---|\n"
            << std::scientific << std::setprecision(2);
  for (int load = 50; load <= 600; load += 50)
    {
      const auto iterations = strut.load_to(upwards(load));
      for (unsigned int i = 0; i < iterations.size(); ++i)
        std::cout << "| " << load << " | " << i + 1 << " | "
                  << iterations[i].residual << " | " << iterations[i].increment
                  << " | " << iterations[i].energy << " |\n";
      // In the norm of energy the increment is squared each time, times a
      // factor that depends on the problem: here its square is below 1/J. The
      // residual's round-off (1e-8 N) along increments of 1e-10 is the end.
      for (unsigned int i = 1; i < iterations.size(); ++i)
        if (iterations[i - 1].energy < 0.5)
          {
            EXPECT_LT(iterations[i].energy,
                      1e-16 + std::pow(iterations[i - 1].energy, 2))
              << "load " << load;
          }
    }
  std::cout << std::defaultfloat << std::endl;
}

namespace
{
  template <int p>
  SpaceVector tip_at_600(const unsigned int n_elements)
  {
    ClampedStrut3D<p> strut(arc(), n_elements, square_section(1. / 6, 5e6));
    strut.load_to(upwards(600));
    return strut.tip();
  }

  /** Prints errors of the tip on four meshes; returns the last rate. */
  template <int p>
  double observed_rate(const unsigned int coarsest, const SpaceVector &exact)
  {
    double before = 0, rate = 0;
    for (unsigned int n = coarsest; n <= 8 * coarsest; n *= 2)
      {
        const double error = (tip_at_600<p>(n) - exact).norm();
        rate               = std::log2(before / error);
        std::cout << "| " << p << " | " << n << " | " << std::scientific
                  << std::setprecision(2) << error << " | ";
        if (n > coarsest)
          std::cout << std::fixed << rate;
        std::cout << " |\n" << std::defaultfloat;
        before = error;
      }
    return rate;
  }
} // namespace

TEST(Bend45, OrderOfConvergence)
{
  // Agrees with the rod equation to its six decimals (first test).
  const SpaceVector exact = tip_at_600<4>(16);
  std::cout << "\n**Tip of the 45-degree bend at P = 600**\n\n"
            << "| order | elements | error | rate |\n|---|---|---|---|\n";
  // Nodes converge with the order of p-point Gauss quadrature.
  EXPECT_NEAR(observed_rate<1>(4, exact), 2, 0.1);
  EXPECT_NEAR(observed_rate<2>(2, exact), 4, 0.2);
  EXPECT_NEAR(observed_rate<3>(1, exact), 6, 0.4);
  std::cout << std::endl;
}
