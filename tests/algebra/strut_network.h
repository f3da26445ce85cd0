#ifndef auxfem_tests_algebra_strut_network_h
#define auxfem_tests_algebra_strut_network_h

#include <auxfem/algebra/tangent_matrix.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <random>
#include <set>

namespace auxfem::testing_support
{
  using DenseMatrix = dealii::FullMatrix<double>;

  /** Number of negative eigenvalues of a symmetric matrix. */
  inline unsigned int n_negative_eigenvalues(const DenseMatrix &matrix)
  {
    dealii::LAPACKFullMatrix<double> copy(matrix.m());
    copy = matrix;
    copy.compute_eigenvalues();
    unsigned int n = 0;
    for (unsigned int i = 0; i < matrix.m(); ++i)
      n += copy.eigenvalue(i).real() < 0;
    return n;
  }

  /** Properties of a StrutNetwork. */
  struct NetworkShape
  {
    unsigned int n_components = 3; ///< of a node
    unsigned int order        = 2;
    unsigned int n_elements   = 1; ///< a strut
    /**
     * Size of the skew part of blocks, relative to a symmetric part of about
     * one.
     */
    double       asymmetry     = 0;
    unsigned int n_multipliers = 0; ///< at most 2
    /** Whether a block acts on the inside of struts 1 and 2. */
    bool has_contact = false;
    /** Subtracted from the diagonal of each block. */
    double shift = 0;
  };

  /**
   * Five struts between four joints with random blocks, distributed over the
   * ranks of MPI_COMM_WORLD, and the same as a dense matrix on each rank. Four
   * motions are prescribed; the end of one strut has rotations of its own.
   */
  class StrutNetwork
  {
  public:
    /** An unknown, the same on all ranks. */
    struct Unknown
    {
      unsigned int                owner;
      UnknownKind                 kind;
      bool                        is_rotation;
      std::optional<unsigned int> strut;
      unsigned int                joint, component;
      int                         global;
    };

    explicit StrutNetwork(const NetworkShape &shape = {})
      : shape(shape)
      , n_ranks(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD))
      , rank(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
    {
      make_joints();
      make_struts();
      make_other_blocks();
      number_unknowns();
      describe_unknowns();
      pattern = std::make_unique<TangentPattern>(*unknowns);
      register_blocks();
      matrix = std::make_unique<TangentMatrix>(*pattern);
      fill();
    }

    /** Registers all blocks of this rank. */
    void register_blocks()
    {
      local_blocks.clear();
      for (const Block &block : blocks)
        if (is_local(block))
          {
            std::vector<int> local;
            for (const int u : block.unknowns)
              local.push_back(u < 0 ? -1 : layout->local(all[u].global));
            pattern->register_block(local.data(), local.size());
            local_blocks.push_back(&block);
          }
    }

    void fill()
    {
      matrix->reset();
      for (std::size_t b = 0; b < local_blocks.size(); ++b)
        matrix->add(b, local_blocks[b]->values.data());
    }

    /**
     * Dense matrix of all ranks by global numbers. Prescribed rows are identity
     * rows; with `enforced` the rest is symmetric except for prescribed
     * columns.
     */
    DenseMatrix dense(const Symmetry symmetry = Symmetry::none) const
    {
      DenseMatrix sum(all.size());
      for (const Block &block : blocks)
        {
          const unsigned int n  = block.unknowns.size();
          const auto         at = [&](const unsigned int i, unsigned int j) {
            return block.values[i * n + j];
          };
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              if (block.unknowns[i] >= 0 && block.unknowns[j] >= 0)
                {
                  const Unknown &row    = all[block.unknowns[i]],
                                &column = all[block.unknowns[j]];
                  const bool is_halved  = symmetry == Symmetry::enforced &&
                    column.kind != UnknownKind::prescribed;
                  if (row.kind != UnknownKind::prescribed)
                    sum(row.global, column.global) +=
                      is_halved ? (at(i, j) + at(j, i)) / 2 : at(i, j);
                }
        }
      for (const Unknown &unknown : all)
        if (unknown.kind == UnknownKind::prescribed)
          sum(unknown.global, unknown.global) = 1;
      return sum;
    }

    /** Rows and columns of dense() selected by @p select. */
    template <class Select>
    DenseMatrix dense_part(const Select &select) const
    {
      std::vector<unsigned int> chosen;
      for (const Unknown &unknown : all)
        if (select(unknown))
          chosen.push_back(unknown.global);
      DenseMatrix part(chosen.size());
      part.extract_submatrix_from(dense(), chosen, chosen);
      return part;
    }

    /** Right-hand side of size one, by global number. */
    dealii::Vector<double> right_side() const
    {
      dealii::Vector<double> b(all.size());
      for (unsigned int i = 0; i < all.size(); ++i)
        b(i) = std::cos(1. + i);
      return b;
    }

    /** Owned rows of global values, with room for ghosts. */
    std::vector<double> owned(const dealii::Vector<double> &values) const
    {
      std::vector<double> local(layout->n_local(), -7e77);
      for (unsigned int i = 0; i < layout->n_owned(); ++i)
        local[i] = values(layout->global(i));
      return local;
    }

    /** The solution of the dense equations for right_side(). */
    dealii::Vector<double>
    solution(const Symmetry symmetry = Symmetry::none) const
    {
      DenseMatrix            inverse = dense(symmetry);
      dealii::Vector<double> x(all.size());
      inverse.gauss_jordan();
      inverse.vmult(x, right_side());
      return x;
    }

    const Unknown &unknown(const int global) const
    {
      return *std::find_if(all.begin(), all.end(), [&](const Unknown &u) {
        return u.global == global;
      });
    }

    unsigned int n_unknowns() const
    {
      return all.size();
    }

    const NetworkShape              shape;
    std::unique_ptr<UnknownLayout>  layout;
    std::unique_ptr<Unknowns>       unknowns;
    std::unique_ptr<TangentPattern> pattern;
    std::unique_ptr<TangentMatrix>  matrix;

  private:
    struct Block
    {
      std::vector<int>    unknowns; ///< index into `all`, or -1
      std::vector<double> values;
    };

    static constexpr unsigned int n_joints = 4, n_struts = 5;
    static constexpr unsigned int strut_ends[n_struts][2] = {{0, 1},
                                                             {1, 2},
                                                             {3, 2},
                                                             {3, 0},
                                                             {0, 2}};

    bool is_rotation(const unsigned int component) const
    {
      return component >= (shape.n_components == 3 ? 2 : 3);
    }

    unsigned int owner_of_joint(const unsigned int joint) const
    {
      return joint * n_ranks / n_joints;
    }

    int add_unknown(const unsigned int                owner,
                    const unsigned int                component,
                    const std::optional<unsigned int> strut,
                    const unsigned int                joint)
    {
      all.push_back({owner,
                     is_rotation(component) ? UnknownKind::rotation
                                            : UnknownKind::translation,
                     is_rotation(component),
                     strut,
                     joint,
                     component,
                     -1});
      return all.size() - 1;
    }

    std::vector<int> add_node(const unsigned int                owner,
                              const std::optional<unsigned int> strut,
                              const unsigned int                joint)
    {
      std::vector<int> node;
      for (unsigned int c = 0; c < shape.n_components; ++c)
        node.push_back(add_unknown(owner, c, strut, joint));
      return node;
    }

    void make_joints()
    {
      for (unsigned int joint = 0; joint < n_joints; ++joint)
        joints.push_back(add_node(owner_of_joint(joint), {}, joint));
      for (unsigned int c = 0; c < 3; ++c)
        all[joints[0][c]].kind = UnknownKind::prescribed;
      all[joints[3][1]].kind = UnknownKind::prescribed;
    }

    void make_struts()
    {
      for (unsigned int s = 0; s < n_struts; ++s)
        {
          const unsigned int owner = owner_of_joint(strut_ends[s][s % 2]);
          std::vector<int>   node  = joints[strut_ends[s][0]],
                           last    = joints[strut_ends[s][1]];
          for (unsigned int c = 0; c < shape.n_components; ++c)
            if (is_rotation(c) && s + 1 == n_struts)
              last[c] = add_unknown(owner, c, {}, strut_ends[s][1]);
          for (unsigned int e = 0; e < shape.n_elements; ++e)
            {
              const std::vector<int> next =
                e + 1 == shape.n_elements ? last : add_node(owner, s, 0);
              std::vector<int> element_unknowns = node;
              const auto       append = [&](const std::vector<int> &further) {
                element_unknowns.insert(element_unknowns.end(),
                                        further.begin(),
                                        further.end());
              };
              append(next);
              for (unsigned int k = 1; k < shape.order; ++k)
                append(add_node(owner, s, 0));
              add_block(element_unknowns);
              node = next;
            }
          last_inside.push_back(all.size() - 1);
        }
    }

    void make_other_blocks()
    {
      // Connectors; one lacks an unknown.
      add_block({joints[1][0], -1, joints[3][1], joints[1][1]});
      add_block({joints[2][0], joints[2][1]});
      if (shape.has_contact)
        add_block({last_inside[1], joints[0][2], last_inside[2]});
      for (unsigned int m = 0; m < shape.n_multipliers; ++m)
        {
          const int multiplier = add_unknown(owner_of_joint(3), 0, {}, 3);
          all[multiplier].kind = UnknownKind::multiplier;
          std::vector<double> values(9, 0.);
          values[1] = values[3] = 1;
          values[2] = values[6] = -1.5;
          blocks.push_back(
            {{multiplier, joints[1][m], joints[3][2 * m]}, values});
        }
    }

    void add_block(const std::vector<int> &block_unknowns)
    {
      const unsigned int               n = block_unknowns.size();
      std::mt19937                     random(blocks.size() + 1);
      std::uniform_real_distribution<> entry(-1., 1.);
      std::vector<double>              values(n * n);
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int j = 0; j < i; ++j)
            {
              const double symmetric = entry(random),
                           skew      = shape.asymmetry * entry(random);
              values[i * n + j]      = symmetric + skew;
              values[j * n + i]      = symmetric - skew;
            }
          values[i * n + i] = n + entry(random) - shape.shift;
        }
      blocks.push_back({block_unknowns, values});
    }

    void number_unknowns()
    {
      int number = 0;
      for (unsigned int r = 0; r < n_ranks; ++r)
        for (Unknown &unknown : all)
          if (unknown.owner == r)
            unknown.global = number++;
    }

    bool is_local(const Block &block) const
    {
      return std::any_of(block.unknowns.begin(),
                         block.unknowns.end(),
                         [this](const int u) {
                           return u >= 0 && all[u].owner == rank;
                         });
    }

    void describe_unknowns()
    {
      std::set<int> ghosts;
      for (const Block &block : blocks)
        if (is_local(block))
          for (const int u : block.unknowns)
            if (u >= 0 && all[u].owner != rank)
              ghosts.insert(all[u].global);
      const unsigned int n_owned =
        std::count_if(all.begin(), all.end(), [this](const Unknown &u) {
          return u.owner == rank;
        });
      // Ghosts in an order other than that of global numbers.
      layout   = std::make_unique<UnknownLayout>(MPI_COMM_WORLD,
                                               n_owned,
                                               std::vector<int>(ghosts.rbegin(),
                                                                ghosts.rend()));
      unknowns = std::make_unique<Unknowns>(*layout);
      for (unsigned int i = 0; i < layout->n_local(); ++i)
        {
          const Unknown &from      = unknown(layout->global(i));
          unknowns->kinds[i]       = from.kind;
          unknowns->is_rotation[i] = from.is_rotation;
          unknowns->strut[i]       = from.strut;
          unknowns->joint[i]       = from.joint;
          unknowns->component[i]   = from.component;
        }
      for (unsigned int c = 0; c < shape.n_components; ++c)
        unknowns->components.push_back(c);
      unknowns->length = 0.5;
    }

    const unsigned int            n_ranks, rank;
    std::vector<Unknown>          all;
    std::vector<std::vector<int>> joints;
    std::vector<int>              last_inside; ///< of each strut
    std::vector<Block>            blocks;
    std::vector<const Block *>    local_blocks;
  };
} // namespace auxfem::testing_support

#endif
