#include <auxfem/mesh/arc.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** The one that is the largest without its sign. */
    double largest_component(const dealii::Tensor<1, 3> &vector)
    {
      double largest = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        if (std::abs(vector[d]) > std::abs(largest))
          largest = vector[d];
      return largest;
    }
  } // namespace

  dealii::Tensor<1, 3> left_of(const dealii::Tensor<1, 3> &along,
                               const dealii::Tensor<1, 3> &normal)
  {
    const dealii::Tensor<1, 3> left = dealii::cross_product_3d(normal, along);
    // Two by two: exact where a component is zero, as in the x-y plane.
    const double length = std::hypot(std::hypot(left[0], left[1]), left[2]);
    Assert(length > 0.,
           dealii::ExcMessage("The normal of an arc's plane cannot be parallel "
                              "to its chord."));
    return left / length;
  }

  dealii::Tensor<1, 3> rise_of_arc(const dealii::Tensor<1, 3> &chord,
                                   const double                sagitta,
                                   const dealii::Tensor<1, 3> &normal)
  {
    return sagitta == 0. ? dealii::Tensor<1, 3>()
                         : sagitta * left_of(chord, normal);
  }

  std::optional<Arc> arc_through(const dealii::Tensor<1, 3> &chord,
                                 const dealii::Tensor<1, 3> &there)
  {
    // The directions from one end to the point and from there to the other end
    // differ by half the angle of the arc (inscribed angle), and
    // sagitta = chord / 2 tan(angle / 4). The sine and one plus the cosine of
    // this half are here times the product of both distances.
    const dealii::Tensor<1, 3> back            = chord - there;
    const double               product         = there.norm() * back.norm();
    const double               one_plus_cosine = product + there * back;
    if (one_plus_cosine <= 1e-8 * product)
      return {};

    const dealii::Tensor<1, 3> turn = dealii::cross_product_3d(back, there);
    if (turn.norm() == 0.)
      return Arc{0., dealii::Point<3>(0, 0, 1)};
    // Normal and sagitta may change their signs together.
    const double sine =
      largest_component(turn) < 0. ? -turn.norm() : turn.norm();
    return Arc{chord.norm() / 2. * sine / one_plus_cosine, turn / sine};
  }
} // namespace auxfem
