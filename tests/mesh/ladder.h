#ifndef auxfem_tests_mesh_ladder_h
#define auxfem_tests_mesh_ladder_h

#include <mesh/cell_from_text.h>

namespace auxfem
{
  /** Joints 0..5 at (0,0) (1,0) (2,0) (0,1) (1,1) (2,1); struts 0, 1 the lower
   * chord, 2, 3 the upper, 4..6 the posts from left to right. */
  inline std::shared_ptr<const Cell> ladder()
  {
    return cell_from_text("frame",
                          "set Joints = 0 0; 1 0; 2 0; 0 1; 1 1; 2 1\n"
                          "set Struts = 0 1; 1 2; 3 4; 4 5; 0 3; 1 4; 2 5");
  }
} // namespace auxfem

#endif
