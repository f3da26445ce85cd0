#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/infinite_lattice/period_tangent.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/scene/infinite_lattice.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace auxfem
{
  namespace
  {
    using Matrix = dealii::FullMatrix<double>;

    /** Groups of inner unknowns that entries couple, by their first member. */
    std::map<int, std::vector<int>>
    groups_of(const std::vector<MatrixEntry> &entries,
              const std::vector<bool>        &is_inner)
    {
      std::vector<int> parent(is_inner.size());
      std::iota(parent.begin(), parent.end(), 0);
      const auto root = [&parent](int u) {
        while (parent[u] != u)
          u = parent[u] = parent[parent[u]];
        return u;
      };
      for (const MatrixEntry &entry : entries)
        if (is_inner[entry.row] && is_inner[entry.column])
          {
            const int one = root(entry.row), other = root(entry.column);
            parent[std::max(one, other)] = std::min(one, other);
          }
      std::map<int, std::vector<int>> groups;
      for (unsigned int u = 0; u < is_inner.size(); ++u)
        if (is_inner[u])
          groups[root(u)].push_back(u);
      return groups;
    }

    /** Positions of numbers in a list that grows. */
    class Positions
    {
    public:
      unsigned int operator()(const int number)
      {
        const auto [entry, is_new] = known.try_emplace(number, numbers.size());
        if (is_new)
          numbers.push_back(number);
        return entry->second;
      }

      std::vector<int> numbers;

    private:
      std::map<int, unsigned int> known;
    };

    double least_eigenvalue(const Matrix &symmetric)
    {
      return symmetric_eigenvalues(symmetric).front();
    }

    /** @p coupling^T @p K^-1 @p coupling: the stiffness that coupled unknowns
     * lose if those of @p K adapt. Throws dealii::ExceptionBase if @p K is
     * singular. */
    Matrix adapted_stiffness(const Matrix &K, const Matrix &coupling)
    {
      Matrix inverse(K.m(), K.m()), motions(K.m(), coupling.n()),
        product(coupling.n(), coupling.n());
      inverse.invert(K);
      inverse.mmult(motions, coupling);
      coupling.Tmmult(product, motions);
      return product;
    }

    /** The stiffness at @p state by global numbers, on the first rank. */
    std::vector<MatrixEntry> stiffness_entries(const Equations &equations,
                                               const State     &state)
    {
      const State       before  = state;
      State             now     = state;
      const Evaluation  at      = Evaluation::equilibrium(before, now);
      EvaluationResults results = equations.make_results();
      equations.residual(at, results);
      TangentMatrix matrix(equations.pattern());
      matrix.reset();
      equations.tangent(at, results, {1., 0., 0.}, matrix);
      return entries_on_first_rank(matrix,
                                   equations.model().numbering.layout());
    }
  } // namespace

  PeriodTangent::PeriodTangent(const Equations &equations, const State &state)
    : dimension(equations.model().lattice.dimension)
    , volume(equations.model().lattice.periodicity->volume() *
             depth_of_continuum(equations.model().plan.scene))
    , strut_length(equations.model().mean_strut_length)
  {
    const LatticeModel      &model   = equations.model();
    std::vector<MatrixEntry> entries = stiffness_entries(equations, state);
    if (model.numbering.layout().rank() != 0)
      return;
    const std::vector<bool> is_inner = classify_unknowns(model);
    touches_next_period = has_contact_with_copies(model, entries, is_inner);
    eliminate(entries, is_inner);
    renumber(is_inner);
    stiffness = PeriodMatrix(components.size());
    for (const MatrixEntry &entry : entries)
      stiffness.add(outer[entry.row].place,
                    outer[entry.column].place,
                    entry.value);
    find_moduli(entries);
  }

  std::vector<bool> PeriodTangent::classify_unknowns(const LatticeModel &model)
  {
    const Lattice       &lattice = model.lattice;
    const GlobalNumbers &numbers = model.numbering.global();
    const PeriodUnknowns period(model);
    outer.resize(model.numbering.layout().n_global());
    for (std::size_t u = 0; u < outer.size(); ++u)
      outer[u].place = period[u];
    std::vector<bool> is_inner(outer.size(), true);
    const auto set_outer = [&](const int number, const unsigned int component) {
      if (number < 0)
        return;
      is_inner[number]        = false;
      outer[number].component = component;
    };
    const auto set_all_outer = [&](const GlobalNumbers::MotionNumbers &motion) {
      for (unsigned int c = 0; c < n_motion_components; ++c)
        set_outer(motion[c], c);
    };
    for (const GlobalNumbers::RigidPartNumbers &part : numbers.rigid_parts)
      {
        n_multipliers += part.multipliers.size();
        for (const int multiplier : part.multipliers)
          set_outer(multiplier, n_motion_components);
        set_all_outer(part.motion);
      }
    for (const GlobalNumbers::RelationNumbers &relation : numbers.relations)
      set_outer(relation.multiplier, n_motion_components);
    for (const GlobalNumbers::MotionNumbers &joint : numbers.joints)
      set_all_outer(joint);
    const auto set_mean_motion = [&](const unsigned int          joint,
                                     const dealii::Tensor<1, 3> &along) {
      for (unsigned int c = 0; c < dimension; ++c)
        for (unsigned int d = 0; d < dimension; ++d)
          outer[numbers.joints[joint][c]].along[d] = along[d];
    };
    for (const JointImage &image : lattice.periodicity->images)
      set_mean_motion(image.joint,
                      lattice.periodicity->translation(image.shift));
    for (unsigned int d = 0; d < lattice.n_axes; ++d)
      set_mean_motion(lattice.joint_of_axis(d),
                      lattice.joints[lattice.joint_of_axis(d)]);
    return is_inner;
  }

  bool PeriodTangent::has_contact_with_copies(
    const LatticeModel             &model,
    const std::vector<MatrixEntry> &entries,
    const std::vector<bool>        &is_inner) const
  {
    std::vector<bool> is_axis(outer.size(), false);
    for (unsigned int d = 0; d < model.lattice.n_axes; ++d)
      for (unsigned int c = 0; c < dimension; ++c)
        is_axis[model.numbering.global()
                  .joints[model.lattice.joint_of_axis(d)][c]] = true;
    // Multipliers and contact with copies alone depend on the mean deformation.
    return std::any_of(entries.begin(),
                       entries.end(),
                       [&](const MatrixEntry &entry) {
                         return is_axis[entry.row] &&
                           (is_inner[entry.column] ||
                            outer[entry.column].component <
                              n_motion_components);
                       });
  }

  void PeriodTangent::renumber(const std::vector<bool> &is_inner)
  {
    std::map<unsigned int, unsigned int> numbers;
    for (std::size_t u = 0; u < outer.size(); ++u)
      if (!is_inner[u] && outer[u].place.number != invalid_index)
        {
          const auto [entry, is_new] =
            numbers.try_emplace(outer[u].place.number, numbers.size());
          outer[u].place.number = entry->second;
          if (is_new)
            components.push_back(outer[u].component);
        }
  }

  void PeriodTangent::eliminate(std::vector<MatrixEntry> &entries,
                                const std::vector<bool>  &is_inner)
  {
    std::vector<std::vector<MatrixEntry>> at_inner(is_inner.size());
    std::vector<MatrixEntry>              condensed;
    for (const MatrixEntry &entry : entries)
      if (is_inner[entry.row])
        at_inner[entry.row].push_back(entry);
      else if (!is_inner[entry.column])
        condensed.push_back(entry);
    for (const auto &[first, group] : groups_of(entries, is_inner))
      {
        Positions inside, outside;
        for (const int u : group)
          inside(u);
        for (const int u : group)
          for (const MatrixEntry &entry : at_inner[u])
            if (!is_inner[entry.column])
              outside(entry.column);
        const unsigned int n = inside.numbers.size(),
                           m = outside.numbers.size();
        Matrix K(n, n), coupling(n, m);
        for (const int u : group)
          for (const MatrixEntry &entry : at_inner[u])
            if (is_inner[entry.column])
              K(inside(u), inside(entry.column)) += entry.value;
            else
              coupling(inside(u), outside(entry.column)) += entry.value;
        inner_is_stable = inner_is_stable && least_eigenvalue(K) > 0;
        if (m == 0)
          continue;
        const Matrix adapted = adapted_stiffness(K, coupling);
        for (unsigned int i = 0; i < m; ++i)
          for (unsigned int j = 0; j < m; ++j)
            condensed.push_back(
              {outside.numbers[i], outside.numbers[j], -adapted(i, j)});
      }
    entries.swap(condensed);
  }

  void PeriodTangent::find_moduli(const std::vector<MatrixEntry> &entries)
  {
    const unsigned int n = stiffness.size(), n_strains = dimension * dimension;
    Matrix             coupling(n, n_strains), direct(n_strains, n_strains);
    // Motion of an unknown: one of the period and parts of the mean strain.
    const auto for_strains = [&](const Outer &at, const auto &action) {
      if (at.component < dimension)
        for (unsigned int d = 0; d < dimension; ++d)
          if (at.along[d] != 0)
            action(dimension * at.component + d, at.along[d]);
    };
    for (const MatrixEntry &entry : entries)
      {
        const Outer       &row = outer[entry.row];
        const unsigned int i   = row.place.number;
        for_strains(outer[entry.column],
                    [&](const unsigned int b, const double along) {
                      if (i != invalid_index)
                        coupling(i, b) += entry.value * along / unit(i);
                      for_strains(row,
                                  [&](const unsigned int a,
                                      const double       other) {
                                    direct(a, b) += entry.value * along * other;
                                  });
                    });
      }
    // At equal phases real and imaginary parts are not coupled.
    const Matrix both = stiffness_in_one_unit({});
    Matrix       K(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        K(i, j) = both(i, j);
    try
      {
        direct.add(-1., adapted_stiffness(K, coupling));
      }
    catch (const dealii::ExceptionBase &)
      {
        return;
      }
    direct *= 1 / volume;
    tangent_moduli = direct;
  }

  double PeriodTangent::unit(const unsigned int number) const
  {
    const unsigned int c = components[number];
    return c >= first_rotation && c < n_motion_components ? strut_length : 1.;
  }

  Matrix PeriodTangent::stiffness_in_one_unit(const WavePhases &phases) const
  {
    Matrix             matrix  = stiffness.at(phases);
    const unsigned int n       = stiffness.size();
    double             largest = 0;
    for (unsigned int i = 0; i < 2 * n; ++i)
      for (unsigned int j = 0; j < 2 * n; ++j)
        {
          matrix(i, j) /= unit(i % n) * unit(j % n);
          largest = std::max(largest, std::abs(matrix(i, j)));
        }
    if (phases == WavePhases{})
      for (unsigned int i = 0; i < 2 * n; ++i)
        for (unsigned int j = 0; j < 2 * n; ++j)
          if (i / n == j / n && components[i % n] < dimension &&
              components[i % n] == components[j % n])
            matrix(i, j) += largest;
    return matrix;
  }

  double PeriodTangent::least_stiffness(const WavePhases &phases) const
  {
    // Each multiplier has a negative eigenvalue of its own, twice as all.
    return symmetric_eigenvalues(
      stiffness_in_one_unit(phases))[2 * n_multipliers];
  }

  unsigned int PeriodTangent::n_mechanisms() const
  {
    // Bending has (height / length)^2 of the stiffness of stretching.
    constexpr double          relative_zero = 1e-9;
    const std::vector<double> values =
      symmetric_eigenvalues(stiffness_in_one_unit({}));
    const double largest = std::max(-values.front(), values.back());
    // Each eigenvalue is there twice.
    return std::count_if(values.begin(),
                         values.end(),
                         [&](const double value) {
                           return std::abs(value) < relative_zero * largest;
                         }) /
      2;
  }

  namespace
  {
    /** Least eigenvalue of the acoustic tensor along @p n (Pa). */
    double acoustic_modulus(const Matrix               &moduli,
                            const unsigned int          dimension,
                            const dealii::Tensor<1, 3> &n)
    {
      Matrix acoustic(dimension, dimension);
      for (unsigned int i = 0; i < dimension; ++i)
        for (unsigned int k = 0; k < dimension; ++k)
          for (unsigned int j = 0; j < dimension; ++j)
            for (unsigned int l = 0; l < dimension; ++l)
              acoustic(i, k) +=
                n[j] * moduli(dimension * i + j, dimension * k + l) * n[l];
      return least_eigenvalue(acoustic);
    }
  } // namespace

  std::pair<double, dealii::Tensor<1, 3>>
  least_acoustic_modulus(const Matrix &moduli)
  {
    const unsigned int dimension = moduli.m() == 4 ? 2 : 3;
    // Directions of half a circle or half a sphere.
    const unsigned int n_turns = dimension == 2 ? 180 : 36,
                       n_tilts = dimension == 2 ? 0 : 18;
    std::pair<double, dealii::Tensor<1, 3>> least{
      std::numeric_limits<double>::infinity(),
      {}};
    for (unsigned int tilt = 0; tilt <= n_tilts; ++tilt)
      for (unsigned int turn = 0; turn < n_turns; ++turn)
        {
          const double a = dealii::numbers::PI * turn / n_turns *
            (dimension == 2 ? 1 : 2),
                       b         = n_tilts == 0
                    ? 0
                    : dealii::numbers::PI_2 * tilt / n_tilts;
          dealii::Tensor<1, 3> n = dealii::Point<3>(std::cos(a) * std::cos(b),
                                                    std::sin(a) * std::cos(b),
                                                    std::sin(b));
          for (unsigned int d = 0; d < 3; ++d)
            if (std::abs(n[d]) < round_off)
              n[d] = 0;
          const double value = acoustic_modulus(moduli, dimension, n);
          // Directions that symmetry makes equal differ by round-off.
          if (std::isinf(least.first) ||
              value < least.first - 1e-9 * std::abs(least.first))
            least = {value, n};
        }
    return least;
  }
} // namespace auxfem
