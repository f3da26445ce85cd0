#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/scene/scene.h>
#include <auxfem/struts/beam_dispatch.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace auxfem
{
  namespace
  {
    template <class... Parts>
    std::string message(const Scene &scene, const Parts &...parts)
    {
      std::ostringstream text;
      text << scene.file << ": ";
      (text << ... << parts);
      return text.str();
    }

    /** Largest number of steps, beyond which neighbouring times lose digits. */
    constexpr double max_steps = 1e12;

    void check_steps(const Scene &scene, Mistakes &mistakes)
    {
      const TimeParameters &time = scene.time;
      if (time.step > time.end_time)
        mistakes.add(message(scene,
                             "Time/Time step = ",
                             time.step,
                             " s is longer than Time/End time = ",
                             time.end_time,
                             " s. Reduce the step or move the end"));
      if (time.end_time / time.step > max_steps)
        mistakes.add(message(scene,
                             "Time/Time step = ",
                             time.step,
                             " s makes ",
                             time.end_time / time.step,
                             " steps until Time/End time = ",
                             time.end_time,
                             " s, but at most ",
                             max_steps,
                             " are allowed. Give a longer step, with its unit, "
                             "e.g. 10 us"));
      if (time.smallest_step > time.step)
        mistakes.add(message(scene,
                             "Time/Smallest time step = ",
                             time.smallest_step,
                             " s is longer than Time/Time step = ",
                             time.step,
                             " s. Reduce it, or set it to 0 for a 1024th of "
                             "the time step"));
    }

    void check_smallest_step(const Scene &scene, Mistakes &mistakes)
    {
      // More than 20 halvings would only delay the failure of the run.
      const double          max_division = 1 << 20;
      const TimeParameters &time         = scene.time;
      if (time.smallest_step > 0 &&
          time.smallest_step < time.step / max_division)
        mistakes.add(message(scene,
                             "Time/Smallest time step = ",
                             time.smallest_step,
                             " s is less than a millionth of Time/Time step = ",
                             time.step,
                             " s. Increase it, or reduce the time step"));
    }

    void check_tolerance(const Scene &scene, Mistakes &mistakes)
    {
      if (!scene.time.relative_tolerance)
        return;
      const auto *scheme =
        dynamic_cast<const ImplicitScheme *>(scene.time.scheme.get());
      if (scene.context.model == Model::reduced_cell || scheme == nullptr ||
          !scheme->estimates_errors())
        mistakes.add(message(
          scene,
          "Time/Relative tolerance: there is no estimate of the error of "
          "Time/Scheme = ",
          scene.time.scheme->name(),
          " with these settings. Set it to none, or choose newmark of second order, "
          "hht, generalized-alpha or esdirk of order 3 or 4, with Model = "
          "lattice"));
    }

    void check_inertia(const Scene &scene, Mistakes &mistakes)
    {
      const bool statics = !scene.time.scheme->is_dynamic();
      if (statics && scene.effects.inertia == Switch::on)
        mistakes.add(message(scene,
                             "Effects/Inertia = on contradicts Time/Scheme = "
                             "static. Choose a dynamic scheme or set Inertia = "
                             "auto"));
      if (!statics && scene.effects.inertia == Switch::off)
        mistakes.add(message(scene,
                             "Effects/Inertia = off with Time/Scheme = ",
                             scene.time.scheme->name(),
                             ": without inertia there is no motion to "
                             "integrate. Set Time/Scheme = static"));
      if (statics && !scene.initial_velocities.empty())
        mistakes.add(message(scene,
                             scene.initial_velocities.front().path,
                             ": an initial velocity contradicts Time/Scheme = "
                             "static. Remove it or choose a dynamic scheme"));
    }

    /** Refuses jumps of a support, whose velocity would be infinite. */
    void check_motion(const Scene        &scene,
                      const std::string  &path,
                      const TimeFunction &motion,
                      Mistakes           &mistakes)
    {
      const double start  = motion.value_after(0);
      const double before = scene.time.static_start ? motion.value(0) : 0.;
      if (std::abs(start - before) > round_off)
        mistakes.add(message(
          scene,
          path,
          " is ",
          start,
          " just after t = 0, but ",
          before,
          " before: with inertia a support cannot jump. Start the motion "
          "from that value, start the lattice in equilibrium with it "
          "(Time/Start from = static equilibrium), or use Time/Scheme = "
          "static"));
      for (const TimeEvent &event : motion.events(0, scene.time.end_time))
        if (event.kind == TimeEvent::Kind::jump)
          {
            mistakes.add(message(
              scene,
              path,
              " jumps at t = ",
              event.time,
              " s from ",
              motion.value_before(event.time),
              " to ",
              motion.value_after(event.time),
              ": with inertia a support cannot jump. Give it a "
              "continuous time history, e.g. a ramp, or use Time/Scheme = "
              "static"));
            return;
          }
    }

    void check_motions(const Scene &scene, Mistakes &mistakes)
    {
      // In a frequency response, motions are amplitudes without a start.
      if (is_static(scene) || scene.analysis == Analysis::frequency_response)
        return;
      for (const SupportDefinition &support : scene.supports)
        for (unsigned int c = 0; c < n_motion_components; ++c)
          try
            {
              check_motion(scene,
                           support.path +
                             (c < first_rotation ? "/Displacement "
                                                 : "/Rotation ") +
                             "xyz"[c % first_rotation],
                           support.motion[c],
                           mistakes);
            }
          catch (const ComputationError &not_finite)
            {
              mistakes.add(not_finite.what());
            }
    }

    void check_density(const Scene &scene, Mistakes &mistakes)
    {
      const bool statics = is_static(scene);
      const bool weight =
        (!scene.gravity.is_zero() && scene.effects.gravity != Switch::off) ||
        !scene.base_motion.is_zero();
      if (statics && !weight)
        return;
      for (const SectionDefinition &section : scene.sections)
        if (!section.has_density)
          mistakes.add(message(scene,
                               section.material_path,
                               "/Density must be given, because there is ",
                               statics ? "weight (Gravity) or Base motion"
                                       : "inertia (Time/Scheme = " +
                                   scene.time.scheme->name() + ")",
                               ". Allowed: a number >= 0 in kg/m3, 0 for "
                               "massless struts"));
    }

    void check_scheme(const Scene &scene, Mistakes &mistakes)
    {
      const std::string &scheme = scene.time.scheme->name();
      if (!time_scheme_entry(scheme).serves(scene.context.model))
        mistakes.add(message(
          scene,
          "Time/Scheme = ",
          scheme,
          scene.context.model == Model::lattice
            ? " integrates the reduced cell only (Model = reduced cell)"
            : ": without inertia the reduced cell is a mechanism, whose angle no "
              "equilibrium determines",
          ". Use e.g. Scheme = newmark"));
    }

    void check_order(const Scene &scene, Mistakes &mistakes)
    {
      if (scene.context.dimension == 3 &&
          scene.discretization.order > largest_space_order)
        mistakes.add(message(scene,
                             "Discretization/Order = ",
                             scene.discretization.order,
                             ": with Dimension = 3 the order is at most ",
                             largest_space_order,
                             ". Use smaller elements instead (Discretization/"
                             "Global refinements)"));
    }

    void check_chosen_order(const Scene &scene, Mistakes &mistakes)
    {
      if (scene.discretization.tolerance && scene.analysis == Analysis::study &&
          scene.study.kind != "effects")
        mistakes.add(
          message(scene,
                  "Discretization/Order = auto: a study with Study/"
                  "Kind = ",
                  scene.study.kind,
                  " needs a fixed order. Set Order to a number, e.g. "
                  "3"));
    }

    /** Checks requirements of paths and buckling. */
    void check_stability_analysis(const Scene &scene, Mistakes &mistakes)
    {
      if (scene.effects.large_rotation == Switch::off)
        mistakes.add(message(scene,
                             "Effects/Large rotation = off: buckling needs "
                             "rotations. Set it to auto for Analysis = ",
                             name_of(scene.analysis)));
      if (scene.analysis == Analysis::static_path &&
          scene.solver.type == "gmres")
        mistakes.add(message(
          scene,
          "Solver/Type = gmres: Analysis = static path detects "
          "bifurcations by counting negative eigenvalues, which needs a "
          "direct solver. Set it to auto, mumps, klu or cholmod"));
      if (scene.analysis != Analysis::buckling || scene.context.dimension != 3)
        return;
      for (const JointDefinition &joint : scene.joints)
        if (joint.type == JointDefinition::Type::rotational_spring || joint.law)
          mistakes.add(
            message(scene,
                    joint.path,
                    ": Analysis = buckling does not support rotational springs "
                    "in space, because their moments depend on the rotation of "
                    "the joint. Make the ends rigid or hinged, or use a planar "
                    "scene"));
    }

    void check_analysis(const Scene &scene, Mistakes &mistakes)
    {
      if (scene.analysis == Analysis::simulation ||
          scene.analysis == Analysis::study)
        return;
      const std::string name = name_of(scene.analysis);
      if (scene.context.model != Model::lattice)
        mistakes.add(message(scene,
                             "Analysis = ",
                             name,
                             " needs a lattice. Set Model = lattice, or "
                             "Analysis = simulation"));
      else if (scene.analysis == Analysis::static_path ||
               scene.analysis == Analysis::buckling)
        check_stability_analysis(scene, mistakes);
      else if (scene.analysis != Analysis::effective_properties &&
               scene.analysis != Analysis::effective_response &&
               (!scene.time.scheme->is_dynamic() ||
                scene.effects.inertia == Switch::off))
        mistakes.add(message(scene,
                             "Analysis = ",
                             name,
                             " needs inertia. Set Time/Scheme "
                             "= newmark and leave Effects/Inertia = auto"));
      if (scene.discretization.tolerance && !is_linearized(scene.analysis))
        mistakes.add(
          message(scene,
                  "Discretization/Order = auto: Analysis = ",
                  name,
                  " needs a fixed order. Set Order to a number, e.g. "
                  "3"));
    }

    /** Refuses contact in analyses that cannot follow changes of the active
     * set, and friction in linearized ones. */
    void check_contact(const Scene &scene, Mistakes &mistakes)
    {
      if (scene.effects.contact == Switch::off)
        return;
      const bool        are_plates = !scene.plates.empty();
      const std::string name       = name_of(scene.analysis);
      if ((scene.analysis == Analysis::static_path ||
           scene.analysis == Analysis::buckling) &&
          (are_plates || scene.effects.contact == Switch::on))
        mistakes.add(message(
          scene,
          are_plates ? scene.plates.front().path : "Effects/Contact = on",
          ": contact begins and ends abruptly, which Analysis = ",
          name,
          " cannot follow. Use load steps with Analysis = simulation and "
          "Scheme = static, or set Effects/Contact = off"));
      if ((scene.analysis == Analysis::modes ||
           scene.analysis == Analysis::frequency_response) &&
          scene.contact.friction > 0)
        mistakes.add(message(scene,
                             "Contact/Friction coefficient = ",
                             scene.contact.friction,
                             ": Analysis = ",
                             name,
                             " is linear and cannot decide whether contacts "
                             "stick or slip. Set it to 0, so that all contacts "
                             "slide"));
    }

    void check_rows(const Scene &scene, Mistakes &mistakes)
    {
      const OutputParameters &output = scene.output;
      if (output.row_interval && output.history_interval > 1)
        mistakes.add(message(scene,
                             "Output/Time between rows = ",
                             *output.row_interval,
                             " s and Output/History interval = ",
                             output.history_interval,
                             " steps both set the rows of history.csv. Remove "
                             "one of them"));
    }

    void check_reduced_cell(const Scene &scene, Mistakes &mistakes)
    {
      if (scene.context.dimension == 3)
        mistakes.add(
          message(scene,
                  "Dimension = 3: with Model = reduced cell the cell "
                  "moves in its plane. Set Dimension = 2, or choose "
                  "Model = lattice"));
      const std::size_t n_connectors = scene.connectors.size();
      // A connector with mistakes is not in the scene.
      if (n_connectors > 1 || (n_connectors == 0 && mistakes.empty()))
        mistakes.add(message(scene,
                             "Connectors has ",
                             n_connectors,
                             " groups, but with Model = reduced cell "
                             "there must be exactly one, the connector between "
                             "the upper part and the foundation"));
      if (scene.time.static_start)
        mistakes.add(message(scene,
                             "Time/Start from = static equilibrium is not "
                             "possible with Model = reduced cell, which starts "
                             "from rest. Remove it"));
      if (!scene.time.events.empty())
        mistakes.add(message(scene,
                             "Time/Events: with Model = reduced cell all steps "
                             "have the same length. Remove it"));
      if (scene.time.smallest_step > 0)
        mistakes.add(message(scene,
                             "Time/Smallest time step = ",
                             scene.time.smallest_step,
                             " s: with Model = reduced cell steps are never "
                             "repeated with a smaller length. Remove it"));
      if (scene.output.effective_strains)
        mistakes.add(message(scene,
                             "Output/Effective strains = true is not possible "
                             "with Model = reduced cell, which has no joint "
                             "sets. Remove it; angle and rise of the cell are "
                             "in history.csv"));
      if (scene.output.row_interval)
        mistakes.add(message(scene,
                             "Output/Time between rows = ",
                             *scene.output.row_interval,
                             " s is not possible with Model = reduced cell, "
                             "which writes rows at its steps. Set History "
                             "interval, a number of steps"));
    }

    /** Refuses definitions whose equal names would give history.csv the same
     * columns `NAME.quantity`. */
    class ColumnNames
    {
    public:
      ColumnNames(const Scene &scene, Mistakes &mistakes)
        : scene(scene)
        , mistakes(mistakes)
      {}

      template <class Definitions>
      void enter(const Definitions &definitions)
      {
        for (const auto &definition : definitions)
          {
            const auto [other, is_new] =
              paths.emplace(definition.name, definition.path);
            if (!is_new)
              mistakes.add(message(scene,
                                   definition.path,
                                   " and ",
                                   other->second,
                                   " have the same name, and both give columns "
                                   "of history.csv for the same quantities. "
                                   "Rename one of them"));
          }
      }

    private:
      const Scene                       &scene;
      Mistakes                          &mistakes;
      std::map<std::string, std::string> paths;
    };

    /** Checks supports among each other (columns `.rx`), probes and plates
     * (`.ux`, `.fx`), and connectors and laws of joints (`.dissipated`). */
    void check_column_names(const Scene &scene, Mistakes &mistakes)
    {
      // Supports of plates are among the supports of the scene.
      ColumnNames(scene, mistakes).enter(scene.supports);
      ColumnNames motions(scene, mistakes);
      motions.enter(scene.output.probes);
      motions.enter(scene.plates);
      std::vector<JointDefinition> laws;
      for (const JointDefinition &joint : scene.joints)
        if (joint.law)
          laws.push_back(joint);
      ColumnNames losses(scene, mistakes);
      losses.enter(scene.connectors);
      losses.enter(laws);
    }

    void check_crush_curve(const Scene &scene, Mistakes &mistakes)
    {
      if (!scene.figures.crush)
        return;
      std::vector<std::string> known;
      for (const SupportDefinition &support : scene.supports)
        known.push_back(support.name);
      for (const PlateDefinition &plate : scene.plates)
        if (!plate.support)
          known.push_back(plate.name);
      for (const std::string &body : scene.figures.crush->bodies)
        if (std::find(known.begin(), known.end(), body) == known.end())
          mistakes.add(
            message(scene,
                    "Crush curve/Bodies: \"",
                    body,
                    "\" is no plate or support. Allowed: ",
                    known.empty() ? "none, as there are none" : joined(known)));
    }
  } // namespace



  void check_consistency(const Scene &scene, Mistakes &mistakes)
  {
    check_materials(scene, mistakes);
    check_connectors(scene, mistakes);
    check_steps(scene, mistakes);
    check_scheme(scene, mistakes);
    if (scene.context.model == Model::reduced_cell)
      check_reduced_cell(scene, mistakes);
    check_smallest_step(scene, mistakes);
    check_rows(scene, mistakes);
    check_order(scene, mistakes);
    check_chosen_order(scene, mistakes);
    check_analysis(scene, mistakes);
    check_contact(scene, mistakes);
    check_tolerance(scene, mistakes);
    check_inertia(scene, mistakes);
    check_motions(scene, mistakes);
    check_density(scene, mistakes);
    check_column_names(scene, mistakes);
    check_crush_curve(scene, mistakes);
    check_optimization(scene, mistakes);
  }
} // namespace auxfem
