#include <auxfem/analysis/lattice_run.h>
#include <auxfem/parameters/errors.h>

#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/star_scene.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// The catalogue of hard cases: each by several schemes, against a run with
// steps that are many times shorter. Whatever happens, no run may be wrong and
// end as if it were right.

namespace
{
  const std::vector<std::string> tried_schemes = {"newmark",
                                                  "hht",
                                                  "generalized-alpha",
                                                  "esdirk",
                                                  "energy-momentum"};

  /** Beyond, a run is not to be called sound; the phase of vibrations, which no
   * watch looks at, has a part in it. */
  constexpr double wrong = 0.1;

  /** What is seen of a run. */
  struct Course
  {
    bool    is_completed = true;
    Verdict verdict      = Verdict::sound;
    /** Largest error of the energy balance over the largest energy. */
    double        energy_error = 0;
    unsigned long rejected     = 0;
    /** Displacements of all joints, by step of the scene. */
    std::vector<std::vector<double>> motions;
    /** From the middle of the run, and how many motions there were then. */
    std::optional<Records> middle;
    std::size_t            n_motions_before = 0;
  };

  /** Follows a run that may fail. */
  class CourseRecorder : public Recorder
  {
  public:
    /** @param interval steps from one that is recorded to the next
     * @param middle step at which a checkpoint is taken
     * @param former checkpoint that the run goes on from; nullptr: none */
    CourseRecorder(const unsigned int   interval,
                   const unsigned long  middle,
                   const Records *const former,
                   Course              &course)
      : interval(interval)
      , middle(middle)
      , former(former)
      , course(course)
    {}

    const Records *goes_on_from() const override
    {
      return former;
    }

    bool wants_checkpoint() override
    {
      return n_steps == middle && former == nullptr;
    }

    void take(const Records &records) override
    {
      course.middle           = records;
      course.n_motions_before = course.motions.size();
    }

    void begin(const Equations &of_run) override
    {
      equations = &of_run;
    }

    void start(const Solution &solution) override
    {
      at_start = solution.state.energies.balance(0);
      largest  = std::abs(solution.state.energies.total());
    }

    void step(const Solution &solution, const StepReport &) override
    {
      const State &state = solution.state;
      n_steps            = state.step;
      largest            = std::max({largest,
                                     std::abs(state.energies.total()),
                                     std::abs(state.energies.external())});
      error = std::max(error, std::abs(state.energies.balance(at_start)));
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
      std::vector<double> motions;
      for (unsigned int joint = 0;
           joint < equations->model().lattice.joints.size();
           ++joint)
        for (unsigned int c = 0; c < equations->model().lattice.dimension; ++c)
          if (const int i = numbering.joint_unknown(joint, c); i >= 0)
            motions.push_back(state.displacement[i]);
      return motions;
    }

    const unsigned int   interval;
    const unsigned long  middle;
    const Records *const former;
    Course              &course;
    unsigned long        n_steps   = 0;
    const Equations     *equations = nullptr;
    double               at_start = 0, largest = 0, error = 0;
  };

  Course course_of(const std::string              &prm,
                   const std::vector<std::string> &overrides,
                   const unsigned int              interval = 1,
                   const Records *const            former   = nullptr)
  {
    const Scene    scene = read_scene_from_text(prm, "test.prm", overrides);
    Course         course;
    CourseRecorder recorder(interval, scene.time.n_steps() / 2, former, course);
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
    const auto n = std::min(course.motions.size(), reference.motions.size());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < course.motions[i].size(); ++j)
        {
          largest = std::max(largest, std::abs(reference.motions[i][j]));
          apart =
            std::max(apart,
                     std::abs(course.motions[i][j] - reference.motions[i][j]));
        }
    return apart / largest;
  }

  /** What became of a run of which no more than a checkpoint was left, beside
   * @p whole. */
  std::string words_on_resumed(const Course &whole, const Course &resumed)
  {
    if (!whole.middle)
      return "ended before";
    const bool is_equal = whole.is_completed == resumed.is_completed &&
      whole.verdict == resumed.verdict && whole.rejected == resumed.rejected &&
      whole.motions.size() == whole.n_motions_before + resumed.motions.size() &&
      std::equal(resumed.motions.begin(),
                 resumed.motions.end(),
                 whole.motions.begin() + whole.n_motions_before);
    return is_equal ? "equal" : "differs";
  }

  /** Up to the next power of ten: what is below is not the same everywhere. */
  std::string magnitude(const double value)
  {
    if (value > wrong)
      return "> 10 %";
    const int power = std::max(-9., std::ceil(std::log10(value)));
    return value > 0 ? "< 1e" + std::to_string(power) : "0";
  }

  struct HardCase
  {
    std::string              title;
    std::string              prm;
    std::vector<std::string> overrides;
    double                   step; ///< s
    /** Reference: esdirk with steps this much shorter. */
    unsigned int refinement = 4;
  };

  std::vector<std::string> with(std::vector<std::string> overrides,
                                const std::string       &scheme,
                                const double             step)
  {
    overrides.push_back("Time/Scheme=" + scheme);
    overrides.push_back("Time/Time step=" + text(step));
    return overrides;
  }

  /** Returns the reference. */
  Course go_through(const HardCase &hard)
  {
    const Course reference =
      course_of(hard.prm,
                with(hard.overrides, "esdirk", hard.step / hard.refinement),
                hard.refinement);
    ResultTable table(hard.title,
                      {"scheme",
                       "ends",
                       "rejected steps",
                       "energy error",
                       "error",
                       "verdict",
                       "resumed"});
    for (const std::string &scheme : tried_schemes)
      {
        const auto        settings = with(hard.overrides, scheme, hard.step);
        const Course      course   = course_of(hard.prm, settings);
        const std::string resumed =
          words_on_resumed(course,
                           course_of(hard.prm,
                                     settings,
                                     1,
                                     course.middle ? &*course.middle
                                                   : nullptr));
        EXPECT_EQ(resumed, "equal") << hard.title << ' ' << scheme;
        const double error = difference(course, reference);
        for (const auto &motions : course.motions)
          for (const double motion : motions)
            EXPECT_TRUE(std::isfinite(motion)) << hard.title << ' ' << scheme;
        // The user's wish: not wrong and as if it were right.
        if (course.is_completed && course.verdict == Verdict::sound)
          {
            EXPECT_LE(course.energy_error, 0.05) << hard.title << ' ' << scheme;
            if (reference.is_completed && reference.verdict == Verdict::sound)
              {
                EXPECT_LE(error, wrong) << hard.title << ' ' << scheme;
              }
          }
        if (scheme == "energy-momentum")
          {
            EXPECT_LE(course.energy_error, 1e-6) << hard.title;
          }
        table.row({scheme,
                   course.is_completed ? "yes" : "with an error",
                   course.rejected > 0 ? "some" : "0",
                   magnitude(course.energy_error),
                   magnitude(error),
                   name_of(course.verdict),
                   resumed});
      }
    return reference;
  }

  /** 2 x 2 stars for 20 ms under @p load (N) a joint. */
  HardCase star_case(const std::string              &title,
                     const double                    load,
                     const std::vector<std::string> &overrides = {},
                     const double                    step      = 20e-6)
  {
    // What collapses goes on through itself, which is harder yet.
    return {title,
            star_scene(),
            star_size(2, load) + overrides +
              std::vector<std::string>{"Effects/Contact=off"},
            step};
  }

  std::vector<std::string> law(const std::string &parameter, const double value)
  {
    return {"Connectors/damper/" + parameter + "=" + text(value)};
  }

  /** A bar of two struts that turns about z and a little about the others. */
  HardCase spinning_bar()
  {
    SceneText scene;
    scene.dimension(3)
      .frame("-0.5 0 0; 0 0 0; 0.5 0.1 0", "0 1; 1 2")
      .circle("rod", 0.02, {1e9, 1000, 0.3})
      .set("Initial velocities/spin/Joints", "all")
      .set("Initial velocities/spin/Angular velocity x", 1)
      .set("Initial velocities/spin/Angular velocity y", 2)
      .set("Initial velocities/spin/Angular velocity z", 60)
      .mesh(2)
      .time(10.5, 0.75e-3, "newmark");
    return {"A hundred revolutions in space", scene.str(), {}, 0.75e-3, 2};
  }

  /** A rod between a clamp and an end that turns about its axis and moves along
   * it, pushed a little to a side. EI = 1.2566e-2 N m2, L = 1 m. */
  HardCase twisted_shaft()
  {
    SceneText scene;
    scene.dimension(3)
      .frame("0 0 0; 0.5 0 0; 1 0 0", "0 1; 1 2")
      .circle("rod", 0.002, {1e9, 1000, 0.3})
      .support("clamp", "0", "clamp")
      .prescribe("bearing", "2", {"free", "0", "0"}, {"free", "0", "0"})
      .load("torque", "2", {"0", "0", "0"}, {"0.11293 * t / 2", "0", "0"})
      .load("push", "1", {"0", "1e-4", "0"}, {"0", "0", "0"})
      .mesh(3, 1)
      .time(2.4, 5e-3, "newmark");
    return {"A shaft twisted a fifth beyond Greenhill's torque",
            scene.str(),
            {},
            5e-3,
            4};
  }
  /** Largest motion in the last third over that in the first. */
  double growth(const Course &course)
  {
    const std::size_t n     = course.motions.size();
    double            first = 0, last = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (const double motion : course.motions[i])
        if (i < n / 3)
          first = std::max(first, std::abs(motion));
        else if (i >= n - n / 3)
          last = std::max(last, std::abs(motion));
    return last / first;
  }

  /** Beck's column, L = EI = 1 and 1 kg, of a strut and a @p part of its flutter
   * load, that a push at the start sets swinging, for some periods. */
  HardCase becks_column(const std::string &title, const double part)
  {
    SceneText scene;
    scene.frame("0 0; 0 1", "0 1")
      .section({1e5, 1e5, 1})
      .set("Sections/section 0/Density", 1e-5)
      .support("clamp", "0", "clamp")
      .load("turning", "1", {"0", text(-20.0509 * part), "0"})
      .set("Loads/turning/Direction", "follows the joint")
      .load("push", "1", {"0.01 * sin(2 * pi * min(t, 0.5))", "0", "0"})
      .mesh(4, 1)
      .time(3, 5e-3, "newmark")
      .set("Time/Start from", "static equilibrium");
    return {title, scene.str(), {}, 5e-3};
  }
} // namespace

TEST(Stability, TenTimesTheLoad)
{
  go_through(star_case("Ten times the load", 10));
}

TEST(Stability, CollapseWithImperfections)
{
  go_through(star_case("Twice the buckling load, imperfections of 10 um",
                       2.6,
                       {"Imperfections/rough/Type=random",
                        "Imperfections/rough/Standard deviation=10 um",
                        "Time/End time=40 ms"}));
}

TEST(Stability, TwentyTimesTheStep)
{
  go_through(star_case("Twenty times the step", 1, {}, 400e-6));
}

TEST(Stability, LoadsThatJumpAndStrike)
{
  go_through(star_case("A load that jumps",
                       0.5,
                       {"Loads/pressure/Force y=-F0 + 0 * t0"}));
  go_through(star_case("A strike: the top at 3 m/s",
                       0,
                       {"Initial velocities/strike/Joints=top",
                        "Initial velocities/strike/Velocity y=-3"}));
}

TEST(Stability, MotionsWithKinks)
{
  go_through(
    star_case("A foot that moves to and fro with kinks",
              0,
              {"Supports/foundation/Type=prescribed",
               "Supports/foundation/Displacement x=1e-3 * abs(t / 5e-3 - 2 * "
               "floor(t / 10e-3 + 0.5))",
               "Supports/foundation/Displacement y=0",
               "Supports/foundation/Rotation z=0"}));
}

TEST(Stability, ConnectorsOfAnyStiffness)
{
  for (const double factor : {1e-6, 1e6})
    {
      go_through(star_case(factor < 1 ? "Springs of a millionth"
                                      : "Springs a million times as stiff",
                           1,
                           law("Spring stiffness", 200 * factor)));
      go_through(star_case(factor < 1 ? "Dashpots of a millionth"
                                      : "Dashpots a million times as strong",
                           1,
                           law("Damping coefficient", 0.05 * factor)));
    }
}

TEST(Stability, MaxwellElementsOfAnyRelaxationTime)
{
  for (const double relaxation_time : {20., 20e-12})
    go_through(
      star_case(relaxation_time > 1 ? "Maxwell elements, dt / tau = 1e-6"
                                    : "Maxwell elements, dt / tau = 1e6",
                1,
                std::vector<std::string>{"Connectors/damper/Law=maxwell"} +
                  law("Damping coefficient", 200 * relaxation_time)));
}

TEST(Stability, SlenderStruts)
{
  go_through(
    {"Slenderness 1e5",
     star_scene(),
     star_size(2, 1) +
       std::vector<std::string>{"Constants=F0 = 4e-15, t0 = 40",
                                "Sections/aluminium/Width=0.1 um",
                                "Sections/aluminium/Height=0.1 um",
                                "Connectors/damper/Spring stiffness=8e-13",
                                "Connectors/damper/Damping coefficient=8e-13",
                                "Time/End time=80 s"},
     80e-3});
}

TEST(Stability, StrutsOfUnequalStiffness)
{
  for (const char *soft : {"stubs", "edges"})
    go_through(star_case(std::string("Stiffness ratio 1e8, soft ") + soft,
                         1e-7,
                         {"Sections/soft/Struts=" + std::string(soft),
                          "Sections/soft/Shape=rectangle",
                          "Sections/soft/Width=0.4 mm",
                          "Sections/soft/Height=0.4 mm",
                          "Sections/soft/Young's modulus=700",
                          "Sections/soft/Density=2700",
                          "Connectors/damper/Spring stiffness=2e-6",
                          "Connectors/damper/Damping coefficient=5e-6"}));
}

TEST(Stability, OpeningAnglesAtTheirEnds)
{
  for (const char *angle : {"45.5 deg", "89.5 deg"})
    go_through(star_case(std::string("Opening angle ") + angle,
                         0.5,
                         {std::string("Lattice/Opening angle=") + angle}));
}

TEST(Stability, JointsWithoutMass)
{
  go_through(star_case("Masses on the top alone",
                       0.5,
                       {"Sections/aluminium/Density=0",
                        "Connectors/damper/Law=maxwell",
                        "Masses/top/Joints=top",
                        "Masses/top/Mass=1e-4"}));
}

TEST(Stability, TwistedShaft)
{
  go_through(twisted_shaft());
}

// Below the flutter load the vibration goes on as it began, beyond it grows.
TEST(Stability, BecksColumn)
{
  const Course below = go_through(
                 becks_column("Beck's column, 0.9 of its flutter load", 0.9)),
               beyond = go_through(
                 becks_column("Beck's column, 1.1 of its flutter load", 1.1));
  EXPECT_LT(growth(below), 2);
  EXPECT_GT(growth(beyond), 50);
}

TEST(Stability, ManyRevolutions)
{
  go_through(spinning_bar());
}
