#include <auxfem/analysis/small_motions/harmonic_response.h>
#include <auxfem/equations/load_direction.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void fail_to_vibrate(const double       omega,
                                      const std::string &why)
    {
      std::ostringstream message;
      message << "No steady vibration was found at "
              << omega / (2 * dealii::numbers::PI) << " Hz: " << why
              << ". Without damping there is none at a natural frequency.";
      throw ComputationError(message.str());
    }
  } // namespace

  HarmonicResponse::HarmonicResponse(TangentSolver &solver,
                                     const State   &equilibrium)
    : solver(solver)
    , layout(solver.equations().unknowns().layout)
    , space(solver)
    , stiffness(solver, equilibrium)
    , loads(load_direction(solver.equations(), stiffness.evaluation()))
  {
    loads.resize(layout.n_owned());
    if (layout.largest(largest_size(loads)) == 0)
      throw InputError(
        "Analysis = frequency response: no load and no prescribed motion acts "
        "at Frequency response/Time of the loads. Set it to a time at which "
        "there is one; about a static equilibrium amplitudes are what differs "
        "from t = 0, so that constants have none.");
  }

  HarmonicVibration HarmonicResponse::at(const double omega)
  {
    stiffness.set({0., omega});
    if (!stiffness.factorize())
      fail_to_vibrate(omega, solver.why());
    const unsigned int  n = layout.n_owned();
    std::vector<double> b(2 * n, 0.), x(2 * n, 0.);
    std::copy(loads.begin(), loads.end(), b.begin());
    if (const std::string why = stiffness.solve(b, x); !why.empty())
      fail_to_vibrate(omega, why);

    HarmonicVibration vibration;
    for (Vector *part :
         {&vibration.displacement.real, &vibration.displacement.imaginary})
      {
        part->assign(layout.n_local(), 0.);
        std::copy_n(x.begin() + (part == &vibration.displacement.real ? 0 : n),
                    n,
                    part->begin());
        layout.update_ghosts(part->data());
      }
    Vector &real          = vibration.reaction.real,
           &other         = vibration.reaction.imaginary;
    std::tie(real, other) = stiffness.forces(vibration.displacement.real,
                                             vibration.displacement.imaginary);
    double left = 0, all = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (space.is_prescribed(i))
        all += real[i] * real[i] + other[i] * other[i];
      else
        {
          left += std::pow(real[i] - loads[i], 2) + other[i] * other[i];
          all += loads[i] * loads[i];
          real[i] = other[i] = 0;
        }
    vibration.residual = std::sqrt(layout.sum(left) / layout.sum(all));
    return vibration;
  }
} // namespace auxfem
