#include <auxfem/analysis/small_motions/damped_modes.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** How much of a damped motion a natural mode has. */
    struct Part
    {
      std::size_t mode, root;
      double      size;
    };

    /** All parts, the largest first. */
    std::vector<Part> parts_of(const MotionPencil             &pencil,
                               const std::vector<NaturalMode> &modes,
                               const std::vector<MotionRoot>  &roots)
    {
      std::vector<Part> parts;
      for (std::size_t k = 0; k < roots.size(); ++k)
        {
          const std::size_t begin = parts.size();
          double            all   = 0;
          for (std::size_t i = 0; i < modes.size(); ++i)
            {
              const double size =
                std::abs(pencil.mass_product(modes[i].shape, roots[k].shape));
              all += size * size;
              parts.push_back({i, k, size});
            }
          for (std::size_t j = begin; j < parts.size() && all > 0; ++j)
            parts[j].size /= std::sqrt(all);
        }
      std::stable_sort(parts.begin(),
                       parts.end(),
                       [](const Part &one, const Part &other) {
                         return one.size > other.size;
                       });
      return parts;
    }
  } // namespace

  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found)
  {
    // Just above the highest frequency, where hardly a root lies.
    constexpr double    above = 1.0437;
    std::vector<double> frequencies;
    for (const NaturalMode &mode : found.modes)
      if (mode.eigenvalue > 0)
        frequencies.push_back(mode.angular_frequency());
    if (frequencies.empty())
      return;
    const auto [lowest, highest] =
      std::minmax_element(frequencies.begin(), frequencies.end());
    const double              reach = above * *highest;
    MotionPencil              pencil(solver, state, Damping::all);
    const MotionPencil::Roots damped = pencil.nearest(
      shift_below_roots * *lowest,
      {swings, static_cast<unsigned int>(frequencies.size()), reach});

    std::vector<char> is_taken(damped.roots.size(), false);
    const auto        told = [](const MotionRoot &root) {
      return NaturalMode::Damped{root.s.real(), root.s.imag()};
    };
    for (const Part &part : parts_of(pencil, found.modes, damped.roots))
      if (NaturalMode &mode = found.modes[part.mode];
          mode.eigenvalue > 0 && !mode.damped && !is_taken[part.root])
        {
          mode.damped         = told(damped.roots[part.root]);
          is_taken[part.root] = true;
        }
    for (std::size_t k = 0; k < damped.roots.size(); ++k)
      if (!is_taken[k])
        found.further_damped.push_back(told(damped.roots[k]));
    if (damped.is_complete)
      found.damped_limit = reach;
  }
} // namespace auxfem
