namespace Caterpillar.Toolpaths;

/// <summary>Homing moves: the travel moves of a <see cref="HomeEvent"/>. They go to the endstops and are never edited.</summary>
internal static class Homing
{
    /// <summary>Position of a head after homing from <paramref name="from"/>, mm.</summary>
    public static Vec3 Home(this HomeEvent home, Vec3 from) => new(home.X ? 0 : from.X, home.Y ? 0 : from.Y, home.Z ? 0 : from.Z);

    /// <summary>The homing event that a move of a toolpath belongs to, or null.</summary>
    public static HomeEvent? HomeOf(this Toolpath toolpath, Move move)
    {
        if (move.Kind != MoveKind.Travel || move.E != 0) return null;
        for (var i = toolpath.FirstEventOf(move.Index); i < toolpath.Events.Count && toolpath.Events[i].Move == move.Index; i++)
        {
            if (toolpath.Events[i].Event is HomeEvent home && move.End == home.Home(move.Start)) return home;
        }
        return null;
    }
}
