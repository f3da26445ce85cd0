#include <auxfem/contact/effects/contact_axes.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** Contact thickness and stiffness of sections and rigid struts. */
    class ContactSections
    {
    public:
      ContactSections(const LatticeModel &model, const double factor)
        : model(model)
        , factor(factor)
      {
        for (const Section &section : model.sections)
          if (const double h =
                section.contact_half_thickness(model.lattice.dimension);
              h > 0)
            stiffest = std::max(stiffest, stiffness(section, h));
      }

      /** Sets half thickness and stiffness. */
      void set(ContactAxis &axis) const
      {
        const Strut &strut  = model.lattice.struts[axis.strut];
        axis.half_thickness = 0;
        axis.stiffness      = stiffest;
        if (strut.section == invalid_index)
          return;
        const Section section =
          model.sections[strut.section].at((axis.begin + axis.end) / 2);
        axis.half_thickness =
          section.contact_half_thickness(model.lattice.dimension);
        if (!strut.is_rigid())
          axis.stiffness = axis.half_thickness > 0
            ? stiffness(section, axis.half_thickness)
            : 0.;
      }

    private:
      /** Stiffness of the half strut between axis and face (N/m2). */
      double stiffness(const Section &section, const double h) const
      {
        return factor * section.axial_stiffness() / (2 * h * h);
      }

      const LatticeModel &model;
      const double        factor;
      double              stiffest = 0;
    };

    /** Axis of an element or a rigid strut, without half thickness and
     * stiffness.
     * @param unknowns scratch storage */
    ContactAxis axis_of(const DofNumbering  &numbering,
                        const StrutInterval &element,
                        const unsigned int   order,
                        std::vector<int>    &unknowns)
    {
      const Lattice &lattice = numbering.lattice();
      const Strut   &strut   = lattice.struts[element.strut];
      ContactAxis    axis;
      axis.strut  = element.strut;
      axis.line   = element.strut;
      axis.begin  = element.begin;
      axis.end    = element.end;
      axis.order  = order;
      axis.length = (element.end - element.begin) * lattice.length(strut);
      dealii::Tensor<1, 3> tangent;
      lattice.axis(strut, axis.begin, axis.ends[0], tangent);
      lattice.axis(strut, axis.end, axis.ends[1], tangent);

      unknowns.clear();
      axis.unknowns.reserve(std::size_t(order + 1) * lattice.dimension);
      numbering.global().add_element(lattice, element, order, unknowns);
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (i % numbering.n_components() < lattice.dimension)
          axis.unknowns.push_back(unknowns[i]);
      axis.is_owned = numbering.layout().owner(axis.unknowns.back()) ==
        numbering.layout().rank();
      return axis;
    }

    /** Numbers points by their first unknown; in an infinite lattice images of
     * a joint by that of their base and their shift. */
    class PointNumbers
    {
    public:
      explicit PointNumbers(const LatticeModel &model)
        : n_unknowns(model.numbering.layout().n_global())
      {
        if (const auto &periodicity = model.lattice.periodicity)
          for (const JointImage &image : periodicity->images)
            bases[first_unknown(model, image.joint)] =
              {first_unknown(model, image.base), image.shift};
      }

      unsigned int operator()(int unknown, std::array<int, 3> shift)
      {
        if (const auto base = bases.find(unknown); base != bases.end())
          {
            unknown = base->second.first;
            for (unsigned int d = 0; d < 3; ++d)
              shift[d] += base->second.second[d];
          }
        if (shift == std::array<int, 3>{})
          return unknown;
        return shifted
          .try_emplace({unknown, shift}, n_unknowns + shifted.size())
          .first->second;
      }

      static int first_unknown(const LatticeModel &model,
                               const unsigned int  joint)
      {
        return model.numbering.global().joints[joint][0];
      }

    private:
      using Point = std::pair<int, std::array<int, 3>>;
      const unsigned int            n_unknowns;
      std::map<int, Point>          bases;
      std::map<Point, unsigned int> shifted;
    };

    void number_points(const LatticeModel &model,
                       PointNumbers       &numbers,
                       ContactAxis        &axis)
    {
      const Strut &strut = model.lattice.struts[axis.strut];
      for (unsigned int end = 0; end < 2; ++end)
        {
          axis.end_points[end] =
            numbers(axis.unknowns[end * model.lattice.dimension], axis.shift);
          axis.strut_ends[end] =
            numbers(PointNumbers::first_unknown(model, strut.joints[end]),
                    axis.shift);
        }
    }

    /** Shifts to the neighbours of a period. */
    std::vector<std::array<int, 3>>
    neighbour_shifts(const unsigned int dimension)
    {
      std::vector<std::array<int, 3>> shifts;
      const int                       depth = dimension == 3 ? 1 : 0;
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
          for (int k = -depth; k <= depth; ++k)
            if (i != 0 || j != 0 || k != 0)
              shifts.push_back({{i, j, k}});
      return shifts;
    }

    using Box = dealii::BoundingBox<3>;

    /** Boxes around the ends of the axes of each strut, in parts of the
     * translations of the period. */
    std::vector<Box> boxes_of_struts(const Lattice                  &lattice,
                                     const std::vector<ContactAxis> &axes)
    {
      const auto reciprocal = lattice.periodicity->reciprocal_vectors();
      std::vector<std::vector<dealii::Point<3>>> ends(lattice.struts.size());
      for (const ContactAxis &axis : axes)
        for (const dealii::Point<3> &end : axis.ends)
          {
            dealii::Point<3> parts;
            for (std::size_t d = 0; d < reciprocal.size(); ++d)
              parts[d] = reciprocal[d] * end;
            ends[axis.strut].push_back(parts);
          }
      std::vector<Box> boxes;
      for (const std::vector<dealii::Point<3>> &points : ends)
        boxes.emplace_back(points);
      return boxes;
    }

    /** Whether @p box, moved by @p shift, meets @p other. */
    bool meet(const Box &box, const std::array<int, 3> &shift, const Box &other)
    {
      for (unsigned int d = 0; d < 3; ++d)
        if (box.upper_bound(d) + shift[d] < other.lower_bound(d) ||
            box.lower_bound(d) + shift[d] > other.upper_bound(d))
          return false;
      return true;
    }

    /** The copy of @p axis moved by @p shift periods, without its line. */
    ContactAxis copy_of(const ContactAxis        &axis,
                        const std::array<int, 3> &shift,
                        const LatticeModel       &model)
    {
      const Lattice &lattice     = model.lattice;
      const auto     translation = lattice.periodicity->translation(shift);
      ContactAxis    copy        = axis;
      copy.shift                 = shift;
      for (unsigned int d = 0; d < lattice.dimension; ++d)
        {
          copy.axis_factors.push_back(translation[d] /
                                      lattice.periodicity->length());
          const auto &unknowns =
            model.numbering.global().joints[lattice.joint_of_axis(d)];
          copy.unknowns.insert(copy.unknowns.end(),
                               unknowns.begin(),
                               unknowns.begin() + lattice.dimension);
        }
      for (dealii::Point<3> &end : copy.ends)
        end += translation;
      return copy;
    }

    /** Copies of the axes of a period in its neighbours. */
    std::vector<ContactAxis> copies_of(const LatticeModel             &model,
                                       const std::vector<ContactAxis> &axes)
    {
      std::vector<ContactAxis> copies;
      const Lattice           &lattice = model.lattice;
      if (!lattice.periodicity)
        return copies;
      const std::vector<Box> boxes = boxes_of_struts(lattice, axes);
      Box                    near  = boxes.front();
      for (const Box &box : boxes)
        near.merge_with(box);
      near.extend(0.5 / std::pow(lattice.n_cells, 1. / lattice.dimension));
      unsigned int first_line = 0;
      for (const auto &shift : neighbour_shifts(lattice.dimension))
        {
          first_line += lattice.struts.size();
          for (const ContactAxis &axis : axes)
            if (meet(boxes[axis.strut], shift, near))
              {
                copies.push_back(copy_of(axis, shift, model));
                copies.back().line = first_line + axis.strut;
              }
        }
      return copies;
    }
  } // namespace

  std::vector<ContactAxis> make_contact_axes(const LatticeModel &model,
                                             const double stiffness_factor)
  {
    const std::vector<Strut> &struts = model.lattice.struts;
    const ContactSections     sections(model, stiffness_factor);
    const auto                division_of = [&](const unsigned int s) {
      return struts[s].is_rigid() ? StrutDivision{1, 1}
                                                 : model.numbering.divisions()[s];
    };
    std::size_t n_axes = 0;
    for (unsigned int s = 0; s < struts.size(); ++s)
      n_axes += division_of(s).n_elements;
    std::vector<int>         unknowns;
    std::vector<ContactAxis> axes;
    axes.reserve(n_axes);
    for (unsigned int s = 0; s < struts.size(); ++s)
      {
        const StrutDivision division = division_of(s);
        const double        n        = division.n_elements;
        for (unsigned int e = 0; e < division.n_elements; ++e)
          {
            axes.push_back(axis_of(model.numbering,
                                   {s, e / n, (e + 1) / n},
                                   division.order,
                                   unknowns));
            sections.set(axes.back());
          }
      }
    const std::vector<ContactAxis> copies = copies_of(model, axes);
    axes.insert(axes.end(), copies.begin(), copies.end());
    PointNumbers points(model);
    for (ContactAxis &axis : axes)
      number_points(model, points, axis);
    return axes;
  }
} // namespace auxfem
