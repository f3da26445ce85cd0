#include <auxfem/algebra/strut_condensation.h>

#include <algebra/strut_network.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Blocks are well conditioned, with entries of about one.
  constexpr double condensation_round_off = 1e-11;

  bool is_condensed(const StrutNetwork          &network,
                    const StrutNetwork::Unknown &unknown)
  {
    const bool is_disturbed =
      network.shape.has_contact && (unknown.strut == 1u || unknown.strut == 2u);
    return unknown.strut && !is_disturbed;
  }

  /** Global numbers of the network in the order of the condensed equations. */
  std::vector<unsigned int> retained_unknowns(const StrutNetwork &network)
  {
    std::vector<unsigned int> retained;
    for (unsigned int global = 0; global < network.n_unknowns(); ++global)
      if (!is_condensed(network, network.unknown(global)))
        retained.push_back(global);
    return retained;
  }

  /** Schur complement of the condensed unknowns, without prescribed columns. */
  DenseMatrix reference(const StrutNetwork &network, const Symmetry symmetry)
  {
    DenseMatrix                     dense    = network.dense(symmetry);
    const std::vector<unsigned int> retained = retained_unknowns(network);
    std::vector<unsigned int>       inside;
    for (unsigned int global = 0; global < network.n_unknowns(); ++global)
      {
        const auto &unknown = network.unknown(global);
        if (is_condensed(network, unknown))
          inside.push_back(global);
        if (unknown.kind == UnknownKind::prescribed)
          for (unsigned int row = 0; row < network.n_unknowns(); ++row)
            dense(row, global) = row == global ? 1. : 0.;
      }
    DenseMatrix joints(retained.size());
    joints.extract_submatrix_from(dense, retained, retained);
    if (inside.empty())
      return joints;
    DenseMatrix inner(inside.size()), to_inner(retained.size(), inside.size()),
      from_inner(inside.size(), retained.size());
    inner.extract_submatrix_from(dense, inside, inside);
    to_inner.extract_submatrix_from(dense, retained, inside);
    from_inner.extract_submatrix_from(dense, inside, retained);
    inner.gauss_jordan();
    joints.triple_product(inner, to_inner, from_inner, false, false, -1.);
    return joints;
  }

  /** The matrix of all ranks, on all ranks. */
  DenseMatrix as_dense(const SparseMatrix &matrix)
  {
    const UnknownLayout &layout = *matrix.layout;
    const unsigned int   n      = layout.n_global();
    std::vector<double>  sums(n * n, 0.);
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        sums[layout.global(row) * n + layout.global(matrix.columns[i])] +=
          matrix.entries[i];
    return DenseMatrix(n, n, layout.sum(sums).data());
  }

  void expect_reference(const StrutNetwork      &network,
                        const StrutCondensation &condensation,
                        const Symmetry           symmetry)
  {
    EXPECT_EQ(condensation.matrix().is_symmetric, symmetry != Symmetry::none);
    DenseMatrix       found    = as_dense(condensation.matrix());
    const DenseMatrix expected = reference(network, symmetry);
    ASSERT_EQ(found.m(), expected.m());
    found.add(-1., expected);
    EXPECT_LT(found.linfty_norm(), condensation_round_off);

    const std::vector<unsigned int> retained = retained_unknowns(network);
    const Unknowns                 &joints   = condensation.joints();
    for (unsigned int i = 0; i < joints.layout.n_local(); ++i)
      {
        const auto &unknown =
          network.unknown(retained[joints.layout.global(i)]);
        EXPECT_EQ(joints.kinds[i], unknown.kind);
        EXPECT_EQ(joints.is_rotation[i], unknown.is_rotation);
        EXPECT_EQ(joints.joint[i], unknown.joint);
        EXPECT_EQ(joints.component[i], unknown.component);
      }
  }

  /** Solves the condensed equations densely, on each rank, and expands. */
  void expect_solution(const StrutNetwork      &network,
                       const StrutCondensation &condensation,
                       const Symmetry           symmetry)
  {
    std::vector<double> values = network.owned(network.right_side()), g;
    condensation.reduce(values, g);
    const UnknownLayout &layout = *condensation.matrix().layout;
    std::vector<double>  all(layout.n_global(), 0.);
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      all[layout.global(row)] = g[row];
    all = layout.sum(all);
    dealii::Vector<double> right_side(all.begin(), all.end()), z(all.size());
    DenseMatrix            inverse = as_dense(condensation.matrix());
    inverse.gauss_jordan();
    inverse.vmult(z, right_side);
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      g[row] = z(layout.global(row));
    condensation.expand(g, values);

    const dealii::Vector<double> expected = network.solution(symmetry);
    for (unsigned int i = 0; i < network.layout->n_local(); ++i)
      EXPECT_NEAR(values[i],
                  expected(network.layout->global(i)),
                  condensation_round_off);
  }

  void expect_condensed(const NetworkShape &shape, const Symmetry symmetry)
  {
    SCOPED_TRACE("components " + std::to_string(shape.n_components) +
                 ", order " + std::to_string(shape.order) + ", elements " +
                 std::to_string(shape.n_elements) + ", symmetry " +
                 std::to_string(static_cast<int>(symmetry)));
    StrutNetwork      network(shape);
    StrutCondensation condensation(*network.matrix);
    ASSERT_EQ(condensation.condense(symmetry), FactorizationOutcome::done);
    EXPECT_EQ(condensation.description(), "");
    expect_reference(network, condensation, symmetry);
    expect_solution(network, condensation, symmetry);
  }

  void expect_all_condensed(NetworkShape shape)
  {
    expect_condensed(shape, Symmetry::given);
    shape.asymmetry = 0.5;
    expect_condensed(shape, Symmetry::none);
    expect_condensed(shape, Symmetry::enforced);
  }
} // namespace

TEST(StrutCondensation, LeavesSchursComplementInThePlane)
{
  NetworkShape shape;
  for (shape.order = 1; shape.order <= 6; ++shape.order)
    expect_all_condensed(shape);
}

TEST(StrutCondensation, LeavesSchursComplementInSpace)
{
  NetworkShape shape;
  shape.n_components = 6;
  for (shape.order = 1; shape.order <= 4; ++shape.order)
    expect_all_condensed(shape);
}

TEST(StrutCondensation, GoesAlongSeveralElements)
{
  NetworkShape shape;
  for (const unsigned int n_components : {3, 6})
    for (const unsigned int order : {1, 3})
      for (const unsigned int n_elements : {2, n_components == 3 ? 5 : 3})
        {
          shape.n_components = n_components;
          shape.order        = order;
          shape.n_elements   = n_elements;
          expect_all_condensed(shape);
        }
}

TEST(StrutCondensation, ExcludesStrutsThatOtherBlocksActOn)
{
  NetworkShape shape;
  shape.has_contact = true;
  for (const unsigned int n_elements : {1, 3})
    {
      shape.n_elements = n_elements;
      expect_all_condensed(shape);
    }
}

TEST(StrutCondensation, IncludesTheAddedDiagonal)
{
  NetworkShape shape;
  shape.n_elements = 2;
  const StrutNetwork network(shape);
  shape.shift = 2;
  const StrutNetwork shifted(shape);
  StrutCondensation  condensation(*shifted.matrix);
  // Replaces the diagonal by that of the other network.
  shifted.matrix->set_diagonal(network.matrix->diagonal());
  ASSERT_EQ(condensation.condense(Symmetry::given), FactorizationOutcome::done);
  expect_reference(network, condensation, Symmetry::given);
  expect_solution(network, condensation, Symmetry::given);
}

TEST(StrutCondensation, FollowsThePattern)
{
  StrutNetwork      network;
  StrutCondensation condensation(*network.matrix);
  ASSERT_EQ(condensation.condense(Symmetry::given), FactorizationOutcome::done);
  const unsigned long before = condensation.version();
  network.pattern->reset(*network.unknowns);
  network.register_blocks();
  network.fill();
  ASSERT_EQ(condensation.condense(Symmetry::given), FactorizationOutcome::done);
  EXPECT_GT(condensation.version(), before);
  expect_reference(network, condensation, Symmetry::given);
}

TEST(StrutCondensation, NamesAStrutThatIsSingularInside)
{
  for (const unsigned int n_elements : {1, 3})
    for (const Symmetry symmetry : {Symmetry::given, Symmetry::none})
      {
        NetworkShape shape;
        shape.n_elements = n_elements;
        StrutNetwork      network(shape);
        StrutCondensation condensation(*network.matrix);
        network.matrix->reset();
        EXPECT_EQ(condensation.condense(symmetry),
                  FactorizationOutcome::singular);
        EXPECT_NE(condensation.description().find("the inside of strut "),
                  std::string::npos);
        // The failure must leave no trace.
        network.fill();
        EXPECT_EQ(condensation.condense(symmetry), FactorizationOutcome::done);
        EXPECT_EQ(condensation.description(), "");
        expect_reference(network, condensation, symmetry);
      }
}

TEST(StrutCondensation, DistinguishesNonFiniteFromSingularStruts)
{
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()})
    for (const Symmetry symmetry : {Symmetry::given, Symmetry::none})
      {
        StrutNetwork        network;
        StrutCondensation   condensation(*network.matrix);
        std::vector<double> values(81, 0.);
        values[80] = wrong;
        if (network.layout->rank() == 0)
          network.matrix->add(0, values.data());
        EXPECT_EQ(condensation.condense(symmetry),
                  FactorizationOutcome::not_finite);
      }
}

TEST(StrutCondensation, CountsEigenvaluesOfTheInside)
{
  NetworkShape shape;
  shape.order = 3;
  for (const unsigned int n_elements : {1, 3})
    for (const double shift : {0., 10., 12., 14.})
      {
        shape.n_elements = n_elements;
        shape.shift      = shift;
        const StrutNetwork network(shape);
        StrutCondensation  condensation(*network.matrix);
        ASSERT_EQ(condensation.condense(Symmetry::given),
                  FactorizationOutcome::done);
        const DenseMatrix inside =
          network.dense_part([&](const StrutNetwork::Unknown &unknown) {
            return is_condensed(network, unknown);
          });
        const unsigned long n_negative = n_negative_eigenvalues(inside);
        EXPECT_EQ(n_negative > 0, shift > 0);
        ASSERT_TRUE(condensation.inner_inertia());
        EXPECT_EQ(condensation.inner_inertia()->negative, n_negative);
        EXPECT_EQ(condensation.inner_inertia()->positive,
                  inside.m() - n_negative);
        EXPECT_EQ(condensation.inner_inertia()->zero, 0u);
        condensation.condense(Symmetry::none);
        EXPECT_FALSE(condensation.inner_inertia());
      }
}
