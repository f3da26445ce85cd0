#include <auxfem/struts/shapes/saint_venant.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace auxfem
{
  namespace
  {
    using Values = dealii::Vector<double>;

    /** Degree of the elements: warping along thin walls is a polynomial of
     * degree 3. */
    constexpr unsigned int degree = 4;

    /** Halvings of the elements at re-entrant corners: the error of the
     * singular stresses there falls by 2^(4/3) with each. */
    constexpr unsigned int n_halvings = 6;

    /** Inner product in four partial sums, which compilers vectorize. */
    double inner_product(const double *a, const double *b, const std::size_t n)
    {
      double      sums[4] = {0, 0, 0, 0};
      std::size_t i       = 0;
      for (; i + 4 <= n; i += 4)
        for (unsigned int k = 0; k < 4; ++k)
          sums[k] += a[i + k] * b[i + k];
      for (; i < n; ++i)
        sums[0] += a[i] * b[i];
      return (sums[0] + sums[1]) + (sums[2] + sums[3]);
    }

    /** Cholesky factor of a positive definite matrix within its envelope
     * (Jennings 1966). */
    class EnvelopeCholesky
    {
    public:
      explicit EnvelopeCholesky(const dealii::SparseMatrix<double> &matrix)
        : rows(matrix.m())
        , first(matrix.m())
      {
        for (std::size_t i = 0; i < rows.size(); ++i)
          {
            first[i] = i;
            for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
              first[i] = std::min<std::size_t>(first[i], entry->column());
            rows[i].resize(i - first[i] + 1);
            for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
              if (entry->column() <= i)
                rows[i][entry->column() - first[i]] = entry->value();
            factorize_row(i);
          }
      }

      void solve(Values &x) const
      {
        for (std::size_t i = 0; i < rows.size(); ++i)
          x[i] = (x[i] -
                  inner_product(rows[i].data(),
                                x.begin() + first[i],
                                i - first[i])) /
            rows[i].back();
        for (std::size_t i = rows.size(); i-- > 0;)
          {
            x[i] /= rows[i].back();
            for (std::size_t k = first[i]; k < i; ++k)
              x[k] -= rows[i][k - first[i]] * x[i];
          }
      }

    private:
      void factorize_row(const std::size_t i)
      {
        for (std::size_t j = first[i]; j <= i; ++j)
          {
            const std::size_t begin = std::max(first[i], first[j]);
            double           &entry = rows[i][j - first[i]];
            entry -= inner_product(&rows[i][begin - first[i]],
                                   &rows[j][begin - first[j]],
                                   j - begin);
            entry = j < i ? entry / rows[j].back() : std::sqrt(entry);
          }
      }

      std::vector<std::vector<double>> rows;
      std::vector<std::size_t>         first;
    };

    /** Divides each triangle into three quadrilaterals by its centroid and the
     * middles of its sides. */
    void make_quadrilaterals(const TriangulatedSection &section,
                             const double               scale,
                             dealii::Triangulation<2>  &mesh)
    {
      std::vector<dealii::Point<2>> points = section.points;
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> middles;
      const auto middle = [&](const unsigned int a, const unsigned int b) {
        const auto [entry, is_new] =
          middles.insert({std::minmax(a, b), points.size()});
        if (is_new)
          points.push_back((points[a] + points[b]) / 2);
        return entry->second;
      };
      std::vector<dealii::CellData<2>> cells;
      for (const auto &[a, b, c] : section.triangles)
        {
          const unsigned int ab = middle(a, b), bc = middle(b, c),
                             ca = middle(c, a), center = points.size();
          points.push_back((points[a] + points[b] + points[c]) / 3);
          for (const auto &vertices :
               {std::array<unsigned int, 4>{{a, ab, ca, center}},
                std::array<unsigned int, 4>{{b, bc, ab, center}},
                std::array<unsigned int, 4>{{c, ca, bc, center}}})
            {
              cells.emplace_back();
              cells.back().vertices.assign(vertices.begin(), vertices.end());
            }
        }
      for (dealii::Point<2> &point : points)
        point /= scale;
      dealii::GridTools::consistently_order_cells(cells);
      mesh.create_triangulation(points, cells, dealii::SubCellData());
    }

    /** The three problems on one mesh. Lengths are over the root of the area.
     */
    class SaintVenantProblems
    {
    public:
      explicit SaintVenantProblems(const TriangulatedSection &section)
        : fe(degree)
        , scale(root_of_area(section))
      {
        make_quadrilaterals(section, scale, mesh);
        for (unsigned int i = 0; i < n_halvings; ++i)
          refine_at(section.reentrant_corners);
        dofs.reinit(mesh);
      }

      /** Constants on the present mesh (m2, m4). */
      SaintVenantConstants solve()
      {
        dofs.distribute_dofs(fe);
        dealii::DoFRenumbering::Cuthill_McKee(dofs);
        constrain();
        assemble();
        const EnvelopeCholesky factor(matrix);
        std::array<double, 3>  energies;
        std::array<Values, 3>  solutions = right_sides;
        for (unsigned int i = 0; i < 3; ++i)
          {
            factor.solve(solutions[i]);
            energies[i] = solutions[i] * right_sides[i];
            constraints.distribute(solutions[i]);
          }
        const double square  = scale * scale;
        const double torsion = moments[0] + moments[1] - energies[2];
        return {square * square * torsion,
                {{square * moments[0] * moments[0] / energies[0],
                  square * moments[1] * moments[1] / energies[1]}},
                stress_points(solutions, torsion)};
      }

    private:
      void refine_at(const std::vector<dealii::Point<2>> &corners)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          for (const unsigned int v : cell->vertex_indices())
            for (const dealii::Point<2> &corner : corners)
              if (cell->vertex(v).distance(corner / scale) < 1e-9)
                cell->set_refine_flag();
        mesh.execute_coarsening_and_refinement();
      }

      static double root_of_area(const TriangulatedSection &section)
      {
        double sum = 0;
        for (const auto &[a, b, c] : section.triangles)
          sum +=
            twice_area(section.points[a], section.points[b], section.points[c]);
        return std::sqrt(sum / 2);
      }

      /** Continuity at hanging nodes; solutions are unique but for a constant,
       * which one fixed value removes. */
      void constrain()
      {
        constraints.clear();
        dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
        unsigned int fixed = 0;
        while (constraints.is_constrained(fixed))
          ++fixed;
        constraints.add_line(fixed);
        constraints.close();
        dealii::DynamicSparsityPattern dynamic(dofs.n_dofs());
        dealii::DoFTools::make_sparsity_pattern(dofs,
                                                dynamic,
                                                constraints,
                                                false);
        matrix.clear();
        pattern.copy_from(dynamic);
        matrix.reinit(pattern);
      }

      void assemble()
      {
        const dealii::QGauss<2>    rule(degree + 1);
        dealii::FEValues<2>        values(fe,
                                   rule,
                                   dealii::update_values |
                                     dealii::update_gradients |
                                     dealii::update_quadrature_points |
                                     dealii::update_JxW_values);
        const unsigned int         n = fe.n_dofs_per_cell();
        dealii::FullMatrix<double> stiffness(n, n);
        std::array<Values, 3>      loads;
        loads.fill(Values(n));
        for (Values &side : right_sides)
          side.reinit(dofs.n_dofs());
        moments = {{0., 0.}};
        std::vector<dealii::types::global_dof_index> numbers(n);
        for (const auto &cell : dofs.active_cell_iterators())
          {
            values.reinit(cell);
            stiffness = 0;
            for (Values &load : loads)
              load = 0;
            for (unsigned int q = 0; q < rule.size(); ++q)
              add_point(values, q, stiffness, loads);
            cell->get_dof_indices(numbers);
            constraints.distribute_local_to_global(stiffness, numbers, matrix);
            for (unsigned int i = 0; i < 3; ++i)
              constraints.distribute_local_to_global(loads[i],
                                                     numbers,
                                                     right_sides[i]);
          }
      }

      void add_point(const dealii::FEValues<2>  &values,
                     const unsigned int          q,
                     dealii::FullMatrix<double> &stiffness,
                     std::array<Values, 3>      &loads)
      {
        const double            weight = values.JxW(q);
        const dealii::Point<2> &x      = values.quadrature_point(q);
        moments[0] += weight * x[0] * x[0];
        moments[1] += weight * x[1] * x[1];
        for (unsigned int a = 0; a < stiffness.m(); ++a)
          {
            const auto gradient = weight * values.shape_grad(a, q);
            for (unsigned int b = 0; b < stiffness.n(); ++b)
              stiffness(a, b) += gradient * values.shape_grad(b, q);
            const double value = weight * values.shape_value(a, q);
            loads[0][a] += value * x[0];
            loads[1][a] += value * x[1];
            loads[2][a] += x[1] * gradient[0] - x[0] * gradient[1];
          }
      }

      /** Stresses at the vertices of cells away from re-entrant corners, means
       * over the cells around them. */
      std::vector<StressPoint>
      stress_points(const std::array<Values, 3> &solutions,
                    const double                 torsion) const
      {
        const dealii::QTrapezoid<2>                                  vertices;
        dealii::FEValues<2>                                          values(fe,
                                   vertices,
                                   dealii::update_gradients |
                                     dealii::update_quadrature_points);
        std::map<unsigned int, std::pair<StressPoint, unsigned int>> sums;
        std::array<std::vector<dealii::Tensor<1, 2>>, 3>             gradients;
        gradients.fill(std::vector<dealii::Tensor<1, 2>>(vertices.size()));
        for (const auto &cell : dofs.active_cell_iterators())
          {
            if (cell->level() > 0)
              continue;
            values.reinit(cell);
            for (unsigned int i = 0; i < 3; ++i)
              values.get_function_gradients(solutions[i], gradients[i]);
            for (unsigned int v = 0; v < vertices.size(); ++v)
              {
                const dealii::Point<2> &x = values.quadrature_point(v);
                auto &[point, n]          = sums[cell->vertex_index(v)];
                point.y                   = scale * x[0];
                point.z                   = scale * x[1];
                ++n;
                for (unsigned int d = 0; d < 2; ++d)
                  {
                    const double turned = d == 0 ? -x[1] : x[0];
                    point.by_shear_2[d] += gradients[0][v][d] / moments[0];
                    point.by_shear_3[d] += gradients[1][v][d] / moments[1];
                    point.by_torque[d] +=
                      (gradients[2][v][d] + turned) / torsion;
                  }
              }
          }
        std::vector<StressPoint> points;
        for (auto &[vertex, sum] : sums)
          {
            auto &[point, n] = sum;
            for (unsigned int d = 0; d < 2; ++d)
              {
                point.by_shear_2[d] /= n * scale * scale;
                point.by_shear_3[d] /= n * scale * scale;
                point.by_torque[d] /= n * scale * scale * scale;
              }
            points.push_back(point);
          }
        return points;
      }

      dealii::Triangulation<2>          mesh;
      const dealii::FE_Q<2>             fe;
      dealii::DoFHandler<2>             dofs;
      dealii::AffineConstraints<double> constraints;
      dealii::SparsityPattern           pattern;
      dealii::SparseMatrix<double>      matrix;
      /** Shear along axes 2 and 3, torsion. */
      std::array<Values, 3> right_sides;
      /** Integrals of y^2 and z^2. */
      std::array<double, 2> moments = {{0., 0.}};
      const double          scale;
    };
  } // namespace

  SaintVenantConstants solve_saint_venant(const TriangulatedSection &section)
  {
    SaintVenantProblems problems(section);
    return problems.solve();
  }
} // namespace auxfem
