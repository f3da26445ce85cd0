#include <auxfem/output/verdict_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/time/large_rotation_error.h>
#include <auxfem/time/small_displacement_error.h>
#include <auxfem/time/small_displacement_limit.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Estimate from which on the exact equilibrium is compared.
     * @tuned theory: struts held at both ends, 500 times longer than thick,
     * are stiffer by some per cent
     */
    constexpr double least_compared = 5e-4;

    /**
     * Growth of the estimate after which the exact equilibrium is compared
     * in any case.
     * @tuned judgement
     */
    constexpr double growth_between_comparisons = 8;

    Verdict verdict_on(const double error)
    {
      return error > unusable_error ? Verdict::not_to_be_used
        : error > doubtful_error    ? Verdict::doubtful
                                    : Verdict::sound;
    }

    /** When a linear scene was furthest beyond its critical load. */
    struct LossOfStability
    {
      double time = 0; ///< s
      /** Largest compressive force over the Euler load of its strut. */
      double compression = 0;
      double strut       = 0; ///< number of that strut
      enum class Evidence
      {
        none,
        compression,
        negative_modes
      } evidence = Evidence::none;

      Finding finding() const
      {
        const std::string location =
          "strut " + std::to_string(std::lround(strut));
        std::ostringstream text;
        text.precision(3);
        text << "The structure "
             << (evidence == Evidence::negative_modes ? "is" : "may be")
             << " loaded beyond its critical load: at t = " << time << " s ";
        if (evidence == Evidence::negative_modes)
          text << "its stiffness under the axial forces has negative modes"
               << (compression > 1 ? ", and " : "");
        if (compression > 1)
          text << location << " bears " << compression
               << " times its Euler load with hinged ends";
        text << ". Linear results hold only if buckling is excluded. Find the "
                "critical load with Analysis = buckling, or set Effects/Large "
                "rotation = on.";
        return {Verdict::doubtful,
                text.str(),
                time,
                compression > 1 ? location : ""};
      }
    };

    /** The exact equilibrium under the same loads, of which the estimate knows
     * no axial forces that come from bending. */
    struct Comparison
    {
      double      estimate = 0; ///< when it was found
      double      error = 0; ///< distance, see LargeRotationError::translation
      double      time  = 0; ///< s
      std::string location;

      /** Error of a motion with another estimate: goes with its square. */
      double expected(const double other) const
      {
        return estimate > 0 ? error * std::pow(other / estimate, 2) : 0;
      }

      Finding finding() const
      {
        std::ostringstream text;
        text << "Displacements are not small, as Large rotation = off "
                "supposes: at t = "
             << time << " s ";
        if (std::isfinite(error))
          text << "the exact equilibrium under the same loads differs by "
               << percentage_text(error)
               << " of the displacements, most in the " << location;
        else
          text << "no exact equilibrium under the same loads was found near";
        text << ". Set Effects/Large rotation = on, or reduce the load.";
        return {std::isfinite(error) ? verdict_on(error) : Verdict::doubtful,
                text.str(),
                time,
                location};
      }
    };

    /** Watches linear scenes. */
    class SmallDisplacementWatch : public Watch
    {
    public:
      explicit SmallDisplacementWatch(const WatchedRun &run)
        : Watch(SamplingRate::single_steps)
        , layout(run.equations.unknowns().layout)
        , equations(run.equations)
        , estimate(run.equations)
        , second_order(run.equations)
        , end_time(run.plan.time.end_time)
        , work(run.work)
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        SmallDisplacementError found = estimate.at(step.to);
        compare(step.to, found);
        if (found.total() <= worst.total())
          return;
        if (verdict_on(found.total()) !=
            verdict_on(found.total() - found.second_order))
          {
            if (found.total() <= growth_between_checks * checked &&
                step.to.time < end_time)
              return;
            checked = found.total();
            make_sure(step.to, found);
          }
        if (found.total() <= worst.total())
          return;
        worst = found;
        time  = step.to.time;
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> all;
        const Finding        by_comparison = comparison.finding(),
                      by_estimate          = error_finding(),
                      &worse = by_estimate.verdict >= by_comparison.verdict
          ? by_estimate
          : by_comparison;
        if (worse.verdict != Verdict::sound)
          all.push_back(worse);
        if (loss.evidence != Evidence::none)
          all.push_back(loss.finding());
        return all;
      }

      void serialize(CheckpointArchive &archive) override
      {
        unsigned int evidence = static_cast<unsigned int>(loss.evidence);
        archive.values("watch: small displacements",
                       worst.rotation,
                       worst.second_order,
                       worst.strain,
                       time,
                       checked,
                       loss.time,
                       loss.compression,
                       loss.strut,
                       evidence,
                       comparison.estimate,
                       comparison.error,
                       comparison.time);
        archive.text("watch: small displacements: location of comparison",
                     comparison.location);
        archive.text("watch: small displacements: location", worst.location);
        loss.evidence = static_cast<Evidence>(evidence);
      }

    private:
      using Evidence = LossOfStability::Evidence;

      Finding error_finding() const
      {
        std::ostringstream text;
        text.precision(2);
        text << "Displacements are not small, as Large rotation = off "
                "supposes: at t = "
             << time << " s forces and displacements are wrong by about "
             << percentage_text(worst.total()) << ", by rotations of "
             << worst.rotation
             << " rad, axial forces that change the stiffness by "
             << percentage_text(worst.second_order) << ", and axial strains of "
             << percentage_text(worst.strain) << " (most at " << worst.location
             << "). Set Effects/Large rotation = on, or reduce the load.";
        return {verdict_on(worst.total()), text.str(), time, worst.location};
      }

      /**
       * Puts the effect of axial forces on the whole structure in place of that
       * on the energy of bending and of the buckling of single struts. Where
       * struts carry loads along their axes, bending is slight and axial forces
       * change much of it, but neither displacements nor forces.
       */
      void make_sure(const State &state, SmallDisplacementError &error)
      {
        const std::optional<SecondOrderChange> change =
          second_order.at(state, estimate.forces_by_turning(state));
        work.add_effort(second_order.collect_effort());
        if (!change)
          return;
        error.second_order = std::min(error.second_order, change->relative);
        const Evidence evidence = change->is_unstable.value_or(false)
          ? Evidence::negative_modes
          : !change->is_unstable && error.compression > 1
          ? Evidence::compression
          : Evidence::none;
        if (evidence != Evidence::none && error.compression >= loss.compression)
          loss = {state.time,
                  error.compression,
                  most_compressed_strut(error),
                  evidence};
      }

      /** Compares the motion with the exact one where that may differ by more
       * than is sound, or is not known. */
      void compare(const State &state, const SmallDisplacementError &now)
      {
        const double total     = now.total();
        const bool   has_ended = state.time >= end_time;
        // At the end it is found how large an error is that is too large.
        const bool is_settled =
          verdict_on(has_ended ? total : std::max(total, comparison.error)) ==
          Verdict::not_to_be_used;
        const bool is_known =
          total <= growth_between_comparisons * comparison.estimate &&
          comparison.expected(total) <= doubtful_error;
        const bool has_grown =
          total > growth_between_checks * comparison.estimate ||
          (has_ended && total > comparison.estimate);
        if (total < least_compared || is_settled || is_known || !has_grown)
          return;
        const Equations *const exact = second_order.exact_equations();
        if (exact == nullptr)
          return;
        LargeRotationErrorEstimator estimator(equations,
                                              *exact,
                                              doubtful_error);
        const LargeRotationError    found = estimator.at(state.displacement);
        work.add_effort(estimator.effort());
        comparison.estimate = total;
        // The estimate tells of motions that are too large to be compared.
        const bool is_compared =
          std::isfinite(found.translation) || total <= doubtful_error;
        if (is_compared && found.translation >= comparison.error)
          {
            comparison.error    = found.translation;
            comparison.time     = state.time;
            comparison.location = found.location;
          }
      }

      /** The first one; collective. */
      double most_compressed_strut(const SmallDisplacementError &error) const
      {
        double first = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < error.compressions.size(); ++i)
          if (error.compressions[i] == error.compression)
            first = std::min<double>(first, estimate.struts()[i]);
        return -layout.largest(-first);
      }

      const UnknownLayout            &layout;
      const Equations                &equations;
      const SmallDisplacementEstimate estimate;
      SecondOrderEffect               second_order;
      const double                    end_time; ///< s
      Work                           &work;
      SmallDisplacementError          worst;
      double                          time = 0; ///< s, of it
      LossOfStability                 loss;     ///< under the largest forces
      Comparison                      comparison;
      /** Estimate with which the effect of axial forces was found last. */
      double checked = 0;
    };
  } // namespace

  std::unique_ptr<Watch> make_small_displacement_watch(const WatchedRun &run)
  {
    return std::make_unique<SmallDisplacementWatch>(run);
  }
} // namespace auxfem
