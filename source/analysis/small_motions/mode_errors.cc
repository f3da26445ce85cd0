#include <auxfem/analysis/small_motions/mode_errors.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Result of @p compare, or the reason of its failure. */
    template <class Compare>
    MeshErrors compared(LatticeRun &run, const Compare &compare)
    {
      try
        {
          FinerRun finer(run);
          return compare(finer);
        }
      catch (const Interrupted &)
        {
          throw;
        }
      catch (const ComputationError &error)
        {
          MeshErrors unknown;
          unknown.unknown_reason = error.what();
          return unknown;
        }
    }

    template <class Mode>
    std::vector<Vector> prolongated_shapes(const FinerRun          &finer,
                                           const std::vector<Mode> &modes)
    {
      std::vector<Vector> shapes;
      for (const Mode &mode : modes)
        shapes.push_back(finer.prolongated(mode.shape));
      return shapes;
    }

    /**
     * Half the relative difference, which for eigenvalues is that of the
     * frequencies; 0 if both are zero.
     */
    double half_difference(const double one, const double other)
    {
      const double sum = std::abs(one) + std::abs(other);
      return sum > 0 ? std::abs(one - other) / sum : 0.;
    }

    /**
     * Stores the errors of modes.
     * @param values eigenvalues or factors of the modes
     * @param part error over the relative difference of values
     */
    template <class Modes>
    MeshErrors compare_values(const std::vector<double> &values,
                              const FinerValues         &finer,
                              const double               part,
                              const unsigned int         n_asked,
                              Modes                     &found)
    {
      MeshErrors errors;
      for (std::size_t i = 0; i < values.size(); ++i)
        {
          if (i < finer.values.size())
            found.modes[i].mesh_error =
              2 * part * half_difference(values[i], finer.values[i]);
          errors.relative.push_back(found.modes[i].mesh_error);
        }
      errors.has_too_few =
        values.size() < n_asked && finer.n_possible > found.n_possible;
      errors.n_missing = finer.n_missing;
      return errors;
    }

    /** Errors of roots by comparison with finer elements. */
    class RootErrors
    {
    public:
      /** @param coarse roots whose errors are requested */
      RootErrors(FinerRun                   &finer,
                 const Damping               damping,
                 const std::vector<Complex> &coarse)
      {
        // Finer elements may have larger roots; search up to 20 % above.
        constexpr double margin = 1.2;
        double smallest = std::numeric_limits<double>::infinity(), largest = 0;
        for (const Complex s : coarse)
          {
            smallest = std::min(smallest, std::abs(s));
            largest  = std::max(largest, std::abs(s));
          }
        if (coarse.empty() || smallest == 0)
          return;
        MotionPencil pencil(finer.solver(), finer.state(), damping);
        for (const MotionRoot &root :
             pencil
               .nearest(shift_below_roots * smallest,
                        {[](const Complex s) { return !relaxes(s); },
                         static_cast<unsigned int>(coarse.size()),
                         margin * largest})
               .roots)
          roots.push_back(root.s);
      }

      /**
       * Distance between @p s and the nearest root of finer elements over |s|;
       * NaN if there is none.
       */
      double relative_error(const Complex s) const
      {
        double error = std::numeric_limits<double>::quiet_NaN();
        for (const Complex root : roots)
          if (const double distance = std::abs(root - s) / std::abs(s);
              !(distance >= error))
            error = distance;
        return error;
      }

    private:
      std::vector<Complex> roots;
    };

    Complex value_of(const NaturalMode::Damped &damped)
    {
      return {damped.growth, damped.angular_frequency};
    }

    /** Stores errors of damped modes where these are larger. */
    void
    compare_damped(FinerRun &finer, NaturalModes &found, MeshErrors &errors)
    {
      std::vector<Complex> coarse;
      for (const NaturalMode &mode : found.modes)
        if (mode.damped)
          coarse.push_back(value_of(*mode.damped));
      for (const NaturalMode::Damped &damped : found.further_damped)
        coarse.push_back(value_of(damped));
      const RootErrors roots(finer, Damping::all, coarse);
      for (std::size_t i = 0; i < found.modes.size(); ++i)
        if (NaturalMode &mode = found.modes[i]; mode.damped)
          if (const double error = roots.relative_error(value_of(*mode.damped));
              !(error <= mode.mesh_error))
            errors.relative[i] = mode.mesh_error = error;
      for (const NaturalMode::Damped &damped : found.further_damped)
        errors.relative.push_back(roots.relative_error(value_of(damped)));
    }
  } // namespace

  MeshErrors estimate_errors(LatticeRun &run, NaturalModes &found)
  {
    return compared(run, [&](FinerRun &finer) {
      std::vector<double> values;
      for (const NaturalMode &mode : found.modes)
        values.push_back(mode.eigenvalue);
      MeshErrors errors =
        compare_values(values,
                       nearby_eigenvalues(finer.solver(),
                                          finer.state(),
                                          found,
                                          prolongated_shapes(finer,
                                                             found.modes)),
                       0.5,
                       run.scene.modes.number,
                       found);
      if (run.scene.modes.damped)
        compare_damped(finer, found, errors);
      return errors;
    });
  }

  MeshErrors estimate_errors(LatticeRun &run, ComplexModes &found)
  {
    return compared(run, [&](FinerRun &finer) {
      std::vector<Complex> coarse;
      for (const ComplexMode &mode : found.modes)
        coarse.push_back(mode.s);
      const RootErrors roots(finer,
                             run.scene.modes.damped ? Damping::all
                                                    : Damping::none,
                             coarse);
      MeshErrors       errors;
      for (ComplexMode &mode : found.modes)
        {
          mode.mesh_error = roots.relative_error(mode.s);
          errors.relative.push_back(mode.mesh_error);
        }
      return errors;
    });
  }

  MeshErrors estimate_errors(LatticeRun &run, BucklingModes &found)
  {
    return compared(run, [&](FinerRun &finer) {
      std::vector<double> values;
      for (const BucklingMode &mode : found.modes)
        values.push_back(mode.factor);
      return compare_values(values,
                            finer_factors(finer.solver(),
                                          finer.state(),
                                          buckling_loads(run.scene),
                                          found,
                                          prolongated_shapes(finer,
                                                             found.modes)),
                            1.,
                            run.scene.modes.number,
                            found);
    });
  }
} // namespace auxfem
