#ifndef auxfem_model_rigid_bodies_h
#define auxfem_model_rigid_bodies_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/model/numbering.h>
#include <auxfem/rigid/rigid_part.h>
#include <auxfem/scene/scene.h>

#include <vector>

namespace auxfem
{
  /**
   * A rigid part in natural coordinates: a body in the plane (dim = 2) or a bar
   * in space (dim = 3).
   */
  template <int dim>
  struct NaturalBody
  {
    /** Index in Lattice::rigid_parts. */
    unsigned int part;
    /** Local unknowns r0_x, r0_y, ..., r1_x, r1_y, ... of the base joints. */
    std::array<int, 2 * dim> base;
    dealii::Tensor<1, dim>   rest;   ///< r1 - r0 at rest (m)
    double                   length; ///< base length (m)
    /** Natural position of the centre of mass. */
    NaturalPosition                   centre;
    std::array<double, 4 * dim * dim> mass; ///< on the base unknowns (kg)
    /** Whether this rank accounts for its energy and writes it to files. */
    bool owned;
  };

  /** A rigid part in space with a rotation of its own. */
  struct RotatingBody
  {
    /** Index in Lattice::rigid_parts. */
    unsigned int part;
    /** Local unknowns of the centre of mass and of the rotation. */
    std::array<int, 3> centre, rotation;
    /** As NaturalBody::owned. */
    bool owned;
  };

  /** Rigid parts on this rank, by kind. */
  struct RigidBodies
  {
    std::vector<NaturalBody<2>> in_plane;
    std::vector<NaturalBody<3>> bars;
    std::vector<RotatingBody>   rotating;

    bool empty() const
    {
      return in_plane.empty() && bars.empty() && rotating.empty();
    }
  };

  /** Natural coordinates of @p point (m, at rest) in a rigid part. */
  template <int dim>
  NaturalPosition position_in(const RigidPart        &part,
                              const Lattice          &lattice,
                              const dealii::Point<3> &point)
  {
    return natural_position<dim>(lattice.joints[part.joints[0]],
                                 lattice.joints[part.joints[1]],
                                 point);
  }

  /** Collects the rigid parts on this rank. */
  RigidBodies rigid_bodies(const Lattice      &lattice,
                           const DofNumbering &numbering);

  /** Local unknowns with their shares of a force. */
  using ForceShares = std::vector<std::pair<int, double>>;

  /**
   * Distributes a dead force along @p component at @p point (m, at rest) of a
   * body to its unknowns, for any rotation.
   */
  template <int dim>
  ForceShares force_shares(const NaturalBody<dim> &body,
                           const Lattice          &lattice,
                           const DofNumbering     &numbering,
                           const dealii::Point<3> &point,
                           unsigned int            component);

  /**
   * Throws InputError for a load point (m, at rest) that is no weighted mean of
   * the joints and the centre of mass of a rotating @p part. Forces on these
   * cannot have their resultant there. Call on all ranks.
   */
  void refuse_unsupported_load_point(const RigidPart        &part,
                                     const Lattice          &lattice,
                                     const dealii::Point<3> &point);

  /**
   * As above, for rotating bodies: forces on the centre of mass and joints with
   * the same resultant. The point must have passed
   * refuse_unsupported_load_point().
   */
  ForceShares force_shares(const RotatingBody     &body,
                           const Lattice          &lattice,
                           const DofNumbering     &numbering,
                           const dealii::Point<3> &point,
                           unsigned int            component);

  /**
   * Creates the rigid parts of @p scene in @p lattice. Struts of one definition
   * that meet form one part, unless each shall be its own. Mass is spread along
   * the struts, or over the joints of a part without struts.
   *
   * Throws InputError for a strut in two definitions and for a part with fewer
   * than two distinct joints.
   */
  void make_rigid_parts(const Scene &scene, Lattice &lattice);

  /** By joint of @p lattice: whether it belongs to a rigid part. */
  std::vector<bool> joints_of_rigid_parts(const Lattice &lattice);

  /** Sorted rigid parts that contain one of @p struts. */
  std::vector<unsigned int>
  rigid_parts_of(const Lattice                   &lattice,
                 const std::vector<unsigned int> &struts);
} // namespace auxfem

#endif
