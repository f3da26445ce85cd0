#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/frequency_response.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/history.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/run_output.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iomanip>
#include <limits>
#include <memory>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void throw_no_vibration(const double       omega,
                                         const std::string &why)
    {
      std::ostringstream message;
      message << "No steady vibration was found at "
              << omega / (2 * dealii::numbers::PI) << " Hz: " << why
              << ". An undamped lattice has no steady vibration at a natural "
                 "frequency.";
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
    , load_derivative(
        solver.equations().load_derivative(stiffness.evaluation()))
  {
    loads.resize(layout.n_owned());
    if (layout.largest(largest_size(loads)) == 0)
      throw InputError(
        "Analysis = frequency response: no load and no prescribed motion acts "
        "at Frequency response/Time of the loads. Set it to a time at which a "
        "load acts. About a static equilibrium, amplitudes are differences "
        "from t = 0, so constant loads do not count.");
  }

  HarmonicVibration HarmonicResponse::at(const double omega)
  {
    stiffness.set({0., omega});
    if (!stiffness.factorize())
      throw_no_vibration(omega, solver.last_failure());
    const unsigned int  n = layout.n_owned();
    std::vector<double> b(2 * n, 0.), x(2 * n, 0.);
    std::copy(loads.begin(), loads.end(), b.begin());
    if (const std::string why = stiffness.solve(b, x); !why.empty())
      throw_no_vibration(omega, why);

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
    Vector &real            = vibration.reaction.real,
           &other           = vibration.reaction.imaginary;
    std::tie(real, other)   = stiffness.forces(vibration.displacement.real,
                                             vibration.displacement.imaginary);
    double squared_residual = 0, squared_norm = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (space.is_prescribed(i))
        {
          squared_norm += real[i] * real[i] + other[i] * other[i];
          // Loads at a support go to it directly.
          real[i] += load_derivative[i];
        }
      else
        {
          squared_residual +=
            std::pow(real[i] - loads[i], 2) + other[i] * other[i];
          squared_norm += loads[i] * loads[i];
          real[i] = other[i] = 0;
        }
    vibration.residual =
      std::sqrt(layout.sum(squared_residual) / layout.sum(squared_norm));
    return vibration;
  }

  namespace
  {
    const std::string table_name = "frequency_response.csv";

    std::vector<Column> columns_of(const std::vector<Column> &quantities)
    {
      std::vector<Column> columns = {
        {"frequency", "Hz", "frequency of the loads"}};
      for (const Column &quantity : quantities)
        {
          columns.push_back({quantity.name + ".amplitude",
                             quantity.unit,
                             quantity.meaning + ", amplitude"});
          columns.push_back(
            {quantity.name + ".phase", "rad", "phase lead over the loads"});
        }
      columns.push_back(
        {"residual", "1", "relative residual of the equations of motion"});
      return columns;
    }

    using Rows = std::vector<std::vector<double>>;

    /** Largest amplitudes, by quantity. */
    class Peaks
    {
    public:
      /** @param rows of the table */
      Peaks(const std::vector<Column> &quantities, const Rows &rows)
        : quantities(quantities)
      {
        for (unsigned int i = 0; i < quantities.size(); ++i)
          peak_rows.push_back(
            std::max_element(rows.begin(),
                             rows.end(),
                             [i](const auto &one, const auto &other) {
                               return one[1 + 2 * i] < other[1 + 2 * i];
                             }) -
            rows.begin());
        for (unsigned int i = 0; i < quantities.size(); ++i)
          {
            amplitudes.push_back(rows[peak_rows[i]][1 + 2 * i]);
            frequencies.push_back(rows[peak_rows[i]][0]);
          }
      }

      /** Row of each largest amplitude. */
      const std::vector<std::size_t> &rows() const
      {
        return peak_rows;
      }

      double amplitude(const unsigned int quantity) const
      {
        return amplitudes[quantity];
      }

      /**
       * Whether an amplitude exceeds the round-off of the largest of its
       * kind: displacements and rotations, or forces and moments.
       * @param length converts rotations and moments (m)
       */
      bool is_significant(const unsigned int quantity,
                          const double       length) const
      {
        constexpr double round_off = 1e-6;
        double           others    = 0;
        for (unsigned int i = 0; i < quantities.size(); ++i)
          if (is_motion(i) == is_motion(quantity))
            others = std::max(others, size(i, length));
        return size(quantity, length) > round_off * others;
      }

      std::string text(const MeshErrors &errors) const
      {
        std::ostringstream text;
        text << "  largest amplitudes, errors of the elements";
        for (unsigned int i = 0; i < amplitudes.size(); ++i)
          text << '\n'
               << "  " << std::setw(20) << std::left << quantities[i].name
               << std::right << std::setprecision(5) << std::setw(14)
               << amplitudes[i] << ' ' << quantities[i].unit << " at "
               << frequencies[i] << " Hz, " << std::setprecision(2)
               << error(errors, i);
        return text.str();
      }

      Json json(const MeshErrors &errors) const
      {
        Json peaks = Json::array();
        for (unsigned int i = 0; i < amplitudes.size(); ++i)
          peaks.push_back({{"quantity", quantities[i].name},
                           {"amplitude", amplitudes[i]},
                           {"frequency_hertz", frequencies[i]},
                           {"mesh_error", error(errors, i)}});
        return peaks;
      }

    private:
      bool is_motion(const unsigned int quantity) const
      {
        return quantities[quantity].unit == "m" ||
          quantities[quantity].unit == "rad";
      }

      double size(const unsigned int quantity, const double length) const
      {
        const std::string &unit = quantities[quantity].unit;
        return amplitudes[quantity] *
          (unit == "rad"     ? length
             : unit == "N m" ? 1 / length
                             : 1.);
      }

      static double error(const MeshErrors &errors, const unsigned int quantity)
      {
        return quantity < errors.relative.size()
          ? errors.relative[quantity]
          : std::numeric_limits<double>::quiet_NaN();
      }

      const std::vector<Column> quantities;
      std::vector<std::size_t>  peak_rows;
      std::vector<double>       amplitudes, frequencies;
    };

    std::vector<double> row_at(const double      frequency,
                               HarmonicResponse &response,
                               const History    &history)
    {
      const HarmonicVibration vibration =
        response.at(2 * dealii::numbers::PI * frequency);
      const std::vector<double> real =
        history.sums(vibration.displacement.real, vibration.reaction.real);
      const std::vector<double> imaginary =
        history.sums(vibration.displacement.imaginary,
                     vibration.reaction.imaginary);
      std::vector<double> row = {frequency};
      for (unsigned int i = 0; i < real.size(); ++i)
        {
          row.push_back(std::hypot(real[i], imaginary[i]));
          row.push_back(std::atan2(imaginary[i], real[i]));
        }
      row.push_back(vibration.residual);
      return row;
    }

    /** The response with the elements of a plan. */
    struct ResponseComputation
    {
      /** Sets up the run. Throws InputError for errors of the scene. */
      ResponseComputation(const RunPlan &plan, const MPI_Comm communicator)
        : scene(plan.scene)
        , communicator(communicator)
        , run(plan, communicator)
        , history(scene, run.equations, communicator)
      {
        run.prepare();
        if (plan.time.static_start)
          run.start();
        response.emplace(run.solver(), run.solution.state);
      }

      /** Computes and writes the table, then compares with finer elements. */
      void find_response()
      {
        std::optional<CsvTable> table;
        on_first_rank(communicator, [&]() {
          table.emplace(scene.output.directory + "/" + table_name,
                        columns_of(history.sum_columns()));
        });
        for (const double frequency : scene.frequency_response.frequencies())
          {
            end_if_interrupted(communicator);
            rows.push_back(row_at(frequency, *response, history));
            on_first_rank(communicator, [&]() { table->append(rows.back()); });
          }
        try
          {
            compare();
          }
        catch (const Interrupted &)
          {
            throw;
          }
        catch (const ComputationError &error)
          {
            errors.unknown_reason = error.what();
          }
      }

      const Scene   &scene;
      const MPI_Comm communicator;
      LatticeRun     run;
      const History  history;
      Rows           rows; ///< of the table
      MeshErrors     errors;

    private:
      std::optional<HarmonicResponse> response;

      /**
       * Compares at the largest amplitudes and at frequencies over the whole
       * band.
       */
      void compare()
      {
        constexpr std::size_t     n_samples  = 8;
        const std::vector<Column> quantities = history.sum_columns();
        const Peaks               peaks(quantities, rows);
        std::set<std::size_t>     compared(peaks.rows().begin(),
                                       peaks.rows().end());
        for (std::size_t i = 0; i <= n_samples; ++i)
          compared.insert(i * (rows.size() - 1) / n_samples);
        FinerRun         finer(run);
        HarmonicResponse finer_response(finer.solver(), finer.state());
        const History    finer_history(finer.lattice_run().scene,
                                    finer.lattice_run().equations,
                                    communicator);
        errors.relative.assign(quantities.size(), 0.);
        for (const std::size_t i : compared)
          {
            end_if_interrupted(communicator);
            const std::vector<double> row =
              row_at(rows[i][0], finer_response, finer_history);
            for (unsigned int q = 0; q < quantities.size(); ++q)
              if (peaks.is_significant(q, run.equations.unknowns().length))
                errors.relative[q] =
                  std::max(errors.relative[q],
                           std::abs(std::polar(row[1 + 2 * q], row[2 + 2 * q]) -
                                    std::polar(rows[i][1 + 2 * q],
                                               rows[i][2 + 2 * q])) /
                             peaks.amplitude(q));
          }
      }
    };

    /**
     * Plan at t = 0 without initial velocities and with all damping.
     * If the scene requests it, elements are chosen for the waves of the band.
     */
    RunPlan plan_of_vibrations(const Scene &scene)
    {
      /**
       * Discretization error of undamped waves over the tolerance.
       * @tuned judgement: small damping magnifies errors about ten times
       */
      constexpr double at_resonance = 0.1;
      RunPlan          plan(scene);
      plan.time.static_start      = scene.frequency_response.about_equilibrium;
      plan.has_initial_velocities = false;
      include_damping(plan.effects);
      if (scene.discretization.tolerance)
        choose_elements(phase_at(scene,
                                 2 * dealii::numbers::PI *
                                   scene.frequency_response.highest),
                        at_resonance * *scene.discretization.tolerance,
                        plan);
      return plan;
    }
  } // namespace

  FolderContents frequency_response_contents()
  {
    return {{table_name, "frequency_response.units.csv"}, {}};
  }

  RunResult run_frequency_response(const Scene         &scene,
                                   const MPI_Comm       communicator,
                                   const FolderOptions &options)
  {
    const RunPlan first = plan_of_vibrations(scene);
    // Errors of the scene must not destroy the results of an earlier run.
    auto computation =
      std::make_unique<ResponseComputation>(first, communicator);
    const DeferredSignals     signals;
    RunReport                 report(scene,
                     computation->run.equations,
                     options.rules,
                     frequency_response_contents());
    const std::vector<Column> quantities = computation->history.sum_columns();
    on_first_rank(communicator, [&]() {
      write_column_reference(scene.output.directory +
                               "/frequency_response.units.csv",
                             columns_of(quantities));
    });
    computation->find_response();
    for (RunPlan plan = first; !elements_accepted(scene, computation->errors) &&
         refine_elements(first, computation->errors, plan);)
      {
        const Work before = computation->run.work();
        computation.reset();
        computation = std::make_unique<ResponseComputation>(plan, communicator);
        computation->run.add_effort(before);
        computation->find_response();
      }
    const RunPlan    &plan   = computation->run.model.plan;
    const MeshErrors &errors = computation->errors;
    const Work       &work   = computation->run.work();
    const Peaks       peaks(quantities, computation->rows);

    RunResult result;
    result.exit_state = "completed";
    result.work       = work;
    result.findings   = mesh_findings(plan, errors, "amplitudes");
    on_first_rank(communicator, [&]() {
      report.print(peaks.text(errors));
      report.print(mesh_text(plan, errors));
      std::ostringstream text;
      text << "  " << work.factorizations << " factorizations, "
           << work.linear_solutions << " solutions by " << work.linear_solver;
      report.print(text.str());
      report.finish({{"largest_amplitudes", peaks.json(errors)},
                     {"elements", json_of(plan, errors)}},
                    result.findings);
    });
    return result;
  }

  void check_frequency_response(const Scene &scene, const MPI_Comm communicator)
  {
    LatticeRun run(plan_of_vibrations(scene), communicator);
    require_existing_columns(scene, run.lattice);
    run.prepare();
    show_lattice(scene, run.equations);
  }

  AnalysisEntry frequency_response_entry()
  {
    return {"frequency response",
            "Amplitudes and phases of steady vibrations over frequency.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::frequency_response;
            },
            run_frequency_response,
            nullptr,
            check_frequency_response,
            frequency_response_contents().names()};
  }
} // namespace auxfem
