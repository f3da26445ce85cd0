#include <auxfem/analysis/infinite_lattice/effective_properties.h>
#include <auxfem/analysis/infinite_lattice/harmonic_moduli.h>
#include <auxfem/analysis/infinite_lattice/period_tangent.h>
#include <auxfem/analysis/infinite_lattice/property_files.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/mathematics/voigt.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/output/console.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/infinite_lattice.h>
#include <auxfem/time/schemes/static.h>

#include <nlohmann/json.hpp>

namespace auxfem
{
  RunPlan plan_of_unit_strains(const Scene &scene)
  {
    RunPlan plan(scene);
    plan.time.scheme             = std::make_shared<QuasiStatic>();
    plan.time.relative_tolerance = std::nullopt;
    plan.time.static_start       = false;
    plan.time.step               = 1;
    plan.time.end_time           = n_strain_components(scene.context.dimension);
    plan.effects.inertia         = Switch::automatic;
    plan.effects.large_rotation  = Switch::off;
    plan.effects.contact         = Switch::off;
    // Dashpots would resist the change from one strain to the next.
    plan.effects.connector_viscosity = Switch::off;
    plan.effects.strut_damping       = Switch::off;
    plan.effects.strut_relaxation    = Switch::off;
    return plan;
  }

  std::vector<double> mean_stress(const LatticeRun &run)
  {
    std::vector<double> stress;
    for (unsigned int i = 0; i < n_strain_components(run.lattice.dimension);
         ++i)
      stress.push_back(sum_of_owned(symmetric_stress_terms(run.model, i),
                                    run.solution.state.displacement.data()));
    return run.model.numbering.layout().sum(stress);
  }

  EffectiveProperties
  properties_with(const dealii::FullMatrix<double> &stiffness,
                  const LatticeRun                 &run)
  {
    const MassAndSize   period = mass_and_size(run.scene, run.lattice);
    const double        depth  = depth_of_continuum(run.scene);
    const double        volume = run.lattice.periodicity->volume() * depth;
    EffectiveProperties found{ElasticConstants(stiffness), {}, {}, depth};
    found.relative_density = period.relative_density;
    if (period.mass)
      found.density = *period.mass / volume;
    return found;
  }

  namespace
  {
    /** Prepares the run; counts the mechanisms if that finds one. */
    void prepare(LatticeRun &run)
    {
      try
        {
          run.prepare();
        }
      catch (const InputError &error)
        {
          const PeriodTangent tangent(run.equations, run.solution.state);
          unsigned int        n = 0;
          on_first_rank(run.model.numbering.layout().communicator(),
                        [&]() { n = tangent.n_mechanisms(); });
          if (n == 0)
            throw;
          throw InputError(
            "Infinite lattice: it has " + std::to_string(n) + " mechanism" +
            (n == 1 ? "" : "s") +
            ", motions of the joints of a period that no strut resists. Make "
            "joints rigid, or add struts or springs.\n" +
            error.what());
        }
    }

    EffectiveProperties properties_of(LatticeRun &run)
    {
      const unsigned int         n = n_strain_components(run.lattice.dimension);
      dealii::FullMatrix<double> stiffness(n, n);
      Recorder                   nobody;
      prepare(run);
      for (unsigned int j = 0; j < n; ++j)
        {
          run.advance(nobody);
          const std::vector<double> stress = mean_stress(run);
          for (unsigned int i = 0; i < n; ++i)
            stiffness(i, j) = stress[i];
        }
      return properties_with(stiffness, run);
    }

    /** Change of the stiffness with finer elements, over its largest entry:
     * ends of straight struts are exact, arcs and tapered struts are not. */
    MeshErrors errors_of(const LatticeRun          &run,
                         const EffectiveProperties &found,
                         const MPI_Comm             communicator)
    {
      LatticeRun finer(with_finer_elements(run.model.plan), communicator);
      dealii::FullMatrix<double> change =
        properties_of(finer).elastic.stiffness();
      const double largest = change.linfty_norm();
      change.add(-1., found.elastic.stiffness());
      MeshErrors errors;
      errors.relative = {change.linfty_norm() / largest};
      return errors;
    }

    /** Storage and loss moduli at the frequencies of `Frequency response`; none
     * if nothing loses energy. */
    std::vector<HarmonicModuli> moduli_with_damping(const LatticeRun &run,
                                                    const MPI_Comm communicator)
    {
      const Scene  &scene = run.scene;
      const RunPlan plan  = with_damping(plan_of_unit_strains(scene));
      if (!has_damping(decide_effects(plan, run.lattice)))
        return {};
      LatticeRun damped(plan, communicator);
      return harmonic_moduli(damped, scene.frequency_response.frequencies());
    }
  } // namespace

  EffectiveProperties effective_properties(const Scene   &scene,
                                           const MPI_Comm communicator)
  {
    LatticeRun run(plan_of_unit_strains(scene), communicator);
    return properties_of(run);
  }

  RunResult run_effective_properties(const Scene         &scene,
                                     const MPI_Comm       communicator,
                                     const FolderOptions &options)
  {
    // Errors of the scene must not destroy the results of an earlier run.
    LatticeRun                run(plan_of_unit_strains(scene), communicator);
    const EffectiveProperties found = properties_of(run);
    RunReport                 report(scene,
                     run.equations,
                     options.rules,
                     effective_property_contents());
    const MeshErrors          errors = errors_of(run, found, communicator);
    const std::vector<HarmonicModuli> harmonic =
      moduli_with_damping(run, communicator);
    RunResult result;
    result.exit_state = "completed";
    result.work       = run.work();
    result.findings =
      mesh_findings(run.model.plan, errors, "entries of the stiffness");
    on_first_rank(communicator, [&]() {
      write_effective_properties(found, scene.output.directory);
      write_harmonic_moduli(harmonic, scene.output.directory);
      report.print(text_of(found));
      if (!harmonic.empty())
        report.print("  storage and loss moduli by frequency: moduli.csv");
      report.print(mesh_text(run.model.plan, errors));
      report.finish(json_of(found), result.findings);
    });
    return result;
  }

  AnalysisEntry effective_properties_entry()
  {
    return {"effective properties",
            "Stiffness, Poisson's ratios and density of the infinite lattice "
            "that repeats the cells: no supports, no loads.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::effective_properties;
            },
            run_effective_properties,
            nullptr,
            [](const Scene &scene, const MPI_Comm communicator) {
              LatticeRun run(plan_of_unit_strains(scene), communicator);
              run.prepare();
              show_lattice(scene, run.equations);
            },
            effective_property_contents().names()};
  }
} // namespace auxfem
