#include <auxfem/equations/node_masses.h>
#include <auxfem/mesh/sets.h>

#include <deal.II/base/quadrature_lib.h>

namespace auxfem
{
  namespace
  {
    /** Mass of element @p e (kg). */
    double element_mass(const LatticeModel &model, const unsigned int e)
    {
      const StrutInterval &interval = model.numbering.elements()[e].interval;
      const Strut         &strut    = model.lattice.struts[interval.strut];
      return model.sections[strut.section]
               .at(interval.at(0))
               .mass_per_length() *
        model.lattice.length(strut) * (interval.end - interval.begin);
    }

    void add_struts(const Equations &equations, std::vector<NodeMass> &masses)
    {
      const LatticeModel &model     = equations.model();
      const DofNumbering &numbering = model.numbering;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          if (!numbering.elements()[e].is_owned)
            continue;
          const std::vector<double> nodal_masses = node_masses(model, e);
          for (unsigned int a = 0; a < nodal_masses.size(); ++a)
            for (unsigned int c = 0; c < model.lattice.dimension; ++c)
              masses.push_back({numbering.element_unknowns(
                                  e)[numbering.n_components() * a + c],
                                nodal_masses[a]});
        }
    }

    void add_point_masses(const LatticeModel    &model,
                          std::vector<NodeMass> &masses)
    {
      for (const MassDefinition &mass : model.plan.scene.masses)
        for (const unsigned int joint :
             joints_of(mass, model.lattice, model.plan.scene.context))
          for (unsigned int c = 0; c < model.lattice.dimension; ++c)
            if (const int unknown = model.numbering.joint_unknown(joint, c);
                model.numbering.layout().is_owned(unknown))
              masses.push_back({unknown, mass.mass});
    }

    template <class Bodies>
    void add_natural_bodies(const Bodies          &bodies,
                            const Lattice         &lattice,
                            std::vector<NodeMass> &masses)
    {
      for (const auto &body : bodies)
        if (body.owned)
          for (const int unknown : body.base)
            masses.push_back(
              {unknown, lattice.rigid_parts[body.part].mass / 2});
    }

    void add_rigid_parts(const LatticeModel    &model,
                         std::vector<NodeMass> &masses)
    {
      add_natural_bodies(model.bodies.in_plane, model.lattice, masses);
      add_natural_bodies(model.bodies.bars, model.lattice, masses);
      for (const RotatingBody &body : model.bodies.rotating)
        if (body.owned)
          for (const int unknown : body.centre)
            masses.push_back(
              {unknown, model.lattice.rigid_parts[body.part].mass});
    }
  } // namespace

  std::vector<double> node_masses(const LatticeModel &model,
                                  const unsigned int  e)
  {
    const unsigned int             order = model.numbering.elements()[e].order;
    const double                   mass  = element_mass(model, e);
    const dealii::QGaussLobatto<1> lobatto(order + 1);
    std::vector<double>            masses;
    for (unsigned int a = 0; a <= order; ++a)
      masses.push_back(mass * lobatto.weight(position_along(a, order)));
    return masses;
  }

  std::vector<NodeMass> all_masses(const Equations &equations)
  {
    std::vector<NodeMass> masses;
    add_struts(equations, masses);
    add_point_masses(equations.model(), masses);
    add_rigid_parts(equations.model(), masses);
    return masses;
  }

  double total_mass(const Equations &equations)
  {
    const LatticeModel   &model = equations.model();
    std::vector<NodeMass> component_masses;
    add_point_masses(model, component_masses);
    add_rigid_parts(model, component_masses);
    double mine = 0;
    for (const NodeMass &node : component_masses)
      mine += node.mass / model.lattice.dimension;
    for (unsigned int e = 0; e < model.numbering.elements().size(); ++e)
      if (model.numbering.elements()[e].is_owned)
        mine += element_mass(model, e);
    double mass = model.numbering.layout().sum(mine);
    for (const PlateDefinition &plate : model.plan.scene.plates)
      if (plate.mass)
        mass += plate.mass->mass;
    return mass;
  }
} // namespace auxfem
