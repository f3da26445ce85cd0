#include <auxfem/equations/contact_axes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace auxfem
{
  namespace
  {
    /** What the rank that owns an element knows of it. */
    struct AxisElement
    {
      unsigned int     strut = 0, order = 1;
      double           begin = 0, end = 1; ///< fractions of the strut's length
      std::vector<int> unknowns;
      bool             is_owned = false;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &strut &order &begin &end &unknowns;
      }
    };

    std::vector<AxisElement>
    elements_of_this_rank(const DofNumbering &numbering)
    {
      const unsigned int       dimension = numbering.lattice().dimension;
      std::vector<AxisElement> mine;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const DofNumbering::Element &element = numbering.elements()[e];
          if (!element.is_owned)
            continue;
          AxisElement axis{element.interval.strut,
                           element.order,
                           element.interval.begin,
                           element.interval.end,
                           {},
                           true};
          for (unsigned int node = 0; node <= element.order; ++node)
            for (unsigned int c = 0; c < dimension; ++c)
              axis.unknowns.push_back(
                numbering.layout().global(numbering.element_unknowns(
                  e)[node * numbering.n_components() + c]));
          mine.push_back(axis);
        }
      return mine;
    }

    std::vector<AxisElement> rigid_struts(const DofNumbering &numbering)
    {
      const Lattice           &lattice = numbering.lattice();
      std::vector<AxisElement> all;
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        if (lattice.struts[s].is_rigid())
          {
            AxisElement axis;
            axis.strut = s;
            for (const unsigned int joint : lattice.struts[s].joints)
              for (unsigned int c = 0; c < lattice.dimension; ++c)
                axis.unknowns.push_back(numbering.global().joints[joint][c]);
            axis.is_owned = numbering.layout().is_owned(
              numbering.layout().local(axis.unknowns.front()));
            all.push_back(axis);
          }
      return all;
    }

    /** Of all ranks, in the order of the struts. Collective. */
    std::vector<AxisElement> all_elements(const DofNumbering &numbering)
    {
      const MPI_Comm           communicator = numbering.layout().communicator();
      std::vector<AxisElement> all          = rigid_struts(numbering);
      std::vector<AxisElement> mine         = elements_of_this_rank(numbering);
      if (numbering.layout().n_ranks() == 1)
        all.insert(all.end(), mine.begin(), mine.end());
      else
        {
          const auto of_ranks =
            dealii::Utilities::MPI::all_gather(communicator, mine);
          for (unsigned int rank = 0; rank < of_ranks.size(); ++rank)
            for (AxisElement element : of_ranks[rank])
              {
                element.is_owned = rank == numbering.layout().rank();
                all.push_back(element);
              }
        }
      std::sort(all.begin(),
                all.end(),
                [](const AxisElement &a, const AxisElement &b) {
                  return std::pair(a.strut, a.begin) <
                    std::pair(b.strut, b.begin);
                });
      return all;
    }

    /** Half the thickness of a strut (m): in the plane that in it, in space the
     * smaller one. */
    double half_thickness(const Section &section, const unsigned int dimension)
    {
      const auto &fibres = section.fibre_distances;
      return dimension == 2 ? fibres[1] : std::min(fibres[0], fibres[1]);
    }

    /** What sections are to contact, and what rigid struts are. */
    class ContactSections
    {
    public:
      ContactSections(const LatticeModel &model, const double factor)
        : model(model)
        , factor(factor)
      {
        for (const Section &section : model.sections)
          if (const double h = half_thickness(section, model.lattice.dimension);
              h > 0)
            stiffest = std::max(stiffest, stiffness(section, h));
      }

      /** Writes half the thickness and the stiffness. */
      void set(ContactAxis &axis) const
      {
        const Strut &strut  = model.lattice.struts[axis.strut];
        axis.half_thickness = 0;
        axis.stiffness      = stiffest;
        if (!strut.is_rigid())
          {
            const Section &section = model.sections[strut.section];
            axis.half_thickness =
              half_thickness(section, model.lattice.dimension);
            axis.stiffness = axis.half_thickness > 0
              ? stiffness(section, axis.half_thickness)
              : 0.;
          }
      }

    private:
      /** Of the half of a strut between its axis and its face. */
      double stiffness(const Section &section, const double h) const
      {
        return factor * section.axial_stiffness() / (2 * h * h);
      }

      const LatticeModel &model;
      const double        factor;
      double              stiffest = 0;
    };

    /** Gauss-Lobatto points and the shape functions there. */
    struct PointTable
    {
      PointTable(const unsigned int order, const unsigned int n) : points(n)
      {
        const dealii::FE_Q<1> element(order);
        ContactAxis::Shape    values(n, order + 1);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int a = 0; a <= order; ++a)
            values(i, a) = element.shape_value(a, points.point(i));
        shape = std::make_shared<const ContactAxis::Shape>(values);
      }

      dealii::QGaussLobatto<1>                  points;
      std::shared_ptr<const ContactAxis::Shape> shape;
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
    unsigned int n_points(const AxisElement &element,
                          const double       length,
                          const double       half_thickness,
                          const bool         is_rigid_arc)
    {
      constexpr unsigned int most = 24;
      // Between its ends a rigid arc does not move as they do.
      if (is_rigid_arc)
        return 2;
      const double fine = half_thickness > 0
        ? std::ceil(length / (2 * half_thickness)) + 1
        : double(most);
      return std::clamp<double>(fine, element.order + 2, most);
    }
  } // namespace

  std::vector<ContactAxis> make_contact_axes(const LatticeModel &model,
                                             const double stiffness_factor)
  {
    const Lattice           &lattice = model.lattice;
    const ContactSections    sections(model, stiffness_factor);
    PointTables              tables;
    std::vector<ContactAxis> axes;
    for (AxisElement &element : all_elements(model.numbering))
      {
        const Strut &strut = lattice.struts[element.strut];
        ContactAxis  axis;
        axis.strut    = element.strut;
        axis.begin    = element.begin;
        axis.end      = element.end;
        axis.unknowns = std::move(element.unknowns);
        axis.is_owned = element.is_owned;
        sections.set(axis);
        const double length =
          (element.end - element.begin) * lattice.length(strut);
        const PointTable &table =
          tables.get(element.order,
                     n_points(element,
                              length,
                              axis.half_thickness,
                              strut.is_rigid() && strut.sagitta != 0));
        const auto &points = table.points;
        axis.length        = length;
        axis.shape         = table.shape;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const double s = element.begin +
              (element.end - element.begin) * points.point(i)[0];
            dealii::Point<3>     position;
            dealii::Tensor<1, 3> tangent;
            lattice.axis(strut, s, position, tangent);
            axis.rest.push_back(position);
            const bool is_end = (i == 0 && element.begin == 0) ||
              (i + 1 == points.size() && element.end == 1);
            axis.weights.push_back(points.weight(i) * length +
                                   (is_end ? axis.half_thickness : 0.));
          }
        axis.ends = {{axis.rest.front(), axis.rest.back()}};
        axes.push_back(std::move(axis));
      }
    return axes;
  }

  dealii::Tensor<1, 3> displacement_of(const ContactAxis &axis,
                                       const unsigned int point,
                                       const unsigned int dimension,
                                       const int         *unknowns,
                                       const double      *values)
  {
    dealii::Tensor<1, 3> result;
    for (unsigned int a = 0; a < axis.n_nodes(); ++a)
      for (unsigned int c = 0; c < dimension; ++c)
        result[c] +=
          (*axis.shape)(point, a) * values[unknowns[a * dimension + c]];
    return result;
  }
} // namespace auxfem
