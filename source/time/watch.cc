#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int n_values = 5;

    /** Flag of presence, followed by the members. */
    std::vector<double> values_of(const std::optional<LocatedEvent> &occurrence)
    {
      if (!occurrence)
        return std::vector<double>(n_values, 0.);
      return {1.,
              occurrence->size,
              occurrence->time,
              double(occurrence->number),
              double(occurrence->group)};
    }

    std::optional<LocatedEvent> event_from(const std::vector<double> &values)
    {
      if (values[0] == 0)
        return std::nullopt;
      return LocatedEvent{values[1],
                          values[2],
                          static_cast<unsigned int>(values[3]),
                          static_cast<unsigned int>(values[4])};
    }

    /** First event over all ranks in this order. */
    template <class ComesBefore>
    std::optional<LocatedEvent>
    extreme_over_ranks(const std::optional<LocatedEvent> &mine,
                       const MPI_Comm                     communicator,
                       const ComesBefore                 &comes_before)
    {
      std::optional<LocatedEvent> best;
      const std::vector<double>   all =
        gather_over_ranks(values_of(mine), communicator);
      for (auto values = all.begin(); values < all.end(); values += n_values)
        if (const auto other = event_from({values, values + n_values});
            other && (!best || comes_before(*other, *best)))
          best = other;
      return best;
    }

    std::string record_of(const std::string &entry)
    {
      return "watch: " + entry;
    }
  } // namespace

  void EventExtremes::add(const LocatedEvent &occurrence)
  {
    if (!first_event)
      first_event = occurrence;
    if (!largest_event || occurrence.size > largest_event->size)
      largest_event = occurrence;
  }

  std::optional<LocatedEvent> EventExtremes::first() const
  {
    return extreme_over_ranks(first_event,
                              communicator,
                              [](const LocatedEvent &one,
                                 const LocatedEvent &other) {
                                return one.time < other.time ||
                                  (one.time == other.time &&
                                   one.size > other.size);
                              });
  }

  std::optional<LocatedEvent> EventExtremes::largest() const
  {
    return extreme_over_ranks(largest_event,
                              communicator,
                              [](const LocatedEvent &one,
                                 const LocatedEvent &other) {
                                return one.size > other.size;
                              });
  }

  void EventExtremes::serialize(const std::string &name,
                                CheckpointArchive &archive)
  {
    for (const auto &[event, over_ranks] :
         {std::pair(&first_event, &EventExtremes::first),
          {&largest_event, &EventExtremes::largest}})
      {
        std::vector<double> values =
          values_of(archive.is_saving() ? (this->*over_ranks)() : std::nullopt);
        archive.list(name + (event == &first_event ? ": first" : ": largest"),
                     values);
        *event = event_from(values);
      }
  }

  void RunStatistics::serialize(CheckpointArchive &archive)
  {
    for (auto &[name, number] : numbers)
      archive.values(record_of(name), number);
    for (auto &[name, largest] : maxima)
      archive.values(record_of(name), largest);
    for (auto &[name, occurrences] : events)
      occurrences.serialize(record_of(name), archive);
    for (auto &[name, list] : lists)
      archive.list(record_of(name), list);
    for (auto &[name, text] : texts)
      archive.text(record_of(name), text);
  }

  namespace
  {
    bool has_yield_strain(const Scene &scene)
    {
      return std::any_of(scene.sections.begin(),
                         scene.sections.end(),
                         [](const SectionDefinition &definition) {
                           return definition.section.yield_strain.has_value();
                         });
    }

    bool has_friction(const RunPlan &plan)
    {
      return plan.simulated.contact && plan.scene.contact.friction > 0;
    }

    bool is_free_in_space(const LatticeModel &model)
    {
      return model.lattice.dimension == 3 &&
        model.plan.simulated.large_rotation && model.supports.empty() &&
        model.lattice.rigid_parts.empty() && model.relations.empty() &&
        model.plan.scene.plates.empty();
    }
  } // namespace

  std::string shorter_step_text(const double          scene_step,
                                const ImplicitScheme &scheme,
                                const double          missed)
  {
    std::ostringstream text;
    text.precision(2);
    text << " (Time/Time step = " << scene_step << " s). A step of "
         << scene_step * std::pow(0.01 / missed, 1. / scheme.order())
         << " s would miss 1 %.";
    return text.str();
  }

  Watches::Watches(const Equations &equations, Work &work)
    : schedule(equations)
    , statistics(equations.unknowns().layout.communicator())
  {
    const RunPlan          &plan        = equations.model().plan;
    const Scene            &scene       = plan.scene;
    const SimulatedEffects &simulated   = plan.simulated;
    const ReportingEffects &reporting   = equations.reporting();
    const bool              has_inertia = simulated.inertia,
               is_linear                = equations.is_linear(),
               has_struts               = !reporting.struts.empty(),
               has_contact              = reporting.plates != nullptr ||
      reporting.strut_contact != nullptr;
    // In elastic statics time only orders the loads.
    const bool time_has_meaning = simulated.connector_viscosity ||
      simulated.strut_damping || simulated.strut_relaxation ||
      has_friction(plan);
    const bool         is_limited = simulated.small_displacements_are_limited;
    const WatchContext run{plan, equations, statistics, work};
    const auto         add_if = [&](const bool is_needed, MakeWatch &make) {
      if (auto watch = is_needed ? make(run) : nullptr)
        watches.push_back(std::move(watch));
    };
    add_if(true, make_energy_watch);
    // Linear scenes are as stable as at the start, where mechanisms are
    // refused. Static paths count unstable modes themselves.
    add_if(!is_linear && plan.analysis != Analysis::static_path,
           make_stability_watch);
    add_if(!simulated.large_rotation && !is_limited,
           make_small_displacement_watch);
    add_if(has_inertia, make_step_watch);
    add_if(has_inertia, make_load_step_watch);
    add_if(has_inertia && plan.time.relative_tolerance &&
             is_free_in_space(equations.model()),
           make_spin_watch);
    add_if(!has_inertia && time_has_meaning, make_load_speed_watch);
    add_if(!is_linear && !reporting.connectors.empty(), make_connector_watch);
    add_if(has_contact, make_contact_watch);
    add_if(has_contact && has_inertia, make_impact_watch);
    add_if(!scene.plates.empty() && reporting.plates == nullptr,
           make_plate_crossing_watch);
    add_if(simulated.shear_flexibility, make_bending_watch);
    add_if(has_struts && has_inertia, make_wave_watch);
    add_if(has_struts && has_yield_strain(scene), make_yield_watch);
    add_if(simulated.plasticity, make_plasticity_watch);
    // Linear responses are judged relative to the loads, not by their size.
    add_if(has_struts && (!is_linear || is_limited), make_strain_watch);
    add_if(has_struts && !is_linear, make_local_buckling_watch);
    // A limited run by small displacements already ends at contact.
    add_if(has_struts && !scene.lattice.struts_may_cross &&
             reporting.strut_contact == nullptr &&
             (!is_limited || plan.effects.contact == Switch::off),
           make_crossing_watch);
  }

  void Watches::start(const State &state)
  {
    for (const auto &watch : watches)
      watch->start(state);
  }

  void Watches::step(const Evaluation        &step,
                     const EvaluationResults &results,
                     TangentSolver           &solver)
  {
    const bool is_in_burst =
      schedule.is_sampled(SamplingRate::bursts, step.from.step);
    for (const auto &watch : watches)
      if (schedule.is_sampled(watch->rate, step.from.step))
        {
          if (watch->rate == SamplingRate::bursts && !follows_burst)
            watch->forget_steps();
          watch->step(step, results, solver);
        }
    follows_burst = is_in_burst;
  }

  void Watches::forget_steps()
  {
    for (const auto &watch : watches)
      watch->forget_steps();
  }

  bool Watches::changes_stability(const Evaluation &step, TangentSolver &solver)
  {
    bool changes = false;
    for (const auto &watch : watches)
      changes = watch->changes_stability(step, solver) || changes;
    return changes;
  }

  std::vector<Finding> Watches::findings() const
  {
    std::vector<Finding> all;
    for (const auto &watch : watches)
      for (const Finding &finding : watch->findings())
        all.push_back(finding);
    std::stable_sort(all.begin(),
                     all.end(),
                     [](const Finding &one, const Finding &other) {
                       return one.verdict > other.verdict;
                     });
    return all;
  }

  std::optional<double> Watches::largest_penetration() const
  {
    for (const auto &watch : watches)
      if (const auto largest = watch->largest_penetration())
        return largest;
    return std::nullopt;
  }

  void Watches::serialize(CheckpointArchive &archive)
  {
    statistics.serialize(archive);
    for (const auto &watch : watches)
      watch->serialize(archive);
  }
} // namespace auxfem
