#include <auxfem/algebra/shared_work.h>
#include <auxfem/analysis/relative_motion.h>
#include <auxfem/model/unknown_records.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    double length_of(const LatticeModel &model, const unsigned int element)
    {
      const StrutInterval &interval =
        model.numbering.elements()[element].interval;
      return model.lattice.length(model.lattice.struts[interval.strut]) *
        (interval.end - interval.begin);
    }

    /** Cells (m) to which the elements at both sides of a strut belong, or
     * their neighbours, and which hold some ten struts. */
    double size_of_cells(const LatticeModel &model)
    {
      double longest = 0;
      for (unsigned int e = 0; e < model.numbering.elements().size(); ++e)
        longest = std::max(longest, length_of(model, e));
      return std::max(4 * model.mean_strut_length,
                      1.5 * model.numbering.layout().largest(longest));
    }
  } // namespace

  RelativeMotion::Box::Box()
  {
    lower.fill(std::numeric_limits<double>::infinity());
    upper.fill(-std::numeric_limits<double>::infinity());
  }

  void RelativeMotion::Box::add(const Box &other)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        lower[d] = std::min(lower[d], other.lower[d]);
        upper[d] = std::max(upper[d], other.upper[d]);
      }
  }

  RelativeMotion::RelativeMotion(const LatticeModel &model)
    : model(model)
    , cell_size(size_of_cells(model))
  {
    for (const DofNumbering::Element &element : model.numbering.elements())
      {
        dealii::Point<3>     middle;
        dealii::Tensor<1, 3> tangent;
        model.lattice.axis(model.lattice.struts[element.interval.strut],
                           element.interval.at(0),
                           middle,
                           tangent);
        middles.push_back(middle);
      }
  }

  void RelativeMotion::start(const Vector &displacement)
  {
    const DofNumbering &numbering = model.numbering;
    start_displacement            = displacement;
    std::map<Key, unsigned int> index;
    keys.clear();
    cell_of_element.clear();
    for (unsigned int e = 0; e < middles.size(); ++e)
      {
        // The first two nodes are the ends.
        dealii::Point<3> middle = middles[e];
        const int       *ends   = numbering.element_unknowns(e);
        for (unsigned int a = 0; a < 2; ++a, ends += numbering.n_components())
          for (unsigned int d = 0; d < model.lattice.dimension; ++d)
            middle[d] += displacement[ends[d]] / 2;
        const auto [cell, is_new] = index.emplace(key(middle), keys.size());
        if (is_new)
          keys.push_back(cell->first);
        cell_of_element.push_back(cell->second);
      }
  }

  void RelativeMotion::save(const std::string &name, Records &records) const
  {
    UnknownRecords(model.numbering)
      .keep(name + ": displacements", start_displacement, records);
  }

  void RelativeMotion::resume(const std::string &name, const Records &records)
  {
    start(UnknownRecords(model.numbering)
            .values(name + ": displacements", records));
  }

  double RelativeMotion::largest(const Vector &displacement) const
  {
    const UnknownLayout &layout = model.numbering.layout();
    // Ranks may differ: one may have no unknowns, or have got ghosts.
    const bool is_new = start_displacement.size() != displacement.size();
    if (layout.largest(is_new ? 1. : 0.) > 0)
      return std::numeric_limits<double>::infinity();
    const Cells cells         = motions(displacement);
    const int   reach_along_z = model.lattice.dimension == 3 ? 1 : 0;
    double      square        = 0;
    for (const auto &[key, of_cell] : cells)
      {
        Box box = of_cell;
        for (int i = -1; i <= 1; ++i)
          for (int j = -1; j <= 1; ++j)
            for (int k = -reach_along_z; k <= reach_along_z; ++k)
              if (const auto beside =
                    cells.find({{key[0] + i, key[1] + j, key[2] + k}});
                  beside != cells.end())
                box.add(beside->second);
        double of_box = 0;
        for (unsigned int d = 0; d < model.lattice.dimension; ++d)
          of_box += std::pow(box.upper[d] - box.lower[d], 2);
        square = std::max(square, of_box);
      }
    return std::sqrt(square);
  }

  RelativeMotion::Key
  RelativeMotion::key(const dealii::Point<3> &position) const
  {
    Key key;
    for (unsigned int d = 0; d < 3; ++d)
      key[d] = static_cast<int>(std::floor(position[d] / cell_size));
    return key;
  }

  RelativeMotion::Cells
  RelativeMotion::motions(const Vector &displacement) const
  {
    const DofNumbering &numbering = model.numbering;
    std::vector<Box>    boxes(keys.size());
    for (unsigned int e = 0; e < cell_of_element.size(); ++e)
      {
        Box       &box      = boxes[cell_of_element[e]];
        const int *unknowns = numbering.element_unknowns(e);
        for (unsigned int a = 0; a <= numbering.elements()[e].order; ++a)
          {
            for (unsigned int d = 0; d < model.lattice.dimension; ++d)
              {
                const double way =
                  displacement[unknowns[d]] - start_displacement[unknowns[d]];
                box.lower[d] = std::min(box.lower[d], way);
                box.upper[d] = std::max(box.upper[d], way);
              }
            unknowns += numbering.n_components();
          }
      }
    // A part of a cell may lie on another rank.
    const MPI_Comm         communicator = numbering.layout().communicator();
    const std::vector<Key> all_keys     = of_all_ranks(keys, communicator);
    const std::vector<Box> all_boxes    = of_all_ranks(boxes, communicator);
    Cells                  cells;
    for (std::size_t i = 0; i < all_keys.size(); ++i)
      cells[all_keys[i]].add(all_boxes[i]);
    return cells;
  }
} // namespace auxfem
