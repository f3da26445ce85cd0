#ifndef auxfem_equations_prescribed_motion_h
#define auxfem_equations_prescribed_motion_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/lattice_model.h>

namespace auxfem
{
  /**
   * Displacement, and in dynamics velocity and acceleration, of prescribed
   * unknowns of evaluation.to at its time, which are differences over @p dt (s).
   */
  void prescribe_motion(const LatticeModel &model,
                        const Evaluation   &evaluation,
                        double              dt);

  /**
   * Right-hand side of an increment at evaluation.to into @p right_side
   * (n_owned entries): minus the residual in free rows, in prescribed rows what
   * is missing to the prescribed displacement or rotation.
   */
  void find_right_side(const LatticeModel &model,
                       const Evaluation   &evaluation,
                       double             *right_side);

  /**
   * Keeps account of the work of supports that move; they have no forces
   * besides the residual. nullptr if all are at rest.
   */
  std::unique_ptr<Effect> make_support_work(const LatticeModel &model);
} // namespace auxfem

#endif
