#include <auxfem/equations/effects/masses.h>
#include <auxfem/equations/make_effects.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/unknown_names.h>
#include <auxfem/parameters/errors.h>

namespace auxfem
{
  namespace
  {
    /** Mass or moment of inertia that acts on a component of motion. */
    double share(const MassDefinition &mass, const unsigned int component)
    {
      return component < first_rotation
        ? mass.mass
        : mass.rotary_inertia[component - first_rotation];
    }

    void refuse_missing_rotation(const MassDefinition &mass,
                                 const DofNumbering   &numbering,
                                 const unsigned int    joint)
    {
      if (mass.rotary_inertia.norm() > 0 &&
          !numbering.joint_has(joint, rotation_z))
        throw InputError(
          mass.path + "/Rotary inertia: " + why_no_rotation(numbering, joint));
    }

    SpaceTensor along_global_axes(const SpaceVector &values)
    {
      SpaceTensor result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c][c] = values[c];
      return result;
    }
  } // namespace

  std::vector<std::unique_ptr<Effect>> make_masses(const LatticeModel &model)
  {
    const Lattice          &lattice   = model.lattice;
    const DofNumbering     &numbering = model.numbering;
    std::vector<PointMass>  points;
    std::vector<RotaryMass> rotary;
    const bool              is_spatial = lattice.dimension == 3;
    for (const MassDefinition &mass : model.plan.scene.masses)
      for (const unsigned int joint :
           joints_of(mass, lattice, model.plan.scene.context))
        {
          refuse_missing_rotation(mass, numbering, joint);
          for (const unsigned int c : numbering.components())
            {
              const int unknown = numbering.joint_unknown(joint, c);
              if (unknown < 0 || share(mass, c) == 0 ||
                  (is_spatial && c >= first_rotation))
                continue;
              points.push_back({unknown, share(mass, c)});
            }
          const int spin = numbering.joint_unknown(joint, rotation_z);
          if (is_spatial && spin >= 0 && mass.rotary_inertia.norm() > 0)
            rotary.push_back({numbering.rotations().with(spin),
                              along_global_axes(mass.rotary_inertia)});
        }
    for (const RotatingBody &body : model.bodies.rotating)
      {
        const RigidPart &part = lattice.rigid_parts[body.part];
        if (part.mass == 0)
          continue;
        for (const int unknown : body.centre)
          points.push_back({unknown, part.mass});
        rotary.push_back(
          {numbering.rotations().with(body.rotation[0]), part.rotary_inertia});
      }
    std::vector<std::unique_ptr<Effect>> effects;
    if (!points.empty())
      effects.push_back(make_point_masses(numbering, std::move(points)));
    if (!rotary.empty())
      effects.push_back(make_rotary_masses(numbering,
                                           model.plan.simulated.large_rotation,
                                           std::move(rotary)));
    return effects;
  }
} // namespace auxfem
