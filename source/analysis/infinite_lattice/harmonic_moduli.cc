#include <auxfem/analysis/infinite_lattice/harmonic_moduli.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/mathematics/voigt.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <limits>
#include <sstream>

namespace auxfem
{
  std::optional<dealii::FullMatrix<std::complex<double>>>
  HarmonicModuli::compliance() const
  {
    dealii::FullMatrix<std::complex<double>> inverse = stiffness;
    try
      {
        inverse.gauss_jordan();
      }
    catch (const dealii::ExceptionBase &)
      {
        return std::nullopt;
      }
    return inverse;
  }

  RunPlan with_damping(RunPlan plan)
  {
    const EffectSwitches &asked      = plan.scene.effects;
    plan.effects.connector_viscosity = asked.connector_viscosity;
    plan.effects.strut_damping       = asked.strut_damping;
    plan.effects.strut_relaxation    = asked.strut_relaxation;
    include_damping(plan.effects);
    return plan;
  }

  bool has_damping(const SimulatedEffects &simulated)
  {
    return simulated.connector_viscosity || simulated.strut_damping ||
      simulated.strut_relaxation;
  }

  namespace
  {
    /** Complex mean stresses of one period at one frequency. */
    class HarmonicPeriod
    {
    public:
      explicit HarmonicPeriod(LatticeRun &run)
        : model(run.model)
        , layout(run.model.numbering.layout())
        , solver(run.solver())
        , stiffness(run.solver(), run.solution.state)
      {}

      HarmonicModuli at(const double frequency)
      {
        const unsigned int dimension = model.lattice.dimension,
                           n         = n_strain_components(dimension);
        stiffness.set({0., 2 * dealii::numbers::PI * frequency});
        if (!stiffness.factorize())
          fail(frequency, solver.last_failure());
        HarmonicModuli moduli{frequency,
                              dealii::FullMatrix<std::complex<double>>(n, n)};
        for (unsigned int j = 0; j < n; ++j)
          {
            const std::vector<double> b = unit_strain(j);
            std::vector<double>       x(b.size(), 0.);
            if (const std::string why = stiffness.solve(b, x); !why.empty())
              fail(frequency, why);
            std::vector<double> stresses;
            for (unsigned int i = 0; i < n; ++i)
              for (const unsigned int first : {0u, layout.n_owned()})
                stresses.push_back(
                  sum_of_owned(symmetric_stress_terms(model, i),
                               x.data() + first));
            stresses = layout.sum(stresses);
            for (unsigned int i = 0; i < n; ++i)
              moduli.stiffness(i, j) = {stresses[2 * i], stresses[2 * i + 1]};
          }
        return moduli;
      }

    private:
      [[noreturn]] static void fail(const double       frequency,
                                    const std::string &why)
      {
        std::ostringstream message;
        message << "No storage and loss moduli were found at " << frequency
                << " Hz: " << why;
        throw ComputationError(message.str());
      }

      /** Prescribed motions of the strain component @p i. */
      std::vector<double> unit_strain(const unsigned int i) const
      {
        const Lattice      &lattice = model.lattice;
        std::vector<double> b(2 * layout.n_owned(), 0.);
        const auto [k, l]   = axes_of_component(i, lattice.dimension);
        const double length = lattice.periodicity->length();
        for (const auto &[a, d] : {std::pair(k, l), std::pair(l, k)})
          if (const int unknown =
                model.numbering.joint_unknown(lattice.joint_of_axis(d), a);
              layout.is_owned(unknown))
            b[unknown] = k == l ? length : length / 2;
        return b;
      }

      const LatticeModel  &model;
      const UnknownLayout &layout;
      TangentSolver       &solver;
      DynamicStiffness     stiffness;
    };
  } // namespace

  std::vector<HarmonicModuli>
  harmonic_moduli(LatticeRun &run, const std::vector<double> &frequencies)
  {
    HarmonicPeriod              period(run);
    std::vector<HarmonicModuli> all;
    for (const double frequency : frequencies)
      {
        end_if_interrupted(run.model.numbering.layout().communicator());
        all.push_back(period.at(frequency));
      }
    return all;
  }

  namespace
  {
    void add_columns(const std::string   &name,
                     const std::string   &meaning,
                     std::vector<Column> &columns)
    {
      columns.push_back({name + "_storage", "Pa", meaning + ", storage"});
      columns.push_back({name + "_loss", "Pa", meaning + ", loss"});
    }

    void add_cells(const std::complex<double> &value, std::vector<double> &row)
    {
      row.push_back(value.real());
      row.push_back(value.imag());
    }
  } // namespace

  void write_harmonic_moduli(const std::vector<HarmonicModuli> &moduli,
                             const std::string                 &folder)
  {
    if (moduli.empty())
      return;
    const unsigned int n         = moduli.front().stiffness.m(),
                       dimension = n == 3 ? 2 : 3;
    std::vector<Column> columns  = {
       {"frequency", "Hz", "of the mean strain or stress"}};
    for (unsigned int i = 0; i < n; ++i)
      if (i < dimension)
        add_columns("E" + std::to_string(i + 1),
                    "Young's modulus along an axis",
                    columns);
      else
        add_columns("G" + name_of_component(i, dimension),
                    "shear modulus between two axes",
                    columns);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i; j < n; ++j)
        add_columns("C_" + name_of_component(i, dimension) + "_" +
                      name_of_component(j, dimension),
                    "stiffness",
                    columns);
    CsvTable table(folder + "/moduli.csv", columns);
    write_column_reference(folder + "/moduli.units.csv", columns);
    for (const HarmonicModuli &at : moduli)
      {
        std::vector<double> row        = {at.frequency};
        const auto          compliance = at.compliance();
        for (unsigned int i = 0; i < n; ++i)
          add_cells(compliance ? 1. / (*compliance)(i, i)
                               : std::numeric_limits<double>::quiet_NaN(),
                    row);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = i; j < n; ++j)
            add_cells(at.stiffness(i, j), row);
        table.append(row);
      }
  }
} // namespace auxfem
