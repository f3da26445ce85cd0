#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/parameters/errors.h>

#include <support/scene_text.h>
#include <verification/hard_case.h>
#include <verification/result_table.h>
#include <verification/space_momenta.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <verification/momenta.h>

namespace auxfem
{
  namespace testing_support
  {
    namespace
    {
      const std::vector<std::string> tried_schemes = {"newmark",
                                                      "hht",
                                                      "generalized-alpha",
                                                      "esdirk",
                                                      "energy-momentum"};

      /** Largest error of a sound run. It includes the phase error of
       * vibrations, which no watch checks. */
      constexpr double wrong = 0.1;

      /** Measures the momenta of @p state, which must stay where it is; those
       * in the plane lie in it and across it. */
      std::function<SpaceMomenta()> momenta_of(const Equations &equations,
                                               const State     &state)
      {
        if (equations.model().lattice.dimension == 3)
          return
            [meter = std::make_shared<SpaceMomentumMeter>(equations, state)] {
              return (*meter)();
            };
        return [meter = std::make_shared<MomentumMeter>(equations, state)] {
          const Momenta momenta = (*meter)();
          return SpaceMomenta{vector(momenta.x, momenta.y, 0),
                              vector(0, 0, momenta.moment)};
        };
      }

      /** Follows the momenta of a body that nothing acts on. */
      class MomentumError
      {
      public:
        MomentumError(const Equations &equations, const State &state)
          : now(momenta_of(equations, state))
          , at_start(now())
        {}

        /** Largest change of either over its amount at the start. */
        double operator()() const
        {
          const SpaceMomenta momenta = now();
          return std::max(change(momenta.linear, at_start.linear),
                          change(momenta.angular, at_start.angular));
        }

      private:
        static double change(const SpaceVector &momentum,
                             const SpaceVector &start)
        {
          return (momentum - start).norm() / start.norm();
        }

        std::function<SpaceMomenta()> now;
        SpaceMomenta                  at_start;
      };

      /** Follows a run that may fail. */
      class CourseRecorder : public Recorder
      {
      public:
        /** @param interval steps from one that is recorded to the next
         * @param checkpoint_step until which the last checkpoint is kept
         * @param former checkpoint that the run goes on from; nullptr: none */
        CourseRecorder(const unsigned int          interval,
                       const unsigned long         checkpoint_step,
                       const bool                  is_free,
                       const CheckpointData *const former,
                       Course                     &course)
          : interval(interval)
          , checkpoint_step(checkpoint_step)
          , is_free(is_free)
          , former(former)
          , course(course)
        {}

        const CheckpointData *restart_checkpoint() const override
        {
          return former;
        }

        void store_checkpoint(CheckpointData records) override
        {
          if (n_steps > checkpoint_step || former != nullptr)
            return;
          course.checkpoint       = std::move(records);
          course.n_motions_before = course.motions.size();
        }

        void begin(const Equations &run_equations) override
        {
          equations = &run_equations;
        }

        void start(const Solution &solution) override
        {
          at_start = solution.state.energies.balance(0);
          largest  = std::abs(solution.state.energies.total());
          if (is_free)
            momentum_error.emplace(*equations, solution.state);
        }

        void step(const Solution &solution, const StepReport &) override
        {
          const State &state = solution.state;
          n_steps            = state.step;
          largest            = std::max({largest,
                                         std::abs(state.energies.total()),
                                         std::abs(state.energies.external())});
          error = std::max(error, std::abs(state.energies.balance(at_start)));
          if (momentum_error)
            course.momentum_error =
              std::max(course.momentum_error, (*momentum_error)());
          if (state.step % interval == 0)
            course.motions.push_back(motions_of(state));
        }

        void finish(const Solution &, const RunResult &result) override
        {
          course.is_completed = result.completed();
          course.verdict      = verdict_of(result.findings);
          course.rejected     = result.work.retries;
          course.energy_error = largest > 0 ? error / largest : 0;
        }

      private:
        std::vector<double> motions_of(const State &state) const
        {
          const DofNumbering &numbering = equations->model().numbering;
          const Lattice      &lattice   = equations->model().lattice;
          std::vector<double> motions;
          for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
            for (unsigned int c = 0; c < lattice.dimension; ++c)
              if (const int i = numbering.joint_unknown(joint, c); i >= 0)
                motions.push_back(state.displacement[i]);
          return motions;
        }

        const unsigned int           interval;
        const unsigned long          checkpoint_step;
        const bool                   is_free;
        const CheckpointData *const  former;
        Course                      &course;
        unsigned long                n_steps   = 0;
        const Equations             *equations = nullptr;
        double                       at_start = 0, largest = 0, error = 0;
        std::optional<MomentumError> momentum_error;
      };

      Course course_of(const HardCase             &hard,
                       const std::string          &scheme,
                       const unsigned int          refinement = 1,
                       const CheckpointData *const former     = nullptr)
      {
        std::vector<std::string> overrides = hard.overrides;
        overrides.push_back("Time/Scheme=" + scheme);
        Scene scene = read_scene_from_text(hard.prm, "test.prm", overrides);
        scene.time.step /= refinement;
        Course         course;
        CourseRecorder recorder(refinement,
                                std::lround(hard.part_before_checkpoint *
                                            scene.time.n_steps()),
                                hard.is_free,
                                former,
                                course);
        LatticeRun     run(scene, MPI_COMM_SELF);
        try
          {
            run.run(recorder);
          }
        catch (const ComputationError &)
          {}
        return course;
      }

      /** Largest difference over time and joints, over the largest motion. */
      double difference(const Course &course, const Course &reference)
      {
        double     largest = 0, apart = 0;
        const auto n =
          std::min(course.motions.size(), reference.motions.size());
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 0; j < course.motions[i].size(); ++j)
            {
              const double motion = course.motions[i][j],
                           exact  = reference.motions[i][j];
              largest             = std::max(largest, std::abs(exact));
              apart               = std::max(apart, std::abs(motion - exact));
            }
        return apart / largest;
      }

      /** Resumes the run @p whole of @p hard from its checkpoint and describes
       * the difference. */
      std::string words_on_resumed(const HardCase    &hard,
                                   const std::string &scheme,
                                   const Course      &whole)
      {
        if (!whole.checkpoint)
          return "ended before";
        const Course resumed  = course_of(hard, scheme, 1, &*whole.checkpoint);
        const bool   is_equal = whole.is_completed == resumed.is_completed &&
          whole.verdict == resumed.verdict &&
          whole.rejected == resumed.rejected &&
          whole.motions.size() ==
            whole.n_motions_before + resumed.motions.size() &&
          std::equal(resumed.motions.begin(),
                     resumed.motions.end(),
                     whole.motions.begin() + whole.n_motions_before);
        EXPECT_TRUE(is_equal);
        return is_equal ? "equal" : "differs";
      }

      /** Up to the next power of ten: what is below is not the same everywhere.
       */
      std::string magnitude(const double value)
      {
        if (value > wrong)
          return "> 10 %";
        const int power = std::max(-9., std::ceil(std::log10(value)));
        return value > 0 ? "< 1e" + std::to_string(power) : "0";
      }

      bool is_called_sound(const Course &course)
      {
        return course.is_completed && course.verdict == Verdict::sound;
      }

      void expect_what_must_hold(const Course      &course,
                                 const std::string &scheme)
      {
        for (const auto &motions : course.motions)
          for (const double motion : motions)
            EXPECT_TRUE(std::isfinite(motion));
        // The user's wish: not wrong and as if it were right.
        if (is_called_sound(course))
          {
            EXPECT_LE(course.energy_error, 0.05);
          }
        if (scheme == "energy-momentum")
          {
            EXPECT_LE(course.energy_error, 1e-6);
            EXPECT_LE(course.momentum_error, 1e-6);
          }
      }

      std::vector<std::string> columns(const HardCase &hard,
                                       const bool      has_reference)
      {
        std::vector<std::string> names = {"scheme",
                                          "ends",
                                          "rejected steps",
                                          "energy error"};
        if (hard.is_free)
          names.push_back("momentum error");
        if (has_reference)
          names.push_back("error");
        names.insert(names.end(), {"verdict", "resumed"});
        return names;
      }

      std::vector<std::string> cells(const HardCase             &hard,
                                     const std::string          &scheme,
                                     const Course               &course,
                                     const std::optional<double> error,
                                     const std::string          &resumed)
      {
        std::vector<std::string> words = {scheme,
                                          course.is_completed ? "yes"
                                                              : "with an error",
                                          course.rejected > 0 ? "some" : "0",
                                          magnitude(course.energy_error)};
        if (hard.is_free)
          words.push_back(magnitude(course.momentum_error));
        if (error)
          words.push_back(magnitude(*error));
        words.insert(words.end(), {name_of(course.verdict), resumed});
        return words;
      }

      /** A row by every scheme. */
      void tabulate(const HardCase &hard, const Course *const reference)
      {
        ResultTable table(hard.title, columns(hard, reference != nullptr));
        for (const std::string &scheme : tried_schemes)
          {
            SCOPED_TRACE(hard.title + ", " + scheme);
            const Course          course = course_of(hard, scheme);
            std::optional<double> error;
            if (reference)
              error = difference(course, *reference);
            const std::string resumed = words_on_resumed(hard, scheme, course);
            expect_what_must_hold(course, scheme);
            if (error && is_called_sound(course) && is_called_sound(*reference))
              {
                EXPECT_LE(*error, wrong);
              }
            table.row(cells(hard, scheme, course, error, resumed));
          }
      }
    } // namespace

    Course go_through(const HardCase &hard)
    {
      const Course reference = course_of(hard, "esdirk", hard.refinement);
      tabulate(hard, &reference);
      return reference;
    }

    void go_on_for_long(const HardCase &hard)
    {
      tabulate(hard, nullptr);
    }
  } // namespace testing_support
} // namespace auxfem
