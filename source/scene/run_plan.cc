#include <auxfem/scene/run_plan.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string division_record = "elements of the struts",
                      report_record   = "search of the elements of the struts",
                      kinematics_name = "large rotation",
                      kinematics_record = "decision on " + kinematics_name;

    template <class Decisions>
    auto &find(Decisions &decisions, const std::string &name)
    {
      return *std::find_if(decisions.begin(),
                           decisions.end(),
                           [&name](const EffectDecision &decision) {
                             return decision.name == name;
                           });
    }

    void save_elements(const ChosenElements &chosen, CheckpointData &records)
    {
      std::vector<double> numbers;
      for (const StrutDivision &division : chosen.divisions)
        {
          numbers.push_back(division.order);
          numbers.push_back(division.n_elements);
        }
      const OrderReport &report = chosen.report;
      records.keep(division_record, numbers);
      records.keep(report_record,
                   {report.tolerance,
                    report.predicted_error,
                    double(report.unknowns),
                    double(report.steps),
                    double(report.iterations),
                    report.cpu_seconds,
                    report.reached});
    }

    ChosenElements restored_elements(const CheckpointData &records)
    {
      const std::vector<double> numbers =
        records.values(division_record,
                       records.values_per_item(division_record));
      const std::vector<double> values = records.values(report_record, 7);
      ChosenElements            chosen;
      for (std::size_t i = 0; i < numbers.size(); i += 2)
        chosen.divisions.push_back({static_cast<unsigned int>(numbers[i]),
                                    static_cast<unsigned int>(numbers[i + 1])});
      OrderReport &report    = chosen.report;
      report.tolerance       = values[0];
      report.predicted_error = values[1];
      report.unknowns        = values[2];
      report.steps           = values[3];
      report.iterations      = values[4];
      report.cpu_seconds     = values[5];
      report.reached         = values[6];
      return chosen;
    }
  } // namespace

  EffectDecision &SimulatedEffects::decision(const std::string &name)
  {
    return find(decisions, name);
  }

  const EffectDecision &
  SimulatedEffects::decision(const std::string &name) const
  {
    return find(decisions, name);
  }

  RunPlan::RunPlan(const Scene &scene)
    : scene(scene)
    , analysis(scene.analysis)
    , time(scene.time)
    , newton(scene.newton)
    , solver(scene.solver)
    , effects(scene.effects)
    , division(scene.discretization.common_division())
  {}

  const std::vector<JointLoadDefinition> &RunPlan::joint_loads() const
  {
    static const std::vector<JointLoadDefinition> none;
    return has_joint_loads ? scene.joint_loads : none;
  }

  const std::vector<InitialVelocityDefinition> &
  RunPlan::initial_velocities() const
  {
    static const std::vector<InitialVelocityDefinition> none;
    return has_initial_velocities ? scene.initial_velocities : none;
  }

  void RunPlan::save(CheckpointData &records) const
  {
    const EffectDecision &decision = simulated.decision(kinematics_name);
    const auto           &measure  = decision.measure;
    records.keep(kinematics_record,
                 {decision.on ? 1. : 0.,
                  measure ? 1. : 0.,
                  measure ? measure->change : 0.});
    records.keep_text(kinematics_record + ", reason", decision.reason);
    records.keep_text(kinematics_record + ", measure of",
                      measure ? measure->of : "");
    if (elements)
      save_elements(*elements, records);
  }

  void RunPlan::restore(const CheckpointData &records)
  {
    const std::vector<double> values = records.values(kinematics_record, 3);
    kinematics                       = {kinematics_name,
                                        values[0] != 0,
                                        records.text(kinematics_record + ", reason")};
    if (values[1] != 0)
      kinematics->measure =
        EffectMeasure{values[2],
                      records.text(kinematics_record + ", measure of")};
    if (records.has(division_record))
      elements = restored_elements(records);
  }
} // namespace auxfem
