using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>Hand cases: the moves of small plans, written as text (kind, end, E, speed).</summary>
public class PlanningTests
{
    // 0.5 mm² of bead is 0.25 mm of filament per mm.
    internal static readonly PlanRules Rules = new(PlanPolicy.Printer, new PrintSettings
    {
        PrintSpeed = 50, OuterWallSpeed = 0, InfillSpeed = 80, FirstLayerSpeed = 0, TravelSpeed = 150, ZHopMinTravel = 2, RetractionMinTravel = 2,
        Comb = false, AvoidCrossingMaxDetour = 0, SeamGap = 0, ZHopType = ZHopType.AbovePrint,
    }, new Printer { MaxSpeed = new(10_000, 10_000, 10_000, 10_000) }, [new ToolRules(2, 1, 40, 30, 0)])
    {
        Clearance = 0.5,
    };

    private static readonly PlanRules NeverLifted = Rules with { Settings = Rules.Settings with { ZHopType = ZHopType.None } };

    private static readonly PlanOptions From0 = new() { Start = Vec3.Zero };

    [Test]
    public void A_travel_retracts_lifts_goes_over_comes_down_and_restores()
    {
        Assert.That(Moves([Line(0, 0, 10, 0, 0.2), Line(10, 10, 0, 10, 0.2)]), Is.EqualTo(new[]
        {
            "Travel 0,0,0.2 0 10", "Print 10,0,0.2 2.5 50",
            "Retract 10,0,0.2 -1 40", "Travel 10,0,0.7 0 10", "Travel 10,10,0.7 0 150", "Travel 10,10,0.2 0 10", "Deretract 10,10,0.2 1 30",
            "Print 0,10,0.2 2.5 50",
        }));
    }

    [Test]
    public void The_lift_is_taken_from_the_highest_point_printed_so_far()
    {
        var moves = Moves([Line(0, 0, 10, 0, 5), Line(20, 0, 30, 0, 0.2), Line(40, 0, 50, 0, 0.2)]);
        Assert.That(moves.Count(m => m.Contains(",5.5 ")), Is.EqualTo(4));
    }

    [Test]
    public void As_drawn_adds_nothing()
    {
        Assert.That(Moves([Line(0, 0, 10, 0, 0), Line(10, 10, 0, 10, 0.2)],
            Rules with { Policy = PlanPolicy.AsDrawn, WipeDistance = 2, Settings = Rules.Settings with { StartDistance = 1, CoastingDistance = 1 } }),
            Is.EqualTo(new[] { "Print 10,0,0 2.5 50", "Travel 10,10,0.2 0 150", "Print 0,10,0.2 2.5 50" }));
    }

    [Test]
    public void Short_travels_neither_lift_nor_retract()
    {
        var plan = Plan([Line(0, 0, 10, 0, 0), Line(10, 1, 0, 1, 0), Line(0, 2, 10, 2, 0.3)], Rules);
        Assert.That(Text(plan.Toolpath), Is.EqualTo(new[]
        {
            "Print 10,0,0 2.5 50", "Travel 10,1,0 0 150", "Print 0,1,0 2.5 50", "Travel 0,1,0.3 0 10", "Travel 0,2,0.3 0 150", "Print 10,2,0.3 2.5 50",
        }));
        Assert.That((plan.Report.SkippedRetractions, plan.Report.SkippedZHops, plan.Report.Retractions, plan.Report.ZHops), Is.EqualTo((2, 2, 0, 0)));
    }

    [Test]
    public void Short_travels_along_a_slope_pass_over_what_is_higher_next_to_them()
    {
        string[] Over(double z) => Moves([.. new[] { Line(0, 0, 10, 0, 0), Line(10, 1, 0, 1, z) }.Select(p => p with { Layer = new Layer(0, 1, 0.2) })]);
        Assert.That(Over(0), Does.Contain("Travel 10,1,0 0 150"));
        Assert.That(Over(0.3), Is.SupersetOf(new[] { "Travel 10,0,0.8 0 10", "Travel 10,1,0.8 0 150", "Travel 10,1,0.3 0 10" }));
    }

    [Test]
    public void Touching_paths_are_printed_without_a_travel()
    {
        Assert.That(Moves([Line(0, 0, 10, 0, 0), Line(10, 0, 10, 4, 0)]), Is.EqualTo(new[] { "Print 10,0,0 2.5 50", "Print 10,4,0 1 50" }));
    }

    [Test]
    public void Without_a_lift_travels_are_straight()
    {
        Assert.That(Moves([Line(0, 0, 10, 0, 3), Line(20, 0, 30, 0, 1)], NeverLifted), Is.EqualTo(new[]
        {
            "Travel 0,0,3 0 10", "Print 10,0,3 2.5 50", "Retract 10,0,3 -1 40", "Travel 20,0,1 0 150", "Deretract 20,0,1 1 30", "Print 30,0,1 2.5 50",
        }));
    }

    [Test]
    public void From_an_unknown_start_the_head_moves_above_the_first_path()
    {
        var plan = Plan([Line(5, 5, 10, 5, 0.2)], Rules, new PlanOptions());
        Assert.That(Text(plan.Toolpath), Is.EqualTo(new[] { "Travel 5,5,0.7 0 150", "Travel 5,5,0.2 0 10", "Print 10,5,0.2 1.25 50" }));
        Assert.That(plan.Toolpath.Start, Is.Null);
        plan = Plan([Line(5, 5, 10, 5, 0.2)], NeverLifted, new PlanOptions());
        Assert.That(Text(plan.Toolpath), Is.EqualTo(new[] { "Travel 5,5,0.2 0 150", "Print 10,5,0.2 1.25 50" }));
    }

    [Test]
    public void Drawn_travels_stay_as_drawn_and_retract_once()
    {
        Step[] steps = [Line(0, 0, 10, 0, 0), new TravelStep(new Vec3(11, 0)), new TravelStep([new Vec3(11, 5), new Vec3(12, 5)], 33), Line(12, 5, 20, 5, 0)];
        var plan = Plan(steps, Rules);
        Assert.That(Text(plan.Toolpath), Is.EqualTo(new[]
        {
            "Print 10,0,0 2.5 50", "Retract 10,0,0 -1 40", "Travel 11,0,0 0 150", "Travel 11,5,0 0 33", "Travel 12,5,0 0 33", "Deretract 12,5,0 1 30",
                "Print 20,5,0 2 50",
        }));
        Assert.That((plan.Report.DrawnTravels, plan.Report.Travels, plan.Report.Retractions, plan.Report.Deretractions), Is.EqualTo((2, 0, 1, 1)));
        Assert.That(Moves([Line(0, 0, 10, 0, 0), new TravelStep(new Vec3(10, 1)), Line(10, 1, 20, 1, 0)]), Has.None.StartsWith("Retract"));
    }

    [Test]
    public void A_short_drawn_travel_followed_by_a_long_one_retracts_before_it()
    {
        Assert.That(Moves([Line(0, 0, 10, 0, 0), new TravelStep(new Vec3(10, 0, 1)), Line(20, 0, 30, 0, 0)]), Is.EqualTo(new[]
        {
            "Print 10,0,0 2.5 50", "Retract 10,0,0 -1 40", "Travel 10,0,1 0 150", "Travel 10,0,1.5 0 10", "Travel 20,0,1.5 0 150", "Travel 20,0,0 0 10",
                "Deretract 20,0,0 1 30",
            "Print 30,0,0 2.5 50",
        }));
    }

    [Test]
    public void Extruding_in_place_restores_retraction_first()
    {
        Step[] steps = [Line(0, 0, 10, 0, 0), new ExtrudeEvent(-6), new TravelStep(new Vec3(20, 0)), new ExtrudeEvent(10, 7), Line(20, 0, 30, 0, 0)];
        foreach (var policy in new[] { PlanPolicy.Printer, PlanPolicy.AsDrawn })
        {
            var plan = Plan(steps, Rules with { Policy = policy });
            Assert.That(Text(plan.Toolpath), Is.EqualTo(new[]
            {
                "Print 10,0,0 2.5 50", "Retract 10,0,0 -3 40", "Travel 20,0,0 0 150", "Deretract 20,0,0 3 7", "Prime 20,0,0 2 7", "Print 30,0,0 2.5 50",
            }));
            Assert.That(plan.Toolpath[3].Deposited, Is.Zero);
            Assert.That(plan.Toolpath[4].Deposited, Is.EqualTo(2));
        }
    }

    [Test]
    public void Extruding_in_place_has_the_speeds_of_the_printer_unless_it_states_its_own()
    {
        Step[] steps = [Line(0, 0, 10, 0, 0), new ExtrudeEvent(-6), new ExtrudeEvent(10), new ExtrudeEvent(-2, 9), new ExtrudeEvent(0, 9)];
        Assert.That(Moves(steps), Is.EqualTo(new[]
        {
            "Print 10,0,0 2.5 50", "Retract 10,0,0 -3 40", "Deretract 10,0,0 3 30", "Prime 10,0,0 2 30", "Retract 10,0,0 -1 9",
        }));
    }

    [TestCase(1.999, false)]
    [TestCase(2, true)]
    public void A_travel_is_retracted_from_its_least_length_on(double length, bool isRetracted)
        => Assert.That(Moves([Line(0, 0, 10, 0, 0), Line(10 + length, 0, 30, 0, 0)]).Any(m => m.StartsWith("Retract", StringComparison.Ordinal)),
            Is.EqualTo(isRetracted));

    [Test]
    public void What_is_primed_in_place_is_retracted_before_the_first_travel()
        => Assert.That(Moves([new ExtrudeEvent(4), Line(20, 0, 30, 0, 0)]), Is.EqualTo(new[]
        {
            "Prime 0,0,0 2 30", "Retract 0,0,0 -1 40", "Travel 0,0,0.5 0 10", "Travel 20,0,0.5 0 150", "Travel 20,0,0 0 10", "Deretract 20,0,0 1 30",
            "Print 30,0,0 2.5 50",
        }));

    [Test]
    public void Over_an_object_the_head_rises_before_it_goes_to_the_first_place_that_is_drawn()
    {
        var options = new PlanOptions { Obstacle = MeshMaker.Box(40, 0, 0, 60, 20, 8) };
        Step[] steps = [new TravelStep([new Vec3(5, 5, 0.2), new Vec3(7, 5, 0.2)], 90), Line(7, 5, 20, 5, 0.2)];
        var toolpath = Plan(steps, Rules, options).Toolpath;
        Assert.That(toolpath.Events.First().Event, Is.EqualTo(new RawEvent("G0 Z8.5 F600")));
        Assert.That(Text(toolpath), Is.EqualTo(new[] { "Travel 5,5,8.5 0 150", "Travel 5,5,0.2 0 10", "Travel 7,5,0.2 0 90", "Print 20,5,0.2 3.25 50" }));
        Assert.That(Text(Plan(steps, Rules, new PlanOptions()).Toolpath),
            Is.EqualTo(new[] { "Travel 5,5,0.2 0 90", "Travel 7,5,0.2 0 90", "Print 20,5,0.2 3.25 50" }));
    }

    [Test]
    public void Printing_with_retracted_filament_deposits_only_what_is_left()
    {
        Step[] steps = [new ExtrudeEvent(-1), Line(0, 0, 10, 0, 0), Line(10, 0, 20, 0, 0)];
        var result = PlanRun.Run(steps, Rules with { Policy = PlanPolicy.AsDrawn }, From0, null, default);
        Assert.That(result.Value!.Toolpath.Moves().Select(m => m.Deposited), Is.EqualTo(new[] { 0, 2, 2.5 }));
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo("plan.printed_retracted"));
    }

    [Test]
    public void Speeds_come_from_the_bead_then_the_role_then_the_first_layer()
    {
        var first = new Layer(0, 0.2);
        var second = new Layer(1, 0.4);
        Step[] steps =
        [
            new PrintPath([new Vec3(0, 0), new Vec3(10, 0)], new Bead(0.5, speed: 5)) { Layer = first },
            new PrintPath([new Vec3(10, 0), new Vec3(20, 0)], new Bead(0.5)) { Layer = first, Role = Role.Infill },
            new PrintPath([new Vec3(20, 0), new Vec3(30, 0)], new Bead(0.5)) { Layer = second, Role = Role.Infill },
            new PrintPath([new Vec3(30, 0), new Vec3(40, 0)], new Bead(0.5)) { Layer = second, Role = Role.OuterWall },
        ];
        var toolpath = Plan(steps, Rules with { Settings = Rules.Settings with { FirstLayerSpeed = 20 } }).Toolpath;
        Assert.That(toolpath.Moves().Select(m => m.Speed), Is.EqualTo(new[] { 5, 20, 80, 50 }));
        Assert.That(toolpath.Moves().Select(m => m.Layer), Is.EqualTo(new[] { 0, 0, 1, 1 }));
        Assert.That(toolpath.Moves().Select(m => m.Source), Is.EqualTo(new[] { 0, 1, 2, 3 }));
        Assert.That(toolpath.Moves().Select(m => m.Role), Is.EqualTo(new[] { Role.Unspecified, Role.Infill, Role.Infill, Role.OuterWall }));
        Assert.That(toolpath.Layers, Is.EqualTo(new[] { first, second }));
    }

    [Test]
    public void Overrides_are_set_before_the_path_and_reverted_after_it_and_not_in_between()
    {
        var hot = new PathOverrides(NozzleTemperature: 230, Fan: 0);
        Step[] steps =
        [
            Line(0, 0, 10, 0, 0), Line(10, 0, 20, 0, 0) with { Overrides = hot }, Line(20, 0, 30, 0, 0) with { Overrides = hot }, Line(30, 0, 40, 0, 0),
            new FanEvent(0.5), Line(40, 0, 50, 0, 0) with { Overrides = hot }, Line(50, 0, 60, 0, 0),
        ];
        var material = new Material { NozzleTemperature = 200, FanOffLayers = 0 };
        var toolpath = Plan(steps, Rules with { Tools = [Rules.Tools[0] with { Material = material }] }).Toolpath;
        Assert.That(toolpath.Events, Is.EqualTo(new MoveEvent[]
        {
            new(0, new FanEvent(1)), new(1, new NozzleTemperatureEvent(230)), new(1, new FanEvent(0)), new(3, new NozzleTemperatureEvent(200)),
                new(3, new FanEvent(1)),
            new(4, new FanEvent(0.5)), new(4, new NozzleTemperatureEvent(230)), new(4, new FanEvent(0)), new(5, new NozzleTemperatureEvent(200)),
                new(5, new FanEvent(0.5)),
        }));
    }

    [TestCase(200, false)]
    [TestCase(0, true)]
    public void A_value_that_cannot_be_reverted_is_noted(double usual, bool noted)
    {
        var tool = Rules.Tools[0] with { Material = new Material { NozzleTemperature = usual } };
        Step[] steps = [Line(0, 0, 10, 0, 0) with { Overrides = new PathOverrides(NozzleTemperature: 230) }, Line(10, 0, 20, 0, 0)];
        var plan = PlanRun.Run(steps, Rules with { Tools = [tool] }, From0, null, default);
        Assert.That(plan.Diagnostics.Any(d => d.Code == "plan.override_kept"), Is.EqualTo(noted));
        Assert.That(plan.Value!.Toolpath.Events.Count(e => e.Event is NozzleTemperatureEvent), Is.EqualTo(noted ? 1 : 2));
    }

    [Test]
    public void Events_are_attached_to_the_move_that_follows_them()
    {
        Step[] steps = [new FanEvent(1), Line(0, 0, 10, 0, 0), new DwellEvent(2), new CommentEvent("x")];
        var toolpath = Plan(steps, Rules).Toolpath;
        Assert.That(toolpath.Events, Is.EqualTo(new MoveEvent[] { new(0, new FanEvent(1)), new(1, new DwellEvent(2)), new(2, new CommentEvent("x")) }));
        Assert.That(Text(toolpath), Is.EqualTo(new[] { "Print 10,0,0 2.5 50", "Dwell 10,0,0 0 0" }));
    }

    [Test]
    public void A_tool_change_retracts_and_each_tool_has_its_own_balance_and_factor()
    {
        var rules = Rules with { Tools = [new ToolRules(2, 1, 40, 30, 0), new ToolRules(1, 4, 20, 10, 0)], Settings = NeverLifted.Settings };
        Step[] steps = [Line(0, 0, 10, 0, 0), Line(10, 0, 20, 0, 0) with { Tool = 1 }, Line(20, 0, 30, 0, 0), Line(30, 0, 40, 0, 0) with { Tool = 1 }];
        var plan = Plan(steps, rules);
        Assert.That(Text(plan.Toolpath), Is.EqualTo(new[]
        {
            "Print 10,0,0 2.5 50", "Retract 10,0,0 -1 40", "Print 20,0,0 5 50", "Retract 20,0,0 -4 20", "Deretract 20,0,0 1 30", "Print 30,0,0 2.5 50",
            "Retract 30,0,0 -1 40", "Deretract 30,0,0 4 10", "Print 40,0,0 5 50",
        }));
        Assert.That(plan.Toolpath.Events.Select(e => (e.Move, ((ToolEvent)e.Event).Tool)), Is.EqualTo(new[] { (2, 1), (4, 0), (7, 1) }));
        Assert.That(plan.Report.ToolChanges, Is.EqualTo(3));
        var wrong = PlanRun.Run([Line(0, 0, 1, 0, 0) with { Tool = 2 }], rules, From0, null, default);
        Assert.That(wrong.Value, Is.Null);
        Assert.That(wrong.Diagnostics.Single().ToString(),
            Is.EqualTo("step 0: error plan.unknown_tool: Step uses tool 2, but the printer has only tools 0 to 1."));
    }

    [Test]
    public void A_wipe_goes_back_along_an_open_path_and_on_along_a_loop_while_retracting()
    {
        var rules = NeverLifted with { WipeDistance = 3 };
        var bent = new PrintPath([new Vec3(0, 0), new Vec3(10, 0), new Vec3(10, 1)], new Bead(0.5));
        Assert.That(Moves([bent, Line(30, 0, 40, 0, 0)], rules).Skip(2).Take(3),
            Is.EqualTo(new[] { "Wipe 10,0,0 -0.33333 120", "Wipe 8,0,0 -0.66667 120", "Travel 30,0,0 0 150" }));
        var loop = new PrintPath([new Vec3(0, 0), new Vec3(2, 0), new Vec3(2, 9)], new Bead(0.5), closed: true);
        var circle = new PrintPath([new Vec3(10, 0), new Vec3(-10, 0)], [new Bead(1), new Bead(1)], closed: true,
            arcs: [new Arc(Vec3.Zero, 180), new Arc(Vec3.Zero, 180)]);
        var onward = WipePath.Along(circle, 3);
        Assert.That(onward.Select(p => p.Length), Is.All.EqualTo(10).Within(0.05), "around");
        Assert.That((onward[0], onward.Zip(onward.Skip(1), (a, b) => b.Y > a.Y).All(up => up)), Is.EqualTo((new Vec3(10, 0), true)));
        Assert.That(onward.Zip(onward.Skip(1), (a, b) => a.DistanceTo(b)).Sum(), Is.EqualTo(3).Within(1e-9));
        Assert.That(Moves([loop, Line(30, 0, 40, 0, 0)], rules).Skip(3).Take(2), Is.EqualTo(new[] { "Wipe 2,0,0 -0.66667 120", "Wipe 2,1,0 -0.33333 120" }));
    }

    [Test]
    public void Restoring_during_the_descent_is_a_moving_restore_that_the_filament_can_follow()
    {
        var rules = Rules with { Clearance = 0.1, Settings = Rules.Settings with { DeretractDuringDescent = true } };
        var moves = Moves([Line(0, 0, 10, 0, 0), Line(20, 0, 30, 0, 0)], rules);
        Assert.That(moves.Skip(4).Take(2), Is.EqualTo(new[] { "MovingDeretract 20,0,0 1 3", "Print 30,0,0 2.5 50" }));
    }

    [Test]
    public void Extra_restore_is_deposited()
    {
        var toolpath = Plan([Line(0, 0, 10, 0, 0), Line(20, 0, 30, 0, 0)], Rules with { Tools = [new ToolRules(2, 1, 40, 30, 0.25)] }).Toolpath;
        Assert.That(Text(toolpath).Skip(5).Take(2), Is.EqualTo(new[] { "Deretract 20,0,0 1 30", "Prime 20,0,0 0.25 30" }));
        Assert.That(toolpath[6].Deposited, Is.EqualTo(0.25));
    }

    [Test]
    public void Pressure_lag_primes_before_the_path_and_stops_early()
    {
        var rules = Rules with { Settings = Rules.Settings with { StartDistance = 2, CoastingDistance = 3 } };
        Assert.That(Moves([Line(0, 0, 40, 0, 0)], rules), Is.EqualTo(new[] { "Prime 0,0,0 0.5 30", "Print 37,0,0 9.25 50", "Travel 40,0,0 0 50" }));
        // A tenth of 30 mm is 3 mm, of 20 mm 2 mm.
        Assert.That(Moves([Line(0, 0, 30, 0, 0)], rules), Is.EqualTo(new[] { "Prime 0,0,0 0.5 30", "Print 27,0,0 6.75 50", "Travel 30,0,0 0 50" }));
        Assert.That(Moves([Line(0, 0, 20, 0, 0)], rules), Is.EqualTo(new[] { "Prime 0,0,0 0.5 30", "Print 18,0,0 4.5 50", "Travel 20,0,0 0 50" }));
        Assert.That(Moves([Line(0, 0, 4, 0, 0)], rules), Is.EqualTo(new[] { "Prime 0,0,0 0.1 30", "Print 3.6,0,0 0.9 50", "Travel 4,0,0 0 50" }));
        var arc = new PrintPath([new Vec3(10, 0), new Vec3(-10, 0)], [new Bead(0.5)], false, [new Arc(Vec3.Zero, 180)]);
        rules = rules with { Settings = rules.Settings with { StartDistance = 0, CoastingDistance = 100 } };
        var most = Plan([arc], rules, new PlanOptions { Start = new Vec3(10, 0) }).Toolpath;
        Assert.That(most.Count, Is.EqualTo(2));
        Assert.That(most[0].End.DistanceTo(new Vec3(-9.510565163, 3.090169944)), Is.LessThan(1e-8), "162 of 180 degrees");
        Assert.That(most[0].Arc!.Value.Sweep, Is.EqualTo(162).Within(1e-9));
        Assert.That(most[1].Arc!.Value.Sweep, Is.EqualTo(18).Within(1e-9));
    }

    [Test]
    public void On_slopes_nothing_is_coasted_or_wiped()
    {
        // Beside a slope a nozzle may go as deep as an extrusion is pressed, but not without one.
        var rules = Rules with { Settings = Rules.Settings with { CoastingDistance = 3 }, WipeDistance = 2 };
        Assert.That(Moves([Line(0, 0, 40, 0, 0), Line(40, 30, 0, 30, 0)], rules).Count(m => m.StartsWith("Wipe")), Is.EqualTo(1));
        var slope = new PrintPath([new Vec3(0, 0), new Vec3(30, 0), new Vec3(40, 0, 4)], new Bead(0.5), false);
        var moves = Moves([slope, Line(40, 30, 0, 30, 0)], rules);
        Assert.That(moves.Any(m => m.StartsWith("Print 40,0,4 ")), Is.True);
        Assert.That(moves.Any(m => m.StartsWith("Wipe")), Is.False);
        var loop = new PrintPath([new Vec3(0, 0), new Vec3(30, 0), new Vec3(30, 30, 4)], new Bead(0.5), true) with { Role = Role.OuterWall };
        Assert.That(Moves([loop], rules with { Settings = rules.Settings with { SeamGap = 0.5 } }).Last(), Does.StartWith("Print 0,0,0 "));
    }

    [Test]
    public void Coasting_leaves_nine_tenths_of_the_wall_of_a_small_hole()
    {
        // The clay profile coasts 3 mm; the wall of the hole is 4 mm long.
        var hole = new PrintPath([new Vec3(0, 0), new Vec3(1, 0), new Vec3(1, 1), new Vec3(0, 1)], new Bead(0.5), true) with { Role = Role.OuterWall };
        var moves = Moves([hole], Rules with { Settings = Rules.Settings with { CoastingDistance = 3 } });
        Assert.That(moves,
            Is.EqualTo(new[] { "Print 1,0,0 0.25 50", "Print 1,1,0 0.25 50", "Print 0,1,0 0.25 50", "Print 0,0.4,0 0.15 50", "Travel 0,0,0 0 50" }));
    }

    [Test]
    public void A_closed_wall_stops_before_its_start_by_the_gap_of_seams()
    {
        var rules = Rules with { Settings = Rules.Settings with { SeamGap = 0.5 } };
        PrintPath Square(double side, Role role, bool closed = true) => new PrintPath(
            closed ? [new Vec3(0, 0), new Vec3(side, 0), new Vec3(side, side), new Vec3(0, side)]
                : [new Vec3(0, 0), new Vec3(side, 0), new Vec3(side, side), new Vec3(0, side), new Vec3(0, 0)], new Bead(0.5), closed) with { Role = role };
        foreach (var role in new[] { Role.OuterWall, Role.InnerWall })
        {
            Assert.That(Moves([Square(10, role)], rules).Skip(3), Is.EqualTo(new[] { "Print 0,0.5,0 2.375 50", "Travel 0,0,0 0 50" }));
            // A tenth of 4 mm.
            Assert.That(Moves([Square(1, role)], rules).Skip(3), Is.EqualTo(new[] { "Print 0,0.4,0 0.15 50", "Travel 0,0,0 0 50" }));
            Assert.That(Moves([Square(10, role, closed: false)], rules), Has.Length.EqualTo(4), "an open one");
            Assert.That(Moves([Square(10, role)]), Has.Length.EqualTo(4), "no gap");
            Assert.That(Moves([Square(10, role)], rules with { Settings = rules.Settings with { CoastingDistance = 3 } }).Skip(3),
                Is.EqualTo(new[] { "Print 0,3,0 1.75 50", "Travel 0,0,0 0 50" }));
            Assert.That(Moves([Square(10, role)], rules with { Policy = PlanPolicy.AsDrawn }).Last(), Does.StartWith("Print 0,0,0"), "as drawn");
        }
        Assert.That(Moves([Square(10, Role.Infill)], rules), Has.Length.EqualTo(4), "no wall");
    }

    [Test]
    public void Strokes_without_material_are_printed_without_E()
    {
        Assert.That(Moves([new PrintPath([new Vec3(0, 0), new Vec3(5, 0)], new Bead(0))]), Is.EqualTo(new[] { "Print 5,0,0 0 50" }));
    }

    [Test]
    public void Repeated_points_and_paths_without_length_are_dropped_and_reported()
    {
        Step[] steps =
        [
            new PrintPath([new Vec3(0, 0), new Vec3(5, 0), new Vec3(5, 0), new Vec3(9, 0)], new Bead(0.5)),
            new PrintPath([new Vec3(50, 0), new Vec3(50, 0)], new Bead(0.5)), Line(9, 0, 10, 0, 0),
        ];
        var result = PlanRun.Run(steps, Rules, From0, null, default);
        Assert.That(Text(result.Value!.Toolpath), Is.EqualTo(new[] { "Print 5,0,0 1.25 50", "Print 9,0,0 1 50", "Print 10,0,0 0.25 50" }));
        Assert.That(result.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "plan.empty_path", "plan.repeated_point" }));
        Assert.That(PlanRun.Run([], Rules, From0, null, default).Diagnostics.Single().Code, Is.EqualTo("plan.empty"));
    }

    internal static Plan Plan(IReadOnlyList<Step> steps, PlanRules rules, PlanOptions? options = null)
        => PlanRun.Run(steps, rules, options ?? From0, null, default).Value!;

    internal static string[] Moves(IReadOnlyList<Step> steps, PlanRules? rules = null) => Text(Plan(steps, rules ?? Rules).Toolpath);

    internal static string[] Text(Toolpath toolpath) => toolpath.Moves().Select(m
        => $"{m.Kind} {F(m.End.X)},{F(m.End.Y)},{F(m.End.Z)} {F(m.E)} {F(m.Speed)}").ToArray();

    internal static PrintPath Line(double x0, double y0, double x1, double y1, double z) => new([new Vec3(x0, y0, z), new Vec3(x1, y1, z)], new Bead(0.5));

    private static string F(double value) => NumberFormatter.Format(value, 5);
}
