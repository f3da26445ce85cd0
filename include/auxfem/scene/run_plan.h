#ifndef auxfem_scene_run_plan_h
#define auxfem_scene_run_plan_h

#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Estimate, made before the run, of how much an effect changes the result.
   */
  struct EffectMeasure
  {
    /** Relative change expected if the effect is left out, at most 1. */
    double change;
    /** Reference quantity of the change, for messages, e.g. `the bending
     * compliance`. */
    std::string of;
  };

  /** Decision on an effect: whether it is simulated, and why. */
  struct EffectDecision
  {
    std::string name;
    bool        on;
    std::string reason;
    /** None if the scene lacks the effect or there is no estimate. */
    std::optional<EffectMeasure> measure = {};

    /** Whether the effect changes the result by more than @p tolerance; without
     * a measure, whether it is on. */
    bool is_needed(const double tolerance) const
    {
      return measure ? measure->change > tolerance : on;
    }
  };

  /** Effects that a run simulates. */
  struct SimulatedEffects
  {
    bool large_rotation, shear_flexibility, inertia, rotary_inertia,
      connector_viscosity, strut_damping, strut_relaxation, plasticity, gravity,
      hinges, contact;
    /** Whether the program chose small displacements and must end the run where
     * they become wrong (analysis/small_displacement_limit.h). */
    bool small_displacements_are_limited = false;

    /** Decisions with their reasons, in the order of `Effects`. */
    std::vector<EffectDecision> decisions;

    /** The decision on the effect @p name. */
    ///@{
    EffectDecision       &decision(const std::string &name);
    const EffectDecision &decision(const std::string &name) const;
    ///@}
  };

  /** Result of the search for elements with `Discretization/Order = auto`. */
  struct OrderReport
  {
    double tolerance = 0;
    /** Error of the motion of joints in the energy norm, predicted by the
     * search run. */
    double predicted_error = 0;
    /** The same error, estimated by the run itself; none before its end. */
    std::optional<double> estimated_error = {};
    /** @name The search run */
    ///@{
    unsigned int  unknowns = 0;
    unsigned long steps = 0, iterations = 0;
    double        cpu_seconds = 0; ///< with the choice, over all ranks
    /** Simulated time (s), less than the end time if the search run failed. */
    double reached = 0;
    ///@}
    /** CPU time of error estimates during the run, over all ranks. */
    double cpu_seconds_of_estimates = 0;
  };

  /** Elements that the program chose strut by strut, and how. */
  struct ChosenElements
  {
    /** By strut; empty: all struts have RunPlan::division. */
    std::vector<StrutDivision> divisions;
    OrderReport                report;
  };

  /**
   * Settings and decisions of one run of a scene. The scene stays as the user
   * wrote it; an analysis may adjust its plan, and runs read all adjustable
   * settings from the plan.
   */
  struct RunPlan
  {
    /** The run as the scene asks for it. @param scene must outlive the plan. */
    RunPlan(const Scene &scene);

    const Scene &scene;

    /** Analysis of this run; buckling for a run that computes buckling modes as
     * imperfections of another analysis. */
    Analysis         analysis;
    TimeParameters   time;
    NewtonParameters newton;
    SolverParameters solver;
    EffectSwitches   effects;
    /** Elements of all struts, unless `elements` has divisions. */
    StrutDivision division;
    /** Elements chosen by the program; the run estimates their error. */
    std::optional<ChosenElements> elements;

    /** @name Parts of the scene that the run has */
    ///@{
    bool has_imperfections      = true;
    bool has_joint_loads        = true;
    bool has_initial_velocities = true;
    ///@}

    /** Effects simulated on the lattice, by decide_effects(). */
    SimulatedEffects simulated{};
    /** Kinematics of the resumed run; none: to be decided. */
    std::optional<EffectDecision> kinematics;

    /** @name Loads and velocities of the scene, empty if the run has none */
    ///@{
    const std::vector<JointLoadDefinition>       &joint_loads() const;
    const std::vector<InitialVelocityDefinition> &initial_velocities() const;
    ///@}

    /** Saves the decisions that need a computation. */
    void save(CheckpointData &records) const;

    /** Restores the decisions written by save(). */
    void restore(const CheckpointData &records);
  };
} // namespace auxfem

#endif
