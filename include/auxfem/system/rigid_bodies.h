#ifndef auxfem_system_rigid_bodies_h
#define auxfem_system_rigid_bodies_h

#include <auxfem/dofs/numbering.h>
#include <auxfem/elements/rigid_part.h>

#include <vector>

namespace auxfem
{
  /** A rigid part as its effects on this rank need it. */
  struct RigidBody
  {
    /** Number in Lattice::rigid_parts. */
    unsigned int part;
    /** Local unknowns r0_x, r0_y, r1_x, r1_y of the base. */
    std::array<int, 4> base;
    PlaneVector        rest;   ///< r1 - r0 at rest (m)
    double             length; ///< of the base (m)
    /** Of the centre of mass. */
    NaturalPlace           centre;
    std::array<double, 16> mass; ///< on the base unknowns (kg)
    /** Whether this rank counts its energy and writes it to files. */
    bool counted;
  };

  /** Natural place of @p point (m, at rest) in a rigid part. */
  NaturalPlace place_in(const RigidPart        &part,
                        const Lattice          &lattice,
                        const dealii::Point<3> &point);

  /** The rigid parts kept on this rank. */
  std::vector<RigidBody> rigid_bodies(const Lattice      &lattice,
                                      const DofNumbering &numbering);
} // namespace auxfem

#endif
