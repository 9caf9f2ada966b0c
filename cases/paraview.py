# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a run in ParaView, from its folder: paraview --script=.../cases/paraview.py

Blocks by their vertical stress, with outlines; contacts of joints by their state (0 open, 1 sticks, 2 slips); wet faces by the water's pressure."""
from paraview.simple import (ColorBy, ExtractBlock, GetActiveViewOrCreate, GetAnimationScene, Hide, MergeBlocks, PVDReader,
                             RenameSource, ResetCamera, Show)

run = PVDReader(FileName="blocks.pvd")
RenameSource("run", run)
view = GetActiveViewOrCreate("RenderView")
view.InteractionMode = "2D"
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()


def shown(part, representation, *field, **settings):
    """One part of the run as a source of its own, coloured by a field of its cells or points."""
    source = MergeBlocks(Input=ExtractBlock(Input=run, Selectors=["/Root/" + part]))
    RenameSource(part, source)
    display = Show(source, view)
    display.SetRepresentationType(representation)
    for name, value in settings.items():
        setattr(display, name, value)
    ColorBy(display, field)
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(view, True)


shown("blocks", "Surface With Edges", "CELLS", "stress_pa", "yy")
shown("joints", "Points", "CELLS", "state", PointSize=8)
shown("water", "Wireframe", "POINTS", "pressure_pa", LineWidth=4)
Hide(run, view)
ResetCamera(view)
