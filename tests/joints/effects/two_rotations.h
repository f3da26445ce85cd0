#ifndef auxfem_tests_joints_effects_two_rotations_h
#define auxfem_tests_joints_effects_two_rotations_h

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>

namespace auxfem
{
  namespace testing_support
  {
    /** The rotations of joints 0 and 1 in the plane, which an effect on trial
     * couples, at both ends of a step. */
    struct TwoRotations
    {
      TwoRotations()
        : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
        , first(setup.dofs().joint_unknown(0, rotation_z))
        , second(setup.dofs().joint_unknown(1, rotation_z))
        , from(setup.equations.initial_state())
        , to(from)
      {}

      /** Registers @p effect and turns the joints to the angles @p one and @p
       * other (rad). */
      void prepare(Effect &effect, const double one, const double other)
      {
        StateLayout layout = setup.equations.layout();
        effect.register_in(layout);
        make_room(layout, from);
        make_room(layout, to);
        to.displacement[first]  = one;
        to.displacement[second] = other;
      }

      Evaluation step()
      {
        return Evaluation::step(from, to, 1.);
      }

      EquationsOnRanks setup;
      int              first, second;
      State            from, to;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
