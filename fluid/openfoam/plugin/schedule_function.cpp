// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/schedule_function.hpp"

#include <addToRunTimeSelectionTable.H>

namespace blockweir::openfoam {

defineTypeNameAndDebug(ScheduleFunction, 0);
using Foam::functionObject;
addToRunTimeSelectionTable(functionObject, ScheduleFunction, dictionary);

ScheduleFunction::ScheduleFunction(const Foam::word& name, const Foam::Time& time, const Foam::dictionary& dict)
    : Foam::functionObjects::fvMeshFunctionObject(name, time, dict), session_(Session::of(mesh_)) {
  // Any other error in this place would be turned into a warning, and the run would go on without the blocks.
  if (session_ == nullptr) {
    FatalIOErrorInFunction(dict) << "there is no session: system/fvOptions needs an entry of type blockweirBlocks"
                                 << Foam::exit(Foam::FatalIOError);
  }
  session_->attach();
}

bool ScheduleFunction::execute() {
  session_->end_step();
  return true;
}

}  // namespace blockweir::openfoam
