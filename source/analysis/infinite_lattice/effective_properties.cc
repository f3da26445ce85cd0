#include <auxfem/analysis/infinite_lattice/effective_properties.h>
#include <auxfem/analysis/infinite_lattice/property_files.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/mathematics/voigt.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/output/console.h>
#include <auxfem/output/overview.h>
#include <auxfem/time/schemes/static.h>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** Load steps of small strains, one for each component. */
    RunPlan plan_of_unit_strains(const Scene &scene)
    {
      RunPlan plan(scene);
      plan.time.scheme             = std::make_shared<QuasiStatic>();
      plan.time.relative_tolerance = std::nullopt;
      plan.time.static_start       = false;
      plan.time.step               = 1;
      plan.time.end_time   = n_strain_components(scene.context.dimension);
      plan.effects.inertia = Switch::automatic;
      plan.effects.large_rotation = Switch::off;
      plan.effects.contact        = Switch::off;
      return plan;
    }

    /** Sum of forces (N) on the joint of the translation @p d. */
    dealii::Tensor<1, 3> force_on_translation(const LatticeRun  &run,
                                              const unsigned int d)
    {
      const UnknownLayout &layout = run.model.numbering.layout();
      const unsigned int   joint  = run.lattice.joint_of_translation(d);
      std::vector<double>  mine(3, 0.);
      for (unsigned int c = 0; c < run.lattice.dimension; ++c)
        if (const int u = run.model.numbering.joint_unknown(joint, c);
            layout.is_owned(u))
          mine[c] = run.solution.state.residual[u];
      const std::vector<double> sum = layout.sum(mine);
      return dealii::Point<3>(sum[0], sum[1], sum[2]);
    }

    /** Mean stress (Pa) as a vector: forces on translations times these, by
     * volume. */
    std::vector<double> mean_stress(const LatticeRun &run, const double volume)
    {
      const unsigned int   dimension = run.lattice.dimension;
      dealii::Tensor<2, 3> moment;
      for (unsigned int d = 0; d < dimension; ++d)
        moment += dealii::outer_product(force_on_translation(run, d),
                                        run.lattice.periodicity->vectors[d]);
      std::vector<double> stress;
      for (unsigned int i = 0; i < n_strain_components(dimension); ++i)
        {
          const auto [a, b] = axes_of_component(i, dimension);
          stress.push_back((moment[a][b] + moment[b][a]) / 2 / volume);
        }
      return stress;
    }

    EffectiveProperties properties_of(LatticeRun &run)
    {
      const unsigned int dimension = run.lattice.dimension;
      const unsigned int n         = n_strain_components(dimension);
      const MassAndSize  period    = mass_and_size(run.scene, run.lattice);
      const double       depth     = period.depth > 0 ? period.depth : 1;
      const double       volume =
        run.lattice.periodicity->volume() * (dimension == 2 ? depth : 1);
      dealii::FullMatrix<double> stiffness(n, n);
      Recorder                   nobody;
      run.prepare();
      for (unsigned int j = 0; j < n; ++j)
        {
          run.advance(nobody);
          const std::vector<double> stress = mean_stress(run, volume);
          for (unsigned int i = 0; i < n; ++i)
            stiffness(i, j) = stress[i];
        }
      EffectiveProperties found{ElasticConstants(stiffness), {}, {}, depth};
      if (period.has_dimensions)
        found.relative_density = period.strut_volume / volume;
      if (period.mass)
        found.density = *period.mass / volume;
      return found;
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
    RunResult                 result;
    result.exit_state = "completed";
    result.work       = run.work();
    result.findings =
      mesh_findings(run.model.plan, errors, "entries of the stiffness");
    on_first_rank(communicator, [&]() {
      write_effective_properties(found, scene.output.directory);
      report.print(text_of(found));
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
