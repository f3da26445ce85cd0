#ifndef auxfem_tests_verification_hard_case_h
#define auxfem_tests_verification_hard_case_h

#include <auxfem/output/verdict.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** A scene that is hard for a time scheme. */
    struct HardCase
    {
      /** Title of its table. */
      std::string              title;
      std::string              prm;
      std::vector<std::string> overrides = {};
      /** Reference: esdirk with steps this much shorter. */
      unsigned int refinement = 4;
      /** Nothing from outside acts on struts without rigid parts, whose momenta
       * then are measured. */
      bool is_free = false;
      /** Part of the steps before the checkpoint that it is resumed from. */
      double part_before_checkpoint = 0.5;
    };

    /** History and verdict of a run. */
    struct Course
    {
      bool    is_completed = true;
      Verdict verdict      = Verdict::sound;
      /** Largest error of the energy balance over the largest energy. */
      double energy_error = 0;
      /** Largest change of momentum or moment of momentum over their amounts at
       * the start; 0 where they are not measured. */
      double        momentum_error = 0;
      unsigned long rejected       = 0;
      /** Displacements of all joints, by step of the scene. */
      std::vector<std::vector<double>> motions;
      /** From within the run, and how many motions there were then. */
      std::optional<CheckpointData> checkpoint;
      std::size_t                   n_motions_before = 0;
    };

    /**
     * Runs @p hard by every time scheme with inertia, and again from a checkpoint
     * on; leaves a table by scheme. Expects what holds of all cases: everything
     * is finite, no run is wrong and calls itself sound, one that is resumed is
     * equal to the last digit, and energy-momentum keeps energy and momenta.
     * @return the reference
     */
    Course go_through(const HardCase &hard);

    /** The same for a run so long that there is no reference. */
    void go_on_for_long(const HardCase &hard);
  } // namespace testing_support
} // namespace auxfem

#endif
