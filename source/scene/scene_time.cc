#include <auxfem/elements/strut_order.h>
#include <auxfem/scene/scene_sections.h>

#include <limits>
#include <string>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;
    using dealii::ParameterHandler;

    // Discretization

    const Integer order       = {"Order",
                                 3,
                                 1,
                                 largest_plane_order,
                                 "Polynomial order of the struts' elements; "
                                       "with Dimension = 3 at most 4."};
    const Integer refinements = {"Global refinements",
                                 0,
                                 0,
                                 10,
                                 "Number n of halvings: 2^n elements a strut."};

    SubsectionKind discretization_kind()
    {
      return {"Discretization",
              Form::fixed,
              "Finite elements of the struts.",
              [](ParameterHandler &prm) {
                declare(prm, order);
                declare(prm, refinements);
              },
              "",
              {},
              [](ParameterHandler &prm,
                 const std::string &,
                 const SceneContext &,
                 Scene &scene) {
                scene.discretization = {get(prm, order), get(prm, refinements)};
              }};
    }

    // Effects

    struct Effect
    {
      Choice entry;
      Switch EffectSwitches::*target;
    };

    Effect effect(const std::string &name,
                  Switch EffectSwitches::*target,
                  const std::string      &sentence)
    {
      return {{name, "auto", {"auto", "on", "off"}, sentence}, target};
    }

    const std::vector<Effect> effects = {
      effect("Large rotation",
             &EffectSwitches::large_rotation,
             "Geometrically exact struts; off: small displacements."),
      effect("Shear flexibility",
             &EffectSwitches::shear_flexibility,
             "Shear deformation of the struts."),
      effect("Inertia", &EffectSwitches::inertia, "Inertia forces."),
      effect("Rotary inertia",
             &EffectSwitches::rotary_inertia,
             "Rotary inertia of the struts' cross-sections."),
      effect("Connector viscosity",
             &EffectSwitches::connector_viscosity,
             "Dashpots of the connectors; off: their long-time springs only."),
      effect("Strut damping",
             &EffectSwitches::strut_damping,
             "Stiffness- and mass-proportional damping of the struts."),
      effect("Gravity", &EffectSwitches::gravity, "Weight."),
      effect("Hinges",
             &EffectSwitches::hinges,
             "Hinges and rotational springs; off: all joints are rigid.")};

    Switch switch_of(const std::string &word)
    {
      return word == "on" ? Switch::on
        : word == "off"   ? Switch::off
                          : Switch::automatic;
    }

    SubsectionKind effects_kind()
    {
      return {"Effects",
              Form::fixed,
              "What is simulated; auto: on if the scene needs it.",
              [](ParameterHandler &prm) {
                for (const Effect &effect : effects)
                  declare(prm, effect.entry);
              },
              "",
              {},
              [](ParameterHandler &prm,
                 const std::string &,
                 const SceneContext &,
                 Scene &scene) {
                for (const Effect &effect : effects)
                  scene.effects.*effect.target =
                    switch_of(get(prm, effect.entry));
              }};
    }

    // Time

    std::string models_of(const TimeSchemeEntry &entry)
    {
      return !entry.serves(Model::reduced_cell) ? " (lattices only)"
        : !entry.serves(Model::lattice)         ? " (reduced cell only)"
                                                : "";
    }

    Choice scheme_choice()
    {
      Choice choice{"Scheme",
                    time_scheme_registry().front().name,
                    {},
                    "Time integrator."};
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        {
          choice.sentence += (choice.choices.empty() ? " " : "; ") +
            entry.name + ": " + entry.description + models_of(entry);
          choice.choices.push_back(entry.name);
        }
      choice.sentence += '.';
      return choice;
    }

    const Quantity end_time      = {"End time",
                                    "1 s",
                                    "s",
                                    Range::positive(),
                                    "End of the simulation."};
    const Quantity step          = {"Time step",
                                    "10 ms",
                                    "s",
                                    Range::positive(),
                                    "Length of a step."};
    const Quantity smallest_step = {
      "Smallest time step",
      "0 s",
      "s",
      Range::non_negative(),
      "A step that fails is repeated with half its length down to this; 0: a "
      "1024th of the time step."};
    const Quantity energy_error = {
      "Largest energy error",
      "0.5",
      "1",
      Range::positive(),
      "A step that creates more energy than this part of the largest "
      "so far is repeated with half its length."};
    const Choice start = {"Start from",
                          "rest",
                          {"rest", "static equilibrium"},
                          "State at t = 0: undeformed, or in equilibrium with "
                          "the loads of t = 0."};

    void declare_time(ParameterHandler &prm)
    {
      declare(prm, scheme_choice());
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        if (entry.declare)
          entry.declare(prm);
      declare(prm, end_time);
      declare(prm, step);
      declare(prm, smallest_step);
      declare(prm, energy_error);
      declare(prm, start);
    }

    void read_time(ParameterHandler &prm,
                   const std::string &,
                   const SceneContext &context,
                   Scene              &scene)
    {
      scene.time.end_time      = get(prm, end_time);
      scene.time.step          = get(prm, step);
      scene.time.smallest_step = get(prm, smallest_step);
      scene.time.energy_error  = get(prm, energy_error);
      scene.time.static_start  = (get(prm, start) == "static equilibrium");
      // last: a scheme that refuses its parameters hides none of the others
      scene.time.scheme =
        time_scheme_entry(get(prm, scheme_choice())).make(prm, context);
    }

    // Newton

    const Quantity tolerance = {
      "Tolerance",
      "1e-8",
      "1",
      Range::open(0, 1),
      "Largest residual, relative to the forces of the scene; rows have their own scale too."};
    const Integer maximum_iterations = {
      "Maximum iterations",
      30,
      1,
      1000,
      "Iterations after which a step counts as failed."};
    const Choice factorization = {
      "Factorization",
      "kept",
      {"kept", "every iteration"},
      "Keep a factorization as long as it serves, or full Newton."};
    const Quantity kept_reduction = {
      "Kept reduction",
      "5",
      "1",
      {1, std::numeric_limits<double>::infinity(), true, false},
      "Factor by which an iteration with a kept factorization must reduce the "
      "residual."};

    SubsectionKind newton_kind()
    {
      return {"Newton",
              Form::fixed,
              "When a step counts as solved.",
              [](ParameterHandler &prm) {
                declare(prm, tolerance);
                declare(prm, maximum_iterations);
                declare(prm, factorization);
                declare(prm, kept_reduction);
              },
              "",
              {},
              [](ParameterHandler &prm,
                 const std::string &,
                 const SceneContext &,
                 Scene &scene) {
                scene.newton = {get(prm, tolerance),
                                get(prm, maximum_iterations),
                                get(prm, factorization) == "kept",
                                get(prm, kept_reduction)};
              },
              {Model::lattice, Model::reduced_cell}};
    }

    // Solver

    const Choice solver_type = {
      "Type",
      "auto",
      {"auto", "cholmod", "klu", "mumps", "gmres"},
      "Direct solvers, or gmres, iterative, for lattices that are too large for "
      "these. cholmod takes the symmetric part of the tangent and no rigid "
      "parts or revolute hinges; klu and mumps take all. auto chooses by kind "
      "and size, as the last lines of a run tell."};
    const Choice preconditioner = {
      "Preconditioner",
      "amg",
      {"amg", "ilu"},
      "For Type = gmres. amg: multigrid on the joints; ilu: incomplete "
      "factorization, quicker where steps are so short that inertia rules."};
    const Quantity solver_tolerance = {
      "Tolerance",
      "1e-8",
      "1",
      Range::open(0, 1),
      "Residual, relative to the right-hand side, at which gmres ends."};
    const Integer solver_iterations = {
      "Maximum iterations",
      1000,
      1,
      100000,
      "Iterations of gmres after which a step counts as failed."};

    void declare_solver(ParameterHandler &prm)
    {
      declare(prm, solver_type);
      declare(prm, preconditioner);
      declare(prm, solver_tolerance);
      declare(prm, solver_iterations);
    }

    SubsectionKind solver_kind()
    {
      return {"Solver",
              Form::fixed,
              "Linear solver.",
              declare_solver,
              "",
              {},
              [](ParameterHandler &prm,
                 const std::string &,
                 const SceneContext &,
                 Scene &scene) {
                scene.solver = {get(prm, solver_type),
                                get(prm, preconditioner),
                                get(prm, solver_tolerance),
                                get(prm, solver_iterations)};
              }};
    }
  } // namespace



  std::vector<SubsectionKind> time_kinds()
  {
    return {discretization_kind(),
            effects_kind(),
            {"Time",
             Form::fixed,
             "Time integration.",
             declare_time,
             "",
             {},
             read_time,
             {Model::lattice, Model::reduced_cell}},
            newton_kind(),
            solver_kind()};
  }
} // namespace auxfem
