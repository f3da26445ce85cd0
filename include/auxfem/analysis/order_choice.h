#ifndef auxfem_analysis_order_choice_h
#define auxfem_analysis_order_choice_h

#include <auxfem/output/order_report.h>
#include <auxfem/output/recorder.h>

namespace auxfem
{
  /** Orders of the elements by strut, and how they were found. */
  struct ChosenOrders
  {
    std::vector<unsigned int> orders;
    OrderReport               report;
  };

  /**
   * The lowest orders with which the estimated errors of all struts add up to
   * no more than `Discretization/Tolerance`; the highest possible where this is
   * not enough. The motion that asks for them is that of a search run: the
   * scene with one order for all struts and fewer steps, which @p recorder is
   * told of. Collective. Throws InputError for a probe whose joints do not
   * exist.
   */
  ChosenOrders
  choose_orders(const Scene &scene, MPI_Comm communicator, Recorder &recorder);

  /**
   * A lattice's run with Discretization/Order = auto: chooses the orders, and
   * estimates the error of the elements on the way.
   */
  RunResult run_with_chosen_orders(const Scene &scene,
                                   MPI_Comm     communicator,
                                   Recorder    &recorder);

  /** The scene with these orders; none of them `auto` any more. */
  Scene with_orders(const Scene                     &scene,
                    const std::vector<unsigned int> &orders);
} // namespace auxfem

#endif
