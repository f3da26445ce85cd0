#include <auxfem/parameters/errors.h>
#include <auxfem/time/schemes/time_parameters.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
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
          choice.sentence += (choice.words.empty() ? " " : "; ") + entry.name +
            ": " + entry.description + models_of(entry);
          choice.words.push_back(entry.name);
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
      "Shortest step to which failed steps are halved; 0: a 1024th of the time "
      "step."};
    const Quantity relative_tolerance = {
      "Relative tolerance",
      "none",
      "1",
      Range::open(0, 1),
      "Allowed error of the time integration until the end time, relative to the "
      "largest displacements and rotations, as root mean squares. Time steps are "
      "divided where their estimated error requires it; results are still "
      "written at every time step. none: only failed steps are divided.",
      {"none"}};
    const Quantity absolute_tolerance = {
      "Absolute tolerance",
      "auto",
      "m",
      Range::positive(),
      "With a relative tolerance: the error allowed while displacements are "
      "small. auto: the relative tolerance times a fiftieth of the mean strut "
      "length; a run with smaller displacements ends with a warning that "
      "gives the value to set.",
      {"auto"}};
    const Quantity absolute_tolerance_of_rotations = {
      "Absolute tolerance of rotations",
      "auto",
      "rad",
      Range::positive(),
      "With a relative tolerance: the error allowed while rotations are small. "
      "auto: that of displacements over the mean strut length.",
      {"auto"}};
    const Quantity energy_error = {
      "Largest energy error",
      "0.5",
      "1",
      Range::positive(),
      "Largest energy that a step may create, as part of the largest energy so "
      "far; otherwise it is repeated with half its length."};
    const QuantityList events = {
      "Events",
      "",
      "s",
      Range::non_negative(),
      0,
      10000,
      "Times at which steps end and rates are recomputed. The program detects "
      "most kinks and jumps of loads and motions; list those that it cannot, as "
      "in sqrt((t - 1)^2), asin(sin(t)) or if(sin(t) > 0.999, 1, 0). No time may "
      "lie after the end time."};
    const Choice start = {"Start from",
                          "rest",
                          {"rest", "static equilibrium"},
                          "State at t = 0: undeformed, or in equilibrium with "
                          "the loads of t = 0."};


    /** All schemes' parameters are listed side by side. */
    Parameters time_parameters()
    {
      Parameters parameters = {scheme_choice()};
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        parameters.insert(parameters.end(),
                          entry.parameters.begin(),
                          entry.parameters.end());
      for (const Parameter &parameter :
           Parameters{end_time,
                      step,
                      smallest_step,
                      relative_tolerance,
                      absolute_tolerance,
                      absolute_tolerance_of_rotations,
                      energy_error,
                      events,
                      start})
        parameters.push_back(parameter);
      return parameters;
    }

    std::vector<std::string>
    values_of_other_schemes(const ParameterValues &values)
    {
      const std::string        chosen = values[scheme_choice()];
      std::vector<std::string> sentences;
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        if (entry.name != chosen)
          for (const Parameter &parameter : entry.parameters)
            if (!values.is_default(parameter))
              sentences.push_back(
                "Time/" + parameter.name + " = " + values.text(parameter) +
                " has no effect: it belongs to Scheme = " + entry.name +
                ", and Time/Scheme is " + chosen + ".");
      return sentences;
    }

    /** Times up to @p end_time (s). */
    std::vector<double> read_events(const ParameterValues &values,
                                    const double           end_time)
    {
      const std::vector<double> times = values[events];
      for (const double time : times)
        if (time > end_time)
          {
            std::ostringstream message;
            message << "Time/Events: " << time
                    << " s lies after the end of the run at " << end_time
                    << " s.\nGive times between 0 and Time/End time.";
            throw InputError(message.str());
          }
      return times;
    }

    // Newton

    const Quantity newton_tolerance = {
      "Tolerance",
      "auto",
      "1",
      Range::open(0, 1),
      "Largest residual, relative to the forces of the scene and, more loosely, "
      "to those of its row. auto: 1e-8; with Time/Relative tolerance a tenth of "
      "it, between 1e-10 and 1e-5.",
      {"auto"}};
    const Integer maximum_iterations = {"Maximum iterations",
                                        30,
                                        1,
                                        1000,
                                        "Iterations after which a step fails."};
    const Choice  factorization      = {
            "Factorization",
            "kept",
            {"kept", "every iteration"},
            "Jacobian reuse (kept), or full Newton (every iteration)."};
    const Quantity jacobian_reuse_threshold = {
      "Jacobian reuse threshold",
      "5",
      "1",
      {1, std::numeric_limits<double>::infinity(), true, false},
      "Smallest factor by which an iteration with a reused factorization must "
      "reduce the residual."};
  } // namespace



  SubsectionSchema time_schema()
  {
    return {"Time",
            SubsectionSchema::Form::fixed,
            "Time integration.",
            time_parameters(),
            "",
            {},
            {Model::lattice, Model::reduced_cell}};
  }



  TimeParameters read_time(ParameterValues &values)
  {
    TimeParameters time;
    time.end_time      = values[end_time];
    time.step          = values[step];
    time.smallest_step = values[smallest_step];
    time.energy_error  = values[energy_error];
    time.events        = read_events(values, time.end_time);
    if (!values.is_word(relative_tolerance))
      time.relative_tolerance = values[relative_tolerance];
    if (!values.is_word(absolute_tolerance))
      time.absolute_tolerance = values[absolute_tolerance];
    if (!values.is_word(absolute_tolerance_of_rotations))
      time.absolute_tolerance_of_rotations =
        values[absolute_tolerance_of_rotations];
    time.static_start = (values[start] == "static equilibrium");

    time.scheme = time_scheme_entry(values[scheme_choice()]).make(values);
    time.values_without_effect = values_of_other_schemes(values);
    return time;
  }



  SubsectionSchema newton_schema()
  {
    return {"Newton",
            SubsectionSchema::Form::fixed,
            "Convergence of Newton's method in a step.",
            {newton_tolerance,
             maximum_iterations,
             factorization,
             jacobian_reuse_threshold},
            "",
            {},
            {Model::lattice, Model::reduced_cell}};
  }



  NewtonParameters read_newton(ParameterValues &values)
  {
    NewtonParameters newton;
    newton.tolerance_is_given = !values.is_word(newton_tolerance);
    if (newton.tolerance_is_given)
      newton.tolerance = values[newton_tolerance];
    newton.maximum_iterations       = values[maximum_iterations];
    newton.keep_factorization       = values[factorization] == "kept";
    newton.jacobian_reuse_threshold = values[jacobian_reuse_threshold];
    return newton;
  }



  NewtonParameters NewtonParameters::for_steps_within(
    const std::optional<double> &time_tolerance) const
  {
    NewtonParameters parameters = *this;
    if (time_tolerance && !tolerance_is_given)
      parameters.tolerance = std::clamp(*time_tolerance / 10, 1e-10, 1e-5);
    parameters.estimates_stages = time_tolerance.has_value();
    return parameters;
  }
} // namespace auxfem
