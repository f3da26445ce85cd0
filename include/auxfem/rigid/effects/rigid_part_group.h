#ifndef auxfem_rigid_effects_rigid_part_group_h
#define auxfem_rigid_effects_rigid_part_group_h

#include <auxfem/equations/effect.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/model/rigid_bodies.h>

#include <memory>

namespace auxfem
{
  /** Joint forces of a rigid part at one time, for output. */
  struct RigidPartReport
  {
    /** Number in Lattice::rigid_parts. */
    unsigned int part;
    /** Force (N) of each joint on the part, in the order of RigidPart::joints:
     * the sum of hinges, struts, connectors, loads and supports there. */
    std::vector<SpaceVector> forces;
  };

  /** Displacement (m) and velocity (m/s) of a point. */
  struct PointMotion
  {
    SpaceVector displacement, velocity;
  };

  /** Common data of the constraints on rigid parts. */
  struct RigidPartSetting
  {
    const Lattice      &lattice;
    const DofNumbering &numbering;
    /** False: the constraints are linearized about rest. */
    bool large_rotation;
    /** Gravity along x, y, z for the reported forces (m/s2), zero if it is left
     * out. */
    std::array<TimeFunction, 3> gravity;
    /** Acceleration of the base (m/s2), see `Base motion`. */
    std::array<TimeFunction, 3> base_acceleration;
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
     * Rotation vector (rad) of part @p i of this rank; its angle is at most pi
     * with large rotations. For a bar, the shortest rotation to its current
     * direction.
     */
    virtual SpaceVector rotation(unsigned int i, const State &state) const = 0;

    /** Motion of @p point (m, at rest) with part @p i of this rank. */
    virtual PointMotion motion(unsigned int            i,
                               const dealii::Point<3> &point,
                               const State            &state) const = 0;

    /** Report on part @p i of this rank, from displacements, accelerations and
     * multipliers of @p state. */
    virtual RigidPartReport report(unsigned int i,
                                   const State &state) const = 0;
  };

  /** @name Constraints of one kind of rigid parts. */
  ///@{
  template <int dim>
  std::unique_ptr<RigidPartGroup>
  make_natural_parts(const std::vector<NaturalBody<dim>> &bodies,
                     const RigidPartSetting              &setting);

  std::unique_ptr<RigidPartGroup>
  make_rotating_parts(const std::vector<RotatingBody> &bodies,
                      const RigidPartSetting          &setting);
  ///@}

  /** Constraints of rigid parts of all kinds. */
  std::unique_ptr<RigidPartGroup>
  make_rigid_part_constraints(const RigidBodies      &bodies,
                              const RigidPartSetting &setting);
} // namespace auxfem

#endif
