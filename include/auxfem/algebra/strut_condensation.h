#ifndef auxfem_algebra_strut_condensation_h
#define auxfem_algebra_strut_condensation_h

#include <auxfem/algebra/joint_blocks.h>
#include <auxfem/algebra/tangent_matrix.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Static condensation: what equations A x = b leave at the joints once the
   * unknowns inside the struts and the prescribed ones are eliminated,
   *
   *     S z = g,  S = A_JJ - A_JI A_II^-1 A_IJ,
   *
   * I inside the struts, J free at joints. Rows and columns are those of
   * JointBlocks; moments are divided by a length and rotations measured in that
   * length times radian, so all entries have the unit N/m. Rows that are
   * prescribed or stand for nothing are rows of the identity.
   */
  class StrutCondensation
  {
  public:
    /**
     * @param length that ties moments to forces (m).
     * @p matrix must stay as it is between condense() and the last expand().
     */
    StrutCondensation(const DofNumbering &numbering,
                      const JointBlocks  &blocks,
                      TangentMatrix      &matrix,
                      double              length);

    /**
     * Makes S from the matrix as it is now. Returns false if the inside of a
     * strut is singular on any rank. Collective.
     */
    bool condense();

    /** S; a new one with each condense(). */
    Epetra_CrsMatrix &matrix();

    /** Returns g for the right-hand side @p b on owned rows of the numbering. */
    const Epetra_Vector &reduce(const Epetra_Vector &b);

    /** Completes @p x, owned rows, from @p z and the last reduce(). */
    void expand(const Epetra_Vector &z, Epetra_Vector &x) const;

  private:
    /** A strut's inner unknowns and the free ones at joints they act on. */
    struct Inside
    {
      std::vector<int> unknowns, at_joints;
    };

    /** Global columns and entries. */
    struct MatrixRow
    {
      std::vector<int>    columns;
      std::vector<double> entries;
    };

    void collect_struts();
    /** Throws InputError if a row inside @p strut acts on the inside of another. */
    void
    refuse_coupled_struts(unsigned int strut, const int *columns, int n) const;
    void make_inner_matrix();
    void fill_inner_matrix();
    void make_influence();
    void make_joint_matrix();
    /**
     * Row of S for an owned unknown.
     * @param with_ghosts rows of A_II^-1 A_IJ for all local unknowns.
     * @param of_influence room for one of these rows.
     */
    void joint_row(int                     unknown,
                   const Epetra_CrsMatrix &with_ghosts,
                   MatrixRow              &of_influence,
                   MatrixRow              &row) const;
    /** Solves A_II y = r for the inner unknowns, in place. */
    void solve_inside(Epetra_MultiVector &of_inside);

    bool   is_free_at_joint(int unknown) const;
    double scale(int unknown) const;

    const DofNumbering                &numbering;
    const JointBlocks                 &blocks;
    TangentMatrix                     &tangent;
    const double                       length;
    std::vector<Inside>                struts;
    std::vector<int>                   inner_unknowns;
    std::vector<int>                   inner_index;
    std::unique_ptr<Epetra_Map>        inner_map;
    std::unique_ptr<Epetra_CrsMatrix>  inner_matrix;
    Epetra_LinearProblem               inner_problem;
    std::unique_ptr<Amesos_BaseSolver> inner_solver;
    bool                               has_symbolic = false;
    /** A_II^-1 A_IJ, rows of the numbering, columns of JointBlocks. */
    std::unique_ptr<Epetra_CrsMatrix> influence;
    std::unique_ptr<Epetra_CrsMatrix> joint_matrix;
    /** g, and x but for what z adds. */
    Epetra_Vector reduced, prepared;
  };
} // namespace auxfem

#endif
