#include <auxfem/mesh/cells/translations.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    QuantityList translation(const unsigned int d)
    {
      const std::string axis(1, "xyz"[d]);
      return {
        "Vector " + axis,
        "none",
        "m",
        Range::any(),
        2,
        3,
        "Translation to the next cell in the direction counted by Cells " +
          axis + ", two or three numbers; none: one cell.",
        {"none"}};
    }

    /** Number of pieces of a lattice that hang together by struts. */
    unsigned int n_pieces(const Lattice &lattice)
    {
      std::vector<unsigned int> parent(lattice.joints.size());
      std::iota(parent.begin(), parent.end(), 0);
      const auto root = [&parent](unsigned int joint) {
        while (parent[joint] != joint)
          joint = parent[joint] = parent[parent[joint]];
        return joint;
      };
      unsigned int n = parent.size();
      for (const Strut &strut : lattice.struts)
        {
          const unsigned int one   = root(strut.joints[0]),
                             other = root(strut.joints[1]);
          n -= one != other;
          parent[one] = other;
        }
      return n;
    }

    void refuse_dependent_vectors(const ParameterValues &values,
                                  const UnitCell        &cell)
    {
      std::vector<dealii::Tensor<1, 3>> units;
      for (unsigned int d = 0; d < 3; ++d)
        if (cell.repeats(d))
          units.push_back(cell.vectors[d] / cell.vectors[d].norm());
      constexpr double smallest_sine = 1e-6;
      for (std::size_t i = 0; i < units.size(); ++i)
        for (std::size_t j = i + 1; j < units.size(); ++j)
          if (dealii::cross_product_3d(units[i], units[j]).norm() <
              smallest_sine)
            values.refuse("the translation vectors are parallel. Give two of "
                          "different directions");
      if (units.size() == 3 &&
          std::abs(units[0] * dealii::cross_product_3d(units[1], units[2])) <
            smallest_sine)
        values.refuse("the three translation vectors lie in one plane. Give "
                      "one that leaves it");
    }

    void refuse_cells_apart(const ParameterValues &values, const UnitCell &cell)
    {
      if (!cell.pairs_across.empty())
        return;
      std::array<unsigned int, 3> two = {{1, 1, 1}};
      for (unsigned int d = 0; d < 3; ++d)
        if (cell.repeats(d))
          two[d] = 2;
      const unsigned int one = n_pieces(make_array(cell, {{1, 1, 1}})),
                         all = n_pieces(make_array(cell, two));
      if (all <= one)
        return;
      values.refuse(
        "the cells do not meet: " + std::to_string(two[0] * two[1] * two[2]) +
        " of them are " + std::to_string(all) + " pieces, one cell is " +
        std::to_string(one) +
        ". Joints that neighbours share must coincide after a translation, "
        "within " +
        (cell.merge_distance > 0 ? values.text(merge_distance())
                                 : std::string("1e-8 of the cell's size")) +
        ". Check the vectors, give a larger Merge distance, or name pairs "
        "that connectors join");
    }
  } // namespace

  Parameters translation_parameters()
  {
    return {translation(0), translation(1), translation(2)};
  }

  void set_translations(const ParameterValues &values, UnitCell &cell)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        const QuantityList vector = translation(d);
        if (values.is_word(vector))
          {
            cell.no_vector_reasons[d] =
              "It has no " + vector.name + " to the next cell.";
            continue;
          }
        cell.vectors[d] = vector_of(values, vector);
        if (cell.vectors[d].norm() == 0)
          values.refuse(vector, "the zero vector leads to no other cell");
      }
    cell.merge_distance = values[merge_distance()];
    refuse_dependent_vectors(values, cell);
    refuse_cells_apart(values, cell);
  }
} // namespace auxfem
