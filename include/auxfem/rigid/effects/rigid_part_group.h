#ifndef auxfem_rigid_effects_rigid_part_group_h
#define auxfem_rigid_effects_rigid_part_group_h

#include <auxfem/equations/effect.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/model/rigid_bodies.h>

#include <memory>

namespace auxfem
{
  /** What a rigid part does at one time. */
  struct RigidPartReport
  {
    /** Number in Lattice::rigid_parts. */
    unsigned int part;
    /**
     * Force (N) that each of its joints, in the order of RigidPart::joints,
     * exerts on the part: what hinges, struts, connectors, loads and supports
     * there pass on to it.
     */
    std::vector<SpaceVector> forces;
  };

  /** Displacement (m) and velocity (m/s) of a point. */
  struct PointMotion
  {
    SpaceVector displacement, velocity;
  };

  /** What constraints on rigid parts need to know besides the parts. */
  struct RigidPartSetting
  {
    const Lattice      &lattice;
    const DofNumbering &numbering;
    /** False: the constraints are linearized about rest. */
    bool large_rotation;
    /** Acceleration along x, y, z for the reported forces (m/s2), zero if it
     * is left out. */
    std::array<TimeFunction, 3> gravity;
  };

  /** The constraints that keep rigid parts of one kind rigid. */
  class RigidPartGroup : public Constraints
  {
  public:
    /** Number of parts this rank reports on. */
    virtual unsigned int n_reported() const = 0;

    /** Number in Lattice::rigid_parts of part @p i of this rank. */
    virtual unsigned int part(unsigned int i) const = 0;

    /**
     * Rotation vector (rad) of part @p i of this rank; with large rotations its
     * angle is at most pi. Of a bar the shortest turn that brings it where it
     * is.
     */
    virtual SpaceVector rotation(unsigned int i, const State &state) const = 0;

    /** Motion of @p point (m, at rest) with part @p i of this rank. */
    virtual PointMotion motion(unsigned int            i,
                               const dealii::Point<3> &point,
                               const State            &state) const = 0;

    /** Report on part @p i of this rank, from displacements, accelerations and multipliers of @p state. */
    virtual RigidPartReport report(unsigned int i,
                                   const State &state) const = 0;
  };

  /** @name Rigid parts of a kind. */
  ///@{
  template <int dim>
  std::unique_ptr<RigidPartGroup>
  make_natural_parts(const std::vector<NaturalBody<dim>> &bodies,
                     const RigidPartSetting              &setting);

  std::unique_ptr<RigidPartGroup>
  make_rotating_parts(const std::vector<RotatingBody> &bodies,
                      const RigidPartSetting          &setting);
  ///@}

  /** Those that keep rigid parts rigid, of all kinds there are. */
  std::unique_ptr<RigidPartGroup>
  make_rigid_part_constraints(const RigidBodies      &bodies,
                              const RigidPartSetting &setting);
} // namespace auxfem

#endif
