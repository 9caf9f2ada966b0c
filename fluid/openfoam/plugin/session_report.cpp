// SPDX-License-Identifier: GPL-3.0-or-later
// What a session leaves for the summary of the run.
#include <Pstream.H>

#include <fstream>

#include "fluid/openfoam/plugin/session.hpp"

namespace blockweir::openfoam {

/// For the summary of the run: its phases with their seconds, then counts, a name and a number a line.
void Session::write_report() const {
  if (!Foam::Pstream::master()) return;
  const std::string folder = time_.globalPath();
  std::ofstream(folder + "/blockweir.times")
      << "wait " << partner_.waited_s() << "\npack " << partner_.packed_s() << "\nwire " << partner_.wire_s()
      << "\ncut " << blocks_.cut_s() << "\nmapping " << mapping_s_ - blocks_.cut_s() << "\nstep " << steps_s_
      << "\noutput " << output_s_ << '\n';
  std::ofstream(folder + "/blockweir.counts") << "windows " << windows_ << "\nwindows_at_rest " << passed_ << "\ncuts "
                                              << blocks_.cuts() << "\nskipped_cuts " << blocks_.skipped_cuts() << '\n';
  std::ofstream warnings(folder + "/blockweir.warnings");
  if (!flow_) return;
  for (const std::string& warning : flow_->warnings()) warnings << warning << '\n';
}

}  // namespace blockweir::openfoam
