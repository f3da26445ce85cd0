#include <auxfem/output/run_output.h>
#include <auxfem/state/step_report.h>

#include <deal.II/base/mpi.h>

#include <support/scene_run.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

// Times the star lattice of prm/star-10x10.prm in several sizes, orders and
// Newton variants: time by phase and microseconds per unknown and iteration.
// Without arguments all cases; with a number, that many repetitions of each,
// of which the fastest is shown.
namespace
{
  using namespace auxfem;

  struct Case
  {
    unsigned int cells, order;
    std::string  factorization;
    std::string  force;
  };

  struct Measurement
  {
    double        cpu_seconds = 0;
    PhaseTimes    phases;
    unsigned long iterations = 0, factorizations = 0, unknowns = 0;
    double        displacement = 0;
  };

  /** Takes the time of what an output writes within steps. */
  struct TimedBetween : public Recorder
  {
    TimedBetween(Recorder &output, double &seconds)
      : output(output)
      , seconds(seconds)
    {}

    std::optional<double> next_time(const double time) const override
    {
      return output.next_time(time);
    }

    void row(const Solution &solution) override
    {
      const Stopwatch watch(seconds);
      output.row(solution);
    }

    Recorder &output;
    double   &seconds;
  };

  Measurement measure(const std::string &prm, const Case &c)
  {
    const std::string         cells = std::to_string(c.cells);
    testing_support::SceneRun run(prm,
                                  {"Lattice/Cells x=" + cells,
                                   "Lattice/Cells y=" + cells,
                                   "Discretization/Order=" +
                                     std::to_string(c.order),
                                   "Newton/Factorization=" + c.factorization,
                                   "Constants=F0 = " + c.force + ", t0 = 10e-3",
                                   "Probes/top=top",
                                   "Output/Directory=output/benchmark"});
    Measurement               result;

    // The console of a run would interrupt the table.
    std::cout.setstate(std::ios::failbit);
    const std::unique_ptr<Recorder> output =
      make_run_output(run.scene, MPI_COMM_WORLD);
    double     output_seconds = 0;
    const auto timed          = [&](const auto &action) {
      const Stopwatch watch(output_seconds);
      action();
    };
    TimedBetween    between(*output, output_seconds);
    const Solution &solution = run.computation.solution;
    const Work      at_start = run.work();
    timed([&] {
      output->begin(run.equations);
      output->start(solution);
    });
    while (run.state.step < run.scene.time.n_steps())
      {
        const double     start  = cpu_seconds() - output_seconds;
        const StepReport report = run.computation.advance(between);
        result.cpu_seconds += cpu_seconds() - output_seconds - start;
        timed([&] { output->step(solution, report); });
      }
    std::cout.clear();

    const Work &work      = run.work();
    result.iterations     = work.iterations - at_start.iterations;
    result.factorizations = work.factorizations - at_start.factorizations;
    result.phases         = work.wall;
    result.phases.output  = output_seconds;
    result.unknowns       = run.model.numbering.unknowns().n_free();
    const std::vector<unsigned int> &top = run.lattice.joint_sets.at("top");
    result.displacement                  = run.motion(top[c.cells / 2], 1);
    return result;
  }

  void print(const Case &c, const Measurement &m)
  {
    std::printf(
      "%2ux%-3u %4s %5u  %-16s %7lu %8.3f %8.3f %8.3f %8.3f %8.3f %8.3f "
      "%6lu %6lu %7.3f %15.9f\n",
      c.cells,
      c.cells,
      c.force.c_str(),
      c.order,
      c.factorization.c_str(),
      m.unknowns,
      m.cpu_seconds,
      m.phases.residual,
      m.phases.tangent,
      m.phases.factorize,
      m.phases.solve,
      m.phases.output,
      m.iterations,
      m.factorizations,
      1e6 * m.cpu_seconds / m.iterations / m.unknowns,
      m.displacement);
  }
} // namespace

int main(int argc, char *argv[])
{
  const int repetitions = argc > 1 ? std::stoi(argv[1]) : 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ifstream     file(AUXFEM_PRM_DIRECTORY "/star-10x10.prm");
  std::stringstream prm;
  prm << file.rdbuf();

  std::printf(
    "cells    F0 order  factorization     unknowns    CPU s "
    "residual  tangent   factor    solve   output  iter.  fact. us/u/it "
    "  u_y at the end\n");
  for (const Case &c : {Case{4, 2, "kept", "1.0"},
                        Case{4, 3, "kept", "1.0"},
                        Case{4, 4, "kept", "1.0"},
                        Case{4, 4, "every iteration", "1.0"},
                        Case{10, 2, "kept", "1.0"},
                        Case{10, 3, "kept", "1.0"},
                        Case{10, 4, "kept", "1.0"},
                        Case{10, 2, "every iteration", "1.0"}})
    {
      Measurement best;
      for (int i = 0; i < repetitions; ++i)
        {
          const Measurement m = measure(prm.str(), c);
          if (i == 0 || m.cpu_seconds < best.cpu_seconds)
            best = m;
        }
      print(c, best);
    }
}
