using System;
using System.Collections.Generic;

namespace Caterpillar.Icons;

/// <summary>The icons by name. Everything stays two pixels away from the edge.</summary>
internal static class Drawings
{
    public static IReadOnlyDictionary<string, Action<Canvas>> All { get; } = new SortedDictionary<string, Action<Canvas>>(StringComparer.Ordinal)
    {
        ["Plugin"] = c => Caterpillar(c),
        ["Component"] = c => c.Ring(12, 12, 8, 2.4, Ink.Green).Disc(12, 12, 2.5, Ink.Dark),
        ["Printer"] = Printer,
        ["PrintSetup"] = c => { Printer(c); c.Rect(13, 12, 21, 21, Ink.Orange).Line(15, 15, 19, 15, 1.2, Ink.Light).Line(15, 18, 19, 18, 1.2, Ink.Light); },
        ["DeconstructSetup"] = c => { c.Rect(3, 8, 9, 16, Ink.Orange); c.Line(9, 12, 13, 12, 1.4, Ink.Gray).Line(13, 6, 13, 18, 1.4, Ink.Gray)
            .Line(13, 6, 16, 6, 1.4, Ink.Gray).Line(13, 18, 16, 18, 1.4, Ink.Gray).Line(13, 12, 16, 12, 1.4, Ink.Gray)
            .Disc(18, 6, 2.4, Ink.Green).Disc(18, 12, 2.4, Ink.Dark).Disc(18, 18, 2.4, Ink.Blue); },
        ["SetupParam"] = c => c.Hexagon().Polyline(1.6, Ink.Light, 8, 17, 8, 7.5, 16, 7.5, 16, 17, 8, 17).Rect(11, 11, 17, 17.5, Ink.Orange),
        ["PrinterChoiceParam"] = c => c.Hexagon().Polyline(1.6, Ink.Light, 8, 17, 8, 7.5, 16, 7.5, 16, 17, 8, 17).Line(10, 12, 14, 12, 1.8, Ink.Green),
        ["MaterialChoiceParam"] = c => c.Hexagon().Ring(12, 12, 4.5, 2.4, Ink.Orange).Line(10, 12, 14, 12, 1.8, Ink.Green),
        ["SettingsChoiceParam"] = c => c.Hexagon().Line(7, 9, 17, 9, 1.4, Ink.Light).Line(7, 15, 17, 15, 1.4, Ink.Light).Line(10, 12, 14, 12, 1.8, Ink.Green),
        ["Material"] = c => c.Ring(12, 12, 7.5, 4, Ink.Orange).Ring(12, 12, 4, 1, Ink.Dark).Ring(12, 12, 9.2, 1, Ink.Dark)
            .Line(19, 13, 21, 20.5, 1.4, Ink.Orange),
        ["PrintSettings"] = Sliders,
        ["Turtle"] = c => Turtle(c, 12, 12, 1),
        ["TurtleProgram"] = c => { Page(c); c.Line(8, 8, 15, 8, 1.3, Ink.Dark).Line(8, 11, 13, 11, 1.3, Ink.Dark); Turtle(c, 12, 15.5, 0.45); },
        ["TurtlePreview"] = c => { c.Polyline(2, Ink.Orange, 4, 19, 4.5, 12, 11, 12); Turtle(c, 15, 12, 0.75); },
        ["LSystem"] = c => c.Line(12, 20.5, 12, 12, 2.2, Ink.Green).Polyline(1.8, Ink.Green, 6, 6, 12, 12, 18, 6)
            .Polyline(1.4, Ink.Green, 4, 9.5, 7.5, 7.5, 8.5, 3.5).Polyline(1.4, Ink.Green, 20, 9.5, 16.5, 7.5, 15.5, 3.5),
        ["TurtleMove"] = c => c.Line(4, 12, 16, 12, 2.2, Ink.Green).Polygon(Ink.Dark, 14, 7, 21, 12, 14, 17),
        ["TurtleRotate"] = c => c.Ring(12, 12, 7.5, 2.2, Ink.Green).Polygon(Ink.Dark, 11, 2.5, 17.5, 5.5, 11, 8.5),
        ["TurtlePen"] = c => c.Polygon(Ink.Orange, 16, 3.5, 20.5, 8, 10.5, 18, 6, 13.5).Polygon(Ink.Dark, 6, 13.5, 10.5, 18, 4, 20),
        ["TurtleExtrusion"] = c => { Nozzle(c, 12, 4); c.Polygon(Ink.Green, 4, 14, 20, 11.5, 20, 18.5, 4, 16.5); },
        ["TurtleEvent"] = c => c.Polygon(Ink.Orange, 13.5, 3, 6, 13, 11, 13, 9.5, 21, 18, 10, 12.5, 10),
        ["TurtleRepeat"] = c => c.Polyline(2, Ink.Green, 5, 13, 5, 7, 17, 7).Polyline(2, Ink.Green, 19, 11, 19, 17, 7, 17)
            .Polygon(Ink.Dark, 15, 3.5, 20, 7, 15, 10.5).Polygon(Ink.Dark, 9, 13.5, 4, 17, 9, 20.5),
        ["TurtleProgramParam"] = c => { c.Hexagon().Line(8, 7.5, 16, 7.5, 1.3, Ink.Light); Turtle(c, 12, 13.5, 0.5); },
        ["TurtleCommandParam"] = c => c.Hexagon().Line(7, 12, 14, 12, 1.8, Ink.Green).Polygon(Ink.Light, 13, 8.5, 18, 12, 13, 15.5),
        ["RoundTrace"] = c => c.Polyline(2.2, Ink.Green, 20, 12, 17.7, 17.7, 12, 20, 6.3, 17.7, 4, 12, 6.3, 6.3, 12, 4, 17.7, 6.3, 20, 12)
            .Disc(19.8, 12, 2, Ink.Dark),
        ["RisingTrace"] = c => c.Polyline(1.9, Ink.Green, 4.5, 19, 12, 20.4, 19.5, 17.5, 12, 15.5, 4.5, 14, 12, 15.4, 19.5, 12.5, 12, 10.5, 4.5, 9, 12, 10.4,
            19.5, 7.5, 12, 5.5, 4.5, 4),
        ["Deform"] = c => c.Line(4, 20, 4, 5, 1.4, Ink.Gray).Line(9, 20, 9, 5, 1.4, Ink.Gray).Polyline(2.2, Ink.Green, 14, 20, 15, 14, 12.5, 9, 15.5, 4)
            .Polyline(2.2, Ink.Green, 19, 20, 20, 14, 17.5, 9, 20, 4),
        ["Modulate"] = c => c.Polygon(Ink.Green, 4, 11, 9, 11, 12, 8, 15, 8, 18, 11, 20, 11, 20, 14, 18, 14, 15, 17, 12, 17, 9, 14, 4, 14)
            .Disc(6, 5.5, 2.2, Ink.Dark).Disc(12, 4.8, 1.4, Ink.Gray).Disc(17.5, 5.5, 2.2, Ink.Light),
        ["CoolLayers"] = c => c.Line(4, 19, 14, 19, 2.2, Ink.Green).Line(4, 15, 11, 15, 2.2, Ink.Green).Line(4, 11, 8, 11, 2.2, Ink.Green)
            .Line(16.5, 3.5, 16.5, 14.5, 1.4, Ink.Blue).Line(11.5, 6, 20.5, 12, 1.4, Ink.Blue)
            .Line(11.8, 12, 20.5, 6, 1.4, Ink.Blue),
        ["ImportProfile"] = c => { Page(c); c.Line(8, 7.5, 16, 7.5, 1.8, Ink.Green).Line(8, 10, 14, 10, 1.3, Ink.Dark).Line(8, 14, 16, 14, 1, Ink.Gray)
            .Line(8, 17.5, 16, 17.5, 1.8, Ink.Green); },
        ["Simulate"] = c => { Nozzle(c, 13, 4); c.Line(4, 16, 13, 16, 2.4, Ink.Green).Line(4, 19.5, 20, 19.5, 2.4, Ink.Green)
            .Line(13, 16, 20, 16, 1, Ink.Gray); },
        ["Play"] = c => c.Polygon(Ink.Green, 7, 4, 20, 12, 7, 20),
        ["Statistics"] = c => c.Rect(4, 13, 8, 20, Ink.Green).Rect(10, 8, 14, 20, Ink.Orange).Rect(16, 4.5, 20, 20, Ink.Blue)
            .Line(3, 20.5, 21, 20.5, 1.2, Ink.Dark),
        ["WaitForResults"] = c => c.Polygon(Ink.Green, 6, 4.5, 18, 4.5, 12, 12).Polygon(Ink.Orange, 12, 12, 18, 19.5, 6, 19.5)
            .Line(4.5, 3.8, 19.5, 3.8, 1.8, Ink.Dark).Line(4.5, 20.2, 19.5, 20.2, 1.8, Ink.Dark),
        ["Check"] = c => c.Polyline(3.2, Ink.Green, 4.5, 12.5, 9.5, 18, 19.5, 6),
        ["ToolpathPreview"] = c => c.Line(4, 18, 20, 18, 2.6, Ink.Blue).Line(4, 14, 20, 14, 2.6, Ink.Green).Line(4, 10, 20, 10, 2.6, Ink.Orange)
            .Line(4, 6, 20, 6, 2.6, Ink.Dark),
        ["BakeToolpath"] = c => c.Polyline(2.2, Ink.Green, 4, 9, 9, 4.5, 14, 9, 20, 4.5).Polygon(Ink.Orange, 8, 12.5, 16, 12.5, 12, 17.5)
            .Line(4, 20.3, 20, 20.3, 2, Ink.Dark),
        ["PlanarSlicer"] = c => c.Polygon(Ink.Light, 12, 3, 21, 19, 3, 19).Line(10.2, 7.5, 13.8, 7.5, 1.6, Ink.Green).Line(8, 11.5, 16, 11.5, 1.6, Ink.Green)
            .Line(5.8, 15.5, 18.2, 15.5, 1.6, Ink.Green).Line(3.6, 19.5, 20.4, 19.5, 1.6, Ink.Green),
        ["CurvedSlicer"] = c => c.Polygon(Ink.Light, 3, 20, 3, 11, 8, 6.5, 12, 5, 16, 6.5, 21, 11, 21, 20)
            .Polyline(1.6, Ink.Green, 4.5, 13.5, 8, 10.5, 12, 9, 16, 10.5, 19.5, 13.5).Polyline(1.6, Ink.Green, 4.5, 18, 8, 15, 12, 13.5, 16, 15, 19.5, 18),
        ["LayerField"] = c => c.Polyline(1.6, Ink.Green, 3.5, 8, 8, 5, 12, 6, 16, 9, 20.5, 6)
            .Polyline(1.6, Ink.Orange, 3.5, 13.5, 8, 11, 12, 12, 16, 14, 20.5, 12)
            .Polyline(1.6, Ink.Dark, 3.5, 19, 8, 18, 12, 18.5, 16, 19.2, 20.5, 18.5),
        ["ProjectPaths"] = c => c.Line(4, 5, 20, 5, 2, Ink.Green).Line(12, 7, 12, 12, 1.4, Ink.Gray).Polygon(Ink.Gray, 9.5, 10.5, 14.5, 10.5, 12, 13.5)
            .Polygon(Ink.Light, 3, 21, 3, 18, 8, 15, 12, 16, 16, 18, 21, 15.5, 21, 21).Polyline(2, Ink.Green, 3.5, 17, 8, 14.2, 12, 15.2, 16, 17.2, 20.5, 15),
        ["ArrangeModels"] = c => c.Polygon(Ink.Light, 3, 20, 7, 9, 21, 9, 17, 20).Rect(8, 10.5, 11.5, 14, Ink.Green).Rect(13.5, 10.5, 17, 14, Ink.Green)
            .Rect(6.5, 15, 10, 18.5, Ink.Orange).Rect(12, 15, 15.5, 18.5, Ink.Blue),
        ["ReadModel"] = c => { Page(c); c.Polygon(Ink.Green, 12, 6.5, 17, 9.5, 17, 15.5, 12, 18.5, 7, 15.5, 7, 9.5)
            .Polyline(1.1, Ink.Dark, 7, 9.5, 12, 12.5, 17, 9.5).Line(12, 12.5, 12, 18.5, 1.1, Ink.Dark); },
        ["LayFlat"] = c => c.Polygon(Ink.Gray, 5, 9, 10, 3.5, 16, 9, 11, 14).Line(3, 20.5, 21, 20.5, 1.8, Ink.Dark).Rect(7, 15, 19, 19.5, Ink.Green)
            .Polygon(Ink.Orange, 17, 8.5, 21, 8.5, 19, 12.5),
        ["LayerFieldParam"] = c => c.Hexagon().Polyline(1.6, Ink.Green, 7, 9.5, 10, 8, 14, 10, 17, 8.5)
            .Polyline(1.6, Ink.Light, 7, 12.5, 10, 11, 14, 13, 17, 11.5)
            .Polyline(1.6, Ink.Orange, 7, 15.5, 10, 14, 14, 16, 17, 14.5),
        ["ReadCurves"] = c => { Page(c); c.Ring(12, 13.5, 3.8, 1.9, Ink.Green); },
        ["PlanToolpath"] = c => c.Polyline(2, Ink.Green, 4, 19, 10, 19, 10, 13).Polyline(1.2, Ink.Gray, 10, 13, 12, 6, 16, 6, 17, 12)
            .Polyline(2, Ink.Green, 17, 12, 17, 19, 20.5, 19)
            .Disc(4.5, 19, 2, Ink.Dark).Disc(19.5, 19, 2, Ink.Orange),
        ["GenerateGCode"] = c => { Page(c); Nozzle(c, 12, 7); c.Line(8.5, 17, 15.5, 17, 1.8, Ink.Green); },
        ["GCodeText"] = c => { Page(c); c.Line(8, 8, 14, 8, 1.3, Ink.Green).Line(8, 11, 16, 11, 1.3, Ink.Dark).Line(8, 14, 13, 14, 1.3, Ink.Dark)
            .Line(8, 17, 16, 17, 1.3, Ink.Dark); },
        ["DecodeGCode"] = c => { Page(c); c.Polyline(2, Ink.Green, 8, 17, 11, 10, 14, 14, 18, 7); },
        ["DeconstructPrintPath"] = c => c.Polyline(2.4, Ink.Green, 4, 18, 9, 7, 15, 15, 20, 5).Disc(4.2, 18, 2, Ink.Dark).Disc(9, 7, 2, Ink.Dark)
            .Disc(15, 15, 2, Ink.Dark).Disc(19.8, 5.2, 2, Ink.Dark),
        ["SortPaths"] = c => c.Line(3.5, 4.5, 7, 4.5, 2.4, Ink.Green).Line(3.5, 9.5, 9.5, 9.5, 2.4, Ink.Green).Line(3.5, 14.5, 12, 14.5, 2.4, Ink.Green)
            .Line(3.5, 19.5, 14.5, 19.5, 2.4, Ink.Green).Line(18.5, 4, 18.5, 15, 1.6, Ink.Dark).Polygon(Ink.Dark, 15, 14.5, 22, 14.5, 18.5, 20.5),
        ["GapBead"] = c => c.Polygon(Ink.Gray, 3, 21, 3, 17, 9, 12, 15, 15.5, 21, 11, 21, 21).Polygon(Ink.Green, 3, 16, 9, 11, 15, 14.5, 21, 10, 21, 7, 3, 7)
            .Line(3, 5, 21, 5, 1.4, Ink.Dark),
        ["ConstructPrintPath"] = c => c.Polyline(2.4, Ink.Green, 4, 18, 9, 7, 15, 15, 20, 5).Line(14.5, 19.5, 20.5, 19.5, 1.8, Ink.Dark)
            .Line(17.5, 16.5, 17.5, 21, 1.8, Ink.Dark),
        ["ConstructBead"] = c => c.Disc(7.5, 15, 4.5, Ink.Green).Disc(16.5, 15, 4.5, Ink.Green).Rect(7.5, 10.5, 16.5, 19.5, Ink.Green)
            .Line(3.5, 20.6, 20.5, 20.6, 1.4, Ink.Dark)
            .Line(4, 6.5, 20, 6.5, 1.2, Ink.Dark).Line(4, 4.5, 4, 8.5, 1.2, Ink.Dark).Line(20, 4.5, 20, 8.5, 1.2, Ink.Dark),
        ["Step"] = c => c.Polyline(2, Ink.Gray, 4, 19, 4, 12, 20, 12, 20, 19).Line(3.5, 19.8, 8, 19.8, 2.2, Ink.Green)
            .Line(16, 19.8, 20.5, 19.8, 2.2, Ink.Green).Polygon(Ink.Orange, 12, 3, 17, 8, 12, 13, 7, 8),
        ["ConstructToolpath"] = c => c.Polyline(2.2, Ink.Green, 4, 16, 9, 16, 9, 6, 15, 6).Disc(4.2, 16, 1.9, Ink.Dark).Disc(9, 11, 1.9, Ink.Dark)
            .Disc(15, 6, 1.9, Ink.Orange).Line(13.5, 17, 20.5, 17, 1.8, Ink.Dark).Line(17, 13.5, 17, 20.5, 1.8, Ink.Dark),
        ["MergeToolpaths"] = c => c.Polyline(2.2, Ink.Green, 3.5, 19, 9, 19, 9, 13, 3.5, 13).Polyline(2.2, Ink.Blue, 20.5, 19, 15, 19, 15, 13, 20.5, 13)
            .Polyline(1.3, Ink.Gray, 4, 12, 4, 5, 20, 5, 20, 12).Polygon(Ink.Orange, 10, 2.5, 15, 5, 10, 7.5),
        ["ToolpathFrames"] = c => c.Polyline(2.2, Ink.Green, 3.5, 20, 9, 14, 20.5, 14).Line(12, 14, 12, 4, 1.8, Ink.Blue)
            .Line(12, 14, 19.5, 14, 1.8, Ink.Orange).Line(12, 14, 7, 19.5, 1.8, Ink.Dark).Polygon(Ink.Blue, 9.5, 6.5, 14.5, 6.5, 12, 2.5),
        ["ViewerPage"] = c => c.Rect(3, 4, 21, 20, Ink.Light).Rect(3, 4, 21, 8, Ink.Gray).Polygon(Ink.Green, 12, 9, 17, 11.5, 17, 16, 12, 18.5, 7, 16, 7, 11.5)
            .Polyline(1.1, Ink.Dark, 7, 11.5, 12, 14, 17, 11.5).Line(12, 14, 12, 18.5, 1.1, Ink.Dark),
        ["SubdivideCurve"] = c => c.Polyline(1.8, Ink.Green, 4, 19, 10, 19, 14, 17.5, 17, 14.5, 18.5, 10.5, 19, 5).Disc(4.5, 19, 1.8, Ink.Dark)
            .Disc(10, 19, 1.8, Ink.Dark)
            .Disc(14, 17.5, 1.5, Ink.Orange).Disc(17, 14.5, 1.5, Ink.Orange).Disc(18.5, 10.5, 1.5, Ink.Orange).Disc(19, 5, 1.8, Ink.Dark),
        ["FitArcs"] = c => c.Ring(12, 13, 7.5, 2.2, Ink.Green).Polyline(1.2, Ink.Dark, 4.5, 13, 7, 7.5, 12, 5.2, 17, 7.5, 19.5, 13)
            .Disc(12, 13, 1.5, Ink.Orange),
        ["MergePaths"] = c => c.Polyline(2.2, Ink.Green, 4, 18, 8, 10, 12, 12).Polyline(2.2, Ink.Blue, 12, 12, 16, 14, 20, 6).Disc(12, 12, 2.4, Ink.Orange),
        ["BeadParam"] = c => c.Hexagon().Disc(9.5, 12, 3, Ink.Green).Disc(14.5, 12, 3, Ink.Green).Rect(9.5, 9, 14.5, 15, Ink.Green),
        ["DeconstructToolpath"] = c => c.Polyline(2.2, Ink.Green, 4, 18, 9, 18, 9, 8, 15, 8).Disc(4.2, 18, 1.9, Ink.Dark).Disc(9, 13, 1.9, Ink.Dark)
            .Disc(15, 8, 1.9, Ink.Orange)
            .Line(17, 13, 20.5, 13, 1.4, Ink.Gray).Line(17, 16, 20.5, 16, 1.4, Ink.Gray).Line(17, 19, 20.5, 19, 1.4, Ink.Gray),
        ["MoveFilter"] = c => c.Polygon(Ink.Gray, 3, 4, 21, 4, 14, 12, 14, 20, 10, 18, 10, 12).Disc(12, 7, 2, Ink.Orange),
        ["MoveFilterParam"] = c => c.Hexagon().Polygon(Ink.Light, 7, 8, 17, 8, 13, 12.5, 13, 17.5, 11, 16.5, 11, 12.5),
        ["FilterToolpath"] = c => c.Polygon(Ink.Gray, 3, 4, 21, 4, 14, 12, 14, 20, 10, 18, 10, 12).Line(6, 6.5, 18, 6.5, 1.8, Ink.Green),
        ["EditToolpath"] = c => c.Polyline(2.2, Ink.Green, 3.5, 19, 9, 19, 9, 12, 14, 12).Line(13, 17, 19.5, 6, 3, Ink.Orange)
            .Line(12.4, 18, 13.4, 16.3, 2, Ink.Dark),
        ["InsertAtLayer"] = c => c.Line(4, 19, 20, 19, 2, Ink.Green).Line(4, 15, 20, 15, 2, Ink.Green).Line(4, 7, 20, 7, 2, Ink.Green)
            .Line(4, 11, 14, 11, 1.4, Ink.Gray).Polygon(Ink.Orange, 20, 8, 20, 14, 14.5, 11),
        ["DeformToolpath"] = c => c.Line(4, 19, 20, 19, 1.8, Ink.Gray).Polyline(2, Ink.Green, 4, 15, 9, 13.4, 15, 13.4, 20, 15)
            .Polyline(2, Ink.Green, 4, 11, 9, 7.8, 15, 7.8, 20, 11).Disc(20, 11, 1.7, Ink.Orange),
        ["TiltTool"] = c => c.Polygon(Ink.Orange, 10.1, 14, 10, 9.3, 13, 4.1, 19, 7.5, 16, 12.7, 11.9, 15)
            .Polyline(2.2, Ink.Green, 3.5, 12.5, 10.5, 16.8, 20, 20).Line(6, 3.5, 6, 10, 1.4, Ink.Gray),
        ["SaveGCode"] = c => { Page(c); c.Line(12, 7, 12, 15, 2.4, Ink.Green).Polygon(Ink.Green, 8, 13, 16, 13, 12, 18); },
        ["PrintPathParam"] = c => c.Hexagon().Polyline(2.4, Ink.Green, 7, 16, 10.5, 8, 14, 15, 17, 8),
        ["ToolpathParam"] = c => c.Hexagon().Polyline(1.8, Ink.Green, 7, 16, 17, 16, 17, 13, 7, 13, 7, 10, 17, 10).Disc(17, 9.5, 1.6, Ink.Orange),
        ["PrinterParam"] = c => c.Hexagon().Polyline(1.6, Ink.Light, 8, 17, 8, 7.5, 16, 7.5, 16, 17, 8, 17).Line(12, 8, 12, 12, 2, Ink.Orange),
        ["MaterialParam"] = c => c.Hexagon().Ring(12, 12, 4.5, 3, Ink.Orange),
        ["SettingsParam"] = c => c.Hexagon().Line(7, 9, 17, 9, 1.4, Ink.Light).Line(7, 15, 17, 15, 1.4, Ink.Light).Disc(10, 9, 2, Ink.Green)
            .Disc(14, 15, 2, Ink.Green),
        ["GCodeParam"] = c => c.Hexagon().Rect(8.5, 6.5, 15.5, 17.5, Ink.Light).Line(10, 9, 14, 9, 1, Ink.Green).Line(10, 12, 14, 12, 1, Ink.Dark)
            .Line(10, 15, 13, 15, 1, Ink.Dark),
        ["StepParam"] = c => c.Hexagon().Polyline(1.8, Ink.Green, 7, 16, 10, 16, 10, 12.5, 13.5, 12.5, 13.5, 9, 17, 9),
        ["ChoiceParam"] = c => c.Hexagon().Line(8, 9, 16, 9, 1.5, Ink.Light).Line(8, 12, 16, 12, 1.5, Ink.Green).Line(8, 15, 16, 15, 1.5, Ink.Light),
    };

    private static void Caterpillar(Canvas c) => c
        .Disc(5.5, 16, 3.2, Ink.Green).Disc(9.5, 13, 3.4, Ink.Green).Disc(13.5, 16, 3.4, Ink.Green).Disc(17.5, 11.5, 4.2, Ink.Green)
        .Disc(18.7, 10.5, 0.9, Ink.Dark).Line(16.5, 8, 15.5, 4.5, 1.2, Ink.Dark).Line(18.8, 7.6, 20, 4.5, 1.2, Ink.Dark).Line(3, 20.5, 21, 20.5, 1.4, Ink.Gray);

    // The triangle of the previews, its sharp corner forward.
    private static void Turtle(Canvas c, double x, double y, double size)
        => c.Polygon(Ink.Green, x - 5 * size, y - 7 * size, x - 5 * size, y + 7 * size, x + 8.5 * size, y).Disc(x - 1.5 * size, y, 2.2 * size, Ink.Dark);

    private static void Printer(Canvas c)
    {
        c.Polyline(2, Ink.Dark, 4, 20, 4, 4, 20, 4, 20, 20).Line(3.2, 20.2, 20.8, 20.2, 1.6, Ink.Dark).Line(5, 9, 19, 9, 1.2, Ink.Gray);
        Nozzle(c, 12, 7);
        c.Line(8, 18.4, 16, 18.4, 2, Ink.Green).Line(9, 16.2, 15, 16.2, 2, Ink.Green);
    }

    private static void Sliders(Canvas c)
    {
        double[] knobs = [8, 15, 11];
        for (var i = 0; i < 3; i++) c.Line(4, 6 + 6 * i, 20, 6 + 6 * i, 1.6, Ink.Gray).Disc(knobs[i], 6 + 6 * i, 2.6, i == 1 ? Ink.Orange : Ink.Green);
    }

    private static void Page(Canvas c) => c.Polygon(Ink.Dark, 5, 3, 15, 3, 19, 7, 19, 21, 5, 21).Polygon(Ink.Light, 6, 4, 14.6, 4, 18, 7.4, 18, 20, 6, 20);

    private static void Nozzle(Canvas c, double x, double y)
        => c.Rect(x - 2.5, y, x + 2.5, y + 3, Ink.Orange).Polygon(Ink.Orange, x - 2.5, y + 3, x + 2.5, y + 3, x + 0.8, y + 6, x - 0.8, y + 6);
}
