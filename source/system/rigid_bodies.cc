#include <auxfem/system/rigid_bodies.h>

namespace auxfem
{
  NaturalPlace place_in(const RigidPart        &part,
                        const Lattice          &lattice,
                        const dealii::Point<3> &point)
  {
    return natural_place(lattice.joints[part.joints[0]],
                         lattice.joints[part.joints[1]],
                         point);
  }

  std::vector<RigidBody> rigid_bodies(const Lattice      &lattice,
                                      const DofNumbering &numbering)
  {
    std::vector<RigidBody> bodies;
    for (const unsigned int number : numbering.rigid_parts())
      {
        const RigidPart        &part = lattice.rigid_parts[number];
        const dealii::Point<3> &r0   = lattice.joints[part.joints[0]],
                               &r1   = lattice.joints[part.joints[1]];
        RigidBody body;
        body.part = number;
        for (unsigned int i = 0; i < 4; ++i)
          body.base[i] = numbering.joint_unknown(part.joints[i / 2], i % 2);
        for (unsigned int c = 0; c < 2; ++c)
          body.rest[c] = r1[c] - r0[c];
        body.length  = body.rest.norm();
        body.centre  = place_in(part, lattice, part.centre_of_mass);
        body.mass    = rigid_mass_matrix(part.mass,
                                      part.rotary_inertia,
                                      body.length,
                                      body.centre);
        body.counted = numbering.is_owned(numbering.multiplier(number, 0));
        bodies.push_back(body);
      }
    return bodies;
  }
} // namespace auxfem
