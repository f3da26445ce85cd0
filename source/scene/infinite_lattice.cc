#include <auxfem/mathematics/voigt.h>
#include <auxfem/scene/infinite_lattice.h>

#include <iomanip>
#include <limits>
#include <sstream>

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
      // Their rotations would not be those of the images.
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

    /** Jump of the displacement over a translation, one strain component after
     * the other. */
    TimeFunction motion_of(const dealii::Tensor<1, 3> &translation,
                           const unsigned int          component,
                           const Scene                &scene)
    {
      const unsigned int dimension = scene.context.dimension;
      std::ostringstream text;
      text << std::setprecision(std::numeric_limits<double>::max_digits10)
           << "0";
      for (unsigned int i = 0; i < n_strain_components(dimension); ++i)
        {
          const auto [a, b]  = axes_of_component(i, dimension);
          const double shear = a == b ? 1. : 0.5;
          double       jump  = 0;
          if (component == a)
            jump += shear * translation[b];
          if (component == b && a != b)
            jump += shear * translation[a];
          if (jump != 0)
            text << " + (" << jump << ") * max(0, 1 - abs(t - " << i + 1
                 << "))";
        }
      SceneContext context = scene.context;
      context.path         = "Analysis";
      return TimeFunction(text.str(), "effective properties", context);
    }
  } // namespace

  std::string name_of_translation(const unsigned int d)
  {
    return "translation " + std::to_string(d + 1);
  }

  void make_infinite(Scene &scene, Mistakes &mistakes)
  {
    refuse_what_is_finite(scene, mistakes);
    scene.lattice.is_infinite = true;
    if (scene.analysis != Analysis::effective_properties)
      return;
    const UnitCell    cell = scene.lattice.cell->build();
    SupportDefinition hold;
    hold.name   = "period";
    hold.joints = "0";
    hold.path   = "Analysis = " + name_of(scene.analysis);
    for (unsigned int c = 0; c < scene.context.dimension; ++c)
      hold.fixed[c] = true;
    std::vector<SupportDefinition> supports = {hold};
    for (unsigned int d = 0; d < scene.context.dimension; ++d)
      {
        SupportDefinition strain = hold;
        strain.name = strain.joints = name_of_translation(d);
        for (unsigned int c = 0; c < scene.context.dimension; ++c)
          strain.motion[c] =
            motion_of(double(scene.lattice.n_cells[d]) * cell.vectors[d],
                      c,
                      scene);
        supports.push_back(strain);
      }
    scene.supports = supports;
  }
} // namespace auxfem
