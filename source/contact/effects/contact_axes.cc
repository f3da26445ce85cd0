#include <auxfem/contact/effects/contact_axes.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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
    return axes;
  }
} // namespace auxfem
