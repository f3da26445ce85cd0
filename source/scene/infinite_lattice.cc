#include <auxfem/mathematics/voigt.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/scene/infinite_lattice.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Refuses what is placed in a lattice with an end. */
    class Refusals
    {
    public:
      Refusals(const Scene &scene, Mistakes &mistakes)
        : scene(scene)
        , mistakes(mistakes)
      {}

      /** @param list of definitions with a path */
      template <class Definitions>
      void none_of(const Definitions &list)
      {
        if (!list.empty())
          refuse(list.front().path);
      }

      void refuse(const std::string &path)
      {
        mistakes.add(scene.file + ": " + path +
                     ": Analysis = " + name_of(scene.analysis) +
                     " computes an infinite lattice, which has none. Remove "
                     "it, or set Analysis = simulation");
      }

    private:
      const Scene &scene;
      Mistakes    &mistakes;
    };

    void refuse_what_is_finite(const Scene &scene, Mistakes &mistakes)
    {
      Refusals refusals(scene, mistakes);
      refusals.none_of(scene.supports);
      refusals.none_of(scene.joint_loads);
      refusals.none_of(scene.line_loads);
      refusals.none_of(scene.pressures);
      refusals.none_of(scene.initial_strains);
      refusals.none_of(scene.initial_velocities);
      refusals.none_of(scene.constraints);
      refusals.none_of(scene.plates);
      refusals.none_of(scene.imperfections);
      if (!scene.gravity.is_zero())
        refusals.refuse("Gravity");
      if (!scene.base_motion.is_zero())
        refusals.refuse("Base motion");
      if (scene.analysis == Analysis::dispersion)
        refusals.none_of(scene.rigid_parts);
      for (const JointDefinition &joint : scene.joints)
        if (joint.type != JointDefinition::Type::hinge || joint.law)
          refusals.refuse(joint.path);
      for (const ConnectorDefinition &connector : scene.connectors)
        if (connector.between.compare(0, 7, "ground:") == 0)
          refusals.refuse(connector.path);
      const ArrayChanges &changes = scene.lattice.changes;
      if (!changes.region.empty())
        refusals.refuse("Lattice/Region");
      if (!changes.missing_struts.empty())
        refusals.refuse("Lattice/Missing struts");
      for (const std::string &map : changes.map)
        if (!map.empty())
          return refusals.refuse("Lattice/Map");
    }

    /** Translations of the period, from which its size follows. */
    Periodicity period_of(const Scene &scene)
    {
      const UnitCell cell = scene.lattice.cell->build();
      Periodicity    period;
      for (unsigned int d = 0; d < scene.context.dimension; ++d)
        period.vectors.push_back(double(scene.lattice.n_cells[d]) *
                                 cell.vectors[d]);
      return period;
    }

    /** The mean strain of effective properties. */
    MeanDeformation unit_strains(const Scene &scene)
    {
      const unsigned int dimension = scene.context.dimension;
      SceneContext       context   = scene.context;
      context.path                 = "Analysis";
      MeanDeformation mean;
      for (unsigned int i = 0; i < n_strain_components(dimension); ++i)
        {
          const auto [a, b]      = axes_of_component(i, dimension);
          const std::string text = std::string(a == b ? "1" : "0.5") +
            " * max(0, 1 - abs(t - " + std::to_string(i + 1) + "))";
          for (const auto &[k, l] : {std::pair(a, b), std::pair(b, a)})
            mean.components[k][l] =
              {true, TimeFunction(text, "effective properties", context), {}};
        }
      return mean;
    }
  } // namespace

  std::string name_of_axis(const unsigned int d)
  {
    return std::string("mean deformation ") + "xyz"[d];
  }

  double depth_of_continuum(const Scene &scene)
  {
    double depth = 0;
    if (scene.context.dimension == 2)
      for (const SectionDefinition &definition : scene.sections)
        depth = std::max(depth, 2 * definition.section.half_thicknesses[0]);
    return depth > 0 ? depth : 1;
  }

  void make_infinite(Scene &scene, Mistakes &mistakes)
  {
    refuse_what_is_finite(scene, mistakes);
    scene.lattice.is_infinite = true;
    if (scene.analysis == Analysis::effective_response &&
        !scene.mean_deformation.is_given())
      mistakes.add(scene.file +
                   ": Analysis = effective response, but nothing deforms the "
                   "lattice. Give Mean deformation/Strain xx = -0.1 * t or "
                   "another component");
  }

  void prescribe_mean_deformation(Scene &scene)
  {
    const unsigned int dimension = scene.context.dimension;
    SupportDefinition  hold;
    hold.name   = "period";
    hold.joints = "0";
    hold.path   = "Mean deformation";
    for (unsigned int c = 0; c < dimension; ++c)
      hold.fixed[c] = true;
    scene.supports = {hold};

    const MeanDeformation mean =
      scene.analysis == Analysis::effective_properties ? unit_strains(scene)
                                                       : scene.mean_deformation;
    const Periodicity period = period_of(scene);
    const double      length = period.length(),
                 area = period.volume() * depth_of_continuum(scene) / length;
    for (unsigned int d = 0; d < dimension; ++d)
      {
        SupportDefinition strain;
        strain.name = strain.joints = name_of_axis(d);
        strain.path                 = hold.path;
        JointLoadDefinition stress;
        stress.name = stress.joints = strain.name;
        stress.path                 = hold.path;
        for (unsigned int c = 0; c < dimension; ++c)
          {
            const MeanDeformation::Component &component = mean.component(c, d);
            strain.fixed[c]      = component.is_strain_given;
            strain.motion[c]     = component.strain.scaled(length);
            stress.components[c] = component.stress.scaled(area);
          }
        if (strain.fixed != decltype(strain.fixed)())
          scene.supports.push_back(strain);
        if (!stress.is_zero())
          scene.joint_loads.push_back(stress);
      }
  }
} // namespace auxfem
