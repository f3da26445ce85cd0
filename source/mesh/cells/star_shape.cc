#include <auxfem/mesh/cells/star_shape.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void refuse(const OpeningAngle &angle,
                             const SceneContext &context,
                             const std::string  &reason)
    {
      std::ostringstream text;
      text << context.path << ": the cell '" << angle.cell
           << "' cannot have an opening angle "
           << "theta0 = " << angle.value * 180. / dealii::numbers::PI
           << " deg. " << reason << " Set 'Opening angle' to more than "
           << angle.lower_limit << " and at most 90 deg.";
      throw InputError(text.str());
    }
  } // namespace

  void check_opening_angle(const OpeningAngle &angle,
                           const SceneContext &context)
  {
    // Angles come from degrees: equality holds up to round-off only.
    if (angle.value > dealii::numbers::PI_2 + round_off)
      refuse(angle,
             context,
             "Above 90 deg the vertices between the tips point outwards: "
             "theta0 <= 90 deg fails.");
    if (angle.vertex_distance <= round_off * angle.strut_length)
      {
        std::ostringstream reason;
        reason << "Its notches would cross in the centre: b = "
               << angle.distance_formula
               << " > 0 fails with b = " << angle.vertex_distance
               << " m for L = " << angle.strut_length << " m." << angle.advice;
        refuse(angle, context, reason.str());
      }
  }

  namespace
  {
    /** Sides in the order of the vertices and stub ends. */
    constexpr std::array<const char *, 4> sides = {
      {"right", "top", "left", "bottom"}};

    constexpr unsigned int first_vertex = 4;

    std::string overlap_sentence(const std::string &side,
                                 const double       depth,
                                 const double       stub)
    {
      std::ostringstream text;
      text << "Its tips would reach past those of the next cell: the " << side
           << " stub length " << stub
           << " m must not be less than the notch depth " << depth
           << " m along the same direction.";
      return text.str();
    }

    class StarCell : public Cell
    {
    public:
      explicit StarCell(const StarShape &shape) : shape(shape)
      {}

      UnitCell build() const override
      {
        return build_star(shape);
      }

    private:
      StarShape shape;
    };

    /** Adds the joints, stubs, ports and joint sets. */
    void add_joints(UnitCell &cell, const StarShape &shape)
    {
      const double w = shape.half_width;
      const double g = shape.half_height;
      const double b = w - shape.side_depth;
      const double c = g - shape.top_depth;
      cell.joints    = {{w, g, 0},
                        {-w, g, 0},
                        {-w, -g, 0},
                        {w, -g, 0},
                        {b, 0, 0},
                        {0, c, 0},
                        {-b, 0, 0},
                        {0, -c, 0}};

      for (unsigned int i = 0; i < sides.size(); ++i)
        {
          const unsigned int axis = i % 2;
          const double       sign = i < 2 ? 1. : -1.;
          const double       length =
            axis == 0 ? shape.horizontal_stub : shape.vertical_stub;
          unsigned int port = first_vertex + i;
          if (length > 0.)
            {
              dealii::Point<3> end = cell.joints[port];
              end[axis] += sign * length;
              port = cell.joints.size();
              cell.joints.push_back(end);
              cell.struts.push_back({first_vertex + i, port, 0., {"stubs"}});
            }
          cell.ports[sides[i]] = {port};
        }
      cell.joint_sets["tips"]    = {0, 1, 2, 3};
      cell.joint_sets["notches"] = {4, 5, 6, 7};
    }

    void add_edges(UnitCell &cell)
    {
      // Tip i lies between the vertices i and i + 1: tip 0 between right and
      // top, and so on.
      for (unsigned int tip = 0; tip < 4; ++tip)
        for (const unsigned int vertex : {tip, (tip + 1) % 4})
          cell.struts.push_back({tip, first_vertex + vertex, 0., {"edges"}});
    }

    void set_period(UnitCell &cell, const StarShape &shape)
    {
      // With equal lengths, up to round-off, tips of neighbours are merged.
      const auto overlaps = [](const double depth, const double stub) {
        return depth - stub > 1e-9 * std::max(depth, stub);
      };
      if (overlaps(shape.side_depth, shape.horizontal_stub))
        cell.no_period_reasons[0] = overlap_sentence("horizontal",
                                                     shape.side_depth,
                                                     shape.horizontal_stub);
      else
        cell.period[0] = cell.joints[cell.ports["right"][0]][0] -
          cell.joints[cell.ports["left"][0]][0];

      if (overlaps(shape.top_depth, shape.vertical_stub))
        cell.no_period_reasons[1] =
          overlap_sentence("vertical", shape.top_depth, shape.vertical_stub);
      else
        cell.period[1] = cell.joints[cell.ports["top"][0]][1] -
          cell.joints[cell.ports["bottom"][0]][1];

      cell.no_period_reasons[2] = "It is planar and has no Layer distance.";
    }
  } // namespace

  UnitCell build_star(const StarShape &shape)
  {
    UnitCell cell;
    add_edges(cell);
    add_joints(cell, shape);
    const unsigned int right = 4, top = 5, left = 6, bottom = 7;
    cell.pairs["in-cell"]   = {{top, bottom}};
    cell.pairs["in-cell x"] = {{left, right}};
    cell.pairs["rod"]       = {{top, cell.ports["bottom"][0]}};
    set_period(cell, shape);
    return cell;
  }

  std::unique_ptr<Cell> make_star_cell(const StarShape &shape)
  {
    return std::make_unique<StarCell>(shape);
  }
} // namespace auxfem
