#ifndef auxfem_scene_graded_sections_h
#define auxfem_scene_graded_sections_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * Sets Strut::section of all struts. Of several sections that name a strut
   * the last one counts; struts that none names have invalid_index. Throws
   * InputError for unknown sets.
   */
  void assign_sections(const Scene &scene, Lattice &lattice);

  /**
   * Replaces each section with a Grading by one section for each different set
   * of factors, with its struts. Positions are those of the designed lattice.
   * Throws InputError if a factor cannot be computed or makes a section
   * impossible.
   */
  void grade_sections(Scene &scene);
} // namespace auxfem

#endif
