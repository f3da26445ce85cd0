#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Complex = std::complex<double>;
    using Values  = std::vector<double>;

    /** Smallest Im s over |s| of an oscillation; round-off scatters clusters of
     * relaxations by up to 1e-4. */
    constexpr double min_oscillation = 1e-3;
  } // namespace

  bool swings(const Complex s)
  {
    return std::abs(s.imag()) > min_oscillation * std::abs(s);
  }

  bool relaxes(const Complex s)
  {
    constexpr double critical = 0.99;
    return -s.real() > critical * std::abs(s);
  }

  /** Krylov space of the shift-and-invert problem. */
  class MotionPencil::Arnoldi
  {
  public:
    /** Requires A(shift) as the factorized matrix. */
    Arnoldi(MotionPencil &pencil, const double shift)
      : pencil(pencil)
      , n(pencil.layout.n_owned())
      , shift(shift)
    {
      // Scaling balances the parts of a vector.
      scale_of_part = {1., 10 * std::abs(shift)};
      for (const RelaxationGroup &relaxing : pencil.relaxing)
        {
          const double largest =
            pencil.space.largest_free(relaxing.stiffness.diagonal());
          scale_of_part.push_back(largest > 0 ? largest : 1.);
        }
      constexpr unsigned int n_start = 3;
      for (unsigned int i = 0; i < n_start; ++i)
        extend(start(i));
    }

    /** Adds a vector; returns false if the space is complete. */
    bool grow()
    {
      if (columns.size() == basis.size())
        return false;
      columns.push_back(extend(image(basis[columns.size()])));
      return columns.size() < basis.size();
    }

    unsigned int size() const
    {
      return columns.size();
    }

    /** A root of the projected problem. */
    struct Ritz
    {
      Complex              s;
      double               residual; ///< over the eigenvalue
      std::vector<Complex> vector;
    };

    /** Ritz pairs, sorted by increasing distance from the shift. */
    std::vector<Ritz> ritz() const
    {
      constexpr double  round_off = 1e-14;
      const std::size_t m         = columns.size();
      Values            projected(m * m, 0.);
      for (std::size_t j = 0; j < m; ++j)
        std::copy_n(columns[j].begin(),
                    std::min(m, columns[j].size()),
                    projected.begin() + j * m);
      std::vector<ComplexEigenpair> pairs = general_eigenpairs(projected, m);
      std::sort(pairs.begin(), pairs.end(), [](const auto &a, const auto &b) {
        return std::abs(a.value) > std::abs(b.value);
      });
      std::vector<Ritz> all;
      for (ComplexEigenpair &pair : pairs)
        if (std::abs(pair.value) > round_off * std::abs(pairs.front().value))
          all.push_back({shift + 1. / pair.value,
                         residual(pair.vector) / std::abs(pair.value),
                         std::move(pair.vector)});
      // Inversion swaps the members of a conjugate pair.
      for (Ritz &one : all)
        if (one.s.imag() < 0)
          {
            one.s = std::conj(one.s);
            for (Complex &part : one.vector)
              part = std::conj(part);
          }
      return all;
    }

    /** The displacements of a vector of ritz(). */
    Values shape(const Ritz &ritz) const
    {
      Values x(2 * n, 0.);
      for (std::size_t j = 0; j < ritz.vector.size(); ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            x[i] += ritz.vector[j].real() * basis[j][i];
            x[n + i] += ritz.vector[j].imag() * basis[j][i];
          }
      return x;
    }

  private:
    /** Start vector in the range of the operator. */
    Values start(const unsigned int number) const
    {
      // The vector has no symmetry that a mode may lack, and is independent of
      // the number of ranks.
      Values w(scale_of_part.size() * n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        w[n + i] = std::sin(
          1. + (0.7 + 0.1 * number) * (pencil.layout.global(i) + number));
      return image(w);
    }

    /** Shift-and-invert operator times @p w. */
    Values image(const Values &w) const
    {
      const std::size_t n_parts = scale_of_part.size();
      const auto        part    = [&](const std::size_t p) {
        Values values(w.begin() + p * n, w.begin() + (p + 1) * n);
        for (double &value : values)
          value *= scale_of_part[p];
        return values;
      };
      // (K + shift C + ...) x = -M (v + shift x) - C x - sum tau q / (1 + shift
      // tau)
      const Values displacements = part(0);
      Values       momenta       = part(1);
      for (unsigned int i = 0; i < n; ++i)
        momenta[i] += shift * displacements[i];
      Values       x = pencil.multiply(pencil.mass, momenta.data());
      const Values damped =
        pencil.multiply(pencil.damping_matrix, displacements.data());
      for (unsigned int i = 0; i < n; ++i)
        x[i] = -x[i] - damped[i];
      for (std::size_t p = 2; p < n_parts; ++p)
        {
          const double time   = pencil.relaxing[p - 2].time,
                       factor = time / (1 + shift * time);
          const Values forces = part(p);
          for (unsigned int i = 0; i < n; ++i)
            x[i] -= factor * forces[i];
        }
      if (!pencil.space.solve(x.data()))
        throw ComputationError(
          "Analysis = modes: " + pencil.solver.last_failure() + '.');
      Values result(w.size());
      for (unsigned int i = 0; i < n; ++i)
        {
          if (!pencil.space.is_free(i))
            x[i] = 0;
          result[i]     = x[i];
          result[n + i] = (shift * x[i] + displacements[i]) / scale_of_part[1];
        }
      for (std::size_t p = 2; p < n_parts; ++p)
        {
          const RelaxationGroup &relaxing = pencil.relaxing[p - 2];
          const Values elastic = pencil.multiply(relaxing.stiffness, x.data());
          const Values forces  = part(p);
          for (unsigned int i = 0; i < n; ++i)
            result[p * n + i] = (elastic[i] - relaxing.time * forces[i]) /
              ((1 + shift * relaxing.time) * scale_of_part[p]);
        }
      return result;
    }

    /**
     * Orthogonalizes @p w, adds the remainder to the basis and returns the
     * coefficients.
     */
    Values extend(Values w)
    {
      Values       coefficients(basis.size(), 0.);
      const double before = length(w);
      // Two passes are enough (Kahan).
      for (unsigned int pass = 0; pass < 2; ++pass)
        {
          Values products(basis.size(), 0.);
          for (std::size_t j = 0; j < basis.size(); ++j)
            for (std::size_t i = 0; i < w.size(); ++i)
              products[j] += basis[j][i] * w[i];
          products = pencil.layout.sum(products);
          for (std::size_t j = 0; j < basis.size(); ++j)
            {
              coefficients[j] += products[j];
              for (std::size_t i = 0; i < w.size(); ++i)
                w[i] -= products[j] * basis[j][i];
            }
        }
      const double rest = length(w);
      if (rest > round_off * before)
        {
          for (double &value : w)
            value /= rest;
          basis.push_back(std::move(w));
          coefficients.push_back(rest);
        }
      return coefficients;
    }

    double length(const Values &w) const
    {
      return auxfem::size(pencil.layout, w);
    }

    double residual(const std::vector<Complex> &vector) const
    {
      double sum = 0;
      for (std::size_t i = columns.size(); i < basis.size(); ++i)
        {
          Complex entry = 0;
          for (std::size_t j = 0; j < columns.size(); ++j)
            if (i < columns[j].size())
              entry += columns[j][i] * vector[j];
          sum += std::norm(entry);
        }
      return std::sqrt(sum);
    }

    MotionPencil       &pencil;
    const unsigned int  n;
    const double        shift;
    Values              scale_of_part;
    std::vector<Values> basis, columns;
  };

  MotionPencil::MotionPencil(TangentSolver &solver,
                             const State   &equilibrium,
                             const Damping  damping)
    : solver(solver)
    , layout(solver.equations().unknowns().layout)
    , space(solver)
    , stiffness(solver, equilibrium, damping)
    , mass(solver.equations().pattern())
    , damping_matrix(solver.equations().pattern())
  {
    const TangentMatrix &at = solver.matrix();
    damping_matrix.reset();
    stiffness.assemble_mass(mass);
    stiffness.set(0.);
    is_symmetric = at.is_symmetric();
    if (damping == Damping::none)
      return;
    for (const double time : solver.equations().relaxation_times())
      {
        relaxing.push_back({time, TangentMatrix(solver.equations().pattern())});
        stiffness.assemble_relaxing_stiffness(time, relaxing.back().stiffness);
      }
    // (A(h) - A(0) - h^2 M - ...) / h
    stiffness.set(0.);
    const double h = fastest_rate();
    damping_matrix.add_multiple(-1 / h, at);
    stiffness.set(h);
    damping_matrix.add_multiple(1 / h, at);
    damping_matrix.add_multiple(-h, mass);
    for (const RelaxationGroup &elements : relaxing)
      damping_matrix.add_multiple(-elements.time / (1 + h * elements.time),
                                  elements.stiffness);
  }

  double MotionPencil::fastest_rate() const
  {
    const double largest_stiffness =
                   space.largest_free(solver.matrix().diagonal()),
                 largest_mass = space.largest_free(mass.diagonal());
    return largest_stiffness > 0 && largest_mass > 0
      ? std::sqrt(largest_stiffness / largest_mass)
      : 1.;
  }

  Values MotionPencil::multiply(const TangentMatrix &matrix,
                                const double        *x) const
  {
    Values y(layout.n_owned());
    space.multiply(matrix, x, y.data());
    return y;
  }

  MotionPencil::Roots MotionPencil::nearest(const double         shift,
                                            const RootSelection &selection)
  {
    constexpr double       converged      = 1e-10;
    constexpr unsigned int check_interval = 10, growth_divisor = 5;
    const unsigned int     max_vectors = 100 + 10 * selection.n;
    stiffness.set(shift);
    if (!solver.factorize())
      throw ComputationError("Analysis = modes: the dynamic stiffness cannot "
                             "be factorized: " +
                             solver.last_failure() + '.');
    Arnoldi                    space_of_motions(*this, shift);
    std::vector<Arnoldi::Ritz> found;
    bool                       is_complete = false, grows = true;
    while (!is_complete && grows && space_of_motions.size() < max_vectors)
      {
        const unsigned int n_new =
          std::max(check_interval, space_of_motions.size() / growth_divisor);
        for (unsigned int i = 0; i < n_new && grows; ++i)
          grows = space_of_motions.grow();
        found.clear();
        bool all_before = true;
        for (Arnoldi::Ritz &ritz : space_of_motions.ritz())
          if (selection.accepts(ritz.s))
            {
              if (grows && !(ritz.residual <= converged))
                {
                  all_before = false;
                  continue;
                }
              const bool is_last = selection.max_magnitude
                ? std::abs(ritz.s) > *selection.max_magnitude
                : found.size() + 1 >= selection.n;
              is_complete        = is_complete || (all_before && is_last);
              found.push_back(std::move(ritz));
            }
      }
    Roots result{{}, is_complete || !grows};
    for (const Arnoldi::Ritz &ritz : found)
      if (!selection.max_magnitude ||
          std::abs(ritz.s) <= *selection.max_magnitude)
        {
          // Roots at -1 / tau have no displacements but round-off.
          constexpr double largest_residual = 1e-3;
          Values           shape            = space_of_motions.shape(ritz);
          if (size(layout, shape) <= sqrt_round_off)
            continue;
          const MotionRoot found_root = root(ritz.s, std::move(shape));
          if (found_root.residual <= largest_residual)
            result.roots.push_back(found_root);
        }
    return result;
  }

  MotionRoot MotionPencil::root(const Complex s, Values shape)
  {
    MotionRoot   root{s, std::move(shape), 0., 0.};
    const double length = size(layout, root.shape);
    for (double &value : root.shape)
      value /= length;
    if (!swings(root.s))
      root.s = root.s.real();
    maximize_real_part(layout, root.shape);
    if (is_symmetric)
      improve(root);
    Values image(root.shape.size());
    stiffness.set(root.s);
    stiffness.multiply(root.shape.data(), image.data());
    root.residual = size(layout, image) /
      (std::abs(root.s) * size(layout, derivative(root.s, root.shape)));
    root.uncertainty =
      std::max(root.uncertainty, root.residual * std::abs(root.s));
    return root;
  }

  /** Newton's method for x.A(s) x = 0. */
  void MotionPencil::improve(MotionRoot &root)
  {
    constexpr double       small = 1e-3, settled = 1e-14;
    constexpr unsigned int max_steps = 4;
    Complex                s         = root.s;
    for (unsigned int i = 0; i < max_steps; ++i)
      {
        const Values slope = derivative(s, root.shape);
        stiffness.set(s); // derivative() has changed it
        const Complex change =
          stiffness.form(root.shape) / product(layout, root.shape, slope);
        // Close to a double root x.A' x is nearly zero.
        if (!(std::abs(change) <= small * std::abs(s)))
          return;
        s -= change;
        root.uncertainty = std::abs(change);
        if (root.uncertainty <= settled * std::abs(s))
          break;
      }
    root.s = s;
  }

  Values MotionPencil::derivative(const Complex s, const Values &x)
  {
    constexpr double relative_step = 1e-4;
    Values           before(x.size()), after(x.size());
    stiffness.set(s * (1. - relative_step));
    stiffness.multiply(x.data(), before.data());
    stiffness.set(s * (1. + relative_step));
    stiffness.multiply(x.data(), after.data());
    const unsigned int n = layout.n_owned();
    for (unsigned int i = 0; i < n; ++i)
      {
        const Complex slope =
          Complex(after[i] - before[i], after[n + i] - before[n + i]) /
          (2. * relative_step * s);
        after[i]     = slope.real();
        after[n + i] = slope.imag();
      }
    return after;
  }

  Complex MotionPencil::mass_product(const Vector &x, const Values &shape) const
  {
    const unsigned int n       = layout.n_owned();
    const Values       inertia = multiply(mass, x.data());
    Values             sums(2, 0.);
    for (unsigned int i = 0; i < n; ++i)
      {
        sums[0] += inertia[i] * shape[i];
        sums[1] += inertia[i] * shape[n + i];
      }
    sums = layout.sum(sums);
    return {sums[0], sums[1]};
  }
} // namespace auxfem
