#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/parameters/errors.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const Quantity bar_length{"Bar length",
                              "0.5 m",
                              "m",
                              Range::positive(),
                              "Length L1 of the bars AF, AB, CD and DE."};

    const Quantity bar_angle{
      "Angle",
      "30 deg",
      "deg",
      Range::open(0, 90),
      "Angle theta0 of the bars to the horizontal, at rest."};

    const Quantity hinged_star_half_width{
      "Half width",
      "auto",
      "m",
      Range::positive(),
      "Distance w of the corners B, C, E, F from the rod; more than "
      "L1 cos(theta0). Above L1 the side joints A and D can never meet. "
      "auto: 1.1 L1.",
      {"auto"}};

    const Quantity notch_depth{
      "Notch depth",
      "auto",
      "m",
      Range::positive(),
      "Depth of the notches in the upper and lower part and length of their "
      "stubs; less than L1 sin(theta0). auto: L1 sin(theta0) / 2.",
      {"auto"}};

    // A gap of zero would merge the corners B, C and F, E of two cells.
    const Quantity cell_gap{
      "Cell gap",
      "auto",
      "m",
      Range::positive(),
      "Distance g of the lower stub end of a cell from the upper stub end of "
      "the cell below: the stroke of the lower part. auto: L1 / 5.",
      {"auto"}};

    const Quantity rod_clearance{
      "Rod clearance",
      "0 m",
      "m",
      Range::non_negative(),
      "Distance of the rod's foot from the upper stub end of the cell below, "
      "at most the cell gap. 0: they are one joint."};

    const Quantity column_gap{
      "Column gap",
      "auto",
      "m",
      Range::positive(),
      "Distance of the corners of a cell from those of the next cell along x. "
      "auto: a fifth of the half width.",
      {"auto"}};

    /** Dimensions of the cell (m). */
    struct HingedStarShape
    {
      double half_width;
      double half_height; ///< rise L1 sin(theta0) of a bar
      double side_depth;  ///< run L1 cos(theta0) of a bar
      double notch_depth;
      double cell_gap;
      double rod_clearance;
      double column_gap;
    };

    /** Joints of the cell in their order; a to f are A to F. */
    enum Joint : unsigned int
    {
      a,
      b,
      c,
      d,
      e,
      f,
      m,
      n,
      p,
      q,
      rod_top,
      rod_foot,
      n_joints
    };

    constexpr std::array<const char *, n_joints> joint_names = {{"A",
                                                                 "B",
                                                                 "C",
                                                                 "D",
                                                                 "E",
                                                                 "F",
                                                                 "m",
                                                                 "n",
                                                                 "p",
                                                                 "q",
                                                                 "rod top",
                                                                 "rod foot"}};

    void add_joints(const HingedStarShape &shape, UnitCell &cell)
    {
      const double w     = shape.half_width;
      const double h     = shape.half_height;
      const double notch = h - shape.notch_depth;
      const double side  = w - shape.side_depth;

      cell.joints.resize(n_joints);
      cell.joints[a]        = {-side, 0, 0};
      cell.joints[b]        = {-w, h, 0};
      cell.joints[c]        = {w, h, 0};
      cell.joints[d]        = {side, 0, 0};
      cell.joints[e]        = {w, -h, 0};
      cell.joints[f]        = {-w, -h, 0};
      cell.joints[m]        = {0, notch, 0};
      cell.joints[n]        = {0, h, 0};
      cell.joints[p]        = {0, -notch, 0};
      cell.joints[q]        = {0, -h, 0};
      cell.joints[rod_top]  = {0, 0, 0};
      cell.joints[rod_foot] = {0, -h - shape.cell_gap + shape.rod_clearance, 0};

      for (unsigned int joint = 0; joint < n_joints; ++joint)
        cell.joint_sets[joint_names[joint]] = {joint};
      cell.joint_sets["axis"] = {m, n, p, q, rod_top, rod_foot};
    }

    void add_bars_and_rod(UnitCell &cell)
    {
      cell.struts = {{a, f, 0., {"bars", "bar AF"}},
                     {a, b, 0., {"bars", "bar AB"}},
                     {c, d, 0., {"bars", "bar CD"}},
                     {d, e, 0., {"bars", "bar DE"}},
                     {b, m, 0., {"upper part"}},
                     {m, c, 0., {"upper part"}},
                     {m, n, 0., {"upper part"}},
                     {f, p, 0., {"lower part"}},
                     {p, e, 0., {"lower part"}},
                     {p, q, 0., {"lower part"}},
                     {rod_top, rod_foot, 0., {"rod"}}};
    }

    /**
     * Cell of Shokri Rad, Mohsenizadeh and Ahmad, Figs. 2 to 4: four bars, an
     * upper and a lower part of three beams each, and the rod that carries the
     * connector's force past the lower part.
     */
    class HingedStarCell : public Cell
    {
    public:
      explicit HingedStarCell(const HingedStarShape &shape) : shape(shape)
      {}

      UnitCell build() const override
      {
        UnitCell cell;
        add_joints(shape, cell);
        add_bars_and_rod(cell);
        cell.pairs["in-cell"]                = {{m, rod_top}};
        cell.pairs["sides"]                  = {{a, d}};
        cell.pairs_across["side neighbours"] = {{d, a, {{1, 0, 0}}}};
        cell.pairs_across["rod seats"]       = {{n, rod_foot, {{0, 1, 0}}}};

        cell.ports["left"]   = {a};
        cell.ports["right"]  = {d};
        cell.ports["bottom"] = {rod_foot};
        cell.ports["top"]    = {n};

        cell.vectors[0][0]        = 2. * shape.half_width + shape.column_gap;
        cell.vectors[1][1]        = 2. * shape.half_height + shape.cell_gap;
        cell.no_vector_reasons[2] = "It is planar and has no Layer distance.";
        return cell;
      }

    private:
      HingedStarShape shape;
    };

    /**
     * Refuses @p entry if its @p value is not below (@p sign = -1) or above
     * (@p sign = 1) the @p limit. The message has the formula @p symbols of the
     * limit, the @p consequence and an alternative @p advice.
     */
    void check_against(const SceneContext &context,
                       const Quantity     &entry,
                       const double        value,
                       const int           sign,
                       const double        limit,
                       const std::string  &symbols,
                       const std::string  &consequence,
                       const std::string  &advice)
    {
      // Sines and cosines of angles in degrees carry round-off.
      if (sign * (value - limit) > 1e-12 * limit)
        return;
      std::ostringstream text;
      text << context.path << '/' << entry.name << ": " << value << " m is not "
           << (sign > 0 ? "more" : "less") << " than " << symbols << " = "
           << limit << " m, so " << consequence << ". "
           << (sign > 0 ? "Increase '" : "Reduce '") << entry.name << "', or "
           << advice << '.';
      throw InputError(text.str());
    }

    void check_shape(const HingedStarShape &shape, const SceneContext &context)
    {
      check_against(context,
                    hinged_star_half_width,
                    shape.half_width,
                    1,
                    shape.side_depth,
                    "L1 cos(theta0)",
                    "the side notches cross or the joints A and D meet",
                    "shorten the bars or make them steeper");
      check_against(context,
                    notch_depth,
                    shape.notch_depth,
                    -1,
                    shape.half_height,
                    "L1 sin(theta0)",
                    "the upper and lower notch cross or meet",
                    "lengthen the bars or make them steeper");
      if (shape.rod_clearance > shape.cell_gap * (1. + 1e-12))
        {
          std::ostringstream text;
          text << context.path << '/' << rod_clearance.name << ": "
               << shape.rod_clearance
               << " m is more than the cell gap g = " << shape.cell_gap
               << " m, so the rod would end inside the lower stub. Reduce '"
               << rod_clearance.name << "' or increase '" << cell_gap.name
               << "'.";
          throw InputError(text.str());
        }
    }

    std::unique_ptr<Cell> make_hinged_star(ParameterValues &values)
    {
      const double length = values[bar_length];
      const double angle  = values[bar_angle];

      HingedStarShape shape;
      shape.half_width  = values.value_or(hinged_star_half_width, 1.1 * length);
      shape.half_height = length * std::sin(angle);
      shape.side_depth  = length * std::cos(angle);
      shape.notch_depth = values.value_or(notch_depth, shape.half_height / 2.);
      shape.cell_gap    = values.value_or(cell_gap, length / 5.);
      shape.rod_clearance = values[rod_clearance];
      shape.column_gap    = values.value_or(column_gap, shape.half_width / 5.);
      check_shape(shape, values.context);
      return std::make_unique<HingedStarCell>(shape);
    }
  } // namespace

  RegistryEntry<Cell> hinged_star_cell_entry()
  {
    return {"hinged star",
            "Star of four bars between an upper and a lower part of three "
            "beams each, with a rod through the lower part: hinges at A to F "
            "make it the cell of Shokri Rad, Mohsenizadeh and Ahmad.",
            {bar_length,
             bar_angle,
             hinged_star_half_width,
             notch_depth,
             cell_gap,
             rod_clearance,
             column_gap},
            make_hinged_star};
  }
} // namespace auxfem
