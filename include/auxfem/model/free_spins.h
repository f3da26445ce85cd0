#ifndef auxfem_model_free_spins_h
#define auxfem_model_free_spins_h

#include <auxfem/model/joint_releases.h>

namespace auxfem
{
  /** Straight struts in one line that turn about it without any resistance. */
  struct FreeSpin
  {
    /** In order; several where they are rigidly connected to each other. */
    std::vector<unsigned int> struts;
    /** The released end of the first strut. */
    StrutEnd end;
  };

  /**
   * The bars between ball hinges: straight elastic struts in space released by
   * a hinge at both ends, or at one and alone at a joint that may turn at the
   * other; or several in line, rigidly connected with each other alone, with
   * such outer ends. No load can turn them about their own axis. None in the
   * plane.
   * @param releases of @p lattice
   */
  std::vector<FreeSpin> free_spins(const RunPlan                   &plan,
                                   const Lattice                   &lattice,
                                   const std::vector<JointRelease> &releases);
} // namespace auxfem

#endif
