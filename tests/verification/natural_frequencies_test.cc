#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/lowest_frequencies.h>
#include <verification/result_table.h>

#include <algorithm>
#include <array>
#include <tuple>

using namespace auxfem;
using namespace auxfem::testing_support;

// Bending vibration of a steel bar 1 m x 0.1 m x 0.1 m: exact frequencies of
// the Timoshenko beam (transfer matrix) and of the Euler-Bernoulli beam.

namespace
{
  constexpr unsigned int n_modes = 5;
  using Frequencies              = std::array<double, n_modes>;

  const SceneText timoshenko;
  const SceneText euler_bernoulli =
    SceneText().add("Effects",
                    "Shear flexibility = off | Rotary inertia = off");

  SceneText bar(const SceneText   &supports,
                const SceneText   &effects,
                const unsigned int refinements)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("steel", "0.1 m", "0.1 m", {"210 GPa", "7850 kg/m3", 0.3})
      .set("Sections/steel/Shear correction", "5/6")
      .mesh(6, refinements)
      .add(supports)
      .add(effects);
  }

  /** Free unknowns but those along the bar, whose motion has no part in
   * bending. */
  std::vector<int> bending_unknowns(const LatticeModel &model)
  {
    const DofNumbering &numbering = model.numbering;
    std::vector<bool>   along(numbering.layout().n_owned(), false);
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      for (unsigned int node = 0; node <= numbering.elements()[e].order; ++node)
        along[numbering.element_unknowns(e)[3 * node]] = true;
    std::vector<int> unknowns;
    for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
      if (!along[i] && numbering.unknowns().kinds[i] != UnknownKind::prescribed)
        unknowns.push_back(i);
    return unknowns;
  }

  /** The lowest frequencies (Hz) above zero. */
  Frequencies frequencies(const SceneText   &supports,
                          const SceneText   &effects,
                          const unsigned int refinements)
  {
    SceneRun                  run(bar(supports, effects, refinements));
    Frequencies               result{};
    const std::vector<double> lowest =
      lowest_frequencies(run, bending_unknowns(run.model), n_modes);
    std::copy(lowest.begin(), lowest.end(), result.begin());
    return result;
  }

  void compare(const std::string &name,
               const Frequencies &computed,
               const Frequencies &exact,
               const Frequencies &allowed,
               ComparisonTable   &table)
  {
    for (unsigned int i = 0; i < n_modes; ++i)
      table.row(name + ", f" + std::to_string(i + 1),
                computed[i],
                exact[i],
                allowed[i]);
  }

  const SceneText free_free;
  const SceneText clamped_end = SceneText().support("wall", "0", "clamp");
  const SceneText pinned =
    SceneText().support("left", "0", "pin").support("right", "1", "pin");
} // namespace

TEST(NaturalFrequencies, TimoshenkoBar)
{
  ComparisonTable table(
    "Natural frequencies of a Timoshenko bar (Hz), transfer "
    "matrix; 8 elements of order 6");
  // The mesh is exact to 3e-9. Round-off of the stiffness is eps f_max^2 / (2
  // f) with the highest frequency of the mesh, 3e5 Hz, times ten for its sums.
  const auto allowed = [](const Frequencies &f) {
    Frequencies error;
    for (unsigned int i = 0; i < n_modes; ++i)
      error[i] = 3e-9 * f[i] + 1e-4 / f[i];
    return error;
  };
  const Frequencies free_exact{513.486056,
                               1335.675928,
                               2436.332636,
                               3717.532326,
                               5112.796653},
    cantilever_exact{82.894363,
                     496.814532,
                     1306.698073,
                     2370.308406,
                     3608.255034},
    pinned_exact{230.680407, 881.522233, 1857.204082, 3057.511789, 4403.749439};
  compare("free-free",
          frequencies(free_free, timoshenko, 3),
          free_exact,
          allowed(free_exact),
          table);
  compare("cantilever",
          frequencies(clamped_end, timoshenko, 3),
          cantilever_exact,
          allowed(cantilever_exact),
          table);
  compare("pinned",
          frequencies(pinned, timoshenko, 3),
          pinned_exact,
          allowed(pinned_exact),
          table);
}

TEST(NaturalFrequencies, EulerBernoulliBar)
{
  // f = (bL)^2 / (2 pi L^2) sqrt(EI / rho A)
  const double EI_over_rhoA = 210e9 / 7850 * 0.01 / 12;
  const auto   exact        = [&](const Frequencies &bL) {
    Frequencies f;
    for (unsigned int i = 0; i < n_modes; ++i)
      f[i] = bL[i] * bL[i] * std::sqrt(EI_over_rhoA) / (2 * std::acos(-1.));
    return f;
  };
  // Measured: 7e-6 where the elements, of length l, are half a wave, kl = pi,
  // and 1e-5 (kl / pi)^7 at most. Round-off
  // leaves eight digits of eigenvalues beside the stiffness of shear and the
  // shift of (500 Hz)^2: f1 of the cantilever differs by 1.3e-5 Hz between
  // versions of LAPACK.
  const auto allowed = [&](const Frequencies &bL) {
    Frequencies error = exact(bL);
    for (unsigned int i = 0; i < n_modes; ++i)
      error[i] = error[i] * 1e-5 * std::pow(bL[i] / 4 / std::acos(-1.), 7) +
        1e-8 * 500 * 500 / (2 * error[i]);
    return error;
  };
  const double      pi = std::acos(-1.);
  const Frequencies free_roots{4.73004074486,
                               7.8532046241,
                               10.995607838,
                               14.1371654913,
                               17.2787596574},
    cantilever_roots{1.87510406871,
                     4.69409113297,
                     7.85475743824,
                     10.9955407349,
                     14.137168391},
    pinned_roots{pi, 2 * pi, 3 * pi, 4 * pi, 5 * pi};
  ComparisonTable table("Natural frequencies of an Euler-Bernoulli bar (Hz), "
                        "closed form; 4 elements of order 6");
  compare("free-free",
          frequencies(free_free, euler_bernoulli, 2),
          exact(free_roots),
          allowed(free_roots),
          table);
  compare("cantilever",
          frequencies(clamped_end, euler_bernoulli, 2),
          exact(cantilever_roots),
          allowed(cantilever_roots),
          table);
  compare("pinned",
          frequencies(pinned, euler_bernoulli, 2),
          exact(pinned_roots),
          allowed(pinned_roots),
          table);
}

TEST(NaturalFrequencies, EulerBernoulliBarOnCoarseMeshes)
{
  // The remaining shear, 5e-3 of the bending of an element, would lower the
  // frequency by 5e-3 (kl)^2 / 24, 2e-3 with an element a half wave. Inertia
  // within the element compensates it to 3e-4 at order 4, as much as the error
  // of the mesh, and 7e-6 at order 6 (doc/theory/struts.md, Sections).
  ComparisonTable table("Lowest frequency of a pinned Euler-Bernoulli bar (Hz) "
                        "on coarse meshes, closed form");
  const double exact = std::acos(-1.) / 2 * std::sqrt(210e9 / 7850 * 0.01 / 12);
  for (const auto &[order, refinements, allowed] : {std::tuple(4u, 0u, 7e-4),
                                                    std::tuple(4u, 1u, 7e-6),
                                                    std::tuple(6u, 0u, 1e-5),
                                                    std::tuple(6u, 1u, 2e-7)})
    {
      SceneText scene = bar(pinned, euler_bernoulli, refinements);
      scene.mesh(order, refinements);
      SceneRun run(scene.str());
      table.relative(
        "order " + std::to_string(order) + ", " +
          std::to_string(1 << refinements) + " elements",
        lowest_frequencies(run, bending_unknowns(run.model), 1).at(0),
        exact,
        allowed);
    }
}
