#ifndef auxfem_output_energy_judgement_h
#define auxfem_output_energy_judgement_h

#include <auxfem/output/verdict.h>
#include <auxfem/time/checkpoint_archive.h>
#include <auxfem/time/energies.h>
#include <auxfem/time/largest_in_time.h>

namespace auxfem
{
  /**
   * Judges a run by its energies: their balance, in both directions, and what
   * the time integration gives or takes, over the energy that came in
   * (doc/user/verdict.md).
   */
  class EnergyJudgement
  {
  public:
    /** What runs have energies for. */
    enum class Kind
    {
      motion,
      static_steps,
      static_path,
      reduced_cell
    };

    explicit EnergyJudgement(Kind kind);

    /** Of t = 0. */
    void start(const Energies &energies);

    /** Whether the balance at a state that is to be added asks for a finding,
     * unless it is round-off. */
    bool is_off(const Energies &energies) const;

    /**
     * Of an accepted state at @p time (s).
     * @param round_off of the balance (J)
     */
    void add(const Energies &energies, double time, double round_off = 0);

    std::vector<Finding> findings() const;

    void serialize(CheckpointArchive &archive);

  private:
    Finding error_finding(double moved) const;
    /** What to do about an error. */
    std::string advice() const;

    const Kind    kind;
    double        zero = 0, initial = 0, work = 0; ///< J
    LargestInTime error, given, taken;             ///< J
  };
} // namespace auxfem

#endif
