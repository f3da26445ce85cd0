#include <auxfem/output/verdict.h>
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
     * Estimate above which the exact equilibrium is compared.
     * @tuned theory: struts held at both ends, 500 times longer than thick,
     *   are stiffer by some per cent
     */
    constexpr double least_compared = 5e-4;

    /**
     * Growth of the estimate after which the exact equilibrium is compared
     * again.
     * @tuned judgement
     */
    constexpr double growth_between_comparisons = 8;

    Verdict verdict_on(const double error)
    {
      return error > unusable_error ? Verdict::not_to_be_used
        : error > doubtful_error    ? Verdict::doubtful
                                    : Verdict::sound;
    }

    /** Largest excess of a linear scene over its critical load. */
    struct LossOfStability
    {
      double time = 0; ///< s
      /** Largest compressive force over the Euler load of its strut. */
      double compression = 0;
      double strut       = 0; ///< its strut
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

    /**
     * Comparison with the exact equilibrium under the same loads. The estimate
     * alone misses axial forces caused by bending.
     */
    struct Comparison
    {
      double      estimate = 0; ///< at the comparison
      double      error = 0; ///< distance, see LargeRotationError::translation
      double      time  = 0; ///< s
      std::string location;

      /** Error of a motion with another estimate, which is quadratic in it. */
      double expected(const double other) const
      {
        return estimate > 0 ? error * std::pow(other / estimate, 2) : 0;
      }

      Finding finding() const
      {
        std::ostringstream text;
        text << "Displacements are not small, as Large rotation = off "
                "assumes: at t = "
             << time << " s ";
        if (std::isfinite(error))
          text << "the exact equilibrium under the same loads differs by "
               << percentage_text(error)
               << " of the displacements, largest in the " << location;
        else
          text << "no exact equilibrium under the same loads was found nearby";
        text << ". Set Effects/Large rotation = on, or reduce the load.";
        return {std::isfinite(error) ? verdict_on(error) : Verdict::doubtful,
                text.str(),
                time,
                location};
      }
    };

    /** Checks linear scenes for large displacements. */
    class SmallDisplacementWatch : public Watch
    {
    public:
      explicit SmallDisplacementWatch(const WatchContext &run)
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
        SmallDisplacementError current = estimate.at(step.to);
        compare(step.to, current);
        if (current.total() <= largest_error.total())
          return;
        if (verdict_on(current.total()) !=
            verdict_on(current.total() - current.second_order))
          {
            if (current.total() <= growth_between_checks * last_checked_error &&
                step.to.time < end_time)
              return;
            last_checked_error = current.total();
            refine_second_order(step.to, current);
          }
        if (current.total() <= largest_error.total())
          return;
        largest_error = current;
        time          = step.to.time;
      }

      std::vector<Finding> findings() const override
      {
        std::vector<Finding> all;
        const Finding        compared = comparison.finding(),
                      estimated       = error_finding(),
                      &worse = estimated.verdict >= compared.verdict ? estimated
                                                                     : compared;
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
                       largest_error.rotation,
                       largest_error.second_order,
                       largest_error.strain,
                       time,
                       last_checked_error,
                       loss.time,
                       loss.compression,
                       loss.strut,
                       evidence,
                       comparison.estimate,
                       comparison.error,
                       comparison.time);
        archive.text("watch: small displacements: location of comparison",
                     comparison.location);
        archive.text("watch: small displacements: location",
                     largest_error.location);
        loss.evidence = static_cast<Evidence>(evidence);
      }

    private:
      using Evidence = LossOfStability::Evidence;

      Finding error_finding() const
      {
        std::ostringstream text;
        text.precision(2);
        text << "Displacements are not small, as Large rotation = off "
                "assumes: at t = "
             << time << " s the estimated error of forces and displacements is "
             << percentage_text(largest_error.total()) << ", largest at "
             << largest_error.location << ". Rotations reach "
             << largest_error.rotation
             << " rad, axial forces change the stiffness by "
             << percentage_text(largest_error.second_order)
             << ", and axial strains reach "
             << percentage_text(largest_error.strain)
             << ". Set Effects/Large rotation = on, or reduce the load.";
        return {verdict_on(largest_error.total()),
                text.str(),
                time,
                largest_error.location};
      }

      /**
       * Replaces the effect of axial forces on bending energy and single
       * struts by that on the whole structure. Where struts carry axial loads,
       * axial forces change much of the slight bending, but neither
       * displacements nor forces.
       */
      void refine_second_order(const State            &state,
                               SmallDisplacementError &error)
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

      /**
       * Compares the motion with the exact one if the difference may be
       * notable or is unknown.
       */
      void compare(const State &state, const SmallDisplacementError &now)
      {
        const double total     = now.total();
        const bool   has_ended = state.time >= end_time;
        // At the end the size of an excessive error is determined.
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
        const LargeRotationError    current = estimator.at(state.displacement);
        work.add_effort(estimator.effort());
        comparison.estimate = total;
        // Motions too large for a comparison are left to the estimate.
        const bool is_compared =
          std::isfinite(current.translation) || total <= doubtful_error;
        if (is_compared && current.translation >= comparison.error)
          {
            comparison.error    = current.translation;
            comparison.time     = state.time;
            comparison.location = current.location;
          }
      }

      /** First strut with the largest compression; collective. */
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
      SmallDisplacementError          largest_error;
      double                          time = 0; ///< of the largest error (s)
      LossOfStability                 loss;     ///< under the largest forces
      Comparison                      comparison;
      /** Estimate at the last check of the effect of axial forces. */
      double last_checked_error = 0;
    };
  } // namespace

  std::unique_ptr<Watch> make_small_displacement_watch(const WatchContext &run)
  {
    return std::make_unique<SmallDisplacementWatch>(run);
  }
} // namespace auxfem
