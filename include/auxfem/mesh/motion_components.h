#ifndef auxfem_mesh_motion_components_h
#define auxfem_mesh_motion_components_h

namespace auxfem
{
  /**
   * Number of components of motion and load at a joint: three displacements or
   * forces along x, y, z, three rotations or moments about them. In the plane
   * only 0, 1 and 5 are used.
   */
  constexpr unsigned int n_motion_components = 6;

  /** The component of rotation and moment that there is in the plane. */
  constexpr unsigned int rotation_z = 5;

  /** The first component of rotation and moment. */
  constexpr unsigned int first_rotation = 3;
} // namespace auxfem

#endif
