#ifndef auxfem_scene_run_plan_h
#define auxfem_scene_run_plan_h

#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** How much of the answer an effect is, found before the run. */
  struct EffectMeasure
  {
    /** Relative change expected if the effect is left out, at most 1. */
    double change;
    /** What @p change is a part of, for people: `the bending compliance`. */
    std::string of;
  };

  /** One line of "what is simulated": an effect, whether it is on, and why. */
  struct EffectDecision
  {
    std::string name;
    bool        on;
    std::string reason;
    /** None where the scene has nothing of the effect, or there is no measure.
     */
    std::optional<EffectMeasure> measure = {};

    /** Whether the effect changes the answer by more than @p tolerance; without
     * a measure whether it is on. */
    bool is_called_for(const double tolerance) const
    {
      return measure ? measure->change > tolerance : on;
    }
  };

  /** Which physics a run simulates. */
  struct SimulatedEffects
  {
    bool large_rotation, shear_flexibility, inertia, rotary_inertia,
      connector_viscosity, strut_damping, gravity, hinges, contact;
    /** Whether the program has decided on small displacements, and ends the run
     * where they are wrong (analysis/small_displacement_limit.h). */
    bool small_displacements_are_limited = false;

    /** The same in words, in the order of the `Effects` subsection. */
    std::vector<EffectDecision> decisions;

    /** The decision on the effect @p name. */
    ///@{
    EffectDecision       &decision(const std::string &name);
    const EffectDecision &decision(const std::string &name) const;
    ///@}
  };

  /** What came of `Discretization/Order = auto`. */
  struct OrderReport
  {
    double tolerance = 0;
    /** Of the motion of joints, in the energy norm, by the search run. */
    double predicted_error = 0;
    /** The same by the run itself; none before its end. */
    std::optional<double> estimated_error = {};
    /** @name The search run. */
    ///@{
    unsigned int  unknowns = 0;
    unsigned long steps = 0, iterations = 0;
    double        cpu_seconds = 0; ///< with the choice, over all ranks
    double        reached     = 0; ///< time (s), less than the end if it failed
    ///@}
    /** Of estimates during the run, over all ranks. */
    double cpu_seconds_of_estimates = 0;
  };

  /** Elements that the program has chosen strut by strut, and how it has found
   * them. */
  struct ChosenElements
  {
    /** By strut; empty: all have RunPlan::division. */
    std::vector<StrutDivision> divisions;
    OrderReport                report;
  };

  /**
   * What the program decides for a run of a scene. The scene stays what the
   * user wrote; an analysis adjusts its plan, and runs read from the plan all
   * that an analysis may adjust.
   */
  struct RunPlan
  {
    /** The run as the user asks for it. @param scene must outlive the plan. */
    RunPlan(const Scene &scene);

    const Scene &scene;

    /** What the run is part of: buckling, where buckling modes are the
     * imperfections of another analysis. */
    Analysis         analysis;
    TimeParameters   time;
    NewtonParameters newton;
    SolverParameters solver;
    EffectSwitches   effects;
    /** Elements of all struts, unless they are chosen strut by strut. */
    StrutDivision division;
    /** The run estimates their error. */
    std::optional<ChosenElements> elements;

    /** @name Whether the run has these parts of the scene. */
    ///@{
    bool has_imperfections      = true;
    bool has_joint_loads        = true;
    bool has_initial_velocities = true;
    ///@}

    /** What `effects` come to on the lattice, see decide_effects(). */
    SimulatedEffects simulated{};
    /** Kinematics of the run that is resumed; none: to be decided. */
    std::optional<EffectDecision> kinematics;

    /** @name Those that the run has. */
    ///@{
    const std::vector<JointLoadDefinition>       &joint_loads() const;
    const std::vector<InitialVelocityDefinition> &initial_velocities() const;
    ///@}

    /** Saves the decisions that take a computation. */
    void save(CheckpointData &records) const;

    /** Takes over what save() has saved. */
    void restore(const CheckpointData &records);
  };
} // namespace auxfem

#endif
