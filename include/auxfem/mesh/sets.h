#ifndef auxfem_mesh_sets_h
#define auxfem_mesh_sets_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

namespace auxfem
{
  /**
   * Joints named by @p text: the name of a joint set; several names joined by
   * `+`; numbers `3, 5, 7`; `nearest: x, y` or `nearest: x, y, z` (the joint
   * next to a point, z = 0 if left out, lengths with or without unit words); or
   * a condition in x, y, z (m) with xmin, xmax, ymin, ymax, zmin, zmax (and the
   * scene's constants), e.g. `y > ymax - 1e-6 && x < 0.02`.
   * Throws InputError naming @p path: unknown set (with the nearest known names), no such joint
   * number, empty result.
   */
  std::vector<unsigned int> select_joints(const Lattice      &lattice,
                                          const std::string  &text,
                                          const SceneContext &context,
                                          const std::string  &path);

  /**
   * As select_joints(), for struts; conditions are tested at the strut's
   * middle.
   */
  std::vector<unsigned int> select_struts(const Lattice      &lattice,
                                          const std::string  &text,
                                          const SceneContext &context,
                                          const std::string  &path);

  /** @name What the parameter `Joints` or `Struts` of @p definition names. */
  ///@{
  template <class Definition>
  std::vector<unsigned int> joints_of(const Definition   &definition,
                                      const Lattice      &lattice,
                                      const SceneContext &context)
  {
    return select_joints(lattice,
                         definition.joints,
                         context,
                         definition.path + "/Joints");
  }

  template <class Definition>
  std::vector<unsigned int> struts_of(const Definition   &definition,
                                      const Lattice      &lattice,
                                      const SceneContext &context)
  {
    return select_struts(lattice,
                         definition.struts,
                         context,
                         definition.path + "/Struts");
  }
  ///@}

  /**
   * Connector pairs named by `between`: a pair set of the cell, `3 5; 7 9`, or
   * `ground: JOINTS`. Throws InputError naming @p path: unknown pairs (with the
   * nearest known names), no such joint number, a pair set without pairs.
   */
  std::vector<JointPair> select_pairs(const Lattice      &lattice,
                                      const std::string  &text,
                                      const SceneContext &context,
                                      const std::string  &path);
} // namespace auxfem

#endif
