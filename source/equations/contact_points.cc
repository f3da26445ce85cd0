#include <auxfem/equations/contact_points.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace auxfem
{
  namespace
  {
    /** Gauss-Lobatto points and the shape functions there. */
    struct PointTable
    {
      PointTable(const unsigned int order, const unsigned int n) : points(n)
      {
        const dealii::FE_Q<1> element(order);
        ContactPoints::Shape  values(n, order + 1);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int a = 0; a <= order; ++a)
            values(i, a) = element.shape_value(a, points.point(i));
        shape = std::make_shared<const ContactPoints::Shape>(values);
      }

      dealii::QGaussLobatto<1>                    points;
      std::shared_ptr<const ContactPoints::Shape> shape;
    };

    /** Those of order p at n points, made once. */
    class PointTables
    {
    public:
      const PointTable &get(const unsigned int order, const unsigned int n)
      {
        return tables.try_emplace({order, n}, order, n).first->second;
      }

    private:
      std::map<std::pair<unsigned int, unsigned int>, PointTable> tables;
    };

    /** About one point for each thickness, enough for the shape functions. */
    unsigned int n_points(const ContactAxis &axis, const bool is_rigid_arc)
    {
      constexpr unsigned int most = 24;
      // Between its ends a rigid arc does not move as they do.
      if (is_rigid_arc)
        return 2;
      const double fine = axis.half_thickness > 0
        ? std::ceil(axis.length / (2 * axis.half_thickness)) + 1
        : double(most);
      return std::clamp<double>(fine, axis.order + 2, most);
    }
  } // namespace

  std::vector<ContactPoints>
  make_contact_points(const Lattice                  &lattice,
                      const std::vector<ContactAxis> &axes)
  {
    PointTables                tables;
    std::vector<ContactPoints> all;
    for (const ContactAxis &axis : axes)
      {
        const Strut      &strut = lattice.struts[axis.strut];
        const PointTable &table =
          tables.get(axis.order,
                     n_points(axis, strut.is_rigid() && strut.sagitta != 0));
        ContactPoints of_axis;
        of_axis.shape = table.shape;
        for (unsigned int i = 0; i < table.points.size(); ++i)
          {
            const double s =
              axis.begin + (axis.end - axis.begin) * table.points.point(i)[0];
            dealii::Point<3>     position;
            dealii::Tensor<1, 3> tangent;
            lattice.axis(strut, s, position, tangent);
            of_axis.rest.push_back(position);
            const bool is_end = (i == 0 && axis.begin == 0) ||
              (i + 1 == table.points.size() && axis.end == 1);
            of_axis.weights.push_back(table.points.weight(i) * axis.length +
                                      (is_end ? axis.half_thickness : 0.));
          }
        all.push_back(std::move(of_axis));
      }
    return all;
  }

  dealii::Tensor<1, 3>
  ContactPoints::displacement(const unsigned int  point,
                              const unsigned int  dimension,
                              const int *const    unknowns,
                              const double *const values) const
  {
    dealii::Tensor<1, 3> result;
    for (unsigned int a = 0; a < shape->size(1); ++a)
      for (unsigned int c = 0; c < dimension; ++c)
        result[c] += (*shape)(point, a) * values[unknowns[a * dimension + c]];
    return result;
  }
} // namespace auxfem
