#include <auxfem/struts/shapes/rolled_shape.h>
#include <auxfem/struts/shapes/shape_table.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const Quantity rolled_width    = {"Width",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Width of the flanges along axis 3, "
                                         "normal to the plane."};
    const Quantity rolled_height   = {"Height",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Height along axis 2, in the plane, "
                                        "flanges included."};
    const Quantity rolled_web      = {"Web thickness",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Thickness of the web, less than the "
                                           "width."};
    const Quantity rolled_flange   = {"Flange thickness",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Thickness of a flange; all flanges "
                                        "together are less than the height."};
    const Quantity angle_height    = {"Height",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Outer length of the leg along axis 2."};
    const Quantity angle_width     = {"Width",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Outer length of the leg along axis 3."};
    const Quantity angle_thickness = {"Thickness",
                                      "",
                                      "m",
                                      Range::positive(),
                                      "Thickness of both legs, less than "
                                      "their lengths."};
    const Quantity fillet_radius   = {"Fillet radius",
                                      "0 m",
                                      "m",
                                      Range::non_negative(),
                                      "Radius of the fillets in inner corners."};
    const Quantity toe_radius      = {"Toe radius",
                                      "0 m",
                                      "m",
                                      Range::non_negative(),
                                      "Radius at the inner edges of the ends "
                                           "of the legs, at most the thickness."};

    Outline i_outline(const RolledDimensions &d)
    {
      const double y = d.height / 2, f = d.height / 2 - d.flange,
                   z = d.width / 2, w = d.web / 2;
      return rounded_outline({{-y, -z},
                              {-f, -z},
                              {-f, -w, d.fillet},
                              {f, -w, d.fillet},
                              {f, -z},
                              {y, -z},
                              {y, z},
                              {f, z},
                              {f, w, d.fillet},
                              {-f, w, d.fillet},
                              {-f, z},
                              {-y, z}});
    }

    Outline t_outline(const RolledDimensions &d)
    {
      const double f = d.height - d.flange, z = d.width / 2, w = d.web / 2;
      return rounded_outline({{0, -w},
                              {f, -w, d.fillet},
                              {f, -z},
                              {d.height, -z},
                              {d.height, z},
                              {f, z},
                              {f, w, d.fillet},
                              {0, w}});
    }

    Outline c_outline(const RolledDimensions &d)
    {
      const double y = d.height / 2, f = d.height / 2 - d.flange;
      return rounded_outline({{-y, 0},
                              {y, 0},
                              {y, d.width},
                              {f, d.width},
                              {f, d.web, d.fillet},
                              {-f, d.web, d.fillet},
                              {-f, d.width},
                              {-y, d.width}});
    }

    Outline l_outline(const RolledDimensions &d)
    {
      return rounded_outline({{0, 0},
                              {d.height, 0},
                              {d.height, d.web, d.toe},
                              {d.flange, d.web, d.fillet},
                              {d.flange, d.width, d.toe},
                              {0, d.width}});
    }

    void refuse_too_large(const ParameterValues &values,
                          const Quantity        &parameter,
                          const double           largest)
    {
      std::ostringstream text;
      text.precision(4);
      text << "at most " << largest
           << " m fits between web and flange. Reduce it";
      if (values[parameter] > largest * (1 + 1e-12))
        values.refuse(parameter, text.str());
    }

    /** Checks the fillets, for which web and flange must leave room. */
    void check_radii(const ParameterValues  &values,
                     const RolledShape      &shape,
                     const RolledDimensions &dimensions)
    {
      if (dimensions.toe > 0)
        refuse_too_large(values, toe_radius, dimensions.web);
      refuse_too_large(values,
                       fillet_radius,
                       std::min(shape.clear_height(dimensions) /
                                  shape.n_flanges,
                                shape.clear_width(dimensions)) -
                         dimensions.toe);
    }

    const RolledShape &rolled_shape(const std::string &name)
    {
      return *find_by_name(rolled_shapes(), name);
    }

    std::unique_ptr<CrossSection> make_rolled(const RolledShape     &shape,
                                              const ParameterValues &values)
    {
      RolledDimensions d;
      d.height = values[rolled_height];
      d.width  = values[rolled_width];
      d.web    = values[rolled_web];
      d.flange = values[rolled_flange];
      d.fillet = values[fillet_radius];
      if (!(shape.clear_height(d) > 0))
        values.refuse(rolled_flange,
                      std::string(shape.n_flanges == 2 ? "two flanges fill"
                                                       : "the flange fills") +
                        " the Height = " + values.text(rolled_height) +
                        ". Give less than " +
                        (shape.n_flanges == 2 ? "half of it" : "that"));
      if (!(shape.clear_width(d) > 0))
        values.refuse(rolled_web,
                      "the web fills the Width = " + values.text(rolled_width) +
                        ". Give less than that, or set Shape = rectangle");
      check_radii(values, shape, d);
      return section_of_outline(values, shape.outline(d));
    }

    std::unique_ptr<CrossSection> make_i(ParameterValues &values)
    {
      return make_rolled(rolled_shape("I"), values);
    }

    std::unique_ptr<CrossSection> make_t(ParameterValues &values)
    {
      return make_rolled(rolled_shape("T"), values);
    }

    std::unique_ptr<CrossSection> make_c(ParameterValues &values)
    {
      return make_rolled(rolled_shape("C"), values);
    }

    std::unique_ptr<CrossSection> make_l(ParameterValues &values)
    {
      const RolledDimensions d = {values[angle_height],
                                  values[angle_width],
                                  values[angle_thickness],
                                  values[angle_thickness],
                                  values[fillet_radius],
                                  values[toe_radius]};
      if (!(d.web < std::min(d.height, d.width)))
        values.refuse(angle_thickness,
                      "the legs are " + values.text(angle_height) + " and " +
                        values.text(angle_width) +
                        " long. Give less than both");
      check_radii(values, rolled_shape("L"), d);
      return section_of_outline(values, l_outline(d));
    }

    Parameters rolled_parameters()
    {
      return {rolled_width,
              rolled_height,
              rolled_web,
              rolled_flange,
              fillet_radius,
              torsion_constant_parameter()};
    }
  } // namespace

  const std::vector<RolledShape> &rolled_shapes()
  {
    static const std::vector<RolledShape> shapes = {{"I", 2, true, i_outline},
                                                    {"T", 1, true, t_outline},
                                                    {"C", 2, false, c_outline},
                                                    {"L", 1, false, l_outline}};
    return shapes;
  }

  RegistryEntry<CrossSection> i_entry()
  {
    return {"I",
            "Web along axis 2 between two equal flanges.",
            rolled_parameters(),
            make_i};
  }

  RegistryEntry<CrossSection> t_entry()
  {
    return {"T",
            "Web along axis 2 with a flange at its end in the positive "
            "direction.",
            rolled_parameters(),
            make_t};
  }

  RegistryEntry<CrossSection> c_entry()
  {
    return {"C",
            "Channel: web along axis 2, flanges at both ends along axis 3.",
            rolled_parameters(),
            make_c};
  }

  RegistryEntry<CrossSection> l_entry()
  {
    return {"L",
            "Angle with legs along axes 2 and 3; in space only, as its "
            "principal axes are turned against them.",
            {angle_width,
             angle_height,
             angle_thickness,
             fillet_radius,
             toe_radius,
             torsion_constant_parameter()},
            make_l};
  }
} // namespace auxfem
