#ifndef auxfem_mesh_lattice_reduction_h
#define auxfem_mesh_lattice_reduction_h

#include <auxfem/mesh/lattice.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Takes struts and joints out of a lattice, and unites joints. Joints that
   * lose all their struts go, and pairs that lose a joint. Straight struts that
   * come to join the same joints become one.
   */
  class LatticeReduction
  {
  public:
    explicit LatticeReduction(Lattice &lattice);

    /** Renumbers joints, struts, pairs and sets. Returns a sentence on joints
     * and pairs that go; empty if there are none. */
    std::string apply();

    std::vector<bool> keep_strut; ///< all, unless changed
    std::vector<bool> keep_joint; ///< all, unless changed
    /** Joint that takes the place of each: itself, or a lower one. */
    std::vector<unsigned int> target;

  private:
    void renumber_struts();
    void renumber_joints();
    void renumber_pairs(std::vector<JointPair> &pairs) const;

    Lattice                  &lattice;
    const std::vector<bool>   had_struts;
    std::vector<unsigned int> new_strut, new_joint;
    unsigned int              n_lost_joints = 0;
  };
} // namespace auxfem

#endif
